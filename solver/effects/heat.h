// SPDX-License-Identifier: MIT
// Heat: conduction, heat transfer from oven and hot colliders, thermal expansion. [Ding19 Sec. 4, 6.3]
#pragma once

#include "solver/core/parameter.h"
#include "solver/effects/elasticity.h"
#include "solver/effects/fields.h"
#include "solver/effects/form.h"
#include "solver/effects/totals.h"

namespace bake {

struct Heat {
  static constexpr const char* name = "heat";
  static constexpr const char* meaning = "temperature: conduction, heat transfer from the surroundings, thermal expansion";

  enum class Integrator { forward_euler, backward_euler };
  friend constexpr auto choice_names(Integrator) { return std::array{"forward_euler", "backward_euler"}; }

  struct Settings {
    Integrator integrator = Integrator::forward_euler;
    double tolerance = 1e-8;
    Form heat_transfer_form = Form::standard;
    Form expansion_form = Form::standard;
    double water_specific_heat_J_per_kgK = 4186;
    double implicit_step_factor = 100;
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"integrator", &Settings::integrator, "", any_number, "gamma = 0 (forward Euler) or 1 (backward Euler) of Sec. 6.3"},
          Parameter{"tolerance", &Settings::tolerance, "1", open_fraction,
                    "relative residual at which backward Euler's conjugate gradients stop"},
          Parameter{"heat_transfer_form", &Settings::heat_transfer_form, "", any_number,
                    "surface flux beta (theta_out - theta) (standard) or with the printed sign (published)", Presence::optional,
                    "exchange_form"},
          Parameter{"expansion_form", &Settings::expansion_form, "", any_number,
                    "thermal stress from g = ln J in stress and heat (standard) or the printed powers of J (published)"},
          Parameter{"water_specific_heat_J_per_kgK", &Settings::water_specific_heat_J_per_kgK, "J/(kg K)", positive,
                    "alpha_w: heat capacity of water per mass; in a scene whose heat runs faster than life, as fast as the solid's"},
          Parameter{"implicit_step_factor", &Settings::implicit_step_factor, "1", positive,
                    "backward Euler's step is at most this many times what forward Euler could take"},
      };
    }
  };
  struct Material {
    double specific_heat_J_per_kgK = 0;
    double conductivity_W_per_mK = 0;
    double expansion_per_K = 0;
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"specific_heat_J_per_kgK", &Material::specific_heat_J_per_kgK, "J/(kg K)", positive,
                    "alpha_s: heat capacity of the solid per mass", Presence::required},
          Parameter{"conductivity_W_per_mK", &Material::conductivity_W_per_mK, "W/(m K)", non_negative,
                    "kappa: heat conductivity of the mixture", Presence::required},
          Parameter{"expansion_per_K", &Material::expansion_per_K, "1/K", non_negative, "alpha_l: linear thermal expansion of the solid"},
      };
    }
  };

  using Stored = FieldList<field::Temperature, field::PeakTemperature>;
  using Transient = FieldList<field::TemperatureGradient>;
  using Moments = FieldList<channel::HeatChange>;
  using Values = FieldList<channel::HeatCapacity, channel::HeatContent>;
  using Gathered = FieldList<channel::TemperatureChange, channel::NodeTemperature>;

  template <class Real>
  struct Constants {
    Real solid, water, kappa, beta_T, theta_0;
    bool implicit, published_expansion;
    template <class Scene, class SceneMaterial>
    Constants(const Scene& scene, const SceneMaterial& material) : theta_0(static_cast<Real>(material.initial_temperature_C)) {
      const auto& m = material.effects.template get<Material>();
      solid = static_cast<Real>(m.specific_heat_J_per_kgK);
      kappa = static_cast<Real>(m.conductivity_W_per_mK);
      const auto& settings = scene.settings.template get<Settings>();
      water = static_cast<Real>(settings.water_specific_heat_J_per_kgK);
      implicit = settings.integrator == Integrator::backward_euler;
      published_expansion = settings.expansion_form == Form::published;
      const Elasticity::Constants<Real> elastic(scene, material);
      // beta_T = 3 K alpha_l. Published: c lambda, with c = 3 alpha_l K / lambda so that both mean the same expansion.
      beta_T = scene.lists("elasticity") ? static_cast<Real>(3 * elastic.bulk * m.expansion_per_K) : Real(0);
    }
  };

  template <class P>
  static void fill(P& p, int lane, double theta, double) {
    p[field::theta][lane] = p[field::theta_peak][lane] = static_cast<typename P::Real>(theta);
  }

  /// c = alpha_s m_s + alpha_w m_w: the mixture's heat capacity.
  /// DEPARTS [Ding19 Sec. 6.3]: printed with the solid's mass only; water carries most of the heat.
  template <class P, class K>
  BAKE_INLINE static auto capacity(P& p, const K& k) {
    auto c = k.solid * p[field::m_s];
    if constexpr (P::template has<field::WaterMass>) c += k.water * p[field::m_w];
    return c;
  }

  /// theta_p += sum w (theta_i^{n+1} - theta_i^n)   [Ding19 Eq. 21]
  template <class P, class From, class K, class S, class R>
  BAKE_INLINE static void gather(P& p, const From& from, const K&, const S&, R&) {
    p[field::theta] += from.value(channel::temperature_change);
    p[field::theta_peak] = max(p[field::theta_peak], p[field::theta]);
    for (int d = 0; d < 3; ++d) p[field::grad_theta][d] = from.gradient(channel::temperature, 0, d);
  }

  /// - beta_T (theta - theta_0) I, from the energy -beta_T (theta - theta_0) ln J.
  /// DEPARTS [Ding19 Eq. 10]: printed as -c lambda J theta (Cauchy): not free of stress at theta_0, and with other powers
  /// of J in stress and heat the energy does not close.
  template <class P, class K>
  BAKE_INLINE static void stress(P& p, const K& k) {
    if constexpr (P::template has<field::KirchhoffStress>) {
      const auto pressure =
          k.published_expansion ? k.beta_T * p[field::J] * p[field::J] * p[field::theta] : k.beta_T * (p[field::theta] - k.theta_0);
      for (int i = 0; i < 3; ++i) p[field::tau][i] -= pressure;
    }
  }

  /// Conduction -V kappa D^-1 w (r . grad theta), the heat that moving water carries, V alpha_w theta D^-1 w (r . q), and the heat
  /// that expansion takes.
  /// DEPARTS [Ding19 Eq. 9]: printed without the water's part, as if it took the temperature of wherever it arrives.
  /// DEPARTS [Ding19 Sec. 6.3]: the conduction term is printed without kappa and with the wrong sign.
  template <class P, class To, class K, class S, class R>
  BAKE_INLINE static void scatter(P& p, To& to, const K& k, const S& step, R&) {
    const auto c = capacity(p, k);
    to.value(channel::heat_capacity) += c;
    to.value(channel::heat_content) += c * p[field::theta];
    const auto flux = (step.dt_next * step.inverse_d) * p.volume();
    if (!k.implicit)
      for (int d = 0; d < 3; ++d) to.moment(channel::heat_change, 0, d) -= k.kappa * flux * p[field::grad_theta][d];
    if constexpr (P::template has<field::WaterFlux>)
      for (int d = 0; d < 3; ++d) to.moment(channel::heat_change, 0, d) += k.water * flux * p[field::theta] * p[field::q][d];
    if constexpr (P::template has<field::AffineVelocity>) {
      if (k.beta_T != 0) {
        const auto& C = p[field::C];
        using Real = typename P::Real;
        const auto theta = k.published_expansion ? p[field::theta] : p[field::theta] + Real(273.15);
        const auto taken = (step.dt_next * k.beta_T) * p[field::V_0] * theta * (C[0] + C[4] + C[8]);
        to.value(channel::heat_change) -= taken;
      }
    }
  }

  template <class P, class K, class S, class R>
  BAKE_INLINE static void limits(P& p, const K& k, const S&, R& report) {
    report.extremes.heat = max(report.extremes.heat, k.kappa * p.volume() / capacity(p, k));
  }

  /// (content + change + dt sum S beta theta_out) / (capacity + dt sum S beta), the capacity being that after the step's water
  /// fluxes: the transfer is implicit at the node, so a light surface node never limits the step; it gains what the surroundings
  /// lose, to round-off. Vapour leaves with the new temperature.
  /// DEPARTS [Ding19 Sec. 4, 6.3]: the boundary flux is beta (theta_out - theta); as printed, a hot body heats itself.
  template <class N, class S, class B>
  BAKE_INLINE static void update(N& node, const S& step, B& booked) {
    auto capacity = node[channel::heat_capacity];
    const auto filled = capacity > 0;
    const auto none = 0 * capacity;
    const auto content = node[channel::heat_content], old = filled ? content / capacity : none;
    auto change = node[channel::heat_change];
    book(booked, Entry::expansion, filled ? -change : none);  // conduction and water only move heat: their sum over the nodes is zero
    if constexpr (N::template scatters<channel::WaterMass>) {
      const auto latent = node.latent_heat_per_kg * node.sums.evaporated;
      change -= latent;
      book(booked, Entry::latent, latent);
      capacity += node.water_specific_heat * (node.sums.moved + node.sums.evaporated);
    }
    const auto& around = node.surroundings;
    const auto transfer = step.dt * around.heat_transfer, source = step.dt * around.heat_transfer_source;
    const auto weight = capacity + transfer;
    auto theta = filled ? (content + change + source) / weight : none;
    if (node.published_heat_transfer) theta = filled ? (content + change - source + transfer * old) / capacity : none;
    book(booked, Entry::exchanged, filled ? capacity * theta - (content + change) : none);
    const auto held = around.is_held & filled;
    book(booked, Entry::exchanged, held ? capacity * (around.held - theta) : none);
    theta = held ? around.held : theta;
    node.sums.heat_weight = held ? none : weight;
    node.out(channel::temperature_change) = theta - old;
    node.out(channel::temperature) = theta;
  }

  template <class P, class K, class S, class R>
  static void totals(P& p, const K& k, const S&, R& report) {
    report.add(Total::heat_content, capacity(p, k) * p[field::theta]);
    report.temperature_low = min(report.temperature_low, p[field::theta]);
    report.temperature_high = max(report.temperature_high, p[field::theta]);
    report.add(Total::temperature, p.volume() * p[field::theta]);
  }
};

}  // namespace bake
