// SPDX-License-Identifier: MIT
// The teaching scenes, pouring and the bread, run at draft by the real program as a user would: they end, their books close, and what they
// show stays what it is in nature. Bounds are derived beside each check.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "solver/io/hdf5.h"
#include "solver/io/ledger_file.h"
#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

/// A finished run: its exit code and its ledger by column names.
class Baked {
 public:
  Baked(const std::string& scene, int frames) {
    const TemporaryFolder folder;
    const std::string command =
        fmt::format("'{}' run '{}/experiments/{}' --quality draft --frames {} --threads 1 --quiet --out '{}' >/dev/null", BAKE_PROGRAM,
                    BAKE_SOURCE_DIR, scene, frames, folder.path().string());
    const int status = std::system(command.c_str());
    exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    if (exit_code != 0) return;
    ledger_ = read_ledger(folder / "ledger.csv");
    positions_ = Hdf5Reader(folder / fmt::format("frames/{:04}.hdf", frames)).table<float>("VTKHDF/Points", 3);
  }
  std::vector<double> operator[](const std::string& column) const {
    const auto at = std::find(ledger_.columns.begin(), ledger_.columns.end(), column);
    if (at == ledger_.columns.end()) throw std::out_of_range("no column " + column);
    std::vector<double> values;
    for (const auto& row : ledger_.rows) values.push_back(row[static_cast<std::size_t>(at - ledger_.columns.begin())]);
    return values;
  }
  const Ledger& ledger() const { return ledger_; }
  /// Positions in the last frame, x y z by x y z [m].
  const std::vector<float>& positions() const { return positions_; }
  int exit_code;

 private:
  Ledger ledger_;
  std::vector<float> positions_;
};

double largest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }
double smallest(const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); }

void expect_finished(const Baked& run, std::size_t frames) {
  ASSERT_EQ(run.exit_code, 0);
  ASSERT_EQ(run.ledger().rows.size(), frames + 1);
  for (const auto& row : run.ledger().rows)
    for (const double value : row) EXPECT_TRUE(std::isfinite(value));
  EXPECT_EQ(run["retired_particles"].back(), 0);
}

void expect_solid_mass_constant(const Baked& run) {
  for (const double mass : run["solid_mass_kg"])  // never written after the start; sums in double
    EXPECT_NEAR(mass, run["solid_mass_kg"].front(), 1e-12 * mass);
}

/// water = initial - evaporated. A particle's mass is rounded once per step, to 6e-8 at most: thousands of roundings that go
/// either way stay below 1e-5.
void expect_water_balance(const Baked& run) {
  const auto water = run["water_mass_kg"], evaporated = run["water_evaporated_kg"];
  for (std::size_t i = 0; i < water.size(); ++i) EXPECT_NEAR(water[i] + evaporated[i], water.front(), 1e-5 * water.front());
}

/// Vertical momentum = what gravity and contacts gave. Single precision: sums of about 1e4 terms per step cancel gravity
/// against contact, so the bound is relative to the impulse of the weight alone.
void expect_momentum_balance(const Baked& run, double gravity) {
  const auto momentum = run["momentum_z_kg_m_per_s"], impulse = run["impulse_z_kg_m_per_s"], time = run["time_s"];
  const double weight = gravity * (run["solid_mass_kg"].front() + run["water_mass_kg"].front());
  for (std::size_t i = 1; i < momentum.size(); ++i)
    EXPECT_NEAR(momentum[i] - momentum.front(), impulse[i] - impulse.front(), 1e-5 * weight * time.back());
}

TEST(TeachingScene, TheFallingBallBouncesWithLessThanItFellWith) {
  const Baked run("teaching/falling_ball.toml", 36);
  ASSERT_NO_FATAL_FAILURE(expect_finished(run, 36));
  expect_solid_mass_constant(run);
  expect_momentum_balance(run, 9.81);
  const auto kinetic = run["kinetic_J"], elastic = run["elastic_J"], time = run["time_s"];
  const double mass = run["solid_mass_kg"].front(), drop = 0.3, energy = mass * 9.81 * drop;
  const double speed = 9.81 * time[10];                               // at 0.21 s, before the first touch at sqrt(2 drop / g) = 0.247 s
  EXPECT_NEAR(kinetic[10], mass * speed * speed / 2, 1e-4 * energy);  // free fall is exact but for rounding
  EXPECT_GT(largest(elastic), 0.5 * energy);                          // the rest moves sideways in the flat ball
  EXPECT_LT(largest(elastic), 1.01 * energy * (1 + 0.05 / drop));     // at most m g (drop + squeeze), squeezed by 5 cm at most
  const double rebound = *std::max_element(kinetic.begin() + 16, kinetic.begin() + 24);  // 0.33 to 0.5 s: on its way up
  EXPECT_GT(rebound, 0.1 * energy);
  EXPECT_LT(rebound, energy);
}

