// SPDX-License-Identifier: MIT
// The layer between a drying surface and nodes that lie deeper than drying has gone.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "solver/effects/water.h"

namespace bake {
namespace {

/// s_t = (s s_x)_x in a half-space that begins with s = 1 and has s s_x = s at its surface: implicit finite volumes, which widen with
/// depth.
class DryingHalfSpace {
 public:
  DryingHalfSpace() : width_(k_cells), middle_(k_cells), s_(k_cells, 1.) {
    const auto face = [](int i) { return 60 * std::pow(static_cast<double>(i) / k_cells, 3); };
    for (int i = 0; i < k_cells; ++i) {
      width_[at(i)] = face(i + 1) - face(i);
      middle_[at(i)] = (face(i + 1) + face(i)) / 2;
    }
  }
  double time() const { return time_; }
  double surface() const { return surface_; }
  void step(double dt) {
    const double a = 1 / (2 * middle_[0]);  // s^2 falls along a straight line within the first cell
    const double share = (std::sqrt(1 + 4 * a * a * s_[0] * s_[0]) - 1) / (2 * a * s_[0]);
    std::vector<double> flow(k_cells + 1), factor(k_cells), right(k_cells);
    for (int i = 1; i < k_cells; ++i) flow[at(i)] = (s_[at(i)] + s_[at(i - 1)]) / 2 / (middle_[at(i)] - middle_[at(i - 1)]);
    for (int i = 0; i < k_cells; ++i) {  // Thomas
      const double before = i > 0 ? factor[at(i - 1)] : 0;
      const double diagonal = width_[at(i)] / dt + flow[at(i)] + flow[at(i + 1)] + (i == 0 ? share : 0) - flow[at(i)] * before;
      factor[at(i)] = flow[at(i + 1)] / diagonal;
      right[at(i)] = (width_[at(i)] / dt * s_[at(i)] + (i > 0 ? flow[at(i)] * right[at(i - 1)] : 0)) / diagonal;
    }
    for (int i = k_cells - 1; i >= 0; --i) s_[at(i)] = right[at(i)] + (i + 1 < k_cells ? factor[at(i)] * s_[at(i + 1)] : 0);
    time_ += dt;
    surface_ = share * s_[0];
  }

 private:
  static constexpr int k_cells = 400;
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  std::vector<double> width_, middle_, s_;
  double time_ = 0, surface_ = 1;
};

double reach(double s, double spread, double h) { return Water::reach(lanes<double>(s), lanes<double>(spread), lanes<double>(h))[0]; }

TEST(TheLayerOfADryingSurface, ResistsAsFiniteVolumesSayFromTheFirstMomentUntilTheSurfaceIsDry) {
  DryingHalfSpace dough;
  double wettest = 0, driest = 1;
  for (double dt = 1e-6; dough.time() < 30; dt = std::min(1.02 * dt, 0.3)) {
    dough.step(dt);
    if (dough.time() < 1e-4) continue;  // its first cells are still to be seen
    const double s = dough.surface(), d = (1 - s * s) / (2 * s);
    ASSERT_NEAR(reach(1, dough.time(), 1) / d, 1, 0.01) << dough.time();
    wettest = std::max(wettest, s), driest = std::min(driest, s);
  }
  EXPECT_GT(wettest, 0.98);
  EXPECT_LT(driest, 0.08);
}

TEST(TheLayerOfADryingSurface, ScalesAsTheEquationDoes) {
  // with s = s_0 u, x in s_0 / h, tau in s_0 / h^2
  for (const double s_0 : {0.01, 0.2, 0.9})
    for (const double h : {0.3, 16., 700.})
      for (const double t : {1e-3, 1., 1e3})
        EXPECT_NEAR(reach(s_0, t * s_0 / (h * h), h), s_0 / h * reach(1, t, 1), 1e-13 * s_0 / h * (1 + t));
}

TEST(TheLayerOfADryingSurface, IsNoneAtTheStartAndWhereThereIsNoWater) {
  EXPECT_EQ(reach(0.2, 0, 16), 0);
  EXPECT_EQ(reach(0, 1e-4, 16), 0);
  EXPECT_EQ(reach(0.2, 0, 0), 0);
}

}  // namespace
}  // namespace bake
