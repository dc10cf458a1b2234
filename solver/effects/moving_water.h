// SPDX-License-Identifier: MIT
// What water adds where its solid moves: the momentum that it carries through the solid. [Ding19 Eq. 25, 27]
#pragma once

#include "solver/effects/water.h"

namespace bake {

/// Part of every model with motion and water.
struct MovingWater : Effect {
  static constexpr const char* name = "moving water";
  static constexpr const char* k_told = "";
  static bool is_implied(const auto& scene) { return scene.lists(Motion::name) && scene.lists(Water::name); }
  using Stored = FieldList<field::ScatteredWaterMomentum>;
  using Transient = FieldList<field::WaterMomentum>;

  template <class Real>
  struct Constants {
    Real heat, inertia;
    bool published;
    template <class Scene, class SceneMaterial>
    Constants(const Scene& scene, const SceneMaterial&) {
      heat = static_cast<Real>(scene.settings.template get<Heat::Settings>().water_specific_heat_J_per_kgK);
      inertia = static_cast<Real>(scene.settings.template get<Motion::Settings>().inertia_scale);
      published = scene.settings.template get<Water::Settings>().form == Form::published;
    }
  };

  /// Q = V q, momentum of the water relative to its solid.
  BAKE_INLINE static void gather(auto& p, const auto&, const auto&, const auto&, auto&) {
    for (int d = 0; d < 3; ++d) p[field::Q][d] = p.volume() * p[field::q][d];
  }

  /// The momentum that the flux carries, V (v_w (x) q) D^-1 w r, with the solid's velocity where vapour moves: it comes to dough without
  /// water, whose v_w has no value, and q q / rho_w is a millionth of a pascal; and the change of the water's own momentum, so that the sum
  /// of m v + V q is kept.
  /// DEPARTS [Ding19 Eq. 25, 27]: no div v terms: as printed they take water and bulk velocity out of a body that expands.
  BAKE_INLINE static void scatter(auto& p, auto& to, const auto& k, const auto& step, auto&) {
    using P = std::decay_t<decltype(p)>;
    const auto moment = (step.baking_dt_next * step.inverse_d) * p.volume();
    const auto per_water = p.volume() / max(p[field::m_w], 0 * p[field::m_w] + std::numeric_limits<typename P::Real>::min());
    for (int i = 0; i < 3; ++i) {
      auto v_w = p[field::v][i];
      if constexpr (!P::template has<field::VapourFlux>) v_w += per_water * p[field::q][i];
      for (int j = 0; j < 3; ++j) to.moment(channel::momentum, i, j) += k.inertia * moment * v_w * p[field::q][j];
      to.value(channel::momentum, i) -= k.inertia * (p[field::Q][i] - p[field::Q_old][i]);
    }
    if (k.published) {
      const auto div = step.baking_dt_next * (p[field::C][0] + p[field::C][4] + p[field::C][8]);
      to.value(channel::water_change) -= p[field::m_w] * div;
      if constexpr (P::template has<field::Temperature>)  // with its heat
        to.value(channel::heat_change) -= k.heat * p[field::theta] * p[field::m_w] * div;
      for (int i = 0; i < 3; ++i) to.value(channel::momentum, i) -= k.inertia * (p.mass() * p[field::v][i] + p[field::Q][i]) * div;
    }
    for (int i = 0; i < 3; ++i) p[field::Q_old][i] = p[field::Q][i];
  }
};

}  // namespace bake
