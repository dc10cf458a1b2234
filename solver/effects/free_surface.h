// SPDX-License-Identifier: MIT
// The volume at the nodes, from which the free surface is measured (solver/engine/surface.h). Part of every model with heat
// or water.
#pragma once

#include "solver/effects/effect.h"
#include "solver/effects/form.h"

namespace bake {

struct FreeSurface : Effect {
  static constexpr const char* name = "free surface";
  static constexpr const char* k_told = "";
  static bool is_implied(const auto& scene) { return scene.lists("heat") || scene.lists("water"); }
  using Values = FieldList<channel::Volume>;

  /// How deep below the surface the nodes are that fluxes through it are taken at [m]: the dough of that layer resists them. 0 with the
  /// published surface, which takes them at particles.
  static double depth(const auto& scene) { return scene.surface.form == Form::standard ? 0.75 * scene.dx() : 0; }

  /// V_i = sum w V   [Ding19 Eq. 18]
  BAKE_INLINE static void scatter(auto& p, auto& to, const auto&, const auto&, auto&) { to.value(channel::volume) += p.volume(); }
};

}  // namespace bake