TEST(TeachingScene, TheHeatedSlabTakesUpTheHeatOfTheSeriesSolution) {
  const Baked run("teaching/heated_slab.toml", 10);
  ASSERT_NO_FATAL_FAILURE(expect_finished(run, 10));
  expect_solid_mass_constant(run);
  const auto content = run["heat_content_J"], exchanged = run["heat_exchanged_J"];
  for (std::size_t i = 1; i < content.size(); ++i)  // single: rounded once per step and particle
    EXPECT_NEAR(content[i] - content.front(), exchanged[i] - exchanged.front(), 1e-4 * content.back());
  // Until 1000 s the cold end feels nothing (erfc(1.6) = 0.02): the slab has taken up 2 sqrt(D t / pi) times 100 C, and the hot layer
  // is 0.01 m of the body's 0.12 m. The layer's edge is sharp to a third of a cell (5 mm): 100 C * 1.7 mm / 0.12 m = 1.4 C.
  const double depth = 2 * std::sqrt(1e-6 * 1000 / std::numbers::pi);
  EXPECT_NEAR(run["temperature_mean_C"].back(), 100 * (0.01 + depth) / 0.12, 1.4);
}

TEST(TeachingScene, TheDryingCubeStaysBelowTheOven) {
  const Baked run("teaching/drying_cube.toml", 45);
  ASSERT_NO_FATAL_FAILURE(expect_finished(run, 45));
  expect_solid_mass_constant(run);
  expect_water_balance(run);
  EXPECT_GE(smallest(run["temperature_min_C"]), 10);  // 10: where evaporation at most could cool it, s = 0.7 against 20 W/(m^2 K)
  EXPECT_LT(largest(run["temperature_max_C"]), 60);   // the oven
  // Not more than a surface of 6 faces at oven temperature and start saturation could lose; a tenth of that for a cooled, drying one.
  const double most = 1.5e-5 * 60 * (0.7 - 0.05) * 6 * 0.04 * 0.04 * 3600;
  EXPECT_LT(run["water_evaporated_kg"].back(), most);
  EXPECT_GT(run["water_evaporated_kg"].back(), 0.1 * most);
}

/// Volume ratio of dough whose pores hold all its gas at the pressure of the atmosphere, at temperature theta [C].
double free_volume_ratio(double porosity, double theta_0, double theta, double gas_mol_per_m3) {
  const double kelvin = theta + 273.15;
  return 1 - porosity + porosity * kelvin / (theta_0 + 273.15) + gas_mol_per_m3 * 8.314 * kelvin / 101325;
}

TEST(TeachingScene, TheRisingBallGrowsAsItsGasDemands) {
  const Baked run("teaching/rising_ball.toml", 64);
  ASSERT_NO_FATAL_FAILURE(expect_finished(run, 64));
  expect_solid_mass_constant(run);
  expect_water_balance(run);
  const auto volume = run["volume_m3"], gas = run["gas_mol"];
  const double start = volume.front(), free = free_volume_ratio(0.1, 10, run["temperature_mean_C"].back(), gas.back() / start);
  EXPECT_LT(gas.back(), 40 * start);  // all the leavener
  // The dough resists: its strength at the end, 1000 Pa, is a quarter of the scene's reference pressure; most of the rise happens at
  // a fiftieth of that strength. So not more than free rise (and thermal noise of 1 %), and not less than four fifths of it.
  EXPECT_LT(volume.back() / start - 1, 1.01 * (free - 1));
  EXPECT_GT(volume.back() / start - 1, 0.8 * (free - 1));
  EXPECT_GE(smallest(run["temperature_min_C"]), 9.9);
  EXPECT_LT(largest(run["temperature_max_C"]), 110);  // the oven
}

TEST(TeachingScene, PulledDoughIsAsLongAsItsGripsHoldIt) {
  const Baked run("teaching/dough_pull.toml", 36);
  ASSERT_NO_FATAL_FAILURE(expect_finished(run, 36));
  expect_solid_mass_constant(run);
  const auto dissipated = run["dissipated_J"], length = run["extent_x_m"];
  for (std::size_t i = 1; i < dissipated.size(); ++i) EXPECT_GE(dissipated[i], dissipated[i - 1]);
  EXPECT_GT(dissipated.back(), 10 * largest(run["elastic_J"]));  // strained far beyond yield: 58 % against tau_y / E = 2 %
  EXPECT_NEAR(length[24] - length.front(), 0.14, 0.02);          // both grips have moved by 0.07 m; within a cell
  EXPECT_LT(length.back(), length[24] + 1e-3);                   // it springs back, and no further
}

