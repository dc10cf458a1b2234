// SPDX-License-Identifier: MIT
#include "solver/engine/conduction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "tests/unit/engine/kernel_cases.h"

namespace bake {
namespace {

/// W - 1 particles anywhere in the reach of one block, against sums over all nodes in doubles.
template <class C>
class ConductingParticles : public testing::Test {
 public:
  using Real = typename C::Real;
  using V = Lanes<Real>;
  using P = Conducting<Real, C::order>;
  using Tile = typename P::Tile;
  static constexpr int N = Kernel<C::order>::support, count = k_width<Real> - 1;
  static constexpr double k_bound = 64 * static_cast<double>(std::numeric_limits<Real>::epsilon());

  ConductingParticles() {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(Kernel<C::order>::lowest_base + Kernel<C::order>::base_shift,
                                                 Kernel<C::order>::highest_base + 1 + Kernel<C::order>::base_shift - 1e-5);
    for (auto& component : x)
      for (int l = 0; l < k_width<Real>; ++l) component[l] = static_cast<Real>(place(random));
  }

  /// Calls visit(tile row, w, r) for the nodes of a particle.
  template <class Visit>
  void nodes_of(int p, Visit visit) const {
    const Stencil<Real, C::order> s(x);
    for (int j = 0; j < N; ++j)
      for (int k = 0; k < N; ++k)
        for (int l = 0; l < N; ++l) {
          const int at[3] = {j, k, l};
          double w = 1, r[3];
          std::size_t row = 0;
          for (int d = 0; d < 3; ++d) {
            const int node = static_cast<int>(s.base[d][p]) + at[d];
            w *= static_cast<double>(s.weight[d][at[d]][p]);
            r[d] = node - static_cast<double>(x[d][p]);
            row += static_cast<std::size_t>((node + 1) * (d == 0 ? k_tile_plane : d == 1 ? k_tile_side : 1));
          }
          visit(row, w, r);
        }
  }

  static Tile random_nodes(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> number(-1, 1);
    Tile tile;
    for (Real& node : tile.node) node = static_cast<Real>(number(random));
    return tile;
  }

  V x[3];
};

TYPED_TEST_SUITE(ConductingParticles, KernelCases);

TYPED_TEST(ConductingParticles, GatherTheMomentsOfTheirNodes) {
  const auto theta = this->random_nodes(1);
  typename TestFixture::V gradient[3];
  typename TestFixture::P{Stencil<typename TypeParam::Real, TypeParam::order>(this->x)}.gather(theta, this->count, gradient);
  for (int p = 0; p < this->count; ++p) {
    double expected[3] = {};
    this->nodes_of(p, [&](std::size_t row, double w, const double(&r)[3]) {
      for (int d = 0; d < 3; ++d) expected[d] += w * r[d] * static_cast<double>(theta.node[row]);
    });
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(gradient[d][p], expected[d], this->k_bound) << p << " axis " << d;
  }
}

TYPED_TEST(ConductingParticles, SeeNoGradientInAUniformTemperature) {
  typename TestFixture::Tile theta;
  std::fill(std::begin(theta.node), std::end(theta.node), typename TypeParam::Real(1));
  typename TestFixture::V gradient[3];
  typename TestFixture::P{Stencil<typename TypeParam::Real, TypeParam::order>(this->x)}.gather(theta, this->count, gradient);
  for (int p = 0; p < this->count; ++p)
    for (int d = 0; d < 3; ++d) EXPECT_NEAR(gradient[d][p], 0, this->k_bound);
}

/// So K is symmetric, and what one node loses others gain.
TYPED_TEST(ConductingParticles, ScatterWithTheTransposeOfTheGather) {
  const typename TestFixture::P particles{Stencil<typename TypeParam::Real, TypeParam::order>(this->x)};
  const auto flux_of = this->random_nodes(2);
  typename TestFixture::V flux[3];
  for (int d = 0; d < 3; ++d)
    for (int p = 0; p < k_width<typename TypeParam::Real>; ++p) flux[d][p] = flux_of.node[3 * p + d];
  typename TestFixture::Tile sum;
  particles.scatter(flux, this->count, sum);
  std::vector<double> expected(std::size(sum.node));
  for (int p = 0; p < this->count; ++p)
    this->nodes_of(p, [&](std::size_t row, double w, const double(&r)[3]) {
      for (int d = 0; d < 3; ++d) expected[row] += w * r[d] * static_cast<double>(flux[d][p]);
    });
  double total = 0;
  for (std::size_t row = 0; row < expected.size(); ++row) {
    EXPECT_NEAR(sum.node[row], expected[row], this->k_bound) << row;
    total += static_cast<double>(sum.node[row]);
  }
  EXPECT_NEAR(total, 0, this->k_bound);
}

}  // namespace
}  // namespace bake
