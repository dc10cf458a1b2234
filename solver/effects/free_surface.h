// SPDX-License-Identifier: MIT
// The volume at the nodes, from which the free surface is measured (solver/engine/surface.h). Part of every model with heat
// or water.
#pragma once

#include "solver/core/kernel_order.h"
#include "solver/core/surface_layer.h"
#include "solver/effects/effect.h"
#include "solver/effects/form.h"

namespace bake {

struct FreeSurface : Effect {
  static constexpr const char* name = "free surface";
  static constexpr const char* k_told = "";
  static bool is_implied(const auto& scene) { return scene.lists("heat") || scene.lists("water"); }
  using Values = FieldList<channel::Volume>;

  /// With the published surface fluxes are taken at particles: nothing resists.
  template <class Real>
  static SurfaceLayer<Real> layer(const auto& scene) {
    if (scene.surface.form == Form::published) return {};
    return {static_cast<Real>(scene.dx()), Real(scene.grid.kernel == KernelOrder::quadratic ? 0.76 : 0.74)};
  }

  static void describe(auto& model, const auto& scene) {
    model.surface_layer = layer<std::decay_t<decltype(model.surface_layer.dx)>>(scene);
    // sigma^2/2 of the smoothing: 1/2 of B and 1/4 (cubic: 1/3) of the B-spline, and 0.08 for the gradient's stencil (by measurement)
    model.surface_rounding = scene.grid.kernel == KernelOrder::quadratic ? 0.415 : 0.457;
  }

  /// V_i = sum w V   [Ding19 Eq. 18]
  BAKE_INLINE static void scatter(auto& p, auto& to, const auto&, const auto&, auto&) { to.value(channel::volume) += p.volume(); }
};

}  // namespace bake
