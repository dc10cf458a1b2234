// SPDX-License-Identifier: MIT
// Motion: momentum, the affine velocity field and the volume it carries along.
#pragma once

#include "solver/scene/parameter.h"

namespace bake {

struct Motion {
  static constexpr const char* name = "motion";
  static constexpr const char* meaning = "particles move: momentum, transfers, gravity, colliders";

  enum class Transfer { apic, pic, flip };
  friend constexpr auto choice_names(Transfer) { return std::array{"apic", "pic", "flip"}; }

  struct Settings {
    Transfer transfer = Transfer::apic;
    double flip_blend = 0.95;
    Vector3 gravity_m_per_s2 = {0, 0, -9.81};
    double inertia_scale = 1;
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"transfer", &Settings::transfer, "", any_number, "velocity transfer between particles and grid"},
          Parameter{"flip_blend", &Settings::flip_blend, "1", fraction, "share of FLIP in a FLIP/PIC blend (transfer = \"flip\")"},
          Parameter{"gravity_m_per_s2", &Settings::gravity_m_per_s2, "m/s^2", any_number, "acceleration of gravity"},
          Parameter{"inertia_scale", &Settings::inertia_scale, "1", positive,
                    "multiplies the inertial mass only (mass scaling for quasi-static baking)"},
      };
    }
  };
  struct Material {
    static constexpr auto parameters() { return std::tuple{}; }
  };
};

}  // namespace bake
