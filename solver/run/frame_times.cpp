// SPDX-License-Identifier: MIT
#include "solver/run/frame_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/core/errors.h"
#include "solver/scene/scene.h"

namespace bake {

namespace {

constexpr double k_most_frames = 1e9;
constexpr int k_all = std::numeric_limits<int>::max();

/// What differs from a whole number by no more than this is one, written with few digits or divided once.
double round_off(double frames) { return 1e-9 + 4 * std::numeric_limits<double>::epsilon() * frames; }

}  // namespace

FrameTimes::FrameTimes(const Scene& scene, std::optional<int> frames)
    : rate_(scene.run.frame_rate_per_s), scene_end_s_(scene.run.end_s), whole_(k_all), last_(0) {
  const double count = scene_end_s_ * rate_, nearest = std::round(count);
  if (count <= k_most_frames) {
    const bool ends_at_a_frame = nearest >= 1 && std::abs(count - nearest) <= round_off(count);
    last_ = static_cast<int>(ends_at_a_frame ? nearest : std::max(1.0, std::ceil(count)));
    if (!ends_at_a_frame) whole_ = last_ - 1;
  } else if (!frames) {
    throw InputError(
        fmt::format("{}: found {:g} s, that is {:.3g} frames at {:g} a second, allowed: up to {:g} frames (a smaller "
                    "run.end_s or run.frame_rate_per_s)",
                    scene.at("run.end_s"), scene_end_s_, count, rate_, k_most_frames));
  }
  if (!frames) return;
  if (*frames > last_) whole_ = k_all;
  last_ = *frames;
}

double FrameTimes::operator()(int frame) const { return frame <= whole_ ? frame / rate_ : scene_end_s_ + (frame - whole_ - 1) / rate_; }

}  // namespace bake
