// SPDX-License-Identifier: MIT
// How many paths of light each pixel of a picture gets: more where it is noisy.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "analysis/image/colour.h"

namespace bake {

struct Exposure {
  int width = 1280, height = 960;  ///< pixels
  int samples = 64;                ///< most paths per pixel
  int threads = 1;
  int most_bounces = 8;
  float noise = 0;  ///< where less than this is left of it no further paths are taken; share of white, as shown. 0: all paths everywhere
  std::function<Colour(const Colour&)> shown = &srgb_from_linear;  ///< how bright light is in the finished picture, 0 to 1 a channel
};

/// Linear radiance, row by row from the top.
struct Radiance {
  int width = 0, height = 0;
  std::vector<Colour> pixels;
  std::vector<int> paths;  ///< that were taken, of each pixel
};

/// The light of one path of a pixel. Depends on nothing but these three numbers; is called by several threads.
using TakePath = std::function<Colour(int row, int column, std::uint32_t path)>;

/// The mean of each pixel's paths.
///
/// With `noise` paths are taken in batches of 16, tile by tile of 8 x 8 pixels (Dammertz et al. 2010, "A hierarchical automatic stopping
/// condition for Monte Carlo global illumination"). The paths of a pixel form two halves, whose means are A and B. Their mean (A + B) / 2
/// has the variance of (A - B) / 2, so that the noise of a tile is the root mean square, over its pixels and channels, of
/// (shown(A) - shown(B)) / 2. Even samples make it less: this is an upper bound. Where it is at least `noise`, and in all tiles around, so
/// that an edge that runs through a corner of a tile is not missed, a further batch is taken. Whether a pixel goes on depends on its
/// light, so that means are not quite without bias; it is far below `noise`.
///
/// The same bits for any number of threads. The first thread calls `progress(share done)` now and then, and at the end.
Radiance expose(const Exposure& exposure, const TakePath& take_path, const std::function<void(double share)>& progress = {});

}  // namespace bake
