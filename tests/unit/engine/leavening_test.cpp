// SPDX-License-Identifier: MIT
#include "solver/effects/leavening.h"

#include <gtest/gtest.h>

#include <limits>

#include "solver/effects/elasticity.h"
#include "solver/effects/heat.h"
#include "solver/effects/water.h"
#include "solver/engine/physics.h"
#include "tests/unit/engine/scene_of_everything.h"

namespace bake {
namespace {

template <class Real>
class PoreGas : public testing::Test {
 public:
  static constexpr double eps = static_cast<double>(std::numeric_limits<Real>::epsilon());
  const Scene scene = scene_of_everything(
      "initial_porosity = 0.3\ninitial_temperature_C = 10\nyield_stress_Pa = 1\n"
      "production_mol_per_kgs = 0.03\nleavener_mol_per_m3 = 2\n");
  const Leavening::Constants<Real> k{scene, scene.materials[0]};
  static constexpr double p_ref = 101325;

  /// Overpressure of the pores, J p [Pa].
  double pressure(double J, double theta) const {
    ParticleOfEverything<Real> p;
    p[field::J] = lanes<Real>(static_cast<Real>(J));
    p[field::theta] = lanes<Real>(static_cast<Real>(theta));
    Leavening::stress(p, k);
    for (int i = 1; i < 3; ++i) EXPECT_EQ(p[field::tau][i][0], p[field::tau][0][0]);
    for (int i = 3; i < 6; ++i) EXPECT_EQ(p[field::tau][i][0], Real(0));
    return -static_cast<double>(p[field::tau][0][0]);
  }
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(PoreGas, Reals);

TYPED_TEST(PoreGas, PushesAgainstNothingAtTheStartHoweverDenseOrLightTheDough) {
  for (const char* porosity : {"1e-3", "0.015", "0.5", "0.99"}) {
    const Scene dough =
        scene_of_everything(std::string("yield_stress_Pa = 1\ninitial_temperature_C = 10\ninitial_porosity = ") + porosity + "\n");
    const Leavening::Constants<TypeParam> constants(dough, dough.materials[0]);
    ParticleOfEverything<TypeParam> p;
    p[field::J] = lanes<TypeParam>(1);
    p[field::theta] = lanes<TypeParam>(10);
    Leavening::stress(p, constants);
    // 1 - (1 - n_0) keeps n_0 up to an epsilon
    EXPECT_NEAR(static_cast<double>(p[field::tau][0][0]), 0, 8 * this->eps * this->p_ref / std::stod(porosity)) << porosity;
  }
}

TYPED_TEST(PoreGas, PressureAndStiffnessStayFiniteWhenThePoresAreGone) {
  for (const double J : {1e-3, 0.1, 0.69999, 0.7, 100.0}) EXPECT_TRUE(std::isfinite(this->pressure(J, 100))) << J;
}

TYPED_TEST(PoreGas, FiniteLeavenerKeepsWhatIsMadePlusWhatIsLeft) {
  ParticleOfEverything<TypeParam> p;
  p[field::theta] = lanes<TypeParam>(40);
  p[field::c] = lanes<TypeParam>(1);
  BooksOfEverything<TypeParam> books;
  Step<TypeParam> step;
  step.baking_dt = TypeParam(0.01);
  for (int i = 1; i <= 200; ++i) {
    Leavening::gather(p, 0, this->k, step, books);
    const double made = static_cast<double>(p[field::nu][0]), left = static_cast<double>(p[field::c][0]);
    ASSERT_NEAR(made + 2 * left, 2, 2 * i * this->eps);
    ASSERT_GE(left, 0);
    // implicit decay: c = (1 + dt rate / total)^-n
    ASSERT_NEAR(left, std::pow(1 + 0.01 * 0.03 * 500 / 2, -i), i * 4 * this->eps);
  }
}

TYPED_TEST(PoreGas, TheReactionIsFastestAtItsPeakAndABellAround) {
  const auto rate = [&](double theta) {
    return static_cast<double>(Leavening::rate(lanes<TypeParam>(static_cast<TypeParam>(theta)), this->k)[0]);
  };
  EXPECT_NEAR(rate(40), 0.03 * 500, 15 * 4 * this->eps);
  EXPECT_NEAR(rate(60), 15 * std::exp(-1), 15 * 8 * this->eps);
  EXPECT_NEAR(rate(20), rate(60), 15 * 8 * this->eps);
}

TYPED_TEST(PoreGas, FreshDoughIsFreeOfStressWhateverTheEffects) {
  const Scene scene = scene_of_everything(
      "initial_porosity = 0.3\ninitial_temperature_C = 10\ninitial_saturation = 0.2\nexpansion_per_K = 1e-3\npressure_Pa = "
      "300\nyield_stress_Pa = 1\n");
  const auto& m = scene.materials[0];
  ParticleOfEverything<TypeParam> p;
  p[field::J] = p[field::J_P] = lanes<TypeParam>(1);
  p[field::theta] = lanes<TypeParam>(10);
  p[field::V_0] = lanes<TypeParam>(TypeParam(1e-3));
  p[field::m_w] = lanes<TypeParam>(TypeParam(0.2));
  Elasticity::stress(p, Elasticity::Constants<TypeParam>(scene, m));
  Heat::stress(p, Heat::Constants<TypeParam>(scene, m));
  Water::stress(p, Water::Constants<TypeParam>(scene, m));
  Leavening::stress(p, Leavening::Constants<TypeParam>(scene, m));
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(static_cast<double>(p[field::tau][i][0]), 0, 8 * this->eps * this->p_ref);
}

}  // namespace
}  // namespace bake
