// SPDX-License-Identifier: MIT
// Every case of `bake study convergence` at its quick resolutions. Bands and their reasons stand with the cases, in
// experiments/convergence, and are printed where one is missed.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "experiments/common/order.h"
#include "experiments/convergence/cases.h"
#include "experiments/convergence/exact.h"

namespace bake::studies {
namespace {

/// All but the wrinkles, which take minutes.
std::vector<ConvergenceCase> quick_cases() {
  std::vector<ConvergenceCase> cases = all_cases();
  std::erase_if(cases, [](const ConvergenceCase& c) { return c.measure == wrinkles || c.measure == wrinkles_of_skin; });
  return cases;
}

class AConvergenceCase : public testing::TestWithParam<ConvergenceCase> {};

TEST_P(AConvergenceCase, HoldsItsBands) {
  SCOPED_TRACE(GetParam().solution);
  for (const Errors& e : GetParam().measure(true)) {
    ASSERT_GE(e.errors.size(), e.figure == Errors::Figure::order ? 3u : 1u) << e.quantity;
    EXPECT_TRUE(e.holds()) << in_words(e);
  }
}
INSTANTIATE_TEST_SUITE_P(Of, AConvergenceCase, testing::ValuesIn(quick_cases()), [](const auto& info) { return info.param.name; });

TEST(TheFittedOrder, IsTheExponentOfAPowerLaw) {
  EXPECT_NEAR(fitted_order(std::vector{8., 16., 40.}, std::vector{3 / 64., 3 / 256., 3 / 1600.}), 2, 1e-12);
}

TEST(TheMeltingSlab, HasStefansFrontWhereItMeltsAtOnePoint) {
  double lambda = 0.5;  // of lambda exp(lambda^2) erf(lambda) = c (theta - theta_melting) / (L sqrt(pi)): one, over the root of pi
  for (int i = 0; i < 100; ++i) lambda += 0.5 * (1 / std::sqrt(std::numbers::pi) - lambda * std::exp(lambda * lambda) * std::erf(lambda));
  EXPECT_NEAR(melting_front(1e-3), lambda, 2e-3);
  EXPECT_NEAR((melting_front(2e-3) - lambda) / (melting_front(1e-3) - lambda), 2, 0.1) << "it goes there with the width";
}

}  // namespace
}  // namespace bake::studies
