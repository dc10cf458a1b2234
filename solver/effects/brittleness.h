// SPDX-License-Identifier: MIT
// Brittleness: what has set loses its strength as it breaks. [not in Ding19; Bazant and Oh 1983]
#pragma once

#include <algorithm>

#include "solver/effects/plasticity.h"

namespace bake {

/// Added to a model when a material has a fracture energy.
///
/// The yield stress of dough past theta_4 falls as its plastic work w (per initial volume) spends the energy that a crack takes. A crack is
/// a band as wide as nodes can show, k_band dx, so that its area takes G_f whatever dx is:
///     tau_y (1 - d)^(1/2),   d = w k_band dx / G_f <= 1
/// which is a straight line over the opening u of the crack: of tau = tau_y (1 - u / u_f) the work is w k_band dx = tau_y (u - u^2 / (2
/// u_f)).
struct Brittleness : Effect {
  static constexpr const char* name = "brittleness";
  static constexpr const char* k_told = " with fracture_energy_J_per_m2";
  static bool is_implied(const auto& scene) {
    return scene.lists(Plasticity::name) && std::any_of(scene.materials.begin(), scene.materials.end(), [](const auto& material) {
             return material.effects.template get<Plasticity::Material>().fracture_energy_J_per_m2 < k_infinity;
           });
  }
  using Stored = FieldList<field::Broken>;
  using Transient = FieldList<field::PlasticWork>;

  /// Width of the band in which the nodes' weights spread a crack, in dx: with it a bar that parts takes G_f per area (tests/conservation).
  static constexpr double k_band = 2.2;

  template <class Real>
  struct Constants {
    Real theta_4, per_work;  ///< k_band dx / G_f
    template <class Scene, class SceneMaterial>
    Constants(const Scene& scene, const SceneMaterial& material) {
      const auto& m = material.effects.template get<Plasticity::Material>();
      theta_4 = static_cast<Real>(m.temperatures_C[3]);
      per_work = static_cast<Real>(k_band * scene.dx() / m.fracture_energy_J_per_m2);
    }
  };

  static void fill(auto& p, int lane, const auto&) { p[field::broken][lane] = 0; }

  BAKE_INLINE static void gather(auto& p, const auto&, const auto& k, const auto&, auto&) {
    using P = std::decay_t<decltype(p)>;
    auto opening = p[field::epsilon][0] + p[field::epsilon][1] + p[field::epsilon][2];
    if constexpr (P::template has<field::ThermalStrain>) opening -= p[field::thermal_strain];
    const auto spent = min(p[field::broken] + k.per_work * p[field::plastic_work], 1 + 0 * opening);
    p[field::broken] = ((p.peak_temperature() >= k.theta_4) & (opening > 0 * opening)) ? spent : p[field::broken];
  }

  static void show(auto& frame) { frame.stored(field::broken); }
};

}  // namespace bake
