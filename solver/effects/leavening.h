// SPDX-License-Identifier: MIT
// Leavening: CO2 made by a temperature-dependent reaction, and the pressure of the gas in the pores. [Ding19 Sec. 5.4]
#pragma once

#include "solver/effects/parameters.h"
#include "solver/scene/parameter.h"

namespace bake {

struct Leavening {
  static constexpr const char* name = "leavening";
  static constexpr const char* meaning = "leavener makes CO2 when warm; the gas in the pores pushes against the atmosphere";

  struct Settings {
    Form form = Form::standard;
    double reference_pressure_Pa = 101325;
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"form", &Settings::form, "", any_number, "pore gas against the atmosphere (standard) or [Ding19 Eq. 13] as printed (published)"},
          Parameter{"reference_pressure_Pa", &Settings::reference_pressure_Pa, "Pa", positive,
                    "p_ref: pressure of the atmosphere; a lower one, with the moles scaled alike, keeps the equilibrium volume "
                    "and softens the pores (larger steps)"},
      };
    }
  };
  struct Material {
    double production_mol_per_kgs = 0;
    double peak_temperature_C = 40;
    double temperature_width_K = 20;
    double leavener_mol_per_m3 = k_infinity;
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"production_mol_per_kgs", &Material::production_mol_per_kgs, "mol/(kg s)", non_negative, "alpha_g: CO2 made per mass and time at the peak"},
          Parameter{"peak_temperature_C", &Material::peak_temperature_C, "C", above_absolute_zero, "theta_r: temperature of the fastest reaction"},
          Parameter{"temperature_width_K", &Material::temperature_width_K, "K", positive, "Delta theta: width of the reaction's bell curve"},
          Parameter{"leavener_mol_per_m3", &Material::leavener_mol_per_m3, "mol/m^3", positive_or_infinite,
                    "total CO2 that the leavener can make, per initial volume; inf is the paper's unlimited supply"},
      };
    }
  };
};

}  // namespace bake
