// SPDX-License-Identifier: MIT
// Elasticity: Hencky's logarithmic strain and a quadratic energy in it. [Ding19 Sec. 5.2]
#pragma once

#include "solver/scene/parameter.h"

namespace bake {

struct Elasticity {
  static constexpr const char* name = "elasticity";
  static constexpr const char* meaning = "elastic stress of the solid, tau_E = C : 1/2 log b_E";

  struct Settings {
    static constexpr auto parameters() { return std::tuple{}; }
  };
  struct Material {
    double young_modulus_Pa = 0;
    double poisson_ratio = 0.3;
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"young_modulus_Pa", &Material::young_modulus_Pa, "Pa", positive, "E: Young's modulus of the solid",
                    Presence::required},
          Parameter{"poisson_ratio", &Material::poisson_ratio, "1", Range{-1, 0.5, true, true, "a number above -1 and below 0.5"},
                    "nu: Poisson's ratio of the solid"},
      };
    }
  };
};

}  // namespace bake
