// SPDX-License-Identifier: MIT
// Cases with an exact solution: those of the study of convergence, a teaching scene, and a sphere.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "experiments/accuracy/running.h"
#include "experiments/convergence/exact.h"
#include "experiments/convergence/manufactured.h"

namespace bake::studies::accuracy {

namespace {

/// What a scene has that says nothing else; the settings of the study of convergence are in double precision.
std::vector<std::string> with_defaults(const std::vector<std::string>& overrides) {
  std::vector<std::string> all{"time.safety=0.5", "run.precision=single"};
  all.insert(all.end(), overrides.begin(), overrides.end());
  return all;
}

int rows_of(const Variant& v) { return v.per_cell == 0 ? 2 : static_cast<int>(std::lround(std::cbrt(v.per_cell))); }

Scene scene_of(Bar bar, const Variant& v) {
  bar.rows = rows_of(v);
  bar.overrides = with_defaults(v.overrides);
  return bar.setting().scene();
}

Scene scene_of(bake::studies::StudyScene setting, const Variant& v) {
  setting.overrides = with_defaults(v.overrides);
  if (v.per_cell > 0) setting.overrides.push_back(fmt::format("body.0.particles_per_cell={}", v.per_cell));
  return setting.scene();
}

}  // namespace

Case heated_slab() {
  static constexpr double length = 0.1, diffusivity = 1e-6, hot = 100;
  static const std::vector<double> times{500, 1500, 3600};
  Case c;
  c.name = "heated_slab";
  c.measured = "temperature at 500, 1500 and 3600 s against the sine series, rms over the middle 60 mm, relative to 100 K";
  c.scene = "teaching/heated_slab";
  c.cells_of = "the slab's 0.1 m";
  c.cells = {5, 10, 15};
  c.full_cells = {20, 30, 40};
  c.quality = {20, 40, 80};
  c.knobs = {"step", "kernel", "particles", "precision", "euler", "textbook"};
  c.scene_of = [](const Variant& v) { return scene_of_file("teaching/heated_slab", length, v, {"run.frame_rate_per_s=0.002"}); };
  c.measure = [](const Scene& scene, By by) {
    return simulate(scene, by, times, [](const std::vector<Snapshot>& seen) {
      double sum = 0;
      for (std::size_t i = 0; i < times.size(); ++i) {
        const auto& theta = seen[i]["temperature"];
        const auto exact = [&](double x) { return hot * held_slab_temperature(x / length, diffusivity * times[i] / (length * length)); };
        const auto off = differences(seen[i], [&](std::size_t p) { return theta[p]; }, exact, {0.2 * length, 0.8 * length});
        sum += std::pow(root_mean_square(off) / hot, 2);
      }
      return std::sqrt(sum / static_cast<double>(times.size()));
    });
  };
  return c;
}

Case cooling_sphere() {
  static constexpr double end = 0.2;
  Case c;
  c.name = "cooling_sphere";
  c.measured = "temperature of a sphere in air at Bi = 1, Fo = 0.2 against its series, rms over all particles, relative to the first";
  c.cells_of = "the radius";
  c.cells = {3, 4, 6, 8};
  c.full_cells = {12, 16, 24};
  c.knobs = {"step", "kernel", "particles", "precision", "euler", "surface", "textbook"};
  c.scene_of = [](const Variant& v) {
    bake::studies::StudyScene setting = ball_in_air::setting(v.cells, 1);
    setting.frame_s = end;
    return scene_of(setting, v);
  };
  c.measure = [](const Scene& scene, By by) {
    return simulate(scene, by, {end}, [](const std::vector<Snapshot>& seen) {
      const auto& theta = seen[0]["temperature"];
      std::vector<double> off;
      for (std::size_t p = 0; p < theta.size(); ++p)
        off.push_back(theta[p] - ball_in_air::temperature(length(seen[0].position[p] - ball_in_air::centre), end));
      return root_mean_square(off);
    });
  };
  return c;
}

Case barenblatt() {
  Case c;
  c.name = "barenblatt";
  c.measured = "saturation when Barenblatt's front has come twice as far, rms, relative to the peak";
  c.cells_of = "the bar's 1 m";
  c.cells = {16, 32, 64};
  c.full_cells = {128, 256};
  c.knobs = {"step", "kernel", "particles", "precision", "textbook"};
  c.scene_of = [](const Variant& v) { return scene_of(source::bar(v.cells), v); };
  c.measure = [](const Scene& scene, By by) {
    return simulate(scene, by, {source::duration_s()}, [](const std::vector<Snapshot>& seen) { return source::saturation_error(seen[0]); });
  };
  return c;
}

Case elastic_bar() {
  static constexpr double speed = 1e-3;  // strains of a promille: Hencky's law is linear to as much of them
  static const std::vector<double> quarters{0.5, 1, 1.5, 2};
  Case c;
  c.name = "elastic_bar";
  c.measured = "half a period of a free bar's first mode, from zero to zero, and its amplitude after half and a whole period, rms";
  c.cells_of = "the bar's 1 m";
  c.cells = {8, 16, 32};
  c.full_cells = {64, 128};
  c.knobs = {"step", "kernel", "transfer", "particles", "precision", "textbook"};
  c.scene_of = [](const Variant& v) { return scene_of(first_mode::bar(v.cells, speed), v); };
  c.measure = [](const Scene& scene, By by) {
    return simulate(scene, by, quarters, [](const std::vector<Snapshot>& seen) {
      const auto share = [&](int quarter) { return first_mode::share(seen[static_cast<std::size_t>(quarter - 1)], speed); };
      // where the share is zero it changes by pi per second; both zeros are half a step late, as velocities are in symplectic Euler
      return root_mean_square({(share(1) + share(3)) / std::numbers::pi, share(2) + 1, share(4) - 1});
    });
  };
  return c;
}

Case vortex() {
  namespace rings = bake::studies::vortex;
  Case c;
  c.name = "vortex";
  c.measured = "place in the generalised vortex at t = 1/2 in material held to the exact velocity outside, rms, relative to the amplitude";
  c.cells_of = "the mean radius";
  c.cells = {12, 16, 24};
  c.full_cells = {32, 48, 64, 96};
  c.knobs = {"step", "kernel", "transfer", "particles", "precision"};
  c.scene_of = [](const Variant& v) { return scene_of(rings::setting(v.cells, true), v); };
  c.measure = [](const Scene& scene, By by) {
    const Compare compare = [](const std::vector<Snapshot>& seen) {
      return place_error(seen[0], seen[1], rings::furthest_s, rings::in_annulus, rings::position) / rings::amplitude;
    };
    return simulate(scene, by, {0, rings::furthest_s}, compare, rings::force(true));
  };
  return c;
}

}  // namespace bake::studies::accuracy
