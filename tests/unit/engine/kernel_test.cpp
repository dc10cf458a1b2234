// SPDX-License-Identifier: MIT
#include "solver/grid/kernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/unit/engine/kernel_cases.h"

namespace bake {
namespace {

template <class C>
class BSpline : public testing::Test {
 public:
  using Real = typename C::Real;
  using V = Lanes<Real>;
  using S = Stencil<Real, C::order>;
  static constexpr int N = Kernel<C::order>::support;
  static constexpr double k_D = 1.0 / Kernel<C::order>::inverse_d;  // in units of dx^2: 1/4 quadratic, 1/3 cubic
  // Weights are below one and computed with fewer than ten roundings each.
  static constexpr double k_bound = 16 * static_cast<double>(std::numeric_limits<Real>::epsilon());

  /// Calls visit(x, stencil, lane) for positions all over one block and its margin.
  template <class Visit>
  static void everywhere(Visit visit) {
    const double low = Kernel<C::order>::lowest_base + Kernel<C::order>::base_shift;
    const double high = Kernel<C::order>::highest_base + 1 + Kernel<C::order>::base_shift - 1e-5;
    constexpr int k_positions = 4096;
    for (int i = 0; i < k_positions; i += k_width<Real>) {
      V x[3];
      for (int l = 0; l < k_width<Real>; ++l)
        for (int d = 0; d < 3; ++d) {
          const int mixed = (i + l) * (d == 0 ? 1 : d == 1 ? 1021 : 2731) % k_positions;  // all axes take all values
          x[d][l] = static_cast<Real>(low + (high - low) * mixed / (k_positions - 1));
        }
      const S stencil(x);
      for (int l = 0; l < k_width<Real>; ++l) visit(x, stencil, l);
    }
  }
};

TYPED_TEST_SUITE(BSpline, KernelCases);

TYPED_TEST(BSpline, WeightsAreAPartitionOfUnityAndNeverNegative) {
  TestFixture::everywhere([](const auto&, const auto& s, int l) {
    for (int d = 0; d < 3; ++d) {
      double sum = 0;
      for (int j = 0; j < TestFixture::N; ++j) {
        EXPECT_GE(static_cast<double>(s.weight[d][j][l]), -TestFixture::k_bound);
        sum += static_cast<double>(s.weight[d][j][l]);
      }
      ASSERT_NEAR(sum, 1, TestFixture::k_bound);
    }
  });
}

TYPED_TEST(BSpline, WeightsErrInNoDirection) {
  double excess = 0;
  int sums = 0;
  TestFixture::everywhere([&](const auto&, const auto& s, int l) {
    for (int d = 0; d < 3; ++d, ++sums) {
      for (int j = 0; j < TestFixture::N; ++j) excess += static_cast<double>(s.weight[d][j][l]);
      excess -= 1;
    }
  });
  // 12 288 sums, each off by at most one rounding of a number below 1 and as likely up as down: four standard errors, half a rounding each
  EXPECT_NEAR(excess / sums, 0, 4 * TestFixture::k_bound / 32 / std::sqrt(sums));
}

TYPED_TEST(BSpline, FirstMomentIsZeroAndSecondIsD) {
  TestFixture::everywhere([](const auto& x, const auto& s, int l) {
    for (int d = 0; d < 3; ++d) {
      double first = 0, second = 0;
      for (int j = 0; j < TestFixture::N; ++j) {
        const double r = static_cast<double>(s.base[d][l]) + j - static_cast<double>(x[d][l]);
        first += static_cast<double>(s.weight[d][j][l]) * r;
        second += static_cast<double>(s.weight[d][j][l]) * r * r;
      }
      ASSERT_NEAR(first, 0, 2 * TestFixture::k_bound);
      ASSERT_NEAR(second, TestFixture::k_D, 4 * TestFixture::k_bound);
    }
  });
}

TYPED_TEST(BSpline, OffsetIsTheDistanceFromTheSecondNode) {
  TestFixture::everywhere([](const auto& x, const auto& s, int l) {
    for (int d = 0; d < 3; ++d) ASSERT_NEAR(x[d][l], s.base[d][l] + 1 + s.offset[d][l], TestFixture::k_bound);
  });
}

TYPED_TEST(BSpline, StencilsOfABlockAndItsMarginStayInItsTile) {
  TestFixture::everywhere([](const auto&, const auto& s, int l) {
    ASSERT_EQ(s.outside()[l], 0);
    for (int d = 0; d < 3; ++d) {
      ASSERT_GE(s.base[d][l], Kernel<TypeParam::order>::lowest_base);
      ASSERT_LE(s.base[d][l] + TestFixture::N - 1, 6);  // the tile's nodes are -1..6
    }
  });
}

TYPED_TEST(BSpline, PositionsBeyondTheMarginAreOutside) {
  using Real = typename TypeParam::Real;
  constexpr double shift = Kernel<TypeParam::order>::base_shift;
  for (const double beyond :
       {Kernel<TypeParam::order>::lowest_base + shift - 1e-3, Kernel<TypeParam::order>::highest_base + 1 + shift + 1e-3, 1e6,
        std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (int d = 0; d < 3; ++d) {
      Lanes<Real> x[3] = {lanes<Real>(2), lanes<Real>(2), lanes<Real>(2)};
      x[d] = lanes<Real>(static_cast<Real>(beyond));
      EXPECT_NE((Stencil<Real, TypeParam::order>(x).outside()[0]), 0) << beyond << " axis " << d;
    }
}

}  // namespace
}  // namespace bake
