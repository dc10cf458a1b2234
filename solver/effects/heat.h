// SPDX-License-Identifier: MIT
// Heat: conduction, heat transfer from oven and hot colliders, thermal expansion. [Ding19 Sec. 4, 6.3]
#pragma once

#include <string>

#include "solver/core/parameter.h"
#include "solver/core/step_limit.h"
#include "solver/effects/common.h"
#include "solver/effects/elasticity.h"
#include "solver/effects/form.h"

namespace bake {

namespace booked {
BAKE_FIELD(heat_exchanged, HeatExchanged, 1, "heat_exchanged", "J", "heat that came in through surfaces, colliders and grips");
BAKE_FIELD(expansion_heat, ExpansionHeat, 1, "expansion_heat", "J", "heat taken by thermal expansion");
}  // namespace booked

namespace total {
BAKE_FIELD(heat_content, HeatContent, 1, "heat_content", "J", "heat content, sum of c theta from 0 C, and of latent heat that dough holds");
BAKE_FIELD(temperature, Temperature, 1, "", "m^3 C", "sum of V theta");
BAKE_FIELD(thermoelastic, Thermoelastic, 1, "thermoelastic", "J",
           "energy bound by expansion: what elastic strain takes from the heat, less what is stored unstrained");
}  // namespace total

namespace highest {
BAKE_FIELD(temperature, Temperature, 1, "", "C", "highest theta");
BAKE_FIELD(coldness, Coldness, 1, "", "C", "highest -theta");
}  // namespace highest

namespace bound {
BAKE_FIELD(heat_diffusivity, HeatDiffusivity, 1, "heat_diffusivity", "m^2/s", "kappa V / c");
}  // namespace bound

struct Water;

struct Heat : Effect {
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
    double subgrid_diffusion = 1;
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"integrator", &Settings::integrator, "", any_number, "gamma = 0 (forward Euler) or 1 (backward Euler) of Sec. 6.3"},
          Parameter{"tolerance", &Settings::tolerance, "1", open_fraction,
                    "relative residual at which backward Euler's conjugate gradients stop, or where round-off ends; what is conducted is "
                    "booked, whatever is left"},
          Parameter{"heat_transfer_form", &Settings::heat_transfer_form, "", any_number,
                    "surface flux beta (theta_out - theta) (standard) or with the printed sign (published)", Presence::optional,
                    "exchange_form"},
          Parameter{"expansion_form", &Settings::expansion_form, "", any_number,
                    "thermal stress from g = ln J in stress and heat (standard) or the printed powers of J (published)"},
          Parameter{"water_specific_heat_J_per_kgK", &Settings::water_specific_heat_J_per_kgK, "J/(kg K)", positive,
                    "alpha_w: heat capacity of water per mass; in a scene whose heat runs faster than life, as fast as the solid's"},
          Parameter{"implicit_step_factor", &Settings::implicit_step_factor, "1", positive,
                    "backward Euler's step is at most this many times what forward Euler could take"},
          Parameter{
              "subgrid_diffusion", &Settings::subgrid_diffusion, "1", non_negative,
              "rate at which a particle's temperature goes to that of its nodes, in units of kappa / (rho c dx^2); 0: never, as published"},
      };
    }
  };
  struct Material {
    double specific_heat_J_per_kgK = 0;
    double conductivity_W_per_mK = 0;
    double expansion_per_K = 0;
    double transition_heat_J_per_kg = 0;
    double transition_from_C = 0;
    double transition_to_C = 1;
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"specific_heat_J_per_kgK", &Material::specific_heat_J_per_kgK, "J/(kg K)", positive,
                    "alpha_s: heat capacity of the solid per mass", Presence::required},
          Parameter{"conductivity_W_per_mK", &Material::conductivity_W_per_mK, "W/(m K)", non_negative,
                    "kappa: heat conductivity of the mixture", Presence::required},
          Parameter{"expansion_per_K", &Material::expansion_per_K, "1/K", non_negative, "alpha_l: linear thermal expansion of the solid"},
          Parameter{"transition_heat_J_per_kg", &Material::transition_heat_J_per_kg, "J/kg", non_negative,
                    "L: latent heat of melting or setting, per mass of the solid; 0: none, as published"},
          Parameter{"transition_from_C", &Material::transition_from_C, "C", above_absolute_zero,
                    "temperature at which warming dough begins to take up that latent heat"},
          Parameter{"transition_to_C", &Material::transition_to_C, "C", above_absolute_zero,
                    "temperature at which it has taken up all, evenly between; higher than transition_from_C"},
      };
    }
  };

  using Stored = FieldList<field::Temperature, field::PeakTemperature>;
  using Transient = FieldList<field::TemperatureGradient, field::LentTemperature, field::ThermalStrain>;
  using Moments = FieldList<channel::HeatChange>;
  using Values = FieldList<channel::HeatCapacity, channel::HeatContent, channel::Conductivity, channel::LentHeat>;
  using Gathered = FieldList<channel::TemperatureChange, channel::NodeTemperature>;
  using Booked = FieldList<booked::HeatExchanged, booked::ExpansionHeat>;
  using Totals = FieldList<total::HeatContent, total::Temperature, total::Thermoelastic>;
  using Highest = FieldList<highest::Temperature, highest::Coldness>;
  using Bounds = FieldList<bound::HeatDiffusivity>;

  template <class Real>
  struct Constants {
    Real solid, water, kappa, beta_T, expansion, theta_0, subgrid, latent, from, width;
    bool implicit, published_expansion;
    template <class Scene, class SceneMaterial>
    Constants(const Scene& scene, const SceneMaterial& material) : theta_0(static_cast<Real>(material.initial_temperature_C)) {
      const auto& m = material.effects.template get<Material>();
      solid = static_cast<Real>(m.specific_heat_J_per_kgK);
      kappa = static_cast<Real>(m.conductivity_W_per_mK);
      latent = static_cast<Real>(m.transition_heat_J_per_kg);
      from = static_cast<Real>(m.transition_from_C);
      width = static_cast<Real>(m.transition_to_C - m.transition_from_C);
      const auto& settings = scene.settings.template get<Settings>();
      water = static_cast<Real>(settings.water_specific_heat_J_per_kgK);
      subgrid = static_cast<Real>(settings.subgrid_diffusion);
      implicit = settings.integrator == Integrator::backward_euler;
      published_expansion = settings.expansion_form == Form::published;
      const Elasticity::Constants<Real> elastic(scene, material);
      // beta_T = 3 K alpha_l. Published: c lambda, with c = 3 alpha_l K / lambda so that both mean the same expansion.
      expansion = scene.lists("elasticity") ? static_cast<Real>(3 * m.expansion_per_K) : Real(0);
      beta_T = elastic.bulk * expansion;
    }
  };

  template <class Real>
  struct NodeConstants {
    Real water;
    bool published_heat_transfer;
    template <class Scene>
    explicit NodeConstants(const Scene& scene) {
      const auto& settings = scene.template of<Heat>();
      water = static_cast<Real>(settings.water_specific_heat_J_per_kgK);
      published_heat_transfer = settings.heat_transfer_form == Form::published;
    }
  };

  static void describe(auto& model, const auto& scene) {
    using Model = std::decay_t<decltype(model)>;
    const auto& settings = scene.template of<Heat>();
    model.implicit_heat = settings.integrator == Integrator::backward_euler;
    model.heat_tolerance = settings.tolerance;
    model.printed_heat_transfer = settings.heat_transfer_form == Form::published;
    if (settings.heat_transfer_form == Form::standard)
      model.conductivity_channel = Model::Scattered::template offset<channel::Conductivity>;
    model.temperature_channel = Model::Gathered::template offset<channel::NodeTemperature>;
    model.heat_entry = Model::Booked::template offset<booked::HeatExchanged>;
    for (const auto& [at, value] : scene.oven.heat_transfer_coefficient_W_per_m2K.points) model.needs_surface |= value != 0;
    for (const auto& collider : scene.colliders) model.needs_surface |= collider.heat_transfer_coefficient_W_per_m2K != 0;
    for (const auto& face : scene.faces) model.needs_surface |= face.passes_heat();
  }

  static void fill(auto& p, int lane, const auto& start) {
    p[field::theta][lane] = p[field::theta_peak][lane] = static_cast<typename std::decay_t<decltype(p)>::Real>(start.temperature_C);
  }

  /// c = alpha_s m_s + alpha_w m_w: the mixture's heat capacity.
  /// DEPARTS [Ding19 Sec. 6.3]: printed with the solid's mass only; water carries most of the heat.
  template <class P, class K>
  BAKE_INLINE static auto capacity(P& p, const K& k) {
    auto c = k.solid * p[field::m_s];
    if constexpr (P::template has<field::WaterMass>) c += k.water * p[field::m_w];
    return c;
  }

  /// c theta less the same without what subgrid diffusion gave: heat that is not the particle's yet.
  BAKE_INLINE static auto lent_heat(auto& p, const auto& k) {
    auto lent = capacity(p, k) * p[field::theta_lent];
    if constexpr (std::decay_t<decltype(p)>::template has<field::LentWater>)
      lent += k.water * p[field::m_w_lent] * (p[field::theta] - p[field::theta_lent]);
    return lent;
  }

  /// Share of a difference between a particle and its nodes that diffusion of the length dx evens out in a step. Implicit: never above 1.
  BAKE_INLINE static auto evened_out(auto diffusivity, auto subgrid, const auto& step) {
    const auto x = (subgrid * step.baking_dt / (step.dx * step.dx)) * diffusivity;
    return x / (1 + x);
  }

  /// L m_s times the share of the transition that lies below theta: what a particle holds beyond c theta.
  BAKE_INLINE static auto latent_heat(auto& p, const auto& k) {
    const auto none = 0 * p[field::theta];
    return k.latent * p[field::m_s] * clamp((p[field::theta] - k.from) * (1 / k.width), none, 1 + none);
  }

  /// The temperature at which c theta and latent heat together are what c theta + `held` is now. Nodes know the sensible heat c only: what
  /// they give is spent on the transition first, so that no heat is lost however far a step goes, even past the whole transition.
  /// DEPARTS [Ding19 Eq. 9]: latent heat is not in the paper; off unless the material has one. [Stomakhin14 Sec. 5.2] has a buffer instead.
  BAKE_INLINE static void spend_on_transition(auto& p, const auto& held, const auto& k) {
    const auto none = 0 * held, inverse_c = 1 / capacity(p, k), span = k.latent * p[field::m_s] * inverse_c;
    const auto all = p[field::theta] + held * inverse_c;
    p[field::theta] = all - span * clamp((all - k.from) / (k.width + span), none, 1 + none);
  }

  /// theta_p += sum w (theta_i^{n+1} - theta_i^n)   [Ding19 Eq. 21]
  /// DEPARTS [Ding19 Eq. 21]: of what differs from particle to particle within a cell the nodes know nothing, and it would stay for ever.
  /// It decays as heat conduction over dx would have it, and what that changes at the nodes is taken back there in the next step, so that
  /// their solution is untouched: subgrid diffusion (Gerya and Yuen 2003, doi:10.1016/j.pepi.2003.09.006).
  /// Particles inside of a grip that holds its temperature have that of their nodes at once, and the grip gives what they lack.
  BAKE_INLINE static void gather(auto& p, const auto& from, const auto& k, const auto& step, auto& books) {
    auto held = 0 * p[field::theta];
    if (k.latent > 0) held = latent_heat(p, k);
    p[field::theta] += from.value(channel::temperature_change);
    p[field::theta_lent] =
        evened_out(k.kappa * p.volume() / capacity(p, k), k.subgrid, step) * (from.value(channel::temperature) - p[field::theta]);
    if (books.any_held()) {
      const auto none = 0 * p[field::theta];
      const auto held = books.held(&p[field::x][0], step);
      const auto given = held ? from.value(channel::temperature) - p[field::theta] : none;
      books.book(booked::heat_exchanged, capacity(p, k) * given);
      p[field::theta] += given;
      p[field::theta_lent] = held ? none : p[field::theta_lent];
    }
    p[field::theta] += p[field::theta_lent];
    if (k.latent > 0) spend_on_transition(p, held, k);
    find_thermal_strain(p, k);
    p[field::theta_peak] = max(p[field::theta_peak], p[field::theta]);
    for (int d = 0; d < 3; ++d) p[field::grad_theta][d] = from.gradient(channel::temperature, 0, d);
  }

  BAKE_INLINE static void find_thermal_strain(auto& p, const auto& k) {
    p[field::thermal_strain] = k.published_expansion ? 0 * p[field::theta] : k.expansion * (p[field::theta] - k.theta_0);
  }

  /// - beta_T (theta - theta_0) I, from the energy -beta_T (theta - theta_0) ln J.
  /// DEPARTS [Ding19 Eq. 10]: printed as -c lambda J theta (Cauchy): not free of stress at theta_0, and with other powers
  /// of J in stress and heat the energy does not close.
  BAKE_INLINE static void stress(auto& p, const auto& k) {
    if constexpr (std::decay_t<decltype(p)>::template has<field::KirchhoffStress>) {
      find_thermal_strain(p, k);
      const auto pressure =
          k.published_expansion ? k.beta_T * p[field::J] * p[field::J] * p[field::theta] : k.beta_T * (p[field::theta] - k.theta_0);
      for (int i = 0; i < 3; ++i) p[field::tau][i] -= pressure;
    }
  }

  /// Conduction -V kappa D^-1 w (r . grad theta), the heat that moving water carries, V alpha_w theta D^-1 w (r . q), and the heat
  /// that elastic expansion takes, V_0 beta_T theta_K d(tr epsilon)/dt.
  /// DEPARTS [Ding19 Eq. 9]: printed without the water's part, as if it took the temperature of wherever it arrives.
  /// DEPARTS [Ding19 Sec. 6.3]: the conduction term is printed without kappa and with the wrong sign.
  BAKE_INLINE static void scatter(auto& p, auto& to, const auto& k, const auto& step, auto&) {
    using P = std::decay_t<decltype(p)>;
    const auto c = capacity(p, k);
    to.value(channel::heat_capacity) += c;
    to.value(channel::heat_content) += c * p[field::theta];
    to.value(channel::heat_lent) += lent_heat(p, k);
    to.value(channel::conductivity) += k.kappa * p.volume();
    const auto flux = (step.baking_dt_next * step.inverse_d) * p.volume();
    if (!k.implicit)
      for (int d = 0; d < 3; ++d) to.moment(channel::heat_change, 0, d) -= k.kappa * flux * p[field::grad_theta][d];
    if constexpr (P::template has<field::WaterFlux>)
      for (int d = 0; d < 3; ++d) to.moment(channel::heat_change, 0, d) += k.water * flux * p[field::theta] * p[field::q][d];
    if constexpr (P::template has<field::AffineVelocity>) {
      if (k.beta_T != 0) {
        const auto& C = p[field::C];
        using Real = typename P::Real;
        const auto theta = k.published_expansion ? p[field::theta] : p[field::theta] + Real(273.15);
        auto rate = C[0] + C[4] + C[8];
        if constexpr (P::template has<field::PlasticDilation>)
          if (!k.published_expansion) rate -= p[field::plastic_dilation];
        const auto taken = (step.baking_dt_next * k.beta_T) * p[field::V_0] * theta * rate;
        to.value(channel::heat_change) -= taken;
      }
    }
  }

  /// While dough melts, the temperature gradient is that of nodes which have risen by the sensible step and particles which have not: what
  /// is between them is -dt times the eigenvalue as large as a step before, which must be below 1, and not 2 as without latent heat.
  BAKE_INLINE static void bounds(auto& p, const auto& k, const auto&, auto& report) {
    report.bound(bound::heat_diffusivity, (k.latent > 0 ? 2 : 1) * k.kappa * p.volume() / capacity(p, k));
  }

  /// Forward Euler: dt < 2 / eigenvalue. With particles everywhere the largest eigenvalue of the moment form is 1.94 D / dx^2 (quadratic)
  /// or 1.21 D / dx^2 (cubic), for a wave along one axis; light nodes at surfaces and thin filling cost up to two thirds of that
  /// (`bake study stability`): dt D / dx^2 below 1/3 and 1/2.
  /// Backward Euler is stable with any step; its factor is a bound on the error.
  static void largest_step(const auto& most, const StepScale& at, const auto& scene, StepLimit& limit) {
    const auto& settings = scene.template of<Heat>();
    const double D = most(bound::heat_diffusivity);
    if (settings.integrator == Integrator::forward_euler)
      limit_diffusion(D, at, limit, "heat conduction");
    else if (D > 0)
      limit.at_most(settings.implicit_step_factor * at.safety * at.diffusion * at.dx * at.dx / D, "heat conduction");
  }

  BAKE_INLINE static auto conductance(auto& p, const auto& k) { return k.kappa * p.volume(); }

  /// (content + change + dt sum S beta theta_out) / (capacity + dt sum S beta), the capacity being that after the step's water
  /// fluxes: the transfer is implicit at the node, so a light surface node never limits the step; it gains what the surroundings
  /// lose, to round-off. Vapour leaves with the new temperature. Nodes that a grip holds change no particle: those inside of it take
  /// the nodes' temperature (`gather`); given the nodes' change, they would overshoot as far as those outside fall short.
  /// DEPARTS [Ding19 Sec. 4, 6.3]: the boundary flux is beta (theta_out - theta); as printed, a hot body heats itself.
  BAKE_INLINE static void update(auto& node, const auto& k, const auto& step, auto& budget) {
    using N = std::decay_t<decltype(node)>;
    auto capacity = node[channel::heat_capacity];
    const auto filled = capacity > 0;
    const auto none = 0 * capacity;
    const auto content = node[channel::heat_content], old = filled ? content / capacity : none;
    auto change = node[channel::heat_change];
    budget.book(booked::expansion_heat, filled ? -change : none);  // conduction and water only move heat: their sum over the nodes is zero
    change -= node[channel::heat_lent];
    if constexpr (N::template scatters<channel::NodeWaterMass>) {
      change -= node.sums.heat_taken;
      capacity += k.water * (node.sums.moved + node.sums.evaporated);
    }
    const auto& around = node.surroundings;
    const auto transfer = step.baking_dt * around.heat_transfer, source = step.baking_dt * around.heat_transfer_source;
    const auto weight = capacity + transfer;
    auto theta = filled ? (content + change + source) / weight : none;
    if (k.published_heat_transfer) theta = filled ? (content + change - source + transfer * old) / capacity : none;
    budget.book(booked::heat_exchanged, filled ? capacity * theta - (content + change) : none);
    const auto held = around.is_held & filled;
    budget.book(booked::heat_exchanged, held ? capacity * (old - theta) : none);
    // water that moves or leaves is booked with the node's temperature
    budget.book(booked::heat_exchanged, held ? (capacity - node[channel::heat_capacity]) * (around.held - old) : none);
    node.sums.heat_weight = held ? none : weight;
    node.out(channel::temperature_change) = held ? none : theta - old;
    node.out(channel::temperature) = held ? around.held : theta;
  }

  static void totals(auto& p, const auto& k, const auto&, auto& report) {
    using P = std::decay_t<decltype(p)>;
    report.add(total::heat_content, capacity(p, k) * p[field::theta] - lent_heat(p, k) + latent_heat(p, k));
    if constexpr (P::template has<field::HenckyStrain>) {
      const auto& e = p[field::epsilon];
      const auto elastic_tr = e[0] + e[1] + e[2], free = p[field::thermal_strain];
      const auto theta = p[field::theta] + typename P::Real(273.15);
      report.add(total::thermoelastic,
                 p[field::V_0] * k.beta_T * (theta * elastic_tr - typename P::Real(0.5) * free * (p[field::theta] - k.theta_0)));
    }
    report.add(total::temperature, p.volume() * p[field::theta]);
    report.highest(highest::coldness, -p[field::theta]);
    report.highest(highest::temperature, p[field::theta]);
  }

  static void show(auto& frame) {
    frame.stored(field::theta);
    frame.stored(field::theta_peak);
  }

  static void ledger(auto& columns) {
    columns.made("temperature_min", "C", "temperature of the coldest particle; 0 without heat",
                 [](const auto& now) { return 0 - now.highest(highest::coldness); });
    columns.made("temperature_mean", "C", "mean temperature, weighted with volume; 0 without heat",
                 [](const auto& now) { return now.particles() > 0 ? now.total(total::temperature) / now.total(total::volume) : 0; });
    columns.made("temperature_max", "C", "temperature of the hottest particle; 0 without heat",
                 [](const auto& now) { return now.highest(highest::temperature); });
  }

  static void check_material(const auto&, const auto&, const Material& own, const auto& complaint) {
    if (own.transition_heat_J_per_kg > 0) complaint.unless_rising("transition_to_C", {own.transition_from_C, own.transition_to_C});
  }

  /// As printed the nodes' temperature is that of the surface, so that none can be held, and a flux would have the sign of the others.
  static void check_face(const auto& scene, const auto& face, const auto& complaint) {
    const bool printed = scene.template of<Heat>().heat_transfer_form == Form::published;
    if (face.temperature_C && !face.heat_transfer_coefficient_W_per_m2K && (printed || scene.surface.form == Form::published))
      complaint.at("temperature_C", "found without heat_transfer_coefficient_W_per_m2K beside form = 'published', allowed: with it");
    if (face.heat_flux_W_per_m2 && printed)
      complaint.at("heat_flux_W_per_m2", "found beside heat_transfer_form = 'published', allowed: beside the standard form");
  }

  static bool swells(const Material& own) { return own.expansion_per_K > 0; }

  static std::string idle(const auto& here) {
    const auto& scene = here.scene;
    if (scene.lists("leavening")) return "";  // which needs it
    const bool exchanged =
        here.is_ever_above_zero(scene.oven.heat_transfer_coefficient_W_per_m2K) ||
        here.any(scene.colliders, [](const auto& c) { return c.temperature_C && c.heat_transfer_coefficient_W_per_m2K > 0; }) ||
        here.any(scene.grips, [](const auto& g) { return g.temperature_C.has_value(); }) ||
        here.any(scene.faces, [](const auto& f) { return f.passes_heat(); });
    const bool uneven =
        here.any(scene.bodies, [](const auto& b) { return b.temperature_C.has_value(); }) ||
        here.any(scene.emitters, [](const auto& e) { return e.temperature_C.has_value(); }) ||
        here.any(here.materials, [&](const auto* m) { return m->initial_temperature_C != here.materials.front()->initial_temperature_C; });
    return exchanged || uneven || here.template cools<Water>()
               ? ""
               : "no heat_transfer_coefficient_W_per_m2K is above zero and everything starts equally warm";
  }
  static const char* coefficient(const Material& own) {
    if (own.specific_heat_J_per_kgK > 0) return "specific_heat_J_per_kgK";
    return own.conductivity_W_per_mK > 0 ? "conductivity_W_per_mK" : own.expansion_per_K > 0 ? "expansion_per_K" : "";
  }
};

}  // namespace bake
