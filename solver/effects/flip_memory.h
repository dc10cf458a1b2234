// SPDX-License-Identifier: MIT
// What FLIP needs beside the motion: the particle's own velocity is kept, and the nodes know their velocity before the step.
#pragma once

#include "solver/effects/motion.h"

namespace bake {

/// Added to a model when [motion] transfer = "flip"; the blend itself is in Motion::gather.
struct FlipMemory : Effect {
  static constexpr const char* name = "flip";
  static constexpr const char* k_told = " with transfer = \"flip\"";
  static bool is_implied(const auto& scene) {
    return scene.lists(Motion::name) && scene.template of<Motion>().transfer == Motion::Transfer::flip;
  }
  using Stored = FieldList<field::Velocity>;
  using Values = FieldList<channel::OldMomentum>;
  using Gathered = FieldList<channel::OldNodeVelocity>;

  template <class Real>
  struct Constants {
    Real inertia;
    template <class Scene, class SceneMaterial>
    Constants(const Scene& scene, const SceneMaterial&)
        : inertia(static_cast<Real>(scene.settings.template get<Motion::Settings>().inertia_scale)) {}
  };

  BAKE_INLINE static void scatter(auto& p, auto& to, const auto& k, const auto&, auto&) {
    for (int i = 0; i < 3; ++i) to.value(channel::old_momentum, i) += k.inertia * p.mass() * p[field::v][i];
  }
};

}  // namespace bake
