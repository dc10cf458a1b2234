// SPDX-License-Identifier: MIT
// Bounded energy, as one inequality for every hard case:
//
//     kinetic + elastic + dissipated  <=  what of these was there + work of gravity + work of the pressures + work of what is scripted
//
// Nothing else can give: walls at rest do no work, or take some by friction and by stopping what hits them; APIC's transfers keep or lose
// kinetic energy (with its affine part), never make it; vapour takes its own along. The works are not in the ledger. They are summed here,
// step by step, from the states that the particles pass through: gravity's m g . v dt, and V_0 pi d(ln J) for pore gas and water, which act
// as pressures pi(J, theta, nu, m_w); these laws are written here once more. A step's forces are those of the state before it, and their
// work is done along the mean of the velocities before and after it. Warming a solid whose strain is held strains it as well: the energy
// of its stress, K/2 (tr epsilon - 3 alpha_l (theta - theta_0))^2 + ..., takes -V_0 beta_T (tr epsilon - ...) d theta from the heat.
// Of the elastic stress the same would hold; its energy instead is that of the strain, half a step later: to and fro by omega dt / 2 of
// what swings at the frequency omega, nothing for good. `k_slack` of all that was exchanged is for that.
#pragma once

#include <gtest/gtest.h>

#include "solver/effects/all_effects.h"
#include "solver/effects/fields.h"
#include "tests/conservation/dough.h"

namespace bake {

class Work {
 public:
  Work(const Scene& scene, const Simulation& s) : scene_(&scene), last_(states(s)), time_(s.time()) {}

  /// After each step.
  void add(const Simulation& s) {
    auto now = states(s);
    const double dt = s.time() - time_;
    const Vector3 g = gravity(s.time());
    time_ = s.time();
    for (std::size_t i = 0; i < last_.size(); ++i) {  // in the order of their identities; none leaves, and what is poured comes last
      const State& before = last_[i];
      State& p = now.at(i);
      p.v = (1 / dt) * (p.x - before.x), p.swelling = std::log(p.J / before.J) / dt;
      const Vector3 v = first_ ? p.v : 0.5 * (p.v + before.v);
      const double swelling = first_ ? p.swelling : (p.swelling + before.swelling) / 2;
      const double lift = dt * before.mass * dot(g, v), push = dt * before.V_0 * before.pressure * swelling,
                   warming = 0.5 * (before.thermal_pressure + p.thermal_pressure) * p.V_0 * (p.thermal_strain - before.thermal_strain);
      given_ += lift + push + warming;
      exchanged_ += std::abs(lift) + std::abs(push) + std::abs(warming);
    }
    first_ = false;
    last_ = std::move(now);
  }

  double given() const { return given_; }          ///< [J]
  double exchanged() const { return exchanged_; }  ///< all of it, to and fro [J]

 private:
  struct State {
    Vector3 x, v = {0, 0, 0};                         ///< v and swelling, d(ln J)/dt, are those of the step that led here
    double swelling = 0;                              ///< [1/s]
    double mass, V_0, J, pressure;                    ///< pi, the negative of the Kirchhoff stress that gas and water add [Pa]
    double thermal_strain = 0, thermal_pressure = 0;  ///< 3 alpha_l (theta - theta_0), and K of it less tr epsilon [Pa]
  };

  /// Its mean until `time`.
  Vector3 gravity(double time) const {
    return scene_->lists("motion") ? scene_->of<Motion>().gravity_m_per_s2.mean(time_, time) : Vector3{0, 0, 0};
  }

