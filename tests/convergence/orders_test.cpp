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

void expect_held(std::vector<Errors> (*measure)(bool quick)) {
  for (const Errors& e : measure(true)) {
    ASSERT_GE(e.errors.size(), e.figure == Errors::Figure::order ? 3u : 1u) << e.quantity;
    EXPECT_TRUE(e.holds()) << in_words(e);
  }
}

TEST(TheFittedOrder, IsTheExponentOfAPowerLaw) {
  EXPECT_NEAR(fitted_order(std::vector{8., 16., 40.}, std::vector{3 / 64., 3 / 256., 3 / 1600.}), 2, 1e-12);
}

TEST(Slab, DecaysAtSecondOrderInside) { expect_held(slab_cosine); }
TEST(Slab, EvensOutAJumpBetweenNeighboursAtSecondOrder) { expect_held(slab_halves); }
TEST(Slab, WarmsBetweenHeldFacesAsItsSeriesSays) {
  expect_held(slab_held);
  expect_held(slab_held_and_insulated);
}

TEST(Slab, CoolsInAirAsItsSeriesSays) { expect_held(robin); }
TEST(Slab, LiesBetweenAHotAndAColdColliderAsOneModeSays) { expect_held(plates); }
TEST(Slab, MeltsAsNeumannsSolutionSays) { expect_held(melting); }
TEST(TheMeltingSlab, HasStefansFrontWhereItMeltsAtOnePoint) {
  double lambda = 0.5;  // of lambda exp(lambda^2) erf(lambda) = c (theta - theta_melting) / (L sqrt(pi)): one, over the root of pi
  for (int i = 0; i < 100; ++i) lambda += 0.5 * (1 / std::sqrt(std::numbers::pi) - lambda * std::exp(lambda * lambda) * std::erf(lambda));
  EXPECT_NEAR(melting_front(1e-3), lambda, 2e-3);
  EXPECT_NEAR((melting_front(2e-3) - lambda) / (melting_front(1e-3) - lambda), 2, 0.1) << "it goes there with the width";
}
TEST(Square, WarmsBetweenHeldSidesAsItsSeriesSays) { expect_held(square); }
TEST(BothEulers, AreOfFirstOrderInTime) { expect_held(eulers); }

TEST(Water, DiffusesAtSecondOrderInside) { expect_held(fick); }
TEST(Water, SpreadsIntoDrySolidAsBarenblattSays) { expect_held(barenblatt); }

TEST(ElasticPulse, TravelsAtSecondOrderInSpaceAndFirstInTime) { expect_held(pulse_wave); }
TEST(ElasticBar, SwingsFreelyWithAPeriodOfSecondOrder) { expect_held(free_bar); }
TEST(ElasticBar, SwingsBetweenWallsWithAPeriodOfFirstOrder) { expect_held(clamped_bar); }
TEST(HenckyBar, TearsWithTheFanOfItsLaw) { expect_held(hencky_fan); }
TEST(ManufacturedWaves, StandAtSecondOrderInACubeAndAtFirstBetweenWalls) { expect_held(axis_aligned_waves); }
TEST(ManufacturedVortex, TurnsAtSecondOrderInsideAndAtFirstBetweenFreeRims) { expect_held(generalised_vortex); }
TEST(FreeFall, IsExactInVelocityAndOfFirstOrderInPath) { expect_held(free_fall); }
TEST(SpinningDisc, WidensAsElasticitySaysAndKeepsItsAngularMomentum) { expect_held(spinning_disc); }
TEST(Block, SlidesAndSticksOnASlopeAsCoulombSays) { expect_held(slope); }

TEST(LumpedSphere, CoolsThroughAnAreaOfSecondOrder) { expect_held(lumped_sphere); }
TEST(WetBall, WarmsAndDriesAsFiniteVolumesInTheRadiusSay) { expect_held(drying_ball); }
TEST(SqueezedDough, WarmsAdiabatically) { expect_held(adiabatic); }
TEST(WarmDough, ExpandsUntilItIsFreeOfStress) { expect_held(thermal_strain); }
TEST(Pores, FillTheVolumeOfAnIdealGas) { expect_held(open_pores); }
TEST(Pores, PushWithThePressureOfAnIdealGas) { expect_held(closed_pores); }
TEST(PressedDough, FlowsWithTheRateOfEitherNorm) { expect_held(perzyna); }

}  // namespace
}  // namespace bake::studies
