// SPDX-License-Identifier: MIT
#include "analysis/image/colour.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solver/scene/describe.h"

namespace bake {
namespace {

TEST(Colour, LinearAndBackIsTheSame) {
  for (float c = 0; c <= 1; c += 0.01f) {
    const Colour back = srgb_from_linear(linear_from_srgb(Colour::Constant(c)));
    EXPECT_NEAR(back[1], c, 1e-5f);
  }
  EXPECT_NEAR(linear_from_srgb(Colour::Constant(0.5f))[0], 0.2140f, 1e-4f);  // IEC 61966-2-1
}

TEST(Colour, LightnessOfKnownGreys) {
  EXPECT_NEAR(lightness(Colour::Zero()), 0, 1e-4);
  EXPECT_NEAR(lightness(Colour::Ones()), 100, 1e-3);
  EXPECT_NEAR(lightness(srgb_from_linear(Colour::Constant(0.184187f))), 50, 0.01);  // L* = 50
}

TEST(ColourMaps, SequentialOnesGetSteadilyLighter) {
  for (const ColourMap map : {ColourMap::viridis, ColourMap::cividis, ColourMap::inferno}) {
    float last = -1;
    for (int i = 0; i <= 256; ++i) {
      const float now = lightness(map_colour(map, static_cast<float>(i) / 256));
      EXPECT_GT(now, last) << word_of(map) << " at " << i;
      last = now;
    }
  }
}

/// Equal steps of the value look about equal: no step of lightness is more than twice the mean.
TEST(ColourMaps, SequentialOnesAreEven) {
  for (const ColourMap map : {ColourMap::viridis, ColourMap::cividis, ColourMap::inferno}) {
    const float whole = lightness(map_colour(map, 1)) - lightness(map_colour(map, 0));
    for (int i = 0; i < 16; ++i) {
      const float step =
          lightness(map_colour(map, static_cast<float>(i + 1) / 16)) - lightness(map_colour(map, static_cast<float>(i) / 16));
      EXPECT_LT(step, 2 * whole / 16) << word_of(map) << " at " << i;
    }
  }
}

TEST(ColourMaps, DivergingOneRisesToItsMiddleAndFalls) {
  float last = -1;
  for (int i = 0; i <= 256; ++i) {
    const float now = lightness(map_colour(ColourMap::vik, static_cast<float>(i) / 256));
    if (i <= 128) {
      EXPECT_GT(now, last) << i;
    }
    if (i > 128) {
      EXPECT_LT(now, last) << i;
    }
    last = now;
  }
}

TEST(ColourMaps, BeyondTheEndsAndForNoNumber) {
  EXPECT_EQ(map_colour(ColourMap::viridis, -3), map_colour(ColourMap::viridis, 0));
  EXPECT_EQ(map_colour(ColourMap::viridis, 7), map_colour(ColourMap::viridis, 1));
  EXPECT_EQ(map_colour(ColourMap::viridis, std::nanf("")), Colour::Constant(0.5f));
}

}  // namespace
}  // namespace bake
