// SPDX-License-Identifier: MIT
#include "experiments/convergence/bar.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "analysis/claims/finite.h"

namespace bake::studies {

namespace {

std::string box(const Bar& bar, double from, double to, const std::string& keys) {
  const double width = bar.across * bar.dx();
  return fmt::format(R"(
[[body]]
material = "dough"
particles_per_cell = {}
jitter = 0
shape = {{ box = {{ centre_m = [{:.17g}, {:.17g}, {:.17g}], half_extents_m = [{:.17g}, {:.17g}, {:.17g}] }} }}
{}
)",
                     bar.rows * bar.rows * bar.rows, (from + to) / 2, width / 2, width / 2, (to - from) / 2, width / 2, width / 2, keys);
}

std::string bodies(const Bar& bar) {
  const double h = bar.dx() / bar.rows;
  const int first = -bar.rows * bar.before, last = bar.rows * (bar.cells + bar.after);
  if (!bar.state) return box(bar, first * h, last * h, "");
  std::string layers;
  for (int i = first; i < last; ++i) layers += box(bar, i * h, (i + 1) * h, bar.state((i + 0.5) * h));
  return layers;
}

}  // namespace

StudyScene Bar::setting() const {
  const double width = across * dx();
  StudyScene setting(effects);
  setting.frame_s = end_s;
  setting.dx = dx();
  setting.low = {-(before + air + shift) * dx(), 0, 0};
  setting.high = {1 + (after + air - shift) * dx(), width, width};
  setting.faces = fmt::format("x_min = {0}\nx_max = {0}\ny_min = \"slip\"\ny_max = \"slip\"\nz_min = \"slip\"\nz_max = \"slip\"\n", faces);
  setting.time = time;
  setting.material += material;
  setting.tables = tables + bodies(*this);
  setting.overrides = overrides;
  return setting;
}

std::string held(const char* point, const char* normal, int temperature_C) {
  return fmt::format("[[grip]]\nshape = {{ half_space = {{ point_m = {}, normal = {} }} }}\ntemperature_C = {}\n", point, normal,
                     temperature_C);
}

std::vector<double> differences(const Snapshot& now, const Field& found, const Profile& exact, const Span& span) {
  std::vector<double> values;
  for (std::size_t i = 0; i < now.id.size(); ++i) {
    const double x = now.position[i][0];
    if (x > span.from && x < span.to) values.push_back(found(i) - exact(x));
  }
  return values;
}

std::vector<double> temperature_differences(Bar bar, double cells, const Profile& exact, const Span& span) {
  bar.cells = static_cast<int>(cells);
  const Snapshot now = bar.end()->snapshot();
  const auto& theta = now["temperature"];
  return differences(
      now, [&](std::size_t i) { return theta[i]; }, exact, span);
}

double root_mean_square(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v * v;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double v : values) most = larger(most, std::abs(v));
  return most;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace bake::studies
