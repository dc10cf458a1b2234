// SPDX-License-Identifier: MIT
// The volume at the nodes, from which the free surface is measured (solver/engine/surface.h). Part of every model with heat
// or water.
#pragma once

#include "solver/effects/effect.h"

namespace bake {

struct FreeSurface : Effect {
  static constexpr const char* name = "free surface";
  static constexpr const char* k_told = "";
  static bool is_implied(const auto& scene) { return scene.lists("heat") || scene.lists("water"); }
  using Values = FieldList<channel::Volume>;

  /// V_i = sum w V   [Ding19 Eq. 18]
  BAKE_INLINE static void scatter(auto& p, auto& to, const auto&, const auto&, auto&) { to.value(channel::volume) += p.volume(); }
};

}  // namespace bake
