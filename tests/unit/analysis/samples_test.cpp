// SPDX-License-Identifier: MIT
#include "analysis/pictures/samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

namespace bake {
namespace {

/// Of each box of 2^-i by 2^(i-k) one of the 2^k points.
TEST(Samples, EachBoxOfEqualAreaHoldsOnePoint) {
  for (const std::uint32_t seed : {1u, 77u})
    for (const int k : {3, 4, 6})
      for (const std::uint32_t first : {0u, 1u << k, 5u << k})
        for (int i = 0; i <= k; ++i) {
          std::set<std::pair<int, int>> boxes;
          for (std::uint32_t n = first; n < first + (1u << k); ++n) {
            const Sample2 s = even_sample(n, seed);
            ASSERT_TRUE(s.u >= 0 && s.u < 1 && s.v >= 0 && s.v < 1);
            boxes.emplace(static_cast<int>(s.u * static_cast<float>(1 << i)), static_cast<int>(s.v * static_cast<float>(1 << (k - i))));
          }
          EXPECT_EQ(boxes.size(), 1u << k) << "k " << k << ", i " << i << ", from " << first;
        }
}

/// The mean of a product of independent numbers is the product of their means; 1 / 12 is the variance of each.
TEST(Samples, ChoicesOfAPathAreIndependent) {
  double sum = 0;
  constexpr int k_pixels = 400, k_paths = 64;
  for (std::uint32_t pixel = 0; pixel < k_pixels; ++pixel)
    for (std::uint32_t path = 0; path < k_paths; ++path) {
      PathSamples samples(pixel, path);
      const auto at_hit = samples.at_hit(0);
      sum += (at_hit.lamp.u - 0.5) * (at_hit.direction.u - 0.5);
    }
  EXPECT_NEAR(sum / (k_pixels * k_paths), 0, 4.0 / 12 / std::sqrt(k_pixels * k_paths));
}

/// The mean of a smooth function over the unit square.
TEST(Samples, ErrorFallsFasterThanThatOfChance) {
  const auto error = [](std::uint32_t count) {
    double squares = 0;
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
      double sum = 0;
      for (std::uint32_t i = 0; i < count; ++i) {
        const Sample2 s = even_sample(i, mixed(seed));
        sum += s.u * s.u * s.v;
      }
      squares += std::pow(sum / count - 1.0 / 6, 2);
    }
    return std::sqrt(squares / 200);
  };
  EXPECT_LT(error(64), error(4) / 30);  // 4 by chance, 64 for a smooth integrand
}

}  // namespace
}  // namespace bake
