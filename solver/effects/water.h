// SPDX-License-Identifier: MIT
// Water: Fick diffusion relative to the solid, evaporation, water stress. [Ding19 Sec. 3.2, 5.5, 6.2]
#pragma once

#include "solver/effects/parameters.h"
#include "solver/scene/parameter.h"

namespace bake {

struct Water {
  static constexpr const char* name = "water";
  static constexpr const char* meaning = "water moves through the solid, evaporates at the surface and pushes on the mixture";

  struct Settings {
    Form form = Form::standard;
    double latent_heat_J_per_kg = 0;
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"form", &Settings::form, "", any_number,
                    "mass and momentum without (standard) or with (published) the printed div v terms"},
          Parameter{"latent_heat_J_per_kg", &Settings::latent_heat_J_per_kg, "J/kg", non_negative,
                    "L_v: heat taken by each kilogram that evaporates (water: 2.4e6)"},
      };
    }
  };
  struct Material {
    double water_density_kg_per_m3 = 1000;
    double diffusivity_m2_per_sK = 0;
    double evaporation_kg_per_m2sK = 0;
    double pressure_Pa = 0;
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"water_density_kg_per_m3", &Material::water_density_kg_per_m3, "kg/m^3", positive,
                    "rho_0^w: intrinsic density of water, s = m_w / (rho_0^w V)"},
          Parameter{"diffusivity_m2_per_sK", &Material::diffusivity_m2_per_sK, "m^2/(s K)", non_negative, "K: Fick's constant, q = -K theta rho_w grad s"},
          Parameter{"evaporation_kg_per_m2sK", &Material::evaporation_kg_per_m2sK, "kg/(m^2 s K)", non_negative,
                    "beta_w: water leaving a surface, q.n = beta_w theta (s - s_out)"},
          Parameter{"pressure_Pa", &Material::pressure_Pa, "Pa", non_negative, "c_hat: water pressure per saturation, p_w = c_hat (s - s_0)"},
      };
    }
  };
};

}  // namespace bake
