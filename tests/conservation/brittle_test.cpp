// SPDX-License-Identifier: MIT
// Set dough with a fracture energy: what it costs to break it.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "tests/conservation/dough.h"

namespace bake {
namespace {

constexpr double k_energy = 2.75;  // [J/m^2]

/// A bar 0.2 m long and two cells thick (its mirror images included), with a flaw one cell wide; two grips move by `pull` in 0.8 s.
Dough bar(double dx, double pull, double theta_4 = 4) {
  Dough dough("motion, elasticity, plasticity");
  dough.dx = dx;
  dough.low = {-0.24, 0, 0}, dough.high = {0.24, 6 * dx, 6 * dx};
  dough.faces = "y_min = \"slip\"\nz_min = \"slip\"";
  dough.heat = "", dough.leavening = "";
  const auto material = [&](double yield_stress_Pa) {
    return fmt::format(
        "density_kg_per_m3 = 500\nyoung_modulus_Pa = 4e4\ninitial_porosity = 0.01\ninitial_temperature_C = 20\n"
        "temperatures_C = [1, 2, 3, {}]\nyield_stress_Pa = {}\nfracture_energy_J_per_m2 = {}\n",
        theta_4, yield_stress_Pa, k_energy);
  };
  const auto box = [&](double half_length) {
    return fmt::format("box = {{ centre_m = [0, {0}, {0}], half_extents_m = [{1}, {0}, {0}] }}", dx / 2, half_length);
  };
  dough.material = material(1000);
  dough.shape = fmt::format("difference = [ {{ {} }}, {{ {} }} ]", box(0.1), box(dx / 2));
  dough.tables = "[[material]]\nname = \"flaw\"\n" + material(900);
  dough.tables += fmt::format("[[body]]\nmaterial = \"flaw\"\nparticles_per_cell = 8\nshape = {{ {} }}\n", box(dx / 2));
  for (const int side : {-1, 1})
    dough.tables += fmt::format(
        "[[grip]]\nshape = {{ box = {{ centre_m = [{}, 0, 0], half_extents_m = [0.04, 0.3, 0.3] }} }}\n"
        "motion = [{{ time_s = 0 }}, {{ time_s = 0.8, position_m = [{}, 0, 0] }}]\n",
        side * 0.1, side * pull);
  return dough;
}

std::vector<double> broken_of(const Simulation& s) { return s.snapshot()["broken"]; }
double mean_broken(const Simulation& s) {
  const std::vector<double> broken = broken_of(s);
  return std::accumulate(broken.begin(), broken.end(), 0.0) / static_cast<double>(broken.size());
}

/// 0.96, 0.96, 0.91 of G_f: the band of a crack is as wide as k_band dx only about.
TEST(ABrittleBar, PartsForItsFractureEnergyWhateverTheGrid) {
  std::vector<double> energies;
  for (const double dx : {0.02, 0.01, 0.005}) {
    const auto s = bar(dx, 0.012).begin();
    s->advance(0.8, 1);
    const std::vector<double> broken = broken_of(*s);
    EXPECT_EQ(*std::max_element(broken.begin(), broken.end()), 1);
    energies.push_back(s->booked(booked::dissipated) / (dx * dx) / k_energy);
    EXPECT_NEAR(energies.back(), 1, 0.12) << dx;
  }
  const auto [least, most] = std::minmax_element(energies.begin(), energies.end());
  EXPECT_LT(*most / *least, 1.08) << "four times finer";
}

TEST(ABrittleBar, DoesNotBreakBeforeItHasSet) {
  const auto s = bar(0.01, 0.012, 40).begin();
  s->advance(0.8, 1);
  EXPECT_EQ(mean_broken(*s), 0);
  EXPECT_GT(s->booked(booked::dissipated), 0) << "else nothing was tested";
}

/// Single particles are pulled open even then, by what nodes do not see of their strains.
TEST(ABrittleBar, BreaksAsItIsPulledAndHardlyAsItIsPressed) {
  const auto pulled = bar(0.01, 0.002).begin(), pressed = bar(0.01, -0.002).begin();
  for (const auto& s : {pulled.get(), pressed.get()}) {
    s->advance(0.8, 1);
    EXPECT_GT(s->booked(booked::dissipated), 5e-5) << "both flow";
  }
  EXPECT_GT(mean_broken(*pulled), 0.02);
  EXPECT_LT(mean_broken(*pressed), mean_broken(*pulled) / 20);
}

}  // namespace
}  // namespace bake
