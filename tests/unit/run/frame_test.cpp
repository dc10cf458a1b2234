// SPDX-License-Identifier: MIT
// A frame holds what the particles are when it is taken.
#include <gtest/gtest.h>

#include <array>
#include <set>

#include "solver/run/simulation.h"
#include "solver/scene/scene_builder.h"

namespace bake {
namespace {

/// A cube of two materials, of which the right half leaves through an open face.
Scene leaving_cube() {
  SceneBuilder builder;
  builder.effects = "motion, elasticity, heat, water";
  builder.precision = "single";
  const std::string common =
      "young_modulus_Pa = 1e4\npoisson_ratio = 0.3\nspecific_heat_J_per_kgK = 1000\nconductivity_W_per_mK = 1\ninitial_saturation = 0.2\n";
  builder.material = "density_kg_per_m3 = 1000\n" + common;
  builder.faces = "x_max = \"open\"";
  builder.tables = "[[material]]\nname = \"crumb\"\ndensity_kg_per_m3 = 700\nwater_density_kg_per_m3 = 800\n" + common +
                   "[[body]]\nmaterial = \"crumb\"\nshape = { box = { centre_m = [0.8, 0, 0], half_extents_m = [0.15, 0.2, 0.2] } }\n"
                   "velocity_m_per_s = [3, 0, 0]";
  builder.shape = "box = { centre_m = [-0.2, 0, 0], half_extents_m = [0.2, 0.2, 0.2] }";
  builder.body = "jitter = 1";
  return builder.scene();
}

template <class T>
const std::vector<T>& column(const FrameData& frame, const char* name) {
  for (const FrameColumn& c : frame.columns)
    if (c.name == name) return std::get<std::vector<T>>(c.values);
  throw std::out_of_range(name);
}

TEST(FrameOfASimulation, HasAllParticlesThatAreThereByIdentity) {
  const auto s = Simulation::begin(leaving_cube());
  const std::size_t at_start = s->particles();
  const FrameData first = s->frame();
  EXPECT_EQ(s->frame().members, first.members);
  s->advance(0.1, 0.2);
  const FrameData frame = s->frame();
  EXPECT_NE(frame.members, first.members) << "who the particles are has changed";
  const Snapshot now = s->snapshot();
  ASSERT_LT(now.id.size(), at_start) << "none left";
  ASSERT_EQ(column<std::int64_t>(frame, "id"), now.id);
  const double rho_w[] = {1000, 800};
  for (std::size_t i = 0; i < now.id.size(); ++i) {
    const auto material = column<std::int64_t>(frame, "material")[i];
    EXPECT_EQ(material, now.material[i]);
    const double volume = now["initial_volume"][i] * now["volume_ratio"][i];
    EXPECT_EQ(column<float>(frame, "volume")[i], static_cast<float>(volume));
    EXPECT_EQ(column<float>(frame, "saturation")[i], static_cast<float>(now["water_mass"][i] / (rho_w[material] * volume)));
    EXPECT_EQ(column<float>(frame, "temperature")[i], static_cast<float>(now["temperature"][i]));
    for (std::size_t d = 0; d < 3; ++d) {
      EXPECT_EQ(std::get<std::vector<float>>(frame.positions)[3 * i + d], static_cast<float>(now.position[i][d]));
      EXPECT_EQ(column<float>(frame, "velocity")[3 * i + d], static_cast<float>(now.velocity[i][d]));
    }
  }
}

TEST(FrameOfASimulation, TellsParticlesApartFarFromTheOrigin) {
  SceneBuilder builder;
  builder.effects = "motion, elasticity";
  builder.precision = "single";
  builder.dx = 1e-3;
  builder.low = {99'999.9, -0.1, -0.1}, builder.high = {100'000.1, 0.1, 0.1};
  builder.material = "density_kg_per_m3 = 1000\nyoung_modulus_Pa = 1e4\npoisson_ratio = 0.3\n";
  builder.shape = "box = { centre_m = [1e5, 0, 0], half_extents_m = [0.004, 0.004, 0.004] }";
  const FrameData frame = Simulation::begin(builder.scene())->frame();
  const auto& positions = std::get<std::vector<double>>(frame.positions);
  ASSERT_EQ(positions.size(), 3u * 4096);
  std::set<std::array<double, 3>> places;
  for (std::size_t i = 0; i < positions.size(); i += 3) places.insert({positions[i], positions[i + 1], positions[i + 2]});
  EXPECT_EQ(places.size(), 4096u);
}

}  // namespace
}  // namespace bake
