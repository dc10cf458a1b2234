// SPDX-License-Identifier: MIT
// How many paths pixels get, on light that is drawn by chance.
#include "analysis/pictures/exposure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <set>

#include "analysis/pictures/samples.h"

namespace bake {
namespace {

Colour as_it_is(const Colour& light) { return light; }

/// Up to 64 paths for each of 40 x 40 pixels, 5 x 5 tiles.
Exposure exposure_to(float noise) {
  Exposure exposure{40, 40, 64, 1};
  exposure.noise = noise;
  exposure.shown = &as_it_is;
  return exposure;
}

/// From 0 to below 1.
float chance(int row, int column, std::uint32_t path) {
  return Random((static_cast<std::uint64_t>(row) * 1000 + static_cast<std::uint64_t>(column)) << 32 | path).uniform();
}

/// Dark but for rare bright paths: a mean of 0.25 and a standard deviation of 0.56.
Colour rare_light(int row, int column, std::uint32_t path) { return Colour::Constant(chance(row, column, path) < 1.0f / 6 ? 1.5f : 0); }

/// The same, brighter from left to right: a mean of 0.125 over the whole picture.
Colour uneven_light(int row, int column, std::uint32_t path) {
  return rare_light(row, column, path) * ((static_cast<float>(column) + 0.5f) / 40);
}

int paths_at(const Radiance& picture, int row, int column) {
  return picture.paths[static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(column)];
}

double mean_of(const Radiance& picture) {
  double sum = 0;
  for (const Colour& pixel : picture.pixels) sum += pixel[0];
  return sum / static_cast<double>(picture.pixels.size());
}

TEST(Exposure, EvenLightEndsAfterTheFirstBatch) {
  const Radiance picture = expose(exposure_to(0.001f), [](int, int, std::uint32_t) { return Colour::Constant(0.25f); });
  EXPECT_EQ(std::set(picture.paths.begin(), picture.paths.end()), std::set{16});
  for (const Colour& pixel : picture.pixels) EXPECT_EQ(pixel, Colour::Constant(0.25f));
}

TEST(Exposure, NoisyCornerAndTilesBesideItGetAllPaths) {
  const auto corner = [](int row, int column, std::uint32_t path) {
    return row < 4 && column < 4 ? rare_light(row, column, path) : Colour::Constant(0.25f);
  };
  const Radiance picture = expose(exposure_to(0.01f), corner);
  for (int row = 0; row < 40; ++row)
    for (int column = 0; column < 40; ++column) EXPECT_EQ(paths_at(picture, row, column), row < 16 && column < 16 ? 64 : 16);
}

TEST(Exposure, WithoutABoundOnNoiseEveryPixelGetsAllPaths) {
  const Radiance picture = expose(exposure_to(0), [](int, int, std::uint32_t) { return Colour::Constant(0.25f); });
  EXPECT_EQ(std::set(picture.paths.begin(), picture.paths.end()), std::set{64});
}

TEST(Exposure, LastBatchEndsAtTheMostPaths) {
  Exposure exposure = exposure_to(0.001f);
  for (const int samples : {1, 7, 16, 20, 50}) {
    exposure.samples = samples;
    const Radiance picture = expose(exposure, rare_light);
    EXPECT_EQ(std::set(picture.paths.begin(), picture.paths.end()), std::set{samples});
  }
}

TEST(Exposure, LightThatIsNotANumberIsNoise) {
  const Radiance picture = expose(exposure_to(0.1f), [](int, int, std::uint32_t) { return Colour::Constant(NAN); });
  EXPECT_EQ(std::set(picture.paths.begin(), picture.paths.end()), std::set{64});
}

/// The noise of light grows from left to right. Where it ends early what is left is below the bound, by the same light's known mean.
TEST(Exposure, LessNoiseIsLeftThanTheBound) {
  Exposure exposure = exposure_to(0.02f);
  exposure.width = 240;
  const auto light = [](int row, int column, std::uint32_t path) {
    const float deviation = 0.16f * static_cast<float>(column) / 240;  // left over after 64 paths: 0.02 at most
    return Colour::Constant(0.5f + deviation * std::sqrt(12.0f) * (chance(row, column, path) - 0.5f));
  };
  const Radiance picture = expose(exposure, light);
  EXPECT_EQ(paths_at(picture, 0, 0), 16);
  EXPECT_GT(paths_at(picture, 0, 230), 48);
  for (int tile = 0; tile < 30; ++tile) {
    double sum = 0;
    for (int row = 0; row < 40; ++row)
      for (int column = 8 * tile; column < 8 * tile + 8; ++column)
        sum += std::pow(picture.pixels[static_cast<std::size_t>(row * 240 + column)][0] - 0.5, 2);
    EXPECT_LT(std::sqrt(sum / 320), 1.1 * 0.02) << tile;
  }
}

/// Light of rare bright paths is the hardest: tiles that miss some look quiet and dark. With all paths the mean of the picture has a
/// standard deviation of 0.56 / sqrt(3 * 1600 * 64) = 0.001.
TEST(Exposure, MeanIsThatOfAllPaths) {
  const double all = mean_of(expose(exposure_to(0), uneven_light));
  EXPECT_NEAR(all, 0.125, 4 * 0.001);
  for (const float noise : {0.05f, 0.07f, 0.1f}) {
    const Radiance picture = expose(exposure_to(noise), uneven_light);
    EXPECT_GT(std::set(picture.paths.begin(), picture.paths.end()).size(), 1u) << noise;
    EXPECT_NEAR(mean_of(picture), all, 0.06 * noise) << noise;
  }
}

TEST(Exposure, SameBitsForAnyNumberOfThreads) {
  const auto picture = [](int threads) {
    Exposure exposure = exposure_to(0.07f);
    exposure.threads = threads;
    return expose(exposure, uneven_light);
  };
  const Radiance one = picture(1);
  EXPECT_GT(std::set(one.paths.begin(), one.paths.end()).size(), 1u);
  for (const int threads : {2, 3}) {
    const Radiance other = picture(threads);
    EXPECT_EQ(one.paths, other.paths);
    EXPECT_EQ(std::memcmp(one.pixels.data(), other.pixels.data(), one.pixels.size() * sizeof one.pixels[0]), 0);
  }
}

TEST(Exposure, ProgressRisesToOne) {
  double last = 0;
  expose(exposure_to(0.07f), uneven_light, [&](double share) {
    EXPECT_GE(share, last);
    last = share;
  });
  EXPECT_EQ(last, 1);
}

}  // namespace
}  // namespace bake
