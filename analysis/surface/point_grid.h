// SPDX-License-Identifier: MIT
// Sorts points into bins of equal size, to find those near a position.
#pragma once

#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "analysis/surface/mesh_tools.h"

namespace bake {

/// The grid refers to the points, which must outlive it.
class PointGrid {
 public:
  /// `points`: x, y, z of each, at least one, all finite; `cell` above 0: edge of a bin, best the distance that is asked for.
  PointGrid(std::span<const float> points, float cell) : points_(points) {
    const auto box = box_around<float>(points);
    low_ = box.min();
    cell_ = cell;
    constexpr double k_most_bins = 1 << 26;  // if points lie far apart, bins get larger so that memory stays bounded
    const Eigen::Array3f size = box.diagonal();
    while (((size.cast<double>() / cell_).floor() + 1).prod() > k_most_bins) cell_ *= 2;
    bins_ = (size / cell_).floor().cast<int>() + 1;
    fill();
  }

  std::size_t count() const { return points_.size() / 3; }
  Eigen::Vector3f point(std::size_t i) const { return {points_[3 * i], points_[3 * i + 1], points_[3 * i + 2]}; }
  float cell() const { return cell_; }

  /// Calls visit(index, squared distance) for every point within `radius` of `place`, in an order that depends on the points alone.
  template <class Visit>
  void within(const Eigen::Vector3f& place, float radius, Visit visit) const {
    const Eigen::Array3i first = bin_of(place.array() - radius).max(0), last = bin_of(place.array() + radius).min(bins_ - 1);
    for (int z = first.z(); z <= last.z(); ++z)
      for (int y = first.y(); y <= last.y(); ++y)
        for (int x = first.x(); x <= last.x(); ++x) {
          const std::size_t bin = number_of({x, y, z});
          for (std::size_t k = starts_[bin]; k < starts_[bin + 1]; ++k) {
            const float distance2 = (point(order_[k]) - place).squaredNorm();
            if (distance2 <= radius * radius) visit(static_cast<std::size_t>(order_[k]), distance2);
          }
        }
  }

  /// The nearest point within `radius`, or -1.
  std::int64_t nearest(const Eigen::Vector3f& place, float radius) const {
    std::int64_t best = -1;
    float best2 = std::numeric_limits<float>::max();
    within(place, radius, [&](std::size_t i, float distance2) {
      if (distance2 >= best2) return;
      best = static_cast<std::int64_t>(i);
      best2 = distance2;
    });
    return best;
  }

 private:
  Eigen::Array3i bin_of(const Eigen::Array3f& place) const { return ((place - low_) / cell_).floor().max(-2e9f).min(2e9f).cast<int>(); }
  std::size_t number_of(const Eigen::Array3i& bin) const {
    return (static_cast<std::size_t>(bin.z()) * static_cast<std::size_t>(bins_.y()) + static_cast<std::size_t>(bin.y())) *
               static_cast<std::size_t>(bins_.x()) +
           static_cast<std::size_t>(bin.x());
  }
  void fill() {  // counting sort
    std::vector<std::uint32_t> bin(count());
    starts_.assign(number_of(bins_ - 1) + 2, 0);
    for (std::size_t i = 0; i < count(); ++i) {
      bin[i] = static_cast<std::uint32_t>(number_of(bin_of(point(i).array()).min(bins_ - 1)));
      ++starts_[bin[i] + 1];
    }
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    order_.resize(count());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (std::size_t i = 0; i < count(); ++i) order_[next[bin[i]]++] = static_cast<std::uint32_t>(i);
  }

  std::span<const float> points_;
  Eigen::Array3f low_;
  float cell_ = 1;
  Eigen::Array3i bins_;
  std::vector<std::uint32_t> starts_;  ///< of each bin's points in order_; one more at the end
  std::vector<std::uint32_t> order_;
};

}  // namespace bake
