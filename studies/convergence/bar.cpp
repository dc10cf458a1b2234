// SPDX-License-Identifier: MIT
#include "studies/convergence/bar.h"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "solver/scene/reader.h"

namespace bake::studies {

namespace {

std::string box(double from, double to, double width, const std::string& keys) {
  return fmt::format(R"(
[[body]]
material = "dough"
particles_per_cell = 8
jitter = 0
shape = {{ box = {{ centre_m = [{:.17g}, {:.17g}, {:.17g}], half_extents_m = [{:.17g}, {:.17g}, {:.17g}] }} }}
{}
)",
                     (from + to) / 2, width / 2, width / 2, (to - from) / 2, width / 2, width / 2, keys);
}

std::string bodies(const Bar& bar) {
  const double h = bar.dx() / 2, width = bar.across * bar.dx();
  const int first = -2 * bar.before, last = 2 * (bar.cells + bar.after);
  if (!bar.state) return box(first * h, last * h, width, "");
  std::string layers;
  for (int i = first; i < last; ++i) layers += box(i * h, (i + 1) * h, width, bar.state((i + 0.5) * h));
  return layers;
}

}  // namespace

std::unique_ptr<Simulation> Bar::begin() const {
  omp_set_num_threads(1);  // a bar is too small to share
  const double width = across * dx(), low = -(before + air) * dx(), high = 1 + (after + air) * dx();
  const std::string text =
      fmt::format(R"(
effects = [{}]
[run]
end_s = 1e9
frame_rate_per_s = {:.17g}
precision = "double"
[grid]
dx_m = {:.17g}
[domain]
min_m = [{:.17g}, 0, 0]
max_m = [{:.17g}, {:.17g}, {:.17g}]
x_min = {}
x_max = {}
y_min = "slip"
y_max = "slip"
z_min = "slip"
z_max = "slip"
[time]
{}
[motion]
gravity_m_per_s2 = [0, 0, 0]
[[material]]
name = "dough"
density_kg_per_m3 = 1
{}
{}
{}
)",
                  effects, 1 / end_s, dx(), low, high, width, width, faces, faces, time, material, tables, bodies(*this));
  return Simulation::begin(parse_scene(text, "bar.toml"));
}

void run_to(Simulation& simulation, double time) { simulation.advance(time, time); }

std::vector<double> differences(const Snapshot& now, const Field& found, const Profile& exact, const Span& span) {
  std::vector<double> values;
  for (std::size_t i = 0; i < now.id.size(); ++i) {
    const double x = now.position[i][0];
    if (x > span.from && x < span.to) values.push_back(found(i) - exact(x));
  }
  return values;
}

double root_mean_square(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v * v;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double v : values) most = std::max(most, std::abs(v));
  return most;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace bake::studies
