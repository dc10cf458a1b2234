// SPDX-License-Identifier: MIT
// When the frames of a run are due.
#pragma once

#include <optional>

namespace bake {

struct Scene;

/// Frame k is due at k / run.frame_rate_per_s, but for the last one, which is due at the end of the run.
class FrameTimes {
 public:
  /// Of a run to the scene's end; with `frames`, of one that ends after so many, be it before the scene's end or behind it.
  /// Throws InputError if the frames cannot be counted.
  explicit FrameTimes(const Scene& scene, std::optional<int> frames = {});

  int last() const { return last_; }  ///< number of the last frame; the first one, at the start, has number 0
  double end_s() const { return (*this)(last_); }
  /// Frames behind the last one are due where a longer run would have them, which decides the length of the step behind the last frame. An
  /// end between two frames shortens the steps before it, so that no longer run has any of the times that follow it.
  double operator()(int frame) const;

 private:
  double rate_;
  double scene_end_s_;
  int whole_;  ///< frames up to this one are due at whole numbers of 1 / rate
  int last_;
};

}  // namespace bake
