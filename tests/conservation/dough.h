// SPDX-License-Identifier: MIT
// A lump of dough for tests: steps of one length, and the ledger's sums by name.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <memory>
#include <string>
#include <type_traits>

#include "solver/effects/all_effects.h"
#include "solver/engine/sheets.h"
#include "solver/run/ledger.h"
#include "solver/run/simulation.h"
#include "solver/scene/scene_builder.h"

namespace bake {

/// The default is an elastic ball at rest in the middle of a box, four cells in radius, without gravity.
struct Dough : SceneBuilder {
  explicit Dough(const std::string& listed = "motion, elasticity") {
    effects = listed;
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
  /// The same with some keys given other values.
  static std::string changed(std::initializer_list<std::pair<const char*, const char*>> keys, const std::string& water = "") {
    std::string text = properties(water);
    for (const auto& [key, value] : keys) {
      const std::size_t at = text.find(std::string("\n") + key + " = ");
      const std::string line = std::string("\n") + key + " = " + value;
      if (at == std::string::npos)
        text += line + "\n";
      else
        text.replace(at, text.find('\n', at + 1) - at, line);
    }
    return text;
  }
  static std::string moving_water() { return "diffusivity_m2_per_sK = 2e-4\nevaporation_kg_per_m2sK = 0.5"; }
};

inline constexpr const char* k_flip = "transfer = \"flip\"";
inline constexpr const char* k_pic = "transfer = \"pic\"";

/// The ledger's sums at the last sample; elastic energy is that of the dough and its skin.
struct Sums {
  double solid, water, heat, gas, volume, kinetic, elastic;
  Vector3 momentum, angular;
  double evaporated = 0, exchanged = 0, latent = 0, vapour_heat = 0, remapped_heat = 0, expansion = 0, dissipated = 0, limited = 0;
  Vector3 impulse{}, angular_impulse{}, remapped{};

  explicit Sums(const Simulation& s) {
    read([&](auto q, int i = 0) { return s.total(q, i); });
    elastic += s.skin_sums().membrane + s.skin_sums().bending;
    const auto vector = [&](auto q) { return Vector3{s.booked(q, 0), s.booked(q, 1), s.booked(q, 2)}; };
    evaporated = s.booked(booked::evaporated), limited = s.booked(booked::water_limited), dissipated = s.booked(booked::dissipated);
    exchanged = s.booked(booked::heat_exchanged), latent = s.booked(booked::latent_heat), expansion = s.booked(booked::expansion_heat);
    vapour_heat = s.booked(booked::vapour_heat), remapped_heat = s.booked(booked::remap_heat);
    impulse = vector(booked::impulse), angular_impulse = vector(booked::angular_impulse), remapped = vector(booked::remap_momentum);
  }
  /// Of the particles that left, and of those that were poured.
  static Sums retired(const Simulation& s) {
    return Sums([&](auto q, int i = 0) { return s.retired(q, i); });
  }
  static Sums emitted(const Simulation& s) {
    return Sums([&](auto q, int i = 0) { return s.emitted(q, i); });
  }
  double mass() const { return solid + water; }
  /// All the heat that was booked as coming in.
  double heat_gained() const { return exchanged - latent - vapour_heat + remapped_heat - expansion; }

 private:
  template <class Sum>
  explicit Sums(Sum sum) {
    read(sum);
  }
  template <class Sum>
  void read(Sum sum) {
    const auto vector = [&](auto q) { return Vector3{sum(q, 0), sum(q, 1), sum(q, 2)}; };
    solid = sum(total::solid_mass), water = sum(total::water_mass), heat = sum(total::heat_content), gas = sum(total::gas);
    volume = sum(total::volume), kinetic = sum(total::kinetic), elastic = sum(total::elastic);
    momentum = vector(total::momentum), angular = vector(total::angular_momentum);
  }
};

/// `count` steps of exactly `dt`, each sampled; calls visit() after each, or visit(step, sums), the first being step 1.
template <class Visit>
void take_steps(Simulation& s, int count, double dt, Visit visit) {
  for (int step = 1; step <= count; ++step) {
    const std::int64_t before = s.counters().steps;
    const double target = s.time() + dt;
    ASSERT_TRUE(s.advance(target, target + dt));
    ASSERT_EQ(s.counters().steps, before + 1) << "the step was cut: choose a smaller one";
    if constexpr (std::is_invocable_v<Visit>)
      visit();
    else
      visit(step, Sums(s));
    if (testing::Test::HasFatalFailure()) return;
  }
}
inline void take_steps(Simulation& s, int count, double dt) {
  take_steps(s, count, dt, [] {});
}

/// Relative error that one step may add to a sum that is kept to round-off. Double: the project's promise. Single: a sum passes
/// through about 64 roundings a step (weights, at most 27 terms of a gather, as many of a scatter, the quotient), each of half
/// an epsilon, all taken with the same sign.
inline double round_off(const std::string& precision) { return precision == "double" ? 1e-12 : 32 * 1.19e-7; }

}  // namespace bake
