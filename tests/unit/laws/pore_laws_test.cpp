// SPDX-License-Identifier: MIT
// Laws of gas, heat and water: what fills the pores.
#include "solver/effects/elasticity.h"
#include "solver/effects/heat.h"
#include "solver/effects/leavening.h"
#include "solver/effects/water.h"
#include "solver/engine/physics.h"
#include "tests/unit/engine/scene_of_everything.h"
#include "tests/unit/laws/law.h"

namespace bake {
namespace {

/// Dough at random: its pores, its start, its constants.
struct Dough {
  double n_0 = between(0.05, 0.9, "n_0");
  double theta_0 = between(0, 40, "theta_0");
  double s_0 = between(0.01, 1, "s_0 / (1 - n_0)") * (1 - n_0);
  double c_hat = decades(0, 6, "c_hat");
  double rho_w = decades(1, 2.6, "rho_w");
  double expansion = decades(-6, -3, "alpha_l");
  double p_ref = decades(3, 5.5, "p_ref");
  double rate = decades(-4, 3, "alpha_g");
  double total = decades(-3, 3, "leavener");
  double heat_s = decades(1, 4, "alpha_s"), heat_w = decades(1, 4, "alpha_w");
  Scene scene = scene_of_everything(
      fmt::format("yield_stress_Pa = 1\ninitial_porosity = {:.17g}\ninitial_temperature_C = {:.17g}\ninitial_saturation = {:.17g}\n"
                  "pressure_Pa = {:.17g}\nwater_density_kg_per_m3 = {:.17g}\nexpansion_per_K = {:.17g}\n"
                  "production_mol_per_kgs = {:.17g}\nleavener_mol_per_m3 = {:.17g}\n",
                  n_0, theta_0, s_0, c_hat, rho_w, expansion, rate, total),
      fmt::format("[leavening]\nreference_pressure_Pa = {:.17g}\n[heat]\nwater_specific_heat_J_per_kgK = {:.17g}\n", p_ref, heat_w));
  /// The volume at which pores take the share n.
  double J_at(double n) const { return (1 - n_0) / (1 - n); }
};

template <class Real>
class PoreLaw : public Law<Real> {
 public:
  using L = Law<Real>;
  using P = ParticleOfEverything<Real>;
  /// Pressure of the gas against vacuum [Pa].
  static double gas_pressure(const Dough& dough, double J, double theta, double nu) {
    P p;
    p[field::J] = L::all(J), p[field::theta] = L::all(theta), p[field::nu] = L::all(nu);
    Leavening::stress(p, Leavening::Constants<Real>(dough.scene, dough.scene.materials[0]));
    return dough.p_ref - L::first(p[field::tau][0]) / L::seen(J);
  }
  /// (nu_0 + nu) R theta_K / (J n), the moles scaled with the atmosphere.
  static double ideal_gas(const Dough& dough, double J, double theta, double nu) {
    const double moles = dough.p_ref * dough.n_0 / (8.314 * (dough.theta_0 + 273.15)) + dough.p_ref / 101325 * nu;
    return moles * 8.314 * (theta + 273.15) / (J - (1 - dough.n_0));
  }
  /// Relative rounding of the gas pressure: that of pores that are a small difference, n of J, and of the atmosphere taken off and added.
  static double rounding(const Dough& dough, double n, double pressure) { return 32 * L::eps * (1 / n + dough.p_ref / pressure); }
};
TYPED_TEST_SUITE(PoreLaw, Reals);

TYPED_TEST(PoreLaw, GasIsIdeal) {
  EXPECT_TRUE(rc::check([] {
    const Dough dough;
    const double n = between(0.03, 0.95, "n"), theta = between(-40, 300, "theta"), nu = between(0, 1000, "nu");
    const double right = TestFixture::ideal_gas(dough, dough.J_at(n), theta, nu);
    expect_near(TestFixture::gas_pressure(dough, dough.J_at(n), theta, nu), right, right * TestFixture::rounding(dough, n, right));
  }));
}

TYPED_TEST(PoreLaw, GasPressureRisesWithTemperatureAndMolesAndFallsWithVolume) {
  EXPECT_TRUE(rc::check([] {
    const Dough dough;
    const double n = between(0.05, 0.9, "n"), theta = between(-40, 300, "theta"), nu = between(0, 1000, "nu"), J = dough.J_at(n);
    const double here = TestFixture::gas_pressure(dough, J, theta, nu), noise = 2 * here * TestFixture::rounding(dough, n, here);
    const double warmer = TestFixture::gas_pressure(dough, J, theta + 10, nu),
                 fuller = TestFixture::gas_pressure(dough, J, theta, nu + 100);
    const double wider = TestFixture::gas_pressure(dough, 1.02 * J, theta, nu);
    // 10 K of at most 573 K; 100 mol beside those that are there; pores that grow by at least 2 per cent
    expect_near(warmer / here, 1 + 10 / (theta + 273.15), noise / here);
    RC_ASSERT(warmer > here);
    RC_ASSERT(fuller > here - noise);
    RC_ASSERT(fuller > here || 100 * dough.p_ref / 101325 * 8.314 * 233 / J < noise);
    RC_ASSERT(wider < here);
  }));
}

TEST(PoreLaws, StiffnessIsTheSlopeOfTheGasPressure) {
  EXPECT_TRUE(rc::check([] {
    using L = PoreLaw<double>;
    const Dough dough;
    const double n = between(0.05, 0.9, "n"), theta = between(-40, 300, "theta"), nu = between(0, 1000, "nu"), J = dough.J_at(n);
    L::P p;
    p[field::J] = L::all(J), p[field::theta] = L::all(theta), p[field::nu] = L::all(nu);
    Leavening::stress(p, Leavening::Constants<double>(dough.scene, dough.scene.materials[0]));
    const double h = 1e-5;
    const double slope = (L::gas_pressure(dough, J * (1 + h), theta, nu) - L::gas_pressure(dough, J * (1 - h), theta, nu)) / (2 * h * J);
    // central differences: (h/n)^2 of the slope, and round-off over h
    expect_near(L::first(p.stiffness), -J * J * slope, L::first(p.stiffness) * 1e-6);
  }));
}

TYPED_TEST(PoreLaw, LeavenerIsConservedHoweverLongTheStep) {
  EXPECT_TRUE(rc::check([] {
    const Dough dough;
    const double share = between(0, 2, "share");
    ParticleOfEverything<TypeParam> p;
    p[field::theta] = TestFixture::all(between(-40, 300, "theta"));
    p[field::c] = TestFixture::all(share);
    Report<TypeParam> report{};
    Step<TypeParam> step;
    step.baking_dt = static_cast<TypeParam>(decades(-6, 6, "dt"));
    const Leavening::Constants<TypeParam> k(dough.scene, dough.scene.materials[0]);
    const int steps = *rc::gen::inRange(1, 20).as("steps");
    for (int i = 0; i < steps; ++i) {
      const double had = TestFixture::first(p[field::c]);
      Leavening::gather(p, 0, k, step, report);
      RC_ASSERT(TestFixture::first(p[field::c]) >= -TestFixture::eps * share);  // all but spent, it may round below nothing
      RC_ASSERT(TestFixture::first(p[field::c]) <= had + TestFixture::eps * share);
    }
    expect_near(TestFixture::first(p[field::nu]) / dough.total + TestFixture::first(p[field::c]), share, 8 * steps * TestFixture::eps);
  }));
}

TYPED_TEST(PoreLaw, TheReactionIsNeverFasterThanAtItsPeakNorNegative) {
  EXPECT_TRUE(rc::check([] {
    const Dough dough;
    const Leavening::Constants<TypeParam> k(dough.scene, dough.scene.materials[0]);
    const double rate = TestFixture::first(Leavening::rate(TestFixture::all(between(-273, 1000, "theta")), k));
    RC_ASSERT(rate >= 0);
    RC_ASSERT(rate <= dough.rate * 500 * (1 + 4 * TestFixture::eps));
  }));
}

TYPED_TEST(PoreLaw, HeatCapacityOfTheMixtureIsTheSumOfSolidAndWater) {
  EXPECT_TRUE(rc::check([] {
    const Dough dough;
    Heat::Constants<TypeParam> k(dough.scene, dough.scene.materials[0]);
    k.solid = static_cast<TypeParam>(dough.heat_s);
    const double m_s = decades(-6, 3, "m_s"), m_w = decades(-6, 3, "m_w");
    ParticleOfEverything<TypeParam> p;
    p[field::m_s] = TestFixture::all(m_s), p[field::m_w] = TestFixture::all(m_w);
    const double right = dough.heat_s * m_s + dough.heat_w * m_w;
    expect_near(TestFixture::first(Heat::capacity(p, k)), right, 8 * TestFixture::eps * right);
  }));
}

TYPED_TEST(PoreLaw, ThermalStressIsZeroAtTheStartTemperatureWhateverTheVolume) {
  EXPECT_TRUE(rc::check([] {
    const Dough dough;
    ParticleOfEverything<TypeParam> p;
    p[field::J] = TestFixture::all(between(0.2, 5, "J"));
    p[field::theta] = TestFixture::all(dough.theta_0);
    Heat::stress(p, Heat::Constants<TypeParam>(dough.scene, dough.scene.materials[0]));
    for (int i = 0; i < 6; ++i) RC_ASSERT(TestFixture::first(p[field::tau][i]) == 0);
  }));
}

TYPED_TEST(PoreLaw, FreeDoughExpandsByTheExpansionCoefficientInEveryDirection) {
  EXPECT_TRUE(rc::check([] {
    const Dough dough;
    const double warmer = between(-40, 300, "warmer by");
    ParticleOfEverything<TypeParam> p;
    p[field::theta] = TestFixture::all(dough.theta_0 + warmer);
    for (int i = 0; i < 3; ++i) p[field::epsilon][i] = TestFixture::all(dough.expansion * warmer);
    const auto& m = dough.scene.materials[0];
    const Elasticity::Constants<TypeParam> elastic(dough.scene, m);
    Elasticity::stress(p, elastic);
    Heat::stress(p, Heat::Constants<TypeParam>(dough.scene, m));
    // the temperature, up to 340 C, is known to an epsilon of itself
    const double bound = 16 * TestFixture::eps * 3 * static_cast<double>(elastic.bulk) * dough.expansion * 340;
    for (int i = 0; i < 6; ++i) expect_near(TestFixture::first(p[field::tau][i]), 0, bound);
  }));
}

TYPED_TEST(PoreLaw, WaterPressesByItsSaturationOverTheStarts) {
  EXPECT_TRUE(rc::check([] {
    const Dough dough;
    const double J = between(0.2, 5, "J"), s = *rc::gen::arbitrary<bool>().as("as at the start") ? dough.s_0 : between(0, 2, "s");
    const double V_0 = decades(-9, 0, "V_0");
    ParticleOfEverything<TypeParam> p;
    p[field::J] = TestFixture::all(J), p[field::V_0] = TestFixture::all(V_0), p[field::m_w] = TestFixture::all(s * dough.rho_w * V_0 * J);
    Water::stress(p, Water::Constants<TypeParam>(dough.scene, dough.scene.materials[0]));
    const double bound = 8 * TestFixture::eps * J * dough.c_hat * (s + dough.s_0);
    for (int i = 0; i < 6; ++i) expect_near(TestFixture::first(p[field::tau][i]), i < 3 ? -J * dough.c_hat * (s - dough.s_0) : 0, bound);
  }));
}

TYPED_TEST(PoreLaw, WaterStiffnessIsTheSlopeOfItsPressureWhenNoneMoves) {
  EXPECT_TRUE(rc::check([] {
    const Dough dough;
    const Water::Constants<TypeParam> k(dough.scene, dough.scene.materials[0]);
    const double J = between(0.2, 5, "J"), s = between(0, 2, "s");
    const auto tau = [&](double at, double& stiffness) {
      ParticleOfEverything<TypeParam> p;
      p[field::J] = TestFixture::all(at), p[field::V_0] = TestFixture::all(1), p[field::m_w] = TestFixture::all(s * dough.rho_w * J);
      Water::stress(p, k);
      stiffness = TestFixture::first(p.stiffness);
      return TestFixture::first(p[field::tau][0]);
    };
    // - J p_w = c_hat (s_0 J - m_w/(rho_w V_0)) is linear in J: its slope times J, from one volume to twice that
    double stiffness = 0, unused = 0;
    const double slope = (tau(2 * J, unused) - tau(J, stiffness)) / J;
    expect_near(stiffness, slope * J, 16 * TestFixture::eps * dough.c_hat * J * (s + 2 * dough.s_0));
  }));
}

}  // namespace
}  // namespace bake
