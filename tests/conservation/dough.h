// SPDX-License-Identifier: MIT
// A lump of dough for tests: steps of one length, and the ledger's sums by name.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <memory>
#include <string>

#include "solver/run/simulation.h"
#include "solver/scene/scene_builder.h"

namespace bake {

/// The default is an elastic ball at rest in the middle of a box, four cells in radius, without gravity.
struct Dough : SceneBuilder {
  Dough() {
    effects = "motion, elasticity";
    dx = 0.0625;  // a power of two: node positions are exact
    frame_s = 1e-3;
    shape = "sphere = { radius_m = 0.25 }";
    material = properties();
    heat = "water_specific_heat_J_per_kgK = 40";
    leavening = "reference_pressure_Pa = 4000";  // soft pores
  }
  std::unique_ptr<Simulation> begin() const { return Simulation::begin(scene()); }

  /// Table 2's bread, softer and slower where that saves steps. `extra` comes on top; nothing may be given twice.
  static std::string properties(const std::string& water = "", const std::string& extra = "") {
    return R"(
density_kg_per_m3 = 500
young_modulus_Pa = 2e4
initial_saturation = 0.2
initial_porosity = 0.2
initial_temperature_C = 20
specific_heat_J_per_kgK = 20
conductivity_W_per_mK = 100
expansion_per_K = 1e-4
yield_stress_Pa = [200, 200, 150, 400]
viscosity_Pa_s = [50, 50, 40, 40]
temperatures_C = [4, 20, 60, 85]
pressure_Pa = 300
production_mol_per_kgs = 0.3
)" + water +
           "\n" + extra;
  }
  static std::string moving_water() { return "diffusivity_m2_per_sK = 2e-4\nevaporation_kg_per_m2sK = 0.5"; }
};

inline constexpr const char* k_flip = "transfer = \"flip\"";
inline constexpr const char* k_pic = "transfer = \"pic\"";

/// `count` steps of exactly `dt`, each sampled; calls visit() after each.
template <class Visit>
void take_steps(Simulation& s, int count, double dt, Visit visit) {
  for (int i = 0; i < count; ++i) {
    const std::int64_t before = s.counters().steps;
    const double target = s.time() + dt;
    ASSERT_TRUE(s.advance(target, target + dt));
    ASSERT_EQ(s.counters().steps, before + 1) << "the step was cut: choose a smaller one";
    visit();
    if (testing::Test::HasFatalFailure()) return;
  }
}
inline void take_steps(Simulation& s, int count, double dt) {
  take_steps(s, count, dt, [] {});
}

/// The ledger's sums at the last sample.
struct Sums {
  double solid, water, heat, gas, volume, kinetic, elastic;
  Vector3 momentum, angular;
  double evaporated, exchanged, latent, vapour_heat, remapped_heat, expansion, dissipated, limited;
  Vector3 impulse, twist, remapped;

  explicit Sums(const Simulation& s) {
    read(s.totals());
    const auto booked = [&](Entry e) { return s.booked()[static_cast<std::size_t>(e)]; };
    evaporated = booked(Entry::evaporated), exchanged = booked(Entry::exchanged), latent = booked(Entry::latent);
    expansion = booked(Entry::expansion), dissipated = booked(Entry::dissipated), limited = booked(Entry::water_limited);
    impulse = {booked(Entry::impulse_x), booked(Entry::impulse_y), booked(Entry::impulse_z)};
    twist = {booked(Entry::twist_x), booked(Entry::twist_y), booked(Entry::twist_z)};
    vapour_heat = booked(Entry::vapour_heat), remapped_heat = booked(Entry::remapped_heat);
    remapped = {booked(Entry::remapped_x), booked(Entry::remapped_y), booked(Entry::remapped_z)};
  }
  explicit Sums(const Totals& totals) { read(totals); }
  double mass() const { return solid + water; }
  /// All the heat that was booked as coming in.
  double heat_gained() const { return exchanged - latent - vapour_heat + remapped_heat - expansion; }

 private:
  void read(const Totals& totals) {
    const auto total = [&](Total t) { return totals[static_cast<std::size_t>(t)]; };
    solid = total(Total::solid_mass), water = total(Total::water_mass), heat = total(Total::heat_content), gas = total(Total::gas);
    volume = total(Total::volume), kinetic = total(Total::kinetic), elastic = total(Total::elastic);
    momentum = {total(Total::momentum_x), total(Total::momentum_y), total(Total::momentum_z)};
    angular = {total(Total::angular_x), total(Total::angular_y), total(Total::angular_z)};
  }
};

/// Relative error that one step may add to a sum that is kept to round-off. Double: the project's promise. Single: a sum passes
/// through about 64 roundings a step (weights, at most 27 terms of a gather, as many of a scatter, the quotient), each of half
/// an epsilon, all taken with the same sign.
inline double round_off(const std::string& precision) { return precision == "double" ? 1e-12 : 32 * 1.19e-7; }

}  // namespace bake
