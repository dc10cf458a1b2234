// SPDX-License-Identifier: MIT
#include "solver/effects/plasticity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "solver/effects/physics.h"
#include "tests/unit/engine/particle_of_everything.h"

namespace bake {
namespace {

/// One return mapping, as numbers.
struct Trial {
  double ap2, q2, aK, mu3, tau_y, eta_dt;
};

/// What the law demands, free of cancellation: positive before the solution, negative after it.
long double excess(const Trial& t, long double z, bool quadratic) {
  const long double pa = 1 / (1 + t.aK * z), qa = 1 / (1 + t.mu3 * z);
  const long double r = std::sqrt(t.ap2 * pa * pa + t.q2 * qa * qa);
  if (quadratic) return r * r - (static_cast<long double>(t.tau_y) * t.tau_y + t.eta_dt * z / 2);
  return r * (1 - t.eta_dt * z) - t.tau_y;
}

/// The solution by bisection of the logarithm of z.
long double brute_force(const Trial& t, bool quadratic) {
  long double low = 1e-45L, high = 1e45L;
  for (int i = 0; i < 300; ++i) {
    const long double middle = std::sqrt(low * high);
    (excess(t, middle, quadratic) > 0 ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

/// r of the mapped state relative to the trial's, at z.
long double shrinkage(const Trial& t, long double z) {
  const long double pa = 1 / (1 + t.aK * z), qa = 1 / (1 + t.mu3 * z);
  return std::sqrt((t.ap2 * pa * pa + t.q2 * qa * qa) / (static_cast<long double>(t.ap2) + t.q2));
}

double cap_of(double n) {
  const double ln = std::log(n);
  return 9 / (4 * ln * ln * (3.5 * n + 1));
}

/// Random trials beyond yield, edges among them. `most`: largest ratio of trial to yield.
std::vector<Trial> trials(int count, double most, double none) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto power = [&](double low, double high) { return std::pow(10, low + (high - low) * uniform(random)); };
  std::vector<Trial> all;
  while (static_cast<int>(all.size()) < count) {
    Trial t;
    const double n = all.size() % 5 == 0 ? 1e-6 : all.size() % 5 == 1 ? 0.97 : 1e-4 + 0.96 * uniform(random);
    const double mu = power(1, 6), K = mu * power(-0.5, 2);
    t.aK = cap_of(n) * K;
    t.mu3 = 3 * mu;
    const double yield = power(0, 4), over = std::pow(10, std::log10(most) * std::pow(uniform(random), 2)) * (1 + 1e-3);
    const double angle = all.size() % 7 == 0 ? 0 : all.size() % 7 == 1 ? M_PI / 2 : M_PI / 2 * uniform(random);
    t.ap2 = std::pow(yield * over * std::sin(angle), 2);
    t.q2 = std::pow(yield * over * std::cos(angle), 2);
    t.tau_y = all.size() % 11 == 0 ? 0 : yield;
    t.eta_dt = all.size() % 3 == 0 ? 0 : all.size() % 13 == 1 ? none : power(0, 6);
    all.push_back(t);
  }
  return all;
}

template <class Real>
class ReturnMapping : public testing::Test {
 public:
  using V = Lanes<Real>;
  static constexpr double k_most = sizeof(Real) == 4 ? 1e6 : 1e8;
  static constexpr double k_infinite_viscosity = 1e30;

  static double solve(const Trial& t, bool quadratic) {
    const V all_flow = lanes<Real>(1);
    const auto pack = [](double x) { return lanes<Real>(static_cast<Real>(x)); };
    return static_cast<double>(Plasticity::solve<V>(pack(t.ap2), pack(t.q2), pack(t.aK), static_cast<Real>(t.mu3), pack(t.tau_y),
                                                    pack(t.eta_dt), all_flow > lanes<Real>(0), quadratic)[0]);
  }
  /// The trial as the solver sees it.
  static Trial rounded(const Trial& t) {
    const auto r = [](double x) { return static_cast<double>(static_cast<Real>(x)); };
    return {r(t.ap2), r(t.q2), r(t.aK), r(t.mu3), r(t.tau_y), r(t.eta_dt)};
  }
  /// Newton stops when a step is below 3e-4 (1e-8) of z; convergence being quadratic, the next would be 1e-7 (1e-16): what
  /// remains is round-off of some twenty operations, and its effect on r (which falls no faster than 1/z) is no larger.
  static constexpr double k_bound = 64 * static_cast<double>(std::numeric_limits<Real>::epsilon());

  static void expect_brute_force(bool quadratic) {
    int flowing = 0;
    for (const Trial& exact : trials(6000, k_most, k_infinite_viscosity)) {
      const Trial t = rounded(exact);
      if (!(t.ap2 + t.q2 > t.tau_y * t.tau_y)) continue;
      ++flowing;
      const double z = solve(t, quadratic);
      ASSERT_TRUE(std::isfinite(z));
      ASSERT_GE(z, 0);
      if (t.tau_y == 0 && t.eta_dt == 0) {  // nothing resists: no stress is left
        ASSERT_LE(static_cast<double>(shrinkage(t, z)), sizeof(Real) == 4 ? 1e-5 : 1e-9);
        continue;
      }
      const long double right = brute_force(t, quadratic);
      // the state, not z: near the yield surface z itself is the difference of two almost equal numbers
      const double error = static_cast<double>(std::abs(shrinkage(t, z) - shrinkage(t, right)) / shrinkage(t, right));
      ASSERT_LE(error, k_bound) << "ap2 " << t.ap2 << " q2 " << t.q2 << " aK " << t.aK << " 3mu " << t.mu3 << " tau_y " << t.tau_y
                                << " eta/dt " << t.eta_dt << ": z " << z << " not " << static_cast<double>(right);
    }
    EXPECT_GE(flowing, 5000);
  }
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(ReturnMapping, Reals);

TYPED_TEST(ReturnMapping, DistanceNormFindsWhatBisectionFinds) { TestFixture::expect_brute_force(false); }
TYPED_TEST(ReturnMapping, QuadraticNormFindsWhatBisectionFinds) { TestFixture::expect_brute_force(true); }

TYPED_TEST(ReturnMapping, LanesThatDoNotFlowStayAtZero) {
  using V = Lanes<TypeParam>;
  const V one = lanes<TypeParam>(1);
  for (const bool quadratic : {false, true}) {
    const V z = Plasticity::solve<V>(one, one, one, TypeParam(1), 100 * one, one, one > 2 * one, quadratic);
    for (int l = 0; l < k_width<TypeParam>; ++l) EXPECT_EQ(z[l], TypeParam(0));
  }
}

/// A particle with a Hencky strain, mapped by the effect itself.
template <class Real>
struct Mapped {
  using P = ParticleOfEverything<Real>;
  P p;
  Report<Real> report{};
  Scene scene;
  Plasticity::Constants<Real> k;
  double tr_before, shear2_before;

  Mapped(const std::string& material, const std::string& tables, const double (&strain)[6], double J_P = 1, double theta = 20,
         double dt = 0.01)
      : scene(scene_of_everything(material, tables)), k(scene, scene.materials[0]) {
    report.alive = lanes<Real>(1);
    for (int i = 0; i < 6; ++i) p[field::epsilon][i] = lanes<Real>(static_cast<Real>(strain[i]));
    Symmetric<Lanes<Real>> e;
    for (int i = 0; i < 6; ++i) e.at[i] = p[field::epsilon][i];
    const auto b = expm1_twice<Real>(e);
    for (int i = 0; i < 6; ++i) p[field::b_E][i] = b.at[i];
    p[field::V_0] = p[field::m_s] = lanes<Real>(1);
    p[field::J] = lanes<Real>(1);
    p[field::J_P] = lanes<Real>(static_cast<Real>(J_P));
    p[field::theta] = p[field::theta_peak] = lanes<Real>(static_cast<Real>(theta));
    tr_before = trace_of(), shear2_before = shear2();
    Step<Real> step;
    step.dt = static_cast<Real>(dt);
    Plasticity::gather(p, 0, k, step, report);
  }
  double epsilon(int i) { return static_cast<double>(p[field::epsilon][i][0]); }
  double trace_of() { return epsilon(0) + epsilon(1) + epsilon(2); }
  double shear2() {
    double sum = 0;
    for (int i = 0; i < 6; ++i) {
      const double d = i < 3 ? epsilon(i) - trace_of() / 3 : epsilon(i);
      sum += (i < 3 ? 1 : 2) * d * d;
    }
    return sum;
  }
  double J_P() { return static_cast<double>(p[field::J_P][0]); }
  double dissipated() { return static_cast<double>(report.booked[static_cast<int>(Entry::dissipated)][0]); }
};

constexpr double k_strain[6] = {0.02, -0.03, 0.025, 0.01, -0.02, 0.015};

TYPED_TEST(ReturnMapping, WithoutViscosityTheStateEndsOnTheYieldSurface) {
  for (const char* norm : {"distance", "quadratic"})
    for (const double J_P : {1.0, 1.5, 0.95}) {
      Mapped<TypeParam> m("initial_porosity = 0.2\nyield_stress_Pa = 20\n", std::string("[plasticity]\nnorm = \"") + norm + "\"\n",
                          k_strain, J_P);
      const double a = cap_of(1 - 0.8 / J_P), K = static_cast<double>(m.k.bulk), mu = static_cast<double>(m.k.mu);
      const double r = std::sqrt(a * std::pow(K * m.trace_of(), 2) + 6 * mu * mu * m.shear2());
      EXPECT_NEAR(r, 20, 20 * TestFixture::k_bound) << norm << " J_P = " << J_P;
    }
}

TYPED_TEST(ReturnMapping, ElasticStrainThatIsLostBecomesPlasticVolume) {
  Mapped<TypeParam> m("yield_stress_Pa = 20\n", "", k_strain);
  EXPECT_NEAR(m.J_P(), std::exp(m.tr_before - m.trace_of()), TestFixture::k_bound);
}

TYPED_TEST(ReturnMapping, DissipationIsTheStressTimesThePlasticStrain) {
  Mapped<TypeParam> m("yield_stress_Pa = 20\nviscosity_Pa_s = 50\n", "", k_strain);
  const double K = static_cast<double>(m.k.bulk), mu = static_cast<double>(m.k.mu);
  const double shear = std::sqrt(m.shear2()), lost = std::sqrt(m.shear2_before) - shear;  // directions are kept
  const double work = K * m.trace_of() * (m.tr_before - m.trace_of()) + 2 * mu * shear * lost;
  EXPECT_GT(work, 0);
  EXPECT_NEAR(m.dissipated(), work, work * 1e3 * TestFixture::k_bound);  // two small differences of strains
}

TYPED_TEST(ReturnMapping, DissipationIsNeverNegative) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 300; ++i) {
    double strain[6];
    for (double& s : strain) s = std::pow(10, -4 + 4 * (i % 5) / 5.0) * normal(random);
    const std::string viscosity = i % 3 == 0 ? "0" : i % 3 == 1 ? "1e-3" : "1e6";
    Mapped<TypeParam> m("yield_stress_Pa = 2\nviscosity_Pa_s = " + viscosity + "\n", i % 2 ? "[plasticity]\nnorm = \"quadratic\"\n" : "",
                        strain);
    EXPECT_GE(m.dissipated(), 0);
    EXPECT_TRUE(std::isfinite(m.dissipated()));
  }
}

TYPED_TEST(ReturnMapping, AnInfiniteViscosityHoldsEverything) {
  Mapped<TypeParam> m("yield_stress_Pa = 2\nviscosity_Pa_s = 1e30\n", "", k_strain);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(m.epsilon(i), k_strain[i], TestFixture::k_bound);
}

TYPED_TEST(ReturnMapping, NoYieldStressAndNoViscosityIsAFluidWithoutStress) {
  Mapped<TypeParam> m("yield_stress_Pa = 0\n", "", k_strain);
  // the solver stops at z = 1e12 / (3 mu), where a share of 1e-12 of the shear and 1e-12 (3 mu) / (a K) of the volume are left
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(m.epsilon(i), 0, 0.03 * 1e-11);
}

/// Yield stress and viscosity at a temperature, after a peak.
template <class Real>
std::pair<double, double> curve_at(double theta, double peak) {
  const Scene scene =
      scene_of_everything("temperatures_C = [4, 20, 60, 85]\nyield_stress_Pa = [20, 30, 15, 400]\nviscosity_Pa_s = [500, 400, 300, 100]\n");
  const Plasticity::Constants<Real> k(scene, scene.materials[0]);
  Lanes<Real> tau_y, eta;
  Plasticity::curves<Lanes<Real>>(lanes<Real>(static_cast<Real>(theta)), lanes<Real>(static_cast<Real>(peak)), k, tau_y, eta);
  return {static_cast<double>(tau_y[0]), static_cast<double>(eta[0])};
}

TYPED_TEST(ReturnMapping, StrengthFollowsTheTemperatureInStraightPieces) {
  constexpr double table[][3] = {{4, 20, 500}, {12, 25, 450}, {20, 30, 400}, {40, 22.5, 350}, {60, 15, 300}, {72.5, 207.5, 200}};
  for (const auto& [theta, tau_y, eta] : table) {
    EXPECT_NEAR(curve_at<TypeParam>(theta, theta).first, tau_y, 400 * TestFixture::k_bound) << theta;
    EXPECT_NEAR(curve_at<TypeParam>(theta, theta).second, eta, 500 * TestFixture::k_bound) << theta;
  }
}
TYPED_TEST(ReturnMapping, StrengthIsFlatOutsideTheMarkedTemperatures) {
  EXPECT_EQ(curve_at<TypeParam>(-200, -200), (std::pair{20.0, 500.0}));
  EXPECT_NEAR(curve_at<TypeParam>(400, 400).first, 400, 400 * TestFixture::k_bound);
  EXPECT_NEAR(curve_at<TypeParam>(400, 400).second, 100, 500 * TestFixture::k_bound);
}
TYPED_TEST(ReturnMapping, WhatOnceGelatinisedStaysStrongWhileItCools) {
  for (const double theta : {84.0, 40.0, -18.0}) {
    EXPECT_EQ(curve_at<TypeParam>(theta, 86), curve_at<TypeParam>(85, 85));
    EXPECT_EQ(curve_at<TypeParam>(theta, 85), curve_at<TypeParam>(85, 85));
    EXPECT_EQ(curve_at<TypeParam>(theta, 84.9), curve_at<TypeParam>(theta, theta));
  }
}

TYPED_TEST(ReturnMapping, PorosityIsHeldBetweenNothingAndNearlyAll) {
  const Scene scene = scene_of_everything("initial_porosity = 0.2\nyield_stress_Pa = 1\n");
  const Plasticity::Constants<TypeParam> k(scene, scene.materials[0]);
  using V = Lanes<TypeParam>;
  const auto porosity = [&](double J_P) {
    return static_cast<double>(Plasticity::porosity<V>(lanes<TypeParam>(static_cast<TypeParam>(J_P)), k)[0]);
  };
  EXPECT_NEAR(porosity(1), 0.2, TestFixture::k_bound);
  EXPECT_NEAR(porosity(1.6), 0.5, TestFixture::k_bound);
  EXPECT_EQ(porosity(0.1), static_cast<double>(TypeParam(1e-6)));
  EXPECT_EQ(porosity(1e6), static_cast<double>(TypeParam(0.97)));
}

}  // namespace
}  // namespace bake
