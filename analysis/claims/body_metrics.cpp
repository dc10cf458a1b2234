// SPDX-License-Identifier: MIT
// Metrics of a body as a whole between two frames: is it one piece, has it turned, has it kept its shape?
#include <fmt/format.h>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "analysis/claims/finite.h"
#include "analysis/claims/metric.h"
#include "solver/core/union_find.h"

namespace bake {
namespace {

/// Joins all points that are no farther apart than `reach`; `positions` has three numbers a point.
UnionFind joined(const std::vector<double>& positions, double reach) {
  const std::size_t count = positions.size() / 3;
  std::map<std::array<long, 3>, std::vector<std::size_t>> cells;  // as wide as the reach: neighbours are in cells side by side
  const auto cell_of = [&](const Vector3& x) {
    return std::array{std::lround(x[0] / reach), std::lround(x[1] / reach), std::lround(x[2] / reach)};
  };
  for (std::size_t i = 0; i < count; ++i) cells[cell_of(position(positions, i))].push_back(i);
  UnionFind sets(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3 x = position(positions, i);
    const auto at = cell_of(x);
    for (long a = -1; a <= 1; ++a)
      for (long b = -1; b <= 1; ++b)
        for (long c = -1; c <= 1; ++c) {
          const auto cell = cells.find({at[0] + a, at[1] + b, at[2] + c});
          if (cell == cells.end()) continue;
          for (const std::size_t j : cell->second) {
            const Vector3 y = position(positions, j);
            if (j < i && std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]) <= reach)
              sets.unite(static_cast<std::int32_t>(i), static_cast<std::int32_t>(j));
          }
        }
  }
  return sets;
}

/// Particles are together if they are no farther apart than one and a half times their size, which Poisson disks are: to that distance an
/// even body has no gaps.
double largest_lump(const Results& run, const MetricPlace& at) {
  constexpr double k_reach = 1.5;
  const CheckedFrame frame = run.frame(run.frame_at(at.time_s));
  const auto volumes = frame.column("volume");
  const double all = std::accumulate(volumes.begin(), volumes.end(), 0.0);
  if (!(all > 0)) return std::nan("");
  UnionFind lumps = joined(frame.positions(), k_reach * std::cbrt(all / static_cast<double>(volumes.size())));
  std::vector<double> volume_of(volumes.size(), 0);
  for (std::size_t i = 0; i < volumes.size(); ++i)
    volume_of[static_cast<std::size_t>(lumps.find(static_cast<std::int32_t>(i)))] += static_cast<double>(volumes[i]);
  return *std::max_element(volume_of.begin(), volume_of.end()) / all;
}

/// Where the particles that are in both frames are in each: one column a particle.
struct BothFrames {
  Eigen::Matrix3Xd before, after;

  BothFrames(const Results& run, const MetricPlace& at) {
    const CheckedFrame then = run.frame(at.reference_time_s ? run.frame_at(at.reference_time_s) : 0),
                       now = run.frame(run.frame_at(at.time_s));
    const auto from = then.positions(), to = now.positions();
    const std::vector<std::int64_t> rows = rows_in(then, now);
    before.resize(3, static_cast<Eigen::Index>(rows.size()));
    after.resize(3, before.cols());
    Eigen::Index count = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i] < 0) continue;
      const Vector3 x = position(from, static_cast<std::size_t>(rows[i])), y = position(to, i);
      before.col(count) << x[0], x[1], x[2];
      after.col(count++) << y[0], y[1], y[2];
    }
    if (count < 3) throw NoNumber(fmt::format("{}: found {} particles in both frames, allowed: 3", run.folder().string(), count));
    before.conservativeResize(3, count);
    after.conservativeResize(3, count);
  }
  /// The turn that, with a shift, brings the one as near to the other as one can. [Kabsch 1976]
  Eigen::Matrix3d turn() const {
    const Eigen::Matrix3d moments = about_middle(after) * about_middle(before).transpose();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moments, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Vector3d sign(1, 1, svd.matrixU().determinant() * svd.matrixV().determinant());  // no reflection
    return svd.matrixU() * sign.asDiagonal() * svd.matrixV().transpose();
  }
  static Eigen::Matrix3Xd about_middle(const Eigen::Matrix3Xd& places) { return places.colwise() - places.rowwise().mean(); }
};

double turned_up(const Results& run, const MetricPlace& at) { return BothFrames(run, at).turn()(2, 2); }

double deformation(const Results& run, const MetricPlace& at) {
  const BothFrames frames(run, at);
  const Eigen::Matrix3Xd before = BothFrames::about_middle(frames.before), after = BothFrames::about_middle(frames.after);
  return (after - frames.turn() * before).norm() / before.norm();
}

/// The length along axis `d` of the middle 98 % of the particles: a whole body's ends would be one particle each.
double middle_extent(const Eigen::Matrix3Xd& places, Eigen::Index d) {
  std::vector<double> sorted(places.row(d).begin(), places.row(d).end());
  std::sort(sorted.begin(), sorted.end());
  const std::size_t left_out = sorted.size() / 100;
  return sorted[sorted.size() - 1 - left_out] - sorted[left_out];
}

double width_change(const Results& run, const MetricPlace& at) {
  const BothFrames frames(run, at);
  double change = 0;
  for (Eigen::Index d = 0; d < 2; ++d)
    change = larger(change, std::abs(middle_extent(frames.after, d) / middle_extent(frames.before, d) - 1));
  return change;
}

}  // namespace

std::vector<Metric> body_metrics() {
  constexpr Range cosine{-1, 1, false, false, "a number from -1 to 1"};
  return {
      {"largest_lump", "1", fraction, "share of the volume in the largest lump of particles that lie side by side: 1 if all is one piece",
       largest_lump, needs(), knows("time_s")},
      {"turned_up", "1", cosine,
       "cosine of the angle between up and where the best rigid motion since reference_time_s has taken it: -1 upside down", turned_up,
       needs(), knows("reference_time_s", "time_s")},
      {"deformation", "1", non_negative,
       "root mean square distance from where that rigid motion alone would have taken each particle, over that from the middle",
       deformation, needs(), knows("reference_time_s", "time_s")},
      {"width_change", "1", non_negative,
       "relative change since reference_time_s of the length along x or y, whichever is larger, of the middle 98 % of the particles",
       width_change, needs(), knows("reference_time_s", "time_s")},
  };
}

}  // namespace bake
