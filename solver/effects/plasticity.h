// SPDX-License-Identifier: MIT
// Plasticity: temperature- and porosity-dependent Cam clay with viscous flow. [Ding19 Sec. 5.3, 6.5]
#pragma once

#include "solver/effects/parameters.h"
#include "solver/scene/parameter.h"

namespace bake {

struct Plasticity {
  static constexpr const char* name = "plasticity";
  static constexpr const char* meaning = "viscoplastic flow beyond a yield stress that follows temperature";

  /// `distance`: overstress is a stress, eta in Pa s. `quadratic`: [Ding19 Eq. 12] as printed, eta in Pa^3 s.
  enum class Norm { distance, quadratic };
  friend constexpr auto choice_names(Norm) { return std::array{"distance", "quadratic"}; }

  struct Settings {
    Norm norm = Norm::distance;
    Form porosity_form = Form::standard;
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"norm", &Settings::norm, "", any_number,
                    "overstress of the viscous law: \"distance\" (viscosity in Pa s) or \"quadratic\" as printed (Pa^3 s)"},
          Parameter{"porosity_form", &Settings::porosity_form, "", any_number,
                    "n = 1 - (1 - n_0)/J_P (standard) or J_P - 1 + n_0 (published)"},
      };
    }
  };
  struct Material {
    std::array<double, 4> temperatures_C = {4, 20, 45, 85};
    std::array<double, 4> yield_stress_Pa = {0, 0, 0, 0};
    std::array<double, 4> viscosity_Pa_s = {0, 0, 0, 0};
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"temperatures_C", &Material::temperatures_C, "C", above_absolute_zero,
                    "theta_1..theta_4 of fig. 8: fridge, room, fat melting, gelatinisation; strictly rising"},
          Parameter{"yield_stress_Pa", &Material::yield_stress_Pa, "Pa", non_negative,
                    "tau_y at theta_1..theta_4, linear between, frozen past theta_4; one number means constant", Presence::required},
          Parameter{"viscosity_Pa_s", &Material::viscosity_Pa_s, "Pa s", non_negative,
                    "eta at theta_1..theta_4 (Pa^3 s with norm = \"quadratic\"); one number means constant"},
      };
    }
  };
};

}  // namespace bake
