// SPDX-License-Identifier: MIT
// Water: Fick diffusion relative to the solid, evaporation, water stress. [Ding19 Sec. 3.2, 5.5, 6.2]
#pragma once

#include <numbers>
#include <string>

#include "solver/core/parameter.h"
#include "solver/effects/form.h"
#include "solver/effects/free_surface.h"
#include "solver/effects/heat.h"
#include "solver/effects/motion.h"
#include "solver/effects/pore_vapour.h"

namespace bake {

namespace booked {
BAKE_FIELD(evaporated, Evaporated, 1, "water_evaporated", "kg", "water that left through surfaces");
BAKE_FIELD(water_limited, WaterLimited, 1, "water_limited", "kg", "water that nodes would have owed; zero while diffusion is stable");
BAKE_FIELD(latent_heat, LatentHeat, 1, "latent_heat", "J", "heat taken by evaporation");
BAKE_FIELD(vapour_heat, VapourHeat, 1, "vapour_heat", "J", "heat content of the water that evaporated, from 0 C");
BAKE_FIELD(remap_heat, RemapHeat, 1, "water_remap_heat", "J",
           "heat that the water's move between particles added beyond what its move between nodes did");
BAKE_FIELD(remap_momentum, RemapMomentum, 3, "water_remap_momentum", "kg m/s",
           "momentum that the water's move between particles added beyond what its move between nodes did");
}  // namespace booked

namespace total {
BAKE_FIELD(water_mass, WaterMass, 1, "water_mass", "kg", "mass of the water");
BAKE_FIELD(water_overfull, WaterOverfull, 1, "water_overfull", "kg",
           "water for which a particle's volume has no room; zero unless dough is crushed");
}  // namespace total

namespace bound {
BAKE_FIELD(water_diffusivity, WaterDiffusivity, 1, "water_diffusivity", "m^2/s", "K theta s");
}  // namespace bound

struct Water : Effect {
  static constexpr const char* name = "water";
  static constexpr const char* meaning = "water moves through the solid, evaporates at the surface and pushes on the mixture";