  double pressure(const Material& material, double V_0, double J, double theta, double nu, double water) const {
    constexpr double R = 8.314, k_atmosphere = 101325, k_zero = 273.15;
    double pi = 0;
    if (scene_->lists("leavening")) {
      const double p_ref = scene_->of<Leavening>().reference_pressure_Pa, n_0 = material.initial_porosity;
      const double nu_0 = p_ref * n_0 / (R * (material.initial_temperature_C + k_zero));
      const double pores = std::clamp(J - (1 - n_0), std::min(0.02, n_0 / 2) * J, std::max(0.97, n_0) * J);
      pi += J * ((nu_0 + p_ref / k_atmosphere * nu) * R * (theta + k_zero) / pores - p_ref);
    }
    if (scene_->lists("water")) {
      const Water::Material& w = of<Water>(material);
      pi += w.pressure_Pa * (water / (w.water_density_kg_per_m3 * V_0) - material.initial_saturation * J);
    }
    return pi;
  }

  std::vector<State> states(const Simulation& s) const {
    const Snapshot now = s.snapshot();
    const auto column = [&](const char* effect, const char* name) { return scene_->lists(effect) ? &now[name] : nullptr; };
    const auto *J = column("motion", field::VolumeRatio::name), *theta = column("heat", field::Temperature::name),
               *nu = column("leavening", field::ProducedGas::name), *water = column("water", field::WaterMass::name);
    const auto* strain = column("elasticity", field::ElasticStrain::name);
    const auto &V_0 = now[field::InitialVolume::name], &solid = now[field::SolidMass::name];
    std::vector<State> all;
    all.reserve(now.id.size());
    for (std::size_t i = 0; i < now.id.size(); ++i) {
      const auto of_it = [&](const auto* values, double otherwise) { return values ? (*values)[i] : otherwise; };
      const double m_w = of_it(water, 0), ratio = of_it(J, 1);
      const Material& material = scene_->materials[static_cast<std::size_t>(now.material[i])];
      const double pi = pressure(material, V_0[i], ratio, of_it(theta, material.initial_temperature_C), of_it(nu, 0), m_w);
      all.push_back({.x = now.position[i], .mass = solid[i] + m_w, .V_0 = V_0[i], .J = ratio, .pressure = pi});
      if (!theta || !strain) continue;
      const Elasticity::Material& e = of<Elasticity>(material);
      const double bulk = e.young_modulus_Pa / (3 * (1 - 2 * e.poisson_ratio));
      const double* b = &(*strain)[6 * i];  // less I
      const double det = (1 + b[0]) * ((1 + b[1]) * (1 + b[2]) - b[3] * b[3]) - b[5] * (b[5] * (1 + b[2]) - b[3] * b[4]) +
                         b[4] * (b[5] * b[3] - (1 + b[1]) * b[4]);
      all.back().thermal_strain = 3 * of<Heat>(material).expansion_per_K * ((*theta)[i] - material.initial_temperature_C);
      all.back().thermal_pressure = bulk * (all.back().thermal_strain - 0.5 * std::log(det));
    }
    return all;
  }

  const Scene* scene_;
  std::vector<State> last_;
  double time_;
  bool first_ = true;  ///< step; of what came before it nothing is known
  double given_ = 0, exchanged_ = 0;
};

/// `scripted` [m/s]: the fastest collider or grip, whose work nobody sums. What it hits flies off at no more than twice its speed, if all
/// is elastic: that bounds what it can have added to the kinetic energy, while it strains and works the dough as far as it goes.
inline void expect_bounded_energy(const Sums& start, const Sums& now, const Work& work, double scripted) {
  constexpr double k_slack = 0.1;                 // measured: 0.05 in eight steps from the freezer to 400 C, else at most 0.02
  const double round_off = 1e-12 * start.mass();  // the square of a speed of 1e-6 m/s
  EXPECT_GE(now.kinetic, 0);
  EXPECT_GE(now.elastic, 0);
  EXPECT_GE(now.dissipated, start.dissipated);
  const double before = start.kinetic + start.elastic, pushed = 2 * start.mass() * scripted * scripted;
  const double stored = scripted > 0 ? 0 : now.elastic + now.dissipated - start.dissipated;
  EXPECT_LE(now.kinetic + stored, before + work.given() + pushed + k_slack * (before + work.exchanged()) + round_off)
      << "energy came from nowhere";
}

}  // namespace bake
