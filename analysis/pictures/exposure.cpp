// SPDX-License-Identifier: MIT
#include "analysis/pictures/exposure.h"

#include <omp.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace bake {
namespace {

constexpr int k_tile = 8;    ///< pixels along an edge: enough of them to tell their noise within a tenth
constexpr int k_batch = 16;  ///< paths: eight in each half

struct Tile {
  int row, column;  ///< among tiles
  int paths = 0;    ///< of each pixel
  bool noisy = true;
};

class Tiles {
 public:
  Tiles(const Exposure& exposure, const TakePath& take_path)
      : exposure_(exposure),
        take_path_(take_path),
        rows_((exposure.height + k_tile - 1) / k_tile),
        columns_((exposure.width + k_tile - 1) / k_tile),
        batch_(exposure.noise > 0 ? k_batch : exposure.samples),
        sums_(static_cast<std::size_t>(exposure.width) * static_cast<std::size_t>(exposure.height), {Colour::Zero(), Colour::Zero()}) {
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column) tiles_.push_back({row, column});
  }

  void take_all(const std::function<void(double)>& progress) {
    std::vector<Tile*> open;
    for (Tile& tile : tiles_) open.push_back(&tile);
    for (int taken = 0; !open.empty(); taken += batch_) {
      const auto count = static_cast<int>(open.size());
      int done = 0;
#pragma omp parallel for schedule(dynamic, 1) num_threads(exposure_.threads)
      for (int i = 0; i < count; ++i) {
        take_batch(*open[static_cast<std::size_t>(i)]);
        int now;
#pragma omp atomic capture
        now = ++done;
        if (progress && omp_get_thread_num() == 0) progress(share_done(count, now, taken));
      }
      std::vector<Tile*> next;
      std::copy_if(open.begin(), open.end(), std::back_inserter(next), [&](const Tile* tile) { return goes_on(*tile); });
      open = std::move(next);
    }
  }

  Radiance means() const {
    Radiance picture{exposure_.width, exposure_.height, {}, {}};
    for (int y = 0; y < exposure_.height; ++y)
      for (int x = 0; x < exposure_.width; ++x) {
        const auto& [a, b] = sums_[index(y, x)];
        const int paths = tile_at(y / k_tile, x / k_tile).paths;
        picture.pixels.push_back((a + b) / static_cast<float>(paths));
        picture.paths.push_back(paths);
      }
    return picture;
  }

 private:
  std::size_t index(int y, int x) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(exposure_.width) + static_cast<std::size_t>(x);
  }
  const Tile& tile_at(int row, int column) const {
    return tiles_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column)];
  }

  template <class Visit>
  void for_each_pixel(const Tile& tile, Visit visit) const {
    for (int y = tile.row * k_tile; y < std::min((tile.row + 1) * k_tile, exposure_.height); ++y)
      for (int x = tile.column * k_tile; x < std::min((tile.column + 1) * k_tile, exposure_.width); ++x) visit(y, x);
  }

  void take_batch(Tile& tile) {
    const int end = std::min(tile.paths + batch_, exposure_.samples);
    for_each_pixel(tile, [&](int y, int x) {
      auto& halves = sums_[index(y, x)];
      for (int i = tile.paths; i < end; ++i)
        halves[static_cast<std::size_t>(i / (k_batch / 2) % 2)] += take_path_(y, x, static_cast<std::uint32_t>(i));
    });
    tile.paths = end;
    if (end < exposure_.samples) tile.noisy = !(noise(tile) < exposure_.noise);  // what is not a number is noisy
  }

  /// Of a tile whose halves have equally many paths.
  float noise(const Tile& tile) const {
    const float half = static_cast<float>(tile.paths) / 2;
    float sum = 0;
    int count = 0;
    for_each_pixel(tile, [&](int y, int x) {
      const auto& [a, b] = sums_[index(y, x)];
      sum += ((exposure_.shown(a / half) - exposure_.shown(b / half)) / 2).squaredNorm();
      count += 3;
    });
    return std::sqrt(sum / static_cast<float>(count));
  }

  bool goes_on(const Tile& tile) const {
    if (tile.paths >= exposure_.samples) return false;
    for (int row = std::max(0, tile.row - 1); row <= std::min(rows_ - 1, tile.row + 1); ++row)
      for (int column = std::max(0, tile.column - 1); column <= std::min(columns_ - 1, tile.column + 1); ++column)
        if (tile_at(row, column).noisy) return true;
    return false;
  }

  /// Of the whole picture, when `done` of `open` tiles, which had `taken` paths, have got a batch more. What does not go on is done.
  double share_done(int open, int done, int taken) const {
    const double left = exposure_.samples - taken, batch = std::min<double>(batch_, left);
    return 1 - (open * left - done * batch) / (static_cast<double>(tiles_.size()) * exposure_.samples);
  }

  const Exposure& exposure_;
  const TakePath& take_path_;
  int rows_, columns_, batch_;
  std::vector<std::array<Colour, 2>> sums_;  ///< of the light of the paths of each half
  std::vector<Tile> tiles_;
};

}  // namespace

Radiance expose(const Exposure& exposure, const TakePath& take_path, const std::function<void(double)>& progress) {
  Tiles tiles(exposure, take_path);
  tiles.take_all(progress);
  if (progress) progress(1);
  return tiles.means();
}

}  // namespace bake
