// SPDX-License-Identifier: MIT
#include "solver/grid/kernel.h"
#include "tests/unit/laws/law.h"

namespace bake {
namespace {

template <class Scalar, KernelOrder k_order>
struct Case {
  using Real = Scalar;
  static constexpr KernelOrder order = k_order;
};

template <class C>
class BSplineLaw : public Law<typename C::Real> {};
using Cases = testing::Types<Case<float, KernelOrder::quadratic>, Case<float, KernelOrder::cubic>, Case<double, KernelOrder::quadratic>,
                             Case<double, KernelOrder::cubic>>;
TYPED_TEST_SUITE(BSplineLaw, Cases);

TYPED_TEST(BSplineLaw, LinearFieldsAreExactInValueAndGradient) {
  EXPECT_TRUE(rc::check([] {
    using Real = typename TypeParam::Real;
    using K = Kernel<TypeParam::order>;
    Lanes<Real> x[3];
    double g[3];
    for (int d = 0; d < 3; ++d) {
      x[d] = TestFixture::all(between(K::lowest_base + K::base_shift + 1e-3, K::highest_base + 1 + K::base_shift - 1e-3, "x"));
      g[d] = between(-10, 10, "gradient");
    }
    const double constant = between(-10, 10, "constant");
    const Stencil<Real, TypeParam::order> stencil(x);

    double sum = 0, value = 0, first[3] = {}, slope[3] = {};
    for (int i = 0; i < K::support; ++i)
      for (int j = 0; j < K::support; ++j)
        for (int k = 0; k < K::support; ++k) {
          const int node[3] = {i, j, k};
          double w = 1, r[3], field = constant;
          for (int d = 0; d < 3; ++d) {
            w *= TestFixture::first(stencil.weight[d][node[d]]);
            r[d] = TestFixture::first(stencil.base[d]) + node[d] - TestFixture::first(x[d]);
            field += g[d] * (TestFixture::first(stencil.base[d]) + node[d]);
          }
          sum += w;
          value += w * field;
          for (int d = 0; d < 3; ++d) first[d] += w * r[d], slope[d] += K::inverse_d * w * r[d] * field;
        }

    // weights carry fewer than ten roundings; nodes are up to 6 away, fields up to 190
    const double bound = 32 * TestFixture::eps;
    expect_near(sum, 1, bound);
    double right = constant;
    for (int d = 0; d < 3; ++d) right += g[d] * TestFixture::first(x[d]);
    expect_near(value, right, 190 * bound);
    for (int d = 0; d < 3; ++d) {
      expect_near(first[d], 0, bound);
      expect_near(slope[d], g[d], 190 * K::inverse_d * bound);
    }
  }));
}

}  // namespace
}  // namespace bake
