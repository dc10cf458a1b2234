// SPDX-License-Identifier: MIT
// run.stress_in_frames: frames show the Cauchy stress and von Mises'.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "solver/io/frames.h"
#include "solver/run/simulation.h"
#include "solver/scene/scene_builder.h"
#include "tests/support/temporary_folder.h"

namespace bake {
namespace {

constexpr double k_E = 2e4, k_nu = 0.3;

/// An elastic bar along x.
SceneBuilder bar(bool stress = true) {
  SceneBuilder builder;
  builder.effects = "motion, elasticity";
  builder.dx = 0.0625;
  builder.frame_s = 1e-3;
  builder.run = stress ? "stress_in_frames = true" : "";
  builder.material = "density_kg_per_m3 = 500\nyoung_modulus_Pa = 2e4\npoisson_ratio = 0.3";
  builder.shape = "box = { half_extents_m = [0.4, 0.2, 0.2] }";
  return builder;
}

std::vector<float> column(const FrameData& frame, const std::string& name, std::size_t components) {
  for (const FrameColumn& c : frame.columns)
    if (c.name == name) {
      EXPECT_EQ(c.components, components);
      return std::get<std::vector<float>>(c.values);
    }
  return {};
}

/// Advances to `time` with the velocities v = L x at all nodes; `rates`: L_xx, L_yy, L_zz and L_xy, for a step of the length dt.
template <class Rates>
std::unique_ptr<Simulation> strained(const SceneBuilder& builder, double time, Rates rates) {
  auto s = Simulation::begin(builder.scene());
  s->set_force([rates](const Point& x, const Vector3&, double, double dt) {
    const std::array<double, 4> L = rates(dt);
    return Vector3{L[0] * x[0] + L[3] * x[1], L[1] * x[1], L[2] * x[2]};
  });
  s->advance(time, 2 * time);
  return s;
}

/// Pressed along x to 0.8 of its length and free to the sides, where it grows by nu of the logarithmic strain: tau_xx = E ln 0.8, and
/// sigma = tau / J.
TEST(StressInFrames, OfABarPressedAlongOneAxisIsThatOfTheClosedForm) {
  constexpr double k_time = 0.1;
  const double rate = std::log(0.8) / k_time;
  const auto s = strained(bar(), k_time, [&](double dt) {  // each step takes exp(rate dt) of the length, exactly
    const double along = std::expm1(rate * dt) / dt, across = std::expm1(-k_nu * rate * dt) / dt;
    return std::array{along, across, across, 0.};
  });
  const double tau = k_E * std::log(0.8), J = std::pow(0.8, 1 - 2 * k_nu), sigma = tau / J;
  const FrameData frame = s->frame();
  const std::vector<float> stress = column(frame, "stress", 6), von_mises = column(frame, "von_mises", 1);
  ASSERT_EQ(stress.size(), 6 * s->particles());
  ASSERT_EQ(von_mises.size(), s->particles());
  for (std::size_t i = 0; i < s->particles(); ++i) {
    ASSERT_NEAR(stress[6 * i], sigma, 1e-6 * std::abs(sigma));
    for (std::size_t c = 1; c < 6; ++c) ASSERT_NEAR(stress[6 * i + c], 0, 1e-6 * std::abs(sigma)) << c;
    ASSERT_NEAR(von_mises[i], std::abs(sigma), 1e-6 * std::abs(sigma));
  }
}

/// What is pulled along one axis and sheared in xy only tells where each component stands.
TEST(StressInFrames, HasItsComponentsInTheOrderOfParaView) {
  const auto s = strained(bar(), 0.02, [](double) { return std::array{0.5, 0., -1., 2.}; });
  const std::vector<float> stress = column(s->frame(), "stress", 6), von_mises = column(s->frame(), "von_mises", 1);
  ASSERT_FALSE(stress.empty());
  const double mu = k_E / (2 * (1 + k_nu));
  EXPECT_GT(stress[0], stress[1]) << "XX is pulled, YY not";
  EXPECT_GT(stress[1], stress[2]) << "ZZ is pressed";
  EXPECT_NEAR(stress[3], mu * 2 * 0.02, 0.03 * mu * 2 * 0.02) << "XY: the shear is 0.04";
  EXPECT_NEAR(stress[4], 0, 1e-6 * stress[3]) << "YZ";
  EXPECT_NEAR(stress[5], 0, 1e-6 * stress[3]) << "XZ";
  const double deviator = (stress[0] - stress[1]) * (stress[0] - stress[1]) + (stress[1] - stress[2]) * (stress[1] - stress[2]) +
                          (stress[2] - stress[0]) * (stress[2] - stress[0]);
  EXPECT_NEAR(von_mises[0], std::sqrt(deviator / 2 + 3 * stress[3] * stress[3]), 1e-5 * von_mises[0]);
}

TEST(StressInFrames, StandsInTheFilesAndFollowsItsParticles) {
  SceneBuilder builder = bar();
  builder.body = "velocity_m_per_s = [3, 1, 0]\nangular_velocity_rad_per_s = [0, 0, 8]";  // which moves them through blocks
  const auto s = Simulation::begin(builder.scene());
  const TemporaryFolder folder;
  s->write_frame_file(folder / "first.hdf");
  const FrameReader first(folder / "first.hdf");
  EXPECT_EQ(first.column("stress", 6), std::vector<float>(6 * s->particles(), 0)) << "it begins without stress";
  s->advance(0.05, 0.1);
  ASSERT_GT(s->counters().orderings, 1);
  s->write_frame_file(folder / "later.hdf");
  const FrameReader later(folder / "later.hdf");
  const std::vector<float> stress = later.column("stress", 6), J = later.column("volume_ratio");
  const double bulk = k_E / (3 * (1 - 2 * k_nu));
  double most = 0;
  for (std::size_t i = 0; i < s->particles(); ++i) {  // the trace of the elastic stress is that of ln J, a column of its own
    const double pressure = (stress[6 * i] + stress[6 * i + 1] + stress[6 * i + 2]) / 3, expected = bulk * std::log(J[i]) / J[i];
    ASSERT_NEAR(pressure, expected, 1e-3 * bulk * 1e-2) << i;
    most = std::max(most, std::abs(expected));
  }
  EXPECT_GT(most, 10 * 1e-3 * bulk * 1e-2) << "else nothing was tested";
}

TEST(StressInFrames, IsNotThereUnlessAskedForAndChangesNothing) {
  const auto with = Simulation::begin(bar().scene()), without = Simulation::begin(bar(false).scene());
  with->advance(0.02, 0.03);
  without->advance(0.02, 0.03);
  EXPECT_TRUE(column(without->frame(), "stress", 6).empty());
  EXPECT_TRUE(column(without->frame(), "von_mises", 1).empty());
  EXPECT_EQ(without->frame().columns.size() + 2, with->frame().columns.size());
  EXPECT_EQ(with->snapshot().position, without->snapshot().position);
  EXPECT_EQ(with->snapshot().velocity, without->snapshot().velocity);
}

}  // namespace
}  // namespace bake