TEST(PouringScene, WhatIsPouredIsBookedAndKeepsItsVolume) {
  const Baked run("features/pouring.toml", 48);
  ASSERT_NO_FATAL_FAILURE(expect_finished(run, 48));
  const double mass = run["solid_mass_kg"].back(), poured = mass / 1000;  // of 1000 kg/m^3
  EXPECT_NEAR(run["emitted_solid_mass_kg"].back(), mass, 1e-6 * mass);
  // 1 s through a spout of 2.5 cm at 0.25 m/s, to one portion (2 cm of the 25 cm poured) and the spout's rim on the grid (10 %).
  const double wanted = std::numbers::pi * 0.025 * 0.025 * 0.25;
  EXPECT_NEAR(poured, wanted, (2.0 / 25 + 0.1) * wanted);
  // Only its pores (a tenth) can be pressed out, and elastically its own weight: 300 Pa against a bulk modulus of 8300 Pa, 4 %.
  EXPECT_GT(run["volume_m3"].back(), 0.9 * 0.96 * poured);
  EXPECT_LT(run["volume_m3"].back(), 1.01 * poured);
}

/// Sizes of the pieces, largest first: particles belong together where their cells of side `dx` touch.
std::vector<std::size_t> pieces(const std::vector<float>& positions, double dx) {
  std::map<std::array<int, 3>, std::size_t> unseen;  // cell -> particles in it
  for (std::size_t i = 0; i + 2 < positions.size(); i += 3) {
    std::array<int, 3> cell;
    for (std::size_t d = 0; d < 3; ++d) cell[d] = static_cast<int>(std::floor(static_cast<double>(positions[i + d]) / dx));
    ++unseen[cell];
  }
  std::vector<std::size_t> sizes;
  while (!unseen.empty()) {
    sizes.push_back(0);
    std::vector<std::array<int, 3>> reached{unseen.begin()->first};
    while (!reached.empty()) {
      const auto cell = reached.back();
      reached.pop_back();
      const auto found = unseen.find(cell);
      if (found == unseen.end()) continue;
      sizes.back() += found->second;
      unseen.erase(found);
      for (int n = 0; n < 27; ++n) reached.push_back({cell[0] + n / 9 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n % 3 - 1});
    }
  }
  std::sort(sizes.rbegin(), sizes.rend());
  return sizes;
}

TEST(KnifeScene, LeavesTwoPiecesOfAboutOneSize) {
  const Baked run("features/knife.toml", 18);
  ASSERT_NO_FATAL_FAILURE(expect_finished(run, 18));
  const auto sizes = pieces(
      run.positions(), 0.0095);  // a node distance, less so much that the faces of the knife, where dough lies, are in cells of their own
  const std::size_t all = run.positions().size() / 3;
  ASSERT_GE(sizes.size(), 2u) << "it is still one piece";
  EXPECT_GT(sizes[0] + sizes[1], all * 98 / 100) << "crumbs";
  EXPECT_GT(sizes[1], all * 45 / 100);
}

TEST(Bread, RisesInItsFirstSeconds) {
  const Baked run("fig15_bread/bread.toml", 96);
  ASSERT_NO_FATAL_FAILURE(expect_finished(run, 96));
  expect_solid_mass_constant(run);
  expect_water_balance(run);
  expect_momentum_balance(run, 0.2);
  const auto volume = run["volume_m3"];
  const double start = volume.front(), rise = volume.back() / start - 1;
  const double free = free_volume_ratio(0.1, 1, run["temperature_mean_C"].back(), run["gas_mol"].back() / start) - 1;
  EXPECT_LT(rise, 1.01 * free);  // as the rising ball
  EXPECT_GT(rise, 0.8 * free);
  EXPECT_GT(run["height_m"].back(), run["height_m"].front() * std::cbrt(1 + rise) * 0.9);  // it does not slump: 10 % of even growth
  EXPECT_GE(smallest(run["temperature_min_C"]), 0.9);                                      // it starts at 1 C
  EXPECT_LE(largest(run["temperature_max_C"]), 100);                                       // oven and tray
}

}  // namespace
}  // namespace bake
