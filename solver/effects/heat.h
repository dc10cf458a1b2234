// SPDX-License-Identifier: MIT
// Heat: conduction, exchange with oven and hot colliders, thermal expansion. [Ding19 Sec. 4, 6.3]
#pragma once

#include "solver/effects/parameters.h"
#include "solver/scene/parameter.h"

namespace bake {

struct Heat {
  static constexpr const char* name = "heat";
  static constexpr const char* meaning = "temperature: conduction, exchange with the surroundings, thermal expansion";

  enum class Integrator { forward_euler, backward_euler };
  friend constexpr auto choice_names(Integrator) { return std::array{"forward_euler", "backward_euler"}; }

  struct Settings {
    Integrator integrator = Integrator::forward_euler;
    double tolerance = 1e-8;
    Form exchange_form = Form::standard;
    Form expansion_form = Form::standard;
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"integrator", &Settings::integrator, "", any_number, "gamma = 0 (forward Euler) or 1 (backward Euler) of Sec. 6.3"},
          Parameter{"tolerance", &Settings::tolerance, "1", open_fraction, "relative residual at which backward Euler's conjugate gradients stop"},
          Parameter{"exchange_form", &Settings::exchange_form, "", any_number,
                    "surface flux beta (theta_out - theta) (standard) or with the printed sign (published)"},
          Parameter{"expansion_form", &Settings::expansion_form, "", any_number,
                    "thermal stress from g = ln J in stress and heat (standard) or the printed powers of J (published)"},
      };
    }
  };
  struct Material {
    double specific_heat_J_per_kgK = 0;
    double water_specific_heat_J_per_kgK = -1;
    double conductivity_W_per_mK = 0;
    double expansion_per_K = 0;
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"specific_heat_J_per_kgK", &Material::specific_heat_J_per_kgK, "J/(kg K)", positive,
                    "alpha_s: heat capacity of the solid per mass", Presence::required},
          Parameter{"water_specific_heat_J_per_kgK", &Material::water_specific_heat_J_per_kgK, "J/(kg K)",
                    Range{-1, k_infinity, false, true, "a number above 0, or -1 for that of the solid"},
                    "alpha_w: heat capacity of the water per mass; -1 takes that of the solid"},
          Parameter{"conductivity_W_per_mK", &Material::conductivity_W_per_mK, "W/(m K)", non_negative,
                    "kappa: heat conductivity of the mixture", Presence::required},
          Parameter{"expansion_per_K", &Material::expansion_per_K, "1/K", non_negative, "alpha_l: linear thermal expansion of the solid"},
      };
    }
  };
};

}  // namespace bake
