// SPDX-License-Identifier: MIT
// Metrics of what is pulled and twisted along x, in parts of a twentieth of its length.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/claims/finite.h"
#include "analysis/claims/metric.h"

namespace bake {
namespace {

constexpr std::size_t k_parts = 20;

/// Lowest and highest x. Throws NoNumber if there is no length between them.
std::pair<double, double> ends_of(const CheckedFrame& frame, const std::vector<double>& positions) {
  std::pair ends{k_infinity, -k_infinity};
  for (std::size_t i = 0; i < positions.size(); i += 3) {
    ends.first = std::min(ends.first, positions[i]);
    ends.second = std::max(ends.second, positions[i]);
  }
  if (!(ends.second > ends.first)) throw NoNumber(fmt::format("found no length along x at {} s, allowed: a body", frame.time_s()));
  return ends;
}

/// The volume of all particles up to each x: running sums in order of x.
struct VolumeAlong {
  std::vector<double> x, volume_up_to{0};

  VolumeAlong(const std::vector<double>& positions, const std::vector<float>& volumes) {
    std::vector<std::pair<double, double>> x_and_volume;
    for (std::size_t row = 0; row < volumes.size(); ++row) x_and_volume.emplace_back(positions[3 * row], volumes[row]);
    std::sort(x_and_volume.begin(), x_and_volume.end());
    for (const auto& [place, volume] : x_and_volume) {
      x.push_back(place);
      volume_up_to.push_back(volume_up_to.back() + volume);
    }
  }
  double between(double low, double high) const {
    const auto first = std::lower_bound(x.begin(), x.end(), low) - x.begin(), last = std::upper_bound(x.begin(), x.end(), high) - x.begin();
    return volume_up_to[static_cast<std::size_t>(last)] - volume_up_to[static_cast<std::size_t>(first)];
  }
};

/// A part is slid along the body in steps much shorter than itself; the mean cross-section of the thinnest place counts as a disc.
double neck_radius(const Results& run, const MetricPlace& at) {
  constexpr std::size_t k_places = 400;
  const CheckedFrame frame = run.frame(run.frame_at(at.time_s));
  const auto positions = frame.positions();
  const auto [low, high] = ends_of(frame, positions);
  const VolumeAlong volume(positions, frame.column("volume"));
  const double part = (high - low) / k_parts, step = (high - low - part) / k_places;
  double thinnest = k_infinity;
  for (std::size_t i = 0; i <= k_places; ++i) {
    const double from = low + static_cast<double>(i) * step;
    thinnest = std::min(thinnest, volume.between(from, from + part));
  }
  return std::sqrt(thinnest / part / std::numbers::pi);
}

/// The turn about the axis of x that fits a part's particles best: the angle of sum y_0 (y, z) + z_0 (z, -y).
struct Turn {
  double along = 0, across = 0;

  void add(const double* before, const double* after) {
    const double y0 = before[1], z0 = before[2], y = after[1], z = after[2];
    along += y0 * y + z0 * z;
    across += y0 * z - z0 * y;
  }
  /// NaN for a part without particles off the axis.
  double degrees() const { return along == 0 && across == 0 ? std::nan("") : std::atan2(across, along) * 180 / std::numbers::pi; }
};

/// The turn of each part of the body at the start. Throws InputError for a particle that was not there.
std::vector<Turn> turns_of(const CheckedFrame& start, const CheckedFrame& now) {
  const auto before = start.positions(), after = now.positions();
  const auto [low, high] = ends_of(start, before);
  const auto rows = rows_at_start(start, now);
  std::vector<Turn> turns(k_parts);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double* place = &before[3 * rows[i]];
    const double share = (place[0] - low) / (high - low);
    turns[std::min(k_parts - 1, static_cast<std::size_t>(share * k_parts))].add(place, &after[3 * i]);
  }
  return turns;
}

/// The largest turn between two neighbouring parts, over the distance of their middles at the start. A turn between neighbours is taken
/// to be less than half a revolution.
double twist_gradient(const Results& run, const MetricPlace& at) {
  const CheckedFrame start = run.frame(0);
  const auto turns = turns_of(start, run.frame(run.frame_at(at.time_s)));
  const auto [low, high] = ends_of(start, start.positions());
  double largest = 0;
  for (std::size_t i = 0; i + 1 < k_parts; ++i)
    largest = larger(largest, std::abs(std::remainder(turns[i + 1].degrees() - turns[i].degrees(), 360.0)));
  return largest / ((high - low) / k_parts);
}

}  // namespace

std::vector<Metric> neck_metrics() {
  return {
      {"neck_radius", "m", non_negative,
       "radius of the thinnest twentieth of the length along x, as a disc of its mean cross-section; 0 if it has parted", neck_radius,
       needs(), knows("time_s")},
      {"twist_gradient", "deg/m", non_negative,
       "largest turn about the axis of x between neighbouring twentieths of the length, per length at the start", twist_gradient, needs(),
       knows("time_s")},
  };
}

}  // namespace bake
