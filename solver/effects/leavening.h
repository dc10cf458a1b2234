// SPDX-License-Identifier: MIT
// Leavening: CO2 made by a temperature-dependent reaction, and the pressure of the gas in the pores. [Ding19 Sec. 5.4]
#pragma once

#include <algorithm>
#include <string>

#include "solver/core/parameter.h"
#include "solver/effects/effect.h"
#include "solver/effects/form.h"
#include "solver/effects/plasticity.h"

namespace bake {

namespace total {
BAKE_FIELD(gas, Gas, 1, "gas", "mol", "CO2 that was made, in true moles; the air that the pores hold from the start is not counted");
}  // namespace total

struct Leavening : Effect {
  static constexpr const char* name = "leavening";
  static constexpr const char* meaning = "leavener makes CO2 when warm; the gas in the pores pushes against the atmosphere";

  static constexpr std::array needs{"plasticity", "heat"};

  /// What happens where pores are pulled wider than their gas fills them at the atmosphere's pressure.
  enum class Pores { closed, open };
  friend constexpr auto choice_names(Pores) { return std::array{"closed", "open"}; }

  struct Settings {
    Form form = Form::standard;
    Pores pores = Pores::closed;
    double reference_pressure_Pa = 101325;
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"form", &Settings::form, "", any_number,
                    "pore gas against the atmosphere (standard) or [Ding19 Eq. 13] as printed (published)"},
          Parameter{"pores", &Settings::pores, "", any_number,
                    "pores pulled wider than their gas fills: \"closed\", a vacuum pulls back; \"open\", air enters (form = \"standard\")"},
          Parameter{
              "reference_pressure_Pa", &Settings::reference_pressure_Pa, "Pa", positive,
              "p_ref: pressure of the atmosphere; the pores' gas counts p_ref / 101325 of its moles by itself, so that a lower one keeps "
              "the volume of equilibrium and softens the pores (larger steps)"},
      };
    }
  };
  struct Material {
    double production_mol_per_kgs = 0;
    double peak_temperature_C = 40;
    double temperature_width_K = 20;
    double leavener_mol_per_m3 = k_infinity;
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"production_mol_per_kgs", &Material::production_mol_per_kgs, "mol/(kg s)", non_negative,
                    "alpha_g: CO2 made per mass and time at the peak"},
          Parameter{"peak_temperature_C", &Material::peak_temperature_C, "C", above_absolute_zero,
                    "theta_r: temperature of the fastest reaction"},
          Parameter{"temperature_width_K", &Material::temperature_width_K, "K", positive,
                    "Delta theta: width of the reaction's bell curve"},
          Parameter{"leavener_mol_per_m3", &Material::leavener_mol_per_m3, "mol/m^3", positive_or_infinite,
                    "total CO2 that the leavener can make, per initial volume; inf is the paper's unlimited supply"},
      };
    }
  };

  static constexpr double k_gas_constant = 8.314;  ///< R [J/(mol K)]

  using Stored = FieldList<field::ProducedGas, field::Leavener>;
  using Totals = FieldList<total::Gas>;

  template <class Real>
  struct Constants {
    Real peak_rate, theta_r, inverse_width, total, n_0, nu_0, p_ref, scale;
    Real least, most;  ///< between which the pore fraction is held; n_0 lies between them, so that fresh dough is free of stress
    bool finite, published, published_porosity, open;
    template <class Scene, class SceneMaterial>
    Constants(const Scene& scene, const SceneMaterial& material) {
      const auto& m = material.effects.template get<Material>();
      const auto& settings = scene.settings.template get<Settings>();
      peak_rate = static_cast<Real>(m.production_mol_per_kgs * material.density_kg_per_m3);
      theta_r = static_cast<Real>(m.peak_temperature_C);
      inverse_width = static_cast<Real>(1 / m.temperature_width_K);
      finite = m.leavener_mol_per_m3 < k_infinity;
      total = finite ? static_cast<Real>(m.leavener_mol_per_m3) : Real(1);
      n_0 = static_cast<Real>(material.initial_porosity);
      least = std::min(Real(0.02), n_0 / 2);
      most = std::max(Real(0.97), n_0);
      p_ref = static_cast<Real>(settings.reference_pressure_Pa);
      scale = static_cast<Real>(settings.reference_pressure_Pa / 101325);
      nu_0 = static_cast<Real>(settings.reference_pressure_Pa * material.initial_porosity /
                               (k_gas_constant * (material.initial_temperature_C + 273.15)));
      published = settings.form == Form::published;
      open = settings.pores == Pores::open;
      published_porosity = scene.settings.template get<Plasticity::Settings>().porosity_form == Form::published;
    }
  };

  static void fill(auto& p, int lane, const auto& start) {
    p[field::nu][lane] = 0;
    p[field::c][lane] = static_cast<typename std::decay_t<decltype(p)>::Real>(start.leavener);
  }

  /// d nu/dt = alpha_g R_0 exp(-((theta - theta_r)/Delta theta)^2)   [Ding19 Sec. 5.4]
  template <class V, class K>
  BAKE_INLINE static V rate(V theta, const K& k) {
    const V g = (theta - k.theta_r) * k.inverse_width;
    return k.peak_rate * exp(-g * g);
  }

  /// DEPARTS [Ding19 Sec. 5.4]: leavener runs out when its total is given: dc/dt = -(rate / total) c, implicit in c, so that
  /// nu + total c is kept to round-off.
  BAKE_INLINE static void gather(auto& p, const auto&, const auto& k, const auto& step, auto&) {
    const auto wanted = step.baking_dt * rate(p[field::theta], k);
    if (k.finite) {
      const auto z = wanted * (1 / k.total);
      const auto spent = p[field::c] * z / (1 + z);
      p[field::c] -= spent;
      p[field::nu] += k.total * spent;
    } else {
      p[field::nu] += wanted * p[field::c];
    }
  }

  /// - J [(nu_0 + nu) R theta_K / (J n) - p_ref] I with J n = J - (1 - n_0): all pore gas, against the atmosphere.
  /// Open pores hold no vacuum: crust and crumb are full of broken walls, so that air follows where they are torn apart.
  /// DEPARTS [Ding19 Eq. 13]: as printed only the CO2 counts, theta is not absolute and nothing pushes back.
  BAKE_INLINE static void stress(auto& p, const auto& k) {
    using P = std::decay_t<decltype(p)>;
    using V = typename P::V;
    using Real = typename P::Real;
    const V J = p[field::J];
    if (k.published) {
      const V n = k.published_porosity ? p[field::J_P] - 1 + k.n_0 : 1 - (1 - k.n_0) / p[field::J_P];
      const V moles = Real(k_gas_constant) * p[field::nu] * p[field::theta] / clamp(n, lanes<Real>(k.least), lanes<Real>(k.most));
      for (int i = 0; i < 3; ++i) p[field::tau][i] -= moles;
      p.stiffness += abs(moles);
      return;
    }
    const V pores = clamp(J - (1 - k.n_0), k.least * J, k.most * J);
    const V moles = Real(k_gas_constant) * (k.nu_0 + k.scale * p[field::nu]) * (p[field::theta] + Real(273.15));
    V pressure = J * (moles / pores - k.p_ref);
    if (k.open) pressure = max(pressure, 0 * pressure);
    for (int i = 0; i < 3; ++i) p[field::tau][i] -= pressure;
    p.stiffness += J * J * moles / (pores * pores);
  }

  static void totals(auto& p, const auto&, const auto&, auto& report) { report.add(total::gas, p[field::V_0] * p[field::nu]); }

  static void show(auto& frame) {
    frame.stored(field::nu);
    frame.stored(field::c);
  }

  static void check_settings(const Settings& settings, const auto& complaint) {
    if (settings.pores == Pores::open && settings.form == Form::published)
      complaint.at("pores", "found \"open\", allowed: \"closed\" with form = \"published\", which knows no atmosphere");
  }

  static bool swells(const Material&) { return true; }
  static std::string idle(const auto& here) {
    const bool makes =
        here.any(here.materials, [](const auto* m) { return m->effects.template get<Material>().production_mol_per_kgs > 0; });
    const bool has_any = !here.scene.emitters.empty() || here.any(here.scene.bodies, [](const auto& b) { return b.leavener > 0; });
    if (!makes) return "production_mol_per_kgs is zero: no gas is made, only the air of the pores pushes";
    return has_any ? "" : "leavener is zero in every body: no gas is made, only the air of the pores pushes";
  }
  static const char* coefficient(const Material& own) { return own.production_mol_per_kgs > 0 ? "production_mol_per_kgs" : ""; }
};

}  // namespace bake
