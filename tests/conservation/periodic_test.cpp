// SPDX-License-Identifier: MIT
// Periodic faces: what goes out at one comes in at the other, and nothing notices.
#include <gtest/gtest.h>

#include "solver/io/checkpoint.h"
#include "tests/conservation/dough.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/threads_restored.h"

namespace bake {
namespace {

std::string ring(const char* axes) {
  std::string faces;
  for (const char* axis = axes; *axis; ++axis) faces += fmt::format("{0}_min = \"periodic\"\n{0}_max = \"periodic\"\n", *axis);
  return faces;
}

/// A lump that flies and spins, alone.
Dough flier(const std::string& effects, double reach, const std::string& faces) {
  Dough dough;
  dough.effects = effects;
  dough.low = {-reach, -reach, -reach};
  dough.high = {reach, reach, reach};
  dough.faces = faces;
  dough.shape = "box = { centre_m = [0.03, 0.02, 0.01], half_extents_m = [0.14, 0.11, 0.08] }";
  dough.body = "velocity_m_per_s = [5, 3, -4]\nangular_velocity_rad_per_s = [3, 1, 2]";
  dough.material = Dough::properties(Dough::moving_water());
  dough.tables = "[oven]\ntemperature_C = 100\nheat_transfer_coefficient_W_per_m2K = 500\nequilibrium_saturation = 0.05\n";
  dough.frame_s = 5e-4;
  return dough;
}

/// 16, 12 and 20 cells: rings of an even and of an odd number of blocks.
TEST(PeriodicFaces, LetAFlierThroughAsIfItWereInTheMiddle) {
  for (const double reach : {0.5, 0.375, 0.625})
    for (const std::string effects : {"motion, elasticity", k_everything})
      for (const std::string kernel : {"quadratic", "cubic"}) {
        Dough through = flier(effects, reach, ring("xyz")), middle = flier(effects, 2, "");
        through.kernel = middle.kernel = kernel;
        const auto a = through.begin(), b = middle.begin();
        const Sums start(*a);
        const int steps = effects == k_everything ? 400 : 500;
        for (const auto* s : {&a, &b}) take_steps(**s, steps, 5e-4);
        const Snapshot there = a->snapshot(), here = b->snapshot();
        ASSERT_EQ(there.id, here.id);
        double worst = 0, passed = 0;
        for (std::size_t p = 0; p < here.id.size(); ++p)
          for (std::size_t d = 0; d < 3; ++d) {
            ASSERT_GE(there.position[p][d], -reach);
            ASSERT_LE(there.position[p][d], reach);
            const double gap = there.position[p][d] - here.position[p][d], periods = std::round(gap / (2 * reach));
            worst = std::max(worst, std::abs(gap - 2 * reach * periods));
            worst = std::max(worst, std::abs(there.velocity[p][d] - here.velocity[p][d]) / 5);
            passed = std::max(passed, std::abs(periods));
          }
        EXPECT_LT(worst, 1e-9) << reach << effects << kernel;
        EXPECT_GT(passed, 0) << "else nothing was tested";
        const Sums now(*a);
        for (std::size_t d = 0; d < 3; ++d)
          EXPECT_NEAR(now.momentum[d], start.momentum[d] + now.impulse[d] + now.remapped[d], steps * 1e-12 * 6 * start.mass());
        EXPECT_NEAR(now.heat, start.heat + now.heat_gained(), steps * 1e-12 * now.heat);
        EXPECT_NEAR(now.water + now.evaporated, start.water, steps * 1e-12 * start.water + 1e-300);
        EXPECT_EQ(a->counters().clamped, 0);
      }
}

/// Hot dough between x = 0 and half a period, cold dough behind it: the sum over odd m of 4 / (pi m) sin(m k x) exp(-alpha m^2 k^2 t).
TEST(PeriodicFaces, LetHeatThrough) {
  constexpr double period = 1, alpha = 100 / (500. * 20), hot = 80, cold = 20;
  const double k = 2 * M_PI / period, time = 2 / (alpha * k * k);
  for (const char* heat : {"", "integrator = \"backward_euler\"\nimplicit_step_factor = 1"}) {
    Dough dough;
    dough.effects = "heat";
    dough.heat = heat;
    dough.low = {0, 0, 0};
    dough.dx = 1 / 32.;
    dough.high = {period, 0.125, 0.125};
    dough.faces = ring("xyz");
    dough.shape = "box = { centre_m = [0.25, 0.0625, 0.0625], half_extents_m = [0.25, 0.0625, 0.0625] }";
    dough.body = fmt::format("temperature_C = {}", hot);
    dough.tables = fmt::format(
        "[oven]\ntemperature_C = 500\nheat_transfer_coefficient_W_per_m2K = 1000\n[[body]]\nmaterial = \"dough\"\nparticles_per_cell = 8\n"
        "shape = {{ box = {{ centre_m = [0.75, 0.0625, 0.0625], half_extents_m = [0.25, 0.0625, 0.0625] }} }}\ntemperature_C = {}\n",
        cold);
    const auto s = dough.begin();
    const double start = Sums(*s).heat;
    s->advance(time, 2 * time);
    const Snapshot now = s->snapshot();
    double sine = 0, cosine = 0;
    for (std::size_t p = 0; p < now.id.size(); ++p) {
      sine += 2 * now["temperature"][p] * std::sin(k * now.position[p][0]) / static_cast<double>(now.id.size());
      cosine += 2 * now["temperature"][p] * std::cos(k * now.position[p][0]) / static_cast<double>(now.id.size());
    }
    const double expected = (hot - cold) / 2 * 4 / M_PI * std::exp(-alpha * k * k * time);
    EXPECT_NEAR(sine / expected, 1, 0.05) << heat;
    EXPECT_LT(std::abs(cosine), 0.02 * expected) << heat;
    EXPECT_NEAR(Sums(*s).heat, start, 1e-9 * start) << "no face is a surface" << heat;
    EXPECT_EQ(s->booked(booked::area), 0) << heat;
  }
}

/// Particles that stand symmetric to a face cannot tell a mirror from a period.
TEST(AFilm, HasTheSurfaceThatItHasBetweenMirrors) {
  double areas[2];
  for (const bool periodic : {false, true}) {
    Dough dough;
    dough.effects = "heat";
    dough.frame_s = 1e-2;
    dough.low = {0, 0, -1};
    dough.high = {0.25, 0.5, 1};
    dough.faces = periodic ? ring("xy") : "";
    dough.shape = "box = { centre_m = [0.125, 0.25, 0], half_extents_m = [0.125, 0.25, 0.25] }";
    dough.body = "jitter = 0";
    dough.tables = "[oven]\ntemperature_C = 100\nheat_transfer_coefficient_W_per_m2K = 100\n";
    const auto s = dough.begin();
    take_steps(*s, 10, 1e-2);
    areas[periodic] = s->booked(booked::area);
  }
  EXPECT_NEAR(areas[1], areas[0], 1e-4);  // mirrors reach 4 nodes far
  EXPECT_NEAR(areas[1], 2 * 0.25 * 0.5, 1e-3);
}

/// Dough between two plates that go through the faces, the upper one moving: 4 cells of it shear as 16 do.
TEST(AFilm, IsTheSameForEveryPeriod) {
  double heights[2], drags[2];
  for (const bool wide : {false, true}) {
    const double side = wide ? 1 : 0.25;
    Dough dough;
    dough.low = {0, 0, -0.5};
    dough.high = {side, side, 0.5};
    dough.faces = ring("xy");
    dough.motion = k_pic;
    dough.shape = fmt::format("box = {{ centre_m = [{0}, {0}, 0], half_extents_m = [{0}, {0}, 0.25] }}", side / 2);
    dough.body = "jitter = 0";
    dough.tables = R"([[collider]]
shape = { half_space = { point_m = [0, 0, -0.25], normal = [0, 0, 1] } }
contact = "sticky"
[[collider]]
name = "lid"
shape = { half_space = { point_m = [0, 0, 0.25], normal = [0, 0, -1] } }
contact = "sticky"
motion = [{ time_s = 0 }, { time_s = 1, position_m = [0.5, 0.25, -0.05] }]
ledger = true
)";
    const auto s = dough.begin();
    take_steps(*s, 200, 1e-3);
    heights[wide] = s->extent().high[2] - s->extent().low[2];
    drags[wide] = s->given().front().impulse[0] / (side * side);
  }
  EXPECT_NEAR(heights[0], heights[1], 1e-10);
  EXPECT_NEAR(drags[0] / drags[1], 1, 1e-9);
  EXPECT_GT(std::abs(drags[0]), 0.1) << "else nothing was tested";
}

TEST(PeriodicFaces, GiveTheSameBitsForAnyNumberOfThreadsAndAfterAStop) {
  Dough dough = flier(k_everything, 0.375, ring("xyz"));
  dough.precision = "single";
  const TemporaryFolder folder;
  const auto save = [&](const Simulation& s, const char* name) {
    CheckpointWriter out(folder / name, "ring", Precision::single_precision);
    s.write(out);
    out.commit();
    return contents(folder / name);
  };
  const ThreadsRestored restored;
  std::string whole;
  for (const int n : {1, 3}) {
    omp_set_num_threads(n);
    const auto s = dough.begin();
    take_steps(*s, 150, 5e-4);
    save(*s, "half.h5");
    take_steps(*s, 150, 5e-4);
    const std::string bits = save(*s, "whole.h5");
    EXPECT_TRUE(whole.empty() || bits == whole) << n << " threads";
    whole = bits;
  }
  const Scene scene = dough.scene();
  const auto resumed = Simulation::resume(scene, CheckpointReader(folder / "half.h5"));
  take_steps(*resumed, 150, 5e-4);
  EXPECT_TRUE(save(*resumed, "resumed.h5") == whole);
}

}  // namespace
}  // namespace bake
