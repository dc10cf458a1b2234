// SPDX-License-Identifier: MIT
// Water: Fick diffusion relative to the solid, evaporation, water stress. [Ding19 Sec. 3.2, 5.5, 6.2]
#pragma once

#include "solver/core/parameter.h"
#include "solver/effects/fields.h"
#include "solver/effects/form.h"
#include "solver/effects/heat.h"
#include "solver/effects/motion.h"
#include "solver/effects/totals.h"

namespace bake {

struct Water {
  static constexpr const char* name = "water";
  static constexpr const char* meaning = "water moves through the solid, evaporates at the surface and pushes on the mixture";

  struct Settings {
    Form form = Form::standard;
    double latent_heat_J_per_kg = 0;
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"form", &Settings::form, "", any_number,
                    "mass and momentum without (standard) or with (published) the printed div v terms"},
          Parameter{"latent_heat_J_per_kg", &Settings::latent_heat_J_per_kg, "J/kg", non_negative,
                    "L_v: heat taken by each kilogram that evaporates (water: 2.4e6)"},
      };
    }
  };
  struct Material {
    double water_density_kg_per_m3 = 1000;
    double diffusivity_m2_per_sK = 0;
    double evaporation_kg_per_m2sK = 0;
    double pressure_Pa = 0;
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"water_density_kg_per_m3", &Material::water_density_kg_per_m3, "kg/m^3", positive,
                    "rho_0^w: intrinsic density of water, s = m_w / (rho_0^w V)"},
          Parameter{"diffusivity_m2_per_sK", &Material::diffusivity_m2_per_sK, "m^2/(s K)", non_negative,
                    "K: Fick's constant, q = -K theta rho_w grad s"},
          Parameter{"evaporation_kg_per_m2sK", &Material::evaporation_kg_per_m2sK, "kg/(m^2 s K)", non_negative,
                    "beta_w: water leaving a surface, q.n = beta_w theta (s - s_out)"},
          Parameter{"pressure_Pa", &Material::pressure_Pa, "Pa", non_negative,
                    "c_hat: water pressure per saturation, p_w = c_hat (s - s_0)"},
      };
    }
  };

  using Stored = FieldList<field::WaterMass>;
  using Transient = FieldList<field::WaterFlux>;
  using Moments = FieldList<channel::WaterChange>;
  using Values = FieldList<channel::WaterMass, channel::WaterCapacity, channel::Evaporability>;
  using Gathered = FieldList<channel::WaterRatio, channel::Saturation>;

  template <class Real>
  struct Constants {
    Real rho_w, K, beta_w, c_hat, s_0, heat, inertia;
    template <class Scene, class SceneMaterial>
    Constants(const Scene& scene, const SceneMaterial& material) : s_0(static_cast<Real>(material.initial_saturation)) {
      const auto& m = material.effects.template get<Material>();
      rho_w = static_cast<Real>(m.water_density_kg_per_m3);
      K = static_cast<Real>(m.diffusivity_m2_per_sK);
      beta_w = static_cast<Real>(m.evaporation_kg_per_m2sK);
      c_hat = static_cast<Real>(m.pressure_Pa);
      heat = static_cast<Real>(scene.settings.template get<Heat::Settings>().water_specific_heat_J_per_kgK);
      inertia = static_cast<Real>(scene.settings.template get<Motion::Settings>().inertia_scale);
    }
  };

  /// Water does not move below 0 C.
  /// DEPARTS [Ding19 Sec. 3.2]: printed with theta alone, which turns diffusion backwards in the freezer.
  template <class P>
  BAKE_INLINE static auto clamped_temperature(P& p) {
    return max(p.temperature(), 0 * p[field::m_w]);
  }

  /// m_w += m_w sum w dm_i / m_i^w, so that particles gain what the nodes gain; s = m_w / (rho_0^w V); q by Fick's law.
  /// [Ding19 Eq. 19, 22]
  /// DEPARTS [Ding19 Eq. 20]: the volume is that of the new time; with the old one and the printed div v term in (25) half
  /// of the water is gone at doubled volume.
  template <class P, class From, class K, class S, class R>
  BAKE_INLINE static void gather(P& p, const From& from, const K& k, const S&, R& report) {
    const auto gained = p[field::m_w] * from.value(channel::water_ratio);
    p[field::m_w] += gained;
    if constexpr (P::template has<field::Temperature>) report.book(Entry::remapped_heat, k.heat * gained * p[field::theta]);
    if constexpr (P::template has<field::Velocity>)
      for (int d = 0; d < 3; ++d)
        report.book(static_cast<Entry>(static_cast<int>(Entry::remapped_x) + d), k.inertia * gained * p[field::v][d]);
    const auto flux = (-k.K) * clamped_temperature(p) * p[field::m_w] / p.volume();
    for (int d = 0; d < 3; ++d) p[field::q][d] = flux * from.gradient(channel::saturation, 0, d);
  }

  /// - J c_hat (s - s_0) I   [Ding19 Eq. 14]
  template <class P, class K>
  BAKE_INLINE static void stress(P& p, const K& k) {
    if constexpr (P::template has<field::KirchhoffStress>) {
      const auto pressure = k.c_hat * (p[field::m_w] / (k.rho_w * p[field::V_0]) - k.s_0 * p[field::J]);
      for (int i = 0; i < 3; ++i) p[field::tau][i] -= pressure;
      p.stiffness += (k.c_hat * k.s_0) * p[field::J];
    }
  }

  /// Flux V D^-1 w (r . q).   [Ding19 Eq. 25]
  template <class P, class To, class K, class S, class R>
  BAKE_INLINE static void scatter(P& p, To& to, const K& k, const S& step, R&) {
    const auto moment = (step.dt_next * step.inverse_d) * p.volume();
    to.value(channel::water_mass) += p[field::m_w];
    to.value(channel::water_capacity) += k.rho_w * p.volume();
    to.value(channel::evaporability) += k.beta_w * clamped_temperature(p) * p.volume();
    for (int j = 0; j < 3; ++j) to.moment(channel::water_change, 0, j) += moment * p[field::q][j];
  }

  template <class P, class K, class S, class R>
  BAKE_INLINE static void limits(P& p, const K& k, const S&, R& report) {
    report.extremes.water = max(report.extremes.water, k.K * clamped_temperature(p) * p[field::m_w] / (k.rho_w * p.volume()));
  }

  /// m_i += flux - evaporation, never below zero.
  template <class N, class S, class B>
  BAKE_INLINE static void update(N& node, const S& step, B& booked) {
    const auto m = node[channel::water_mass], none = 0 * m;
    const auto capacity = node[channel::water_capacity];
    const auto filled = (m > 0) & (capacity > 0);
    const auto& around = node.surroundings;
    // beta_w theta of the node times its free area: (w V beta_w theta) / (w V) * area
    const auto rate = node[channel::volume] > 0 ? step.dt * around.area * node[channel::evaporability] / node[channel::volume] : none;
    const auto flux = node[channel::water_change];
    const auto after_flux = m + flux;
    const auto wanted = filled ? rate * (m / capacity - around.saturation) : none;
    const auto evaporated = min(wanted, max(after_flux, none));
    const auto kept = max(after_flux - evaporated, none);
    book(booked, Entry::evaporated, evaporated);
    book(booked, Entry::water_limited, filled ? kept - (after_flux - evaporated) : none);
    const auto moved = filled ? kept - m : none;
    node.sums.moved = moved;
    node.sums.evaporated = evaporated;
    node.out(channel::water_ratio) = filled ? moved / m : none;
    node.out(channel::saturation) = capacity > 0 ? (m + moved) / capacity : none;
  }

  template <class P, class K, class S, class R>
  static void totals(P& p, const K&, const S&, R& report) {
    report.add(Total::water_mass, p[field::m_w]);
  }
};

}  // namespace bake
