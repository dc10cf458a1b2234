// SPDX-License-Identifier: MIT
// Vapour: water that evaporates in hot pores and condenses in cold ones. [not in Ding19; Philip and de Vries 1957]
#pragma once

#include <algorithm>

#include "solver/effects/water.h"

namespace bake {

namespace bound {
BAKE_FIELD(vapour_diffusivity, VapourDiffusivity, 1, "vapour_diffusivity", "m^2/s",
           "n D_v (L_v V / c d rho_v / d theta + d rho_v / d rho_w): what vapour adds to the diffusion of heat and of water");
}  // namespace bound

/// Part of a model when a material has a vapour diffusivity.
///
/// Vapour in the pores is in equilibrium with the dough around, rho_v = a_w(m_w / m_s) rho_sat(theta), and diffuses,
///     j_v = -n D_v grad rho_v,   n = 1 - (1 - n_0) / J
/// What flows away has evaporated, what arrives condenses: j_v is a flux of water that carries the heat L_v j_v beside alpha_w theta j_v,
/// with the same convention as at the surface. Where dough is wet, a_w = 1, it is conduction with kappa + L_v n D_v d rho_sat / d theta.
///
/// It stands before heat and water: its fluxes are known when they need them, and at nodes, which are updated in reverse, it comes last.
struct Vapour : Effect {
  static constexpr const char* name = "vapour";
  static constexpr const char* k_told = " with vapour_diffusivity_m2_per_s";
  static bool is_implied(const auto& scene) {
    return scene.lists(Water::name) && std::any_of(scene.materials.begin(), scene.materials.end(), [](const auto& material) {
             return material.effects.template get<Water::Material>().vapour_diffusivity_m2_per_s > 0;
           });
  }
  using Transient = FieldList<field::VapourFlux>;
  using Values = FieldList<channel::HygroscopicWater, channel::VapourMobility, channel::VapourTransfer>;
  using Gathered = FieldList<channel::VapourDensity>;
  using Bounds = FieldList<bound::VapourDiffusivity>;

  template <class Real>
  struct Constants {
    Real D, h, hygroscopic, skeleton, latent;
    Real solid, water;  ///< heat capacities per mass
    Real melts;         ///< 2 where latent heat of melting halves the step of conduction (Heat::bounds), else 1
    template <class Scene, class SceneMaterial>
    Constants(const Scene& scene, const SceneMaterial& material) {
      const auto& m = material.effects.template get<Water::Material>();
      const auto& heat = material.effects.template get<Heat::Material>();
      D = static_cast<Real>(m.vapour_diffusivity_m2_per_s);
      h = static_cast<Real>(m.vapour_transfer_m_per_s);
      hygroscopic = static_cast<Real>(m.hygroscopic_water_kg_per_kg);
      skeleton = static_cast<Real>(1 - material.initial_porosity);
      solid = static_cast<Real>(heat.specific_heat_J_per_kgK);
      water = static_cast<Real>(scene.settings.template get<Heat::Settings>().water_specific_heat_J_per_kgK);
      latent = static_cast<Real>(scene.settings.template get<Water::Settings>().latent_heat_J_per_kg);
      melts = heat.transition_heat_J_per_kg > 0 ? Real(2) : Real(1);
    }
  };

  /// Nothing: what nodes need of a material they are told.
  template <class Real>
  struct NodeConstants {
    template <class Scene>
    explicit NodeConstants(const Scene&) {}
  };

  /// n D_v. The solid does not change its volume, so that all that dough gains or loses is pores.
  BAKE_INLINE static auto mobility(auto& p, const auto& k) {
    const auto none = 0 * p[field::V_0];
    return k.D * max(1 - k.skeleton * p[field::V_0] / p.volume(), none);
  }

  BAKE_INLINE static void gather(auto& p, const auto& from, const auto& k, const auto&, auto&) {
    const auto D = mobility(p, k);
    for (int d = 0; d < 3; ++d) p[field::j_v][d] = -D * from.gradient(channel::vapour_density, 0, d);
  }

  /// What the surface needs, and the latent heat V L_v D^-1 w (r . j_v). The vapour itself is a part of the water's flux q.
  BAKE_INLINE static void scatter(auto& p, auto& to, const auto& k, const auto& step, auto&) {
    to.value(channel::hygroscopic_water) += k.hygroscopic * p[field::m_s];
    to.value(channel::vapour_mobility) += p.volume() * mobility(p, k);
    to.value(channel::vapour_transfer) += k.h * p.volume();
    const auto flux = (step.baking_dt_next * step.inverse_d * k.latent) * p.volume();
    for (int d = 0; d < 3; ++d) to.moment(channel::heat_change, 0, d) += flux * p[field::j_v][d];
  }

  /// rho_v over what the node has after the step.
  BAKE_INLINE static void update(auto& node, const auto&, const auto&, auto&) {
    const auto water = node[channel::water_mass] + node.sums.moved;
    const auto density =
        pore_vapour::activity(water, node[channel::hygroscopic_water]) * pore_vapour::saturated(node.out(channel::temperature));
    node.out(channel::vapour_density) = node[channel::volume] > 0 ? density : 0 * water;
  }

  /// With kappa = K = 0 heat and water diffuse as one number: the fluxes are n D_v (L_v, 1) (rho_theta grad theta + rho_w grad w), so that
  /// the only eigenvalue besides 0 is n D_v (L_v rho_theta / (rho c) + rho_w). kappa and K add at most their own.
  BAKE_INLINE static void bounds(auto& p, const auto& k, const auto&, auto& report) {
    using Real = typename std::decay_t<decltype(p)>::Real;
    const auto water = max(p[field::m_w], 0 * p[field::m_w] + std::numeric_limits<Real>::min());
    const auto a = pore_vapour::activity(water, k.hygroscopic * p[field::m_s]), density = a * pore_vapour::saturated(p[field::theta]);
    const auto by_heat = k.latent * pore_vapour::saturated_slope(p[field::theta]) / Heat::capacity(p, k);
    const auto by_water = 3 * (1 - a) / water;
    report.bound(bound::vapour_diffusivity, k.melts * mobility(p, k) * density * p.volume() * (by_heat + by_water));
  }

  /// As forward Euler's of heat, of all that diffuses together.
  static void largest_step(const auto& most, const StepScale& at, const auto&, StepLimit& limit) {
    const double vapour = most(bound::vapour_diffusivity);
    const double D = vapour + most(bound::heat_diffusivity) + most(bound::water_diffusivity);
    if (vapour > 0) limit_diffusion(D, at, limit, "vapour diffusion");
  }
};

}  // namespace bake
