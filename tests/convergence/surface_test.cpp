// SPDX-License-Identifier: MIT
// `bake study surface` at its quick resolutions. Bands and their reasons stand in experiments/surface.
#include "experiments/surface/surface.h"

#include <gtest/gtest.h>

namespace bake::studies {
namespace {

class TheSurface : public testing::Test {
 protected:
  static void SetUpTestSuite() { areas_ = measure_areas(true); }
  static void expect_held(bool smooth) {
    int seen = 0;
    for (const Areas& a : areas_)
      if (a.form == "standard" && a.smooth == smooth) {
        ++seen;
        EXPECT_TRUE(holds(a)) << a.body << ", " << a.particles_per_cell << " particles a cell: " << largest_error(a) << ", allowed "
                              << claim_of(a).most << " (" << claim_of(a).why << ")";
      }
    EXPECT_GE(seen, 3);
  }
  static inline std::vector<Areas> areas_;
};

TEST_F(TheSurface, OfASmoothBodyIsFoundFromFourCellsOn) { expect_held(true); }
TEST_F(TheSurface, OfABodyWithEdgesIsFoundFromFourCellsOn) { expect_held(false); }

// Boundary particles stand for discs whose number goes with dx^-2 and whose area with dx^2: their sum tends to a share of the true area
// that depends on the particles per cell alone.
TEST_F(TheSurface, AsPublishedIsNotFoundByRefining) {
  for (const Areas& a : areas_)
    if (a.form == "published") {
      EXPECT_LT(a.ratios.back(), 0.7) << a.body << ", " << a.particles_per_cell << " particles a cell";
    }
}

}  // namespace
}  // namespace bake::studies