  struct Settings {
    Form form = Form::standard;
    double latent_heat_J_per_kg = 0;
    double subgrid_diffusion = 1;
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"form", &Settings::form, "", any_number,
                    "gains shared by volume, losses by water (standard), or all by water and with the printed div v terms (published)"},
          Parameter{"latent_heat_J_per_kg", &Settings::latent_heat_J_per_kg, "J/kg", non_negative,
                    "L_v: heat taken by each kilogram that evaporates (water: 2.4e6)"},
          Parameter{
              "subgrid_diffusion", &Settings::subgrid_diffusion, "1", non_negative,
              "rate at which a particle's saturation goes to that of its nodes, in units of K theta s / dx^2; 0: never, as published"},
      };
    }
  };
  struct Material {
    double water_density_kg_per_m3 = 1000;
    double diffusivity_m2_per_sK = 0;
    double evaporation_kg_per_m2sK = 0;
    double pressure_Pa = 0;
    double vapour_diffusivity_m2_per_s = 0;
    double vapour_transfer_m_per_s = 0;
    double hygroscopic_water_kg_per_kg = 0.055;
    bool has_vapour() const { return vapour_diffusivity_m2_per_s > 0 || vapour_transfer_m_per_s > 0; }
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"water_density_kg_per_m3", &Material::water_density_kg_per_m3, "kg/m^3", positive,
                    "rho_0^w: intrinsic density of water, s = m_w / (rho_0^w V)"},
          Parameter{"diffusivity_m2_per_sK", &Material::diffusivity_m2_per_sK, "m^2/(s K)", non_negative,
                    "K: Fick's constant, q = -K theta rho_w grad s, theta in degrees Celsius and 0 below 0 C"},
          Parameter{"evaporation_kg_per_m2sK", &Material::evaporation_kg_per_m2sK, "kg/(m^2 s K)", non_negative,
                    "beta_w: water leaving a surface, q.n = beta_w theta (s - s_out), theta in degrees Celsius and 0 below 0 C"},
          Parameter{"pressure_Pa", &Material::pressure_Pa, "Pa", non_negative,
                    "c_hat: water pressure per saturation, p_w = c_hat (s - s_0)"},
          Parameter{"vapour_diffusivity_m2_per_s", &Material::vapour_diffusivity_m2_per_s, "m^2/s", non_negative,
                    "D_v: diffusivity of vapour in the pores, j = -n D_v grad rho_v, which takes latent heat from where it is hot to where "
                    "it is cold; 0: none, as published"},
          Parameter{"vapour_transfer_m_per_s", &Material::vapour_transfer_m_per_s, "m/s", non_negative,
                    "h_v: vapour that leaves a surface, j.n = h_v rho_v, into air without any; beside evaporation_kg_per_m2sK"},
          Parameter{"hygroscopic_water_kg_per_kg", &Material::hygroscopic_water_kg_per_kg, "kg/kg", positive,
                    "X_h: water per solid over which vapour is half as dense as over water (wheat at 100 C: 0.055)"},
      };
    }
  };

  using Stored = FieldList<field::WaterMass, field::WaterSpread>;
  using Transient = FieldList<field::WaterFlux, field::LentWater>;
  using Moments = FieldList<channel::WaterChange>;
  using Values =
      FieldList<channel::NodeWaterMass, channel::WaterCapacity, channel::Evaporability, channel::Permeability, channel::WaterSpread>;
  using Gathered = FieldList<channel::WaterLoss, channel::WaterGain, channel::Saturation>;
  using Booked =
      FieldList<booked::Evaporated, booked::WaterLimited, booked::LatentHeat, booked::VapourHeat, booked::RemapHeat, booked::RemapMomentum>;
  using Totals = FieldList<total::WaterMass, total::WaterOverfull>;
  using Bounds = FieldList<bound::WaterDiffusivity>;

  template <class Real>
  struct Constants {
    Real rho_w, K, beta_w, c_hat, s_0, heat, inertia, subgrid;
    template <class Scene, class SceneMaterial>
    Constants(const Scene& scene, const SceneMaterial& material) : s_0(static_cast<Real>(material.initial_saturation)) {
      const auto& m = material.effects.template get<Material>();
      rho_w = static_cast<Real>(m.water_density_kg_per_m3);
      K = static_cast<Real>(m.diffusivity_m2_per_sK);
      beta_w = static_cast<Real>(m.evaporation_kg_per_m2sK);
      c_hat = static_cast<Real>(m.pressure_Pa);
      subgrid = static_cast<Real>(scene.settings.template get<Settings>().subgrid_diffusion);
      heat = static_cast<Real>(scene.settings.template get<Heat::Settings>().water_specific_heat_J_per_kgK);
      inertia = static_cast<Real>(scene.settings.template get<Motion::Settings>().inertia_scale);
    }
  };

  template <class Real>
  struct NodeConstants {
    Real latent_heat;
    SurfaceLayer<Real> layer;
    bool published;
    template <class Scene>
    explicit NodeConstants(const Scene& scene)
        : latent_heat(static_cast<Real>(scene.template of<Water>().latent_heat_J_per_kg)),
          layer(FreeSurface::layer<Real>(scene)),
          published(scene.template of<Water>().form == Form::published) {}
  };

  static void describe(auto& model, const auto& scene) {
    using Booked = typename std::decay_t<decltype(model)>::Booked;
    model.moves_mass = true;
    model.moved_specific_heat = scene.template of<Heat>().water_specific_heat_J_per_kgK;
    model.left_heat_entry = Booked::template offset<booked::VapourHeat>;
    model.moved_heat_entry = Booked::template offset<booked::RemapHeat>;
    model.moved_momentum_entry = Booked::template offset<booked::RemapMomentum>;
    for (const auto& material : scene.materials)
      model.needs_surface |= material.effects.template get<Material>().evaporation_kg_per_m2sK != 0 ||
                             material.effects.template get<Material>().vapour_transfer_m_per_s != 0;
  }

  static void fill(auto& p, int lane, const auto& start) {
    using Real = typename std::decay_t<decltype(p)>::Real;
    const double rho_w = start.material.effects.template get<Material>().water_density_kg_per_m3;
    p[field::m_s][lane] = static_cast<Real>(start.volume * (start.material.density_kg_per_m3 - rho_w * start.material.initial_saturation));
    p[field::m_w][lane] = static_cast<Real>(start.volume * rho_w * start.saturation);
    p[field::w_spread][lane] = 0;
  }

  /// Water does not move below 0 C.
  /// DEPARTS [Ding19 Sec. 3.2]: printed with theta alone, which turns diffusion backwards in the freezer.
  BAKE_INLINE static auto clamped_temperature(auto& p) { return max(p.temperature(), 0 * p[field::m_w]); }

  BAKE_INLINE static auto diffusivity(auto& p, const auto& k) {
    return k.K * clamped_temperature(p) * p[field::m_w] / (k.rho_w * p.volume());
  }

  /// m_w += m_w sum w min(dm_i, 0) / m_i^w + rho_0^w V sum w max(dm_i, 0) / (rho_0^w V)_i: particles gain what their nodes gain, and none
  /// falls below zero; s = m_w / (rho_0^w V); q by Fick's law. What differs within a cell decays as of heat (Heat::gather).
  /// [Ding19 Eq. 19, 22]
  /// Vapour is water, too, once it has left its place: q is the flux of both (Vapour::gather).
  /// DEPARTS [Ding19 Eq. 19]: printed with gains shared by the water that is there, so that dry dough stays dry for ever.
  /// DEPARTS [Ding19 Eq. 20]: the volume is that of the new time; with the old one and the printed div v term in (25) half
  /// of the water is gone at doubled volume.
  BAKE_INLINE static void gather(auto& p, const auto& from, const auto& k, const auto& step, auto& report) {
    using P = std::decay_t<decltype(p)>;
    const auto room = k.rho_w * p.volume_before();
    const auto gained = p[field::m_w] * from.value(channel::water_loss) + room * from.value(channel::water_gain);
    p[field::m_w] += gained;
    p[field::m_w_lent] = Heat::evened_out(diffusivity(p, k), k.subgrid, step) * (room * from.value(channel::saturation) - p[field::m_w]);
    p[field::m_w] += p[field::m_w_lent];
    p[field::w_spread] += step.baking_dt * k.K * clamped_temperature(p);
    if constexpr (P::template has<field::Temperature>)
      report.book(booked::remap_heat, k.heat * gained * (p[field::theta] - p[field::theta_lent]));
    if constexpr (P::template has<field::Velocity>)
      for (int d = 0; d < 3; ++d) report.book(booked::remap_momentum, k.inertia * gained * p[field::v][d], d);
    const auto flux = (-k.K) * clamped_temperature(p) * p[field::m_w] / p.volume();
    for (int d = 0; d < 3; ++d) p[field::q][d] = flux * from.gradient(channel::saturation, 0, d);
    if constexpr (P::template has<field::VapourFlux>)
      for (int d = 0; d < 3; ++d) p[field::q][d] += p[field::j_v][d];
  }

  /// - J c_hat (s - s_0) I   [Ding19 Eq. 14]
  BAKE_INLINE static void stress(auto& p, const auto& k) {
    if constexpr (std::decay_t<decltype(p)>::template has<field::KirchhoffStress>) {
      const auto pressure = k.c_hat * (p[field::m_w] / (k.rho_w * p[field::V_0]) - k.s_0 * p[field::J]);
      for (int i = 0; i < 3; ++i) p[field::tau][i] -= pressure;
      p.stiffness += (k.c_hat * k.s_0) * p[field::J];
    }
  }

  /// Flux V D^-1 w (r . q).   [Ding19 Eq. 25]
  BAKE_INLINE static void scatter(auto& p, auto& to, const auto& k, const auto& step, auto&) {
    const auto moment = (step.baking_dt_next * step.inverse_d) * p.volume();
    to.value(channel::water_mass) += p[field::m_w];
    to.value(channel::water_capacity) += k.rho_w * p.volume();
    to.value(channel::evaporability) += k.beta_w * clamped_temperature(p) * p.volume();
    to.value(channel::permeability) += k.rho_w * k.K * clamped_temperature(p) * p.volume();
    to.value(channel::water_spread) += p.volume() * p[field::w_spread];
    to.value(channel::water_change) -= p[field::m_w_lent];
    for (int j = 0; j < 3; ++j) to.moment(channel::water_change, 0, j) += moment * p[field::q][j];
  }

  BAKE_INLINE static void bounds(auto& p, const auto& k, const auto&, auto& report) {
    report.bound(bound::water_diffusivity, diffusivity(p, k));
  }

  /// As forward Euler's of heat.
  static void largest_step(const auto& most, const StepScale& at, const auto&, StepLimit& limit) {
    limit_diffusion(most(bound::water_diffusivity), at, limit, "water diffusion");
  }

  /// How deep a layer resists while drying has not gone as deep as the nodes are. In tau, the integral of K theta dt, and with h = beta_w /
  /// (rho K), the half-space that dries into dry air, s_tau = (s s_x)_x with s s_x = h s at its surface, is one problem for all dough and
  /// every course of its temperature. So d = (s_i^2 - s^2) / (2 h s) of its solution is sqrt(s_i tau) times a function of h^2 tau / s_i
  /// alone. That begins with 2 / sqrt(pi), a constant flux, and ends with 1 / (2 * 0.33206), a dry surface. Between, finite volumes give
  /// the form below within 0.6 %.
  template <class V>
  BAKE_INLINE static V reach(V s_i, V spread, V h) {
    using Real = std::decay_t<decltype(h[0])>;
    constexpr double k_first = 2 * std::numbers::inv_sqrtpi, k_last = 1 / (2 * 0.33206), k_half_way = 2.15;
    const V z = h * h * spread, dried = z / (z + Real(k_half_way) * s_i + std::numeric_limits<Real>::min());
    return sqrt(s_i * spread) * (Real(k_first) + Real(k_last - k_first) * dried);
  }

  /// s at the surface, where as much evaporates as comes through the layer of depth d between the nodes and the surface:
  ///     rho K theta (s_i^2 - s^2) / (2 d) = beta_w theta (s - s_out),
  /// d being that of the nodes, or `reach` before drying has gone so deep; s_out where nothing comes. `evaporability`: V beta_w theta;
  /// `permeability`: V rho K theta.
  template <class V, class Real>
  BAKE_INLINE static V surface_saturation(V s_i, V s_out, V evaporability, V permeability, V reach, const SurfaceLayer<Real>& layer) {
    const V e = layer.dx * evaporability, tiny = 0 * e + std::numeric_limits<Real>::min();
    const V d = min(layer.dx * layer.depth(e / (e + permeability * s_i + tiny)), reach), resisted = 2 * d * evaporability;
    const V a = permeability < Real(1e12) * resisted ? permeability / resisted : Real(1e12) + 0 * e;
    const V b = s_out + a * s_i * s_i;
    const V s = permeability > 0 ? 2 * b / (1 + sqrt(1 + 4 * a * b)) : s_out;  // the root of a s^2 + s = b, without cancellation
    return layer.dx > 0 ? s : s_i;
  }

  /// m_i += flux - evaporation, never below zero.
  BAKE_INLINE static void update(auto& node, const auto& k, const auto& step, auto& budget) {
    const auto m = node[channel::water_mass], none = 0 * m;
    const auto capacity = node[channel::water_capacity];
    const auto filled = capacity > 0;
    const auto& around = node.surroundings;
    // beta_w theta of the node times its free area: (w V beta_w theta) / (w V) * area
    const auto rate =
        node[channel::volume] > 0 ? step.baking_dt * around.area * node[channel::evaporability] / node[channel::volume] : none;
    const auto flux = node[channel::water_change];
    const auto after_flux = m + flux;
    const auto s_i = filled ? m / capacity : none;
    const auto permeability = node[channel::permeability];
    // to the end of the step
    const auto spread = filled ? node[channel::water_spread] / node[channel::volume] + step.baking_dt * permeability / capacity : none;
    const auto h = permeability > 0 ? node[channel::evaporability] / permeability : none;
    const auto s = surface_saturation(s_i, around.saturation, node[channel::evaporability], permeability, reach(s_i, spread, h), k.layer);
    auto wanted = filled ? rate * (s - around.saturation) : none;
    if constexpr (std::decay_t<decltype(node)>::template scatters<channel::VapourMobility>)
      wanted += filled ? step.baking_dt * around.area * pore_vapour::through_surface(node, k.layer) : none;
    const auto evaporated = min(wanted, max(after_flux, none));
    const auto kept = max(after_flux - evaporated, none);
    budget.book(booked::evaporated, evaporated);
    budget.book(booked::water_limited, filled ? kept - (after_flux - evaporated) : none);
    const auto moved = filled ? kept - m : none;
    node.sums.moved = moved;
    node.sums.evaporated = evaporated;
    if constexpr (std::decay_t<decltype(node)>::template scatters<channel::HeatContent>) {
      const auto latent = k.latent_heat * evaporated;
      node.sums.heat_taken = latent;
      budget.book(booked::latent_heat, latent);
    }
    const auto by_water = k.published ? moved : min(moved, none);
    node.out(channel::water_loss) = (filled & (m > 0)) ? by_water / m : none;
    node.out(channel::water_gain) = (filled & !k.published) ? max(moved, none) / capacity : none;
    node.out(channel::saturation) = filled ? (m + moved) / capacity : none;
  }

  static void totals(auto& p, const auto& k, const auto&, auto& report) {
    report.add(total::water_mass, p[field::m_w] - p[field::m_w_lent]);
    report.add(total::water_overfull, max(p[field::m_w] - k.rho_w * p.volume(), 0 * p[field::m_w]));
  }

  static void show(auto& frame) {
    frame.stored(field::m_w);
    frame.made("saturation", "1", "s: share of the volume that is water", [](const auto& material) {
      const double rho_w = material.effects.template get<Material>().water_density_kg_per_m3;
      return [rho_w](const auto& p) { return p[field::m_w] / (rho_w * p.volume()); };
    });
  }

  /// Something must be left for the solid. Vapour needs heat that it carries, and the temperatures of both ends of a step.
  static void check_material(const auto& scene, const auto& material, const Material& own, const auto& complaint) {
    if (scene.lists(name) && own.has_vapour()) check_vapour(scene, own, complaint);
    const double water = material.initial_saturation * own.water_density_kg_per_m3;
    if (scene.lists(name) && material.initial_porosity + material.initial_saturation > 1)
      complaint.at("initial_saturation", "found {} of the volume water and {} gas (initial_porosity), allowed: together at most 1",
                   material.initial_saturation, material.initial_porosity);
    if (!scene.lists(name) || water < material.density_kg_per_m3) return;
    complaint.at("initial_saturation", "found {} kg/m^3 of water in a mixture of {} kg/m^3, allowed: less water than mixture", water,
                 material.density_kg_per_m3);
  }

  static void check_vapour(const auto& scene, const Material& own, const auto& complaint) {
    const char* key = own.vapour_diffusivity_m2_per_s > 0 ? "vapour_diffusivity_m2_per_s" : "vapour_transfer_m_per_s";
    if (own.vapour_diffusivity_m2_per_s == 0) complaint.at(key, "found without vapour_diffusivity_m2_per_s, allowed: with it, above 0");
    if (!scene.lists(Heat::name)) complaint.at(key, "found without the effect heat, allowed: with it, since vapour carries heat");
    if (scene.template of<Water>().latent_heat_J_per_kg == 0)
      complaint.at(key, "found beside water.latent_heat_J_per_kg = 0, allowed: above 0 (water: 2.3e6)");
    if (scene.template of<Water>().form == Form::published)
      complaint.at(key, "found beside water.form = 'published', allowed: beside the standard form");
    if (scene.template of<Heat>().integrator == Heat::Integrator::backward_euler)
      complaint.at(key, "found beside heat.integrator = 'backward_euler', allowed: beside 'forward_euler'");
  }

  static bool swells(const Material& own) { return own.pressure_Pa > 0; }
  /// Can evaporation cool?
  static bool cools(const auto& scene, const Material& own) {
    return scene.template of<Water>().latent_heat_J_per_kg > 0 && (own.evaporation_kg_per_m2sK > 0 || own.has_vapour());
  }
  static std::string idle(const auto& here) {
    const bool acts = here.any(here.materials, [](const auto* m) {
      const auto& own = m->effects.template get<Material>();
      return own.diffusivity_m2_per_sK > 0 || own.pressure_Pa > 0 || own.has_vapour();
    });
    return acts ? ""
                : "diffusivity_m2_per_sK and pressure_Pa are zero: no water comes to the surface, it only counts as mass and heat capacity";
  }
  static const char* coefficient(const Material& own) {
    if (own.diffusivity_m2_per_sK > 0) return "diffusivity_m2_per_sK";
    if (own.evaporation_kg_per_m2sK > 0) return "evaporation_kg_per_m2sK";
    return own.pressure_Pa > 0 ? "pressure_Pa" : own.vapour_diffusivity_m2_per_s > 0 ? "vapour_diffusivity_m2_per_s" : "";
  }
};

}  // namespace bake
