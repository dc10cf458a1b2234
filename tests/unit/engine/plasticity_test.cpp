// SPDX-License-Identifier: MIT
#include "solver/effects/plasticity.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "solver/engine/physics.h"
#include "tests/unit/engine/scene_of_everything.h"

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

/// The solution by bisection of the logarithm of z: 100 halvings of 90 decades leave 2e-28 of it.
long double brute_force(const Trial& t, bool quadratic) {
  long double low = 1e-45L, high = 1e45L;
  for (int i = 0; i < 100; ++i) {
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

/// r of the mapped state [Pa].
double left_over(const Trial& t, double z) { return static_cast<double>(shrinkage(t, z)) * std::sqrt(t.ap2 + t.q2); }

double cap_of(double n) {
  const double ln = std::log(n);
  return 9 / (4 * ln * ln * (3.5 * n + 1));
}

/// Where a function with one minimum has it, by golden sections: 60 of them leave 3e-13 of the interval.
template <class Function>
long double lowest(long double low, long double high, Function f) {
  constexpr long double k_golden = 0.618033988749894848205L;
  long double left = high - k_golden * (high - low), right = low + k_golden * (high - low);
  long double f_left = f(left), f_right = f(right);
  for (int i = 0; i < 60; ++i) {
    if (f_left < f_right) {
      high = right, right = left, f_right = f_left;
      f_left = f(left = high - k_golden * (high - low));
    } else {
      low = left, left = right, f_left = f_right;
      f_right = f(right = low + k_golden * (high - low));
    }
  }
  return (low + high) / 2;
}

/// Minimiser over (sqrt(a) p, q) of 1/2 (tau_tr - tau) : C^-1 : (tau_tr - tau) + (dt/eta) f^2/2, with f the overstress of the norm
/// and as a hard constraint f = 0 without viscosity.   [Ding19 Sec. 6.5]
std::array<double, 2> least_functional(const Trial& t, bool quadratic) {
  const long double p_tr = std::sqrt(static_cast<long double>(t.ap2)), q_tr = std::sqrt(static_cast<long double>(t.q2));
  const long double tau_y = t.tau_y;
  const auto value = [&](long double r, long double angle) {
    const long double p = r * std::sin(angle) - p_tr, q = r * std::cos(angle) - q_tr;
    const long double f = quadratic ? r * r - tau_y * tau_y : r - tau_y;
    return p * p / (2 * t.aK) + q * q / (2 * t.mu3) + (t.eta_dt > 0 ? f * f / (2 * t.eta_dt) : 0);
  };
  const auto angle_at = [&](long double r) { return lowest(0, M_PI_2, [&](long double angle) { return value(r, angle); }); };
  const long double r =
      t.eta_dt > 0 ? lowest(tau_y, std::hypot(p_tr, q_tr), [&](long double at) { return value(at, angle_at(at)); }) : tau_y;
  return {static_cast<double>(r * std::sin(angle_at(r))), static_cast<double>(r * std::cos(angle_at(r)))};
}

/// Random trials up to a hundred times the yield stress, where a minimum is found to half the digits.
std::vector<Trial> moderate_trials(int count, bool quadratic) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto power = [&](double low, double high) { return std::pow(10, low + (high - low) * uniform(random)); };
  std::vector<Trial> all;
  for (int i = 0; i < count; ++i) {
    const double mu = power(2, 5), yield = power(0, 3), trial = yield * power(0.01, 2), angle = M_PI / 2 * uniform(random);
    Trial t{std::pow(trial * std::sin(angle), 2),
            std::pow(trial * std::cos(angle), 2),
            cap_of(0.01 + 0.9 * uniform(random)) * mu * power(-0.5, 1),
            3 * mu,
            yield,
            i % 4 == 0 ? 0 : power(-4, 4) * 3 * mu};
    if (quadratic) t.eta_dt *= yield * yield;
    all.push_back(t);
  }
  return all;
}

/// Random trials beyond yield, edges among them: no pores and all pores, pure pressure and pure shear, no yield stress, no
/// viscosity and an infinite one, 1e8 times the yield stress.
std::vector<Trial> trials(int count) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto power = [&](double low, double high) { return std::pow(10, low + (high - low) * uniform(random)); };
  const auto either = [&](double first, double second) { return uniform(random) < 0.5 ? first : second; };
  std::vector<Trial> all;
  for (int i = 0; i < count; ++i) {
    Trial t;
    const double n = i % 5 == 0 ? either(1e-6, 1e-30) : i % 5 == 1 ? either(0.97, 0.999) : 1e-4 + 0.96 * uniform(random);
    const double mu = power(1, 6), K = mu * power(-0.5, 2);
    t.aK = cap_of(n) * K;
    t.mu3 = 3 * mu;
    const double yield = i % 11 == 1 ? 1e-6 : power(0, 4);
    const double over = i % 17 == 0 ? 1e8 : std::pow(10, 8 * std::pow(uniform(random), 2)) * (1 + 1e-3);
    const double angle = i % 7 == 0 ? 0 : i % 7 == 1 ? M_PI / 2 : M_PI / 2 * uniform(random);
    t.ap2 = std::pow(yield * over * std::sin(angle), 2);
    t.q2 = std::pow(yield * over * std::cos(angle), 2);
    t.tau_y = i % 11 == 0 ? 0 : yield;
    t.eta_dt = i % 3 == 0 ? 0 : i % 13 == 1 ? 1e30 : power(-6, 12);
    all.push_back(t);
  }
  return all;
}

template <class Real>
class ReturnMapping : public testing::Test {
 public:
  using V = Lanes<Real>;
  struct Solved {
    double z;
    int iterations;
  };

  /// Solves W trials side by side, as the solver does.
  static std::vector<Solved> solve(const std::vector<Trial>& all, bool quadratic) {
    constexpr std::size_t W = k_width<Real>;
    std::vector<Solved> solved;
    for (std::size_t first = 0; first < all.size(); first += W) {
      V ap2, q2, aK, tau_y, eta_dt, z[W];
      LaneMask<Real> iterations[W];
      const std::size_t many = std::min(W, all.size() - first);
      for (std::size_t l = 0; l < W; ++l) {
        const Trial& t = all[first + l % many];
        ap2[l] = static_cast<Real>(t.ap2), q2[l] = static_cast<Real>(t.q2), aK[l] = static_cast<Real>(t.aK);
        tau_y[l] = static_cast<Real>(t.tau_y), eta_dt[l] = static_cast<Real>(t.eta_dt);
      }
      for (std::size_t l = 0; l < many; ++l) {  // 3 mu is one number for all lanes, so each lane is looked at in its own turn
        iterations[l] = LaneMask<Real>{};
        z[l] = Plasticity::solve<V>(ap2, q2, aK, static_cast<Real>(all[first + l].mu3), tau_y, eta_dt, ap2 + q2 > tau_y * tau_y, quadratic,
                                    [&](auto active) { iterations[l] -= active; });
        solved.push_back({static_cast<double>(z[l][l]), static_cast<int>(iterations[l][l])});
      }
    }
    return solved;
  }
  /// The trial as the solver sees it.
  static Trial rounded(const Trial& t) {
    const auto r = [](double x) { return static_cast<double>(static_cast<Real>(x)); };
    return {r(t.ap2), r(t.q2), r(t.aK), r(t.mu3), r(t.tau_y), r(t.eta_dt)};
  }
  /// Newton stops when a step is below 3e-4 (1e-8) of z; convergence being quadratic, the next would be 1e-7 (1e-16): what
  /// remains is round-off of some twenty operations, and its effect on r (which falls no faster than 1/z) is no larger.
  static constexpr double k_bound = 64 * static_cast<double>(std::numeric_limits<Real>::epsilon());
  /// Newton's iterations: all of these trials need at most 9 (distance), 22 (quadratic, single) and 16 (quadratic, double).
  static constexpr int most_iterations(bool quadratic) { return quadratic ? 24 : 12; }

  static void expect_brute_force(bool quadratic) {
    std::vector<Trial> flowing;
    for (const Trial& exact : trials(24000)) {
      const Trial t = rounded(exact);
      if (t.ap2 + t.q2 > t.tau_y * t.tau_y) flowing.push_back(t);
    }
    ASSERT_GE(flowing.size(), 20000u);
    const std::vector<Solved> solved = solve(flowing, quadratic);
    std::map<int, int> histogram;
    for (std::size_t i = 0; i < flowing.size(); ++i) {
      const Trial& t = flowing[i];
      const double z = solved[i].z;
      ++histogram[solved[i].iterations];
      ASSERT_TRUE(std::isfinite(z));
      ASSERT_GE(z, 0);
      const double highest = 1e12 / t.mu3;  // where the solver may stop: a share of 1e-12 of the shear is left
      const long double right = t.tau_y == 0 && t.eta_dt == 0 ? INFINITY : brute_force(t, quadratic);
      if (right > highest) {  // nothing resists: no stress is left, or a nanopascal in single precision
        ASSERT_TRUE(z > 0.999 * highest || left_over(t, z) < 2e-9 * (sizeof(Real) == 4)) << "z " << z << " of " << highest;
        continue;
      }
      // the state, not z: near the yield surface z itself is the difference of two almost equal numbers
      const double error = static_cast<double>(std::abs(shrinkage(t, z) - shrinkage(t, right)) / shrinkage(t, right));
      ASSERT_LE(error, k_bound) << "ap2 " << t.ap2 << " q2 " << t.q2 << " aK " << t.aK << " 3mu " << t.mu3 << " tau_y " << t.tau_y
                                << " eta/dt " << t.eta_dt << ": z " << z << " not " << static_cast<double>(right);
    }
    std::string summary;
    for (const auto& [iterations, cases] : histogram) summary += fmt::format("{}: {}  ", iterations, cases);
    testing::Test::RecordProperty("cases_by_iterations", summary);
    EXPECT_LE(histogram.rbegin()->first, most_iterations(quadratic)) << "cases by iterations: " << summary;
  }
};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(ReturnMapping, Reals);

TYPED_TEST(ReturnMapping, DistanceNormFindsWhatBisectionFinds) { TestFixture::expect_brute_force(false); }
TYPED_TEST(ReturnMapping, QuadraticNormFindsWhatBisectionFinds) { TestFixture::expect_brute_force(true); }

TYPED_TEST(ReturnMapping, TheMappedStressMinimisesThePublishedFunctional) {
  // Of a functional known to 5e-20 a minimum is known to the square root of that times its condition, here up to 1e7.
  const double bound = 1e-6 + TestFixture::k_bound;
  for (const bool quadratic : {false, true}) {
    std::vector<Trial> all = moderate_trials(200, quadratic);
    for (Trial& t : all) t = TestFixture::rounded(t);
    const auto solved = TestFixture::solve(all, quadratic);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto [p, q] = least_functional(all[i], quadratic);
      const double r = std::hypot(p, q);
      ASSERT_NEAR(std::sqrt(all[i].ap2) / (1 + all[i].aK * solved[i].z), p, bound * r) << "trial " << i << ", quadratic " << quadratic;
      ASSERT_NEAR(std::sqrt(all[i].q2) / (1 + all[i].mu3 * solved[i].z), q, bound * r) << "trial " << i << ", quadratic " << quadratic;
    }
  }
}

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
  BooksOfEverything<Real> books;
  Scene scene;
  Plasticity::Constants<Real> k;
  double tr_before, shear2_before;

  Mapped(const std::string& material, const std::string& tables, const double (&strain)[6], double J_P = 1, double theta = 20,
         double dt = 0.01)
      : scene(scene_of_everything(material, tables)), k(scene, scene.materials[0]) {
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
    Plasticity::gather(p, 0, k, step, books);
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
  double dissipated() { return static_cast<double>(books(booked::dissipated)[0]); }
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

TYPED_TEST(ReturnMapping, DissipationIsTheStressTimesThePlasticStrain) {
  Mapped<TypeParam> m("yield_stress_Pa = 20\nviscosity_Pa_s = 50\n", "", k_strain);
  const double K = static_cast<double>(m.k.bulk), mu = static_cast<double>(m.k.mu);
  const double shear = std::sqrt(m.shear2()), lost = std::sqrt(m.shear2_before) - shear;  // directions are kept
  const double work = K * m.trace_of() * (m.tr_before - m.trace_of()) + 2 * mu * shear * lost;
  EXPECT_GT(work, 0);
  EXPECT_NEAR(m.dissipated(), work, work * 1e3 * TestFixture::k_bound);  // two small differences of strains
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

TYPED_TEST(ReturnMapping, DoughThatNeverHadPoresIsAnElasticFluidWhenItHasNoStrength) {
  for (const double sign : {1.0, -1.0}) {
    double strain[6];
    for (int i = 0; i < 6; ++i) strain[i] = sign * k_strain[i];
    Mapped<TypeParam> m("yield_stress_Pa = 0\ninitial_porosity = 1e-7\n", "", strain);
    EXPECT_NEAR(m.trace_of(), sign * 0.015, TestFixture::k_bound) << "its volume answers to compression and to tension";
    EXPECT_NEAR(m.shear2(), 0, 1e-12) << "and it resists no shear";
    EXPECT_EQ(m.J_P(), 1) << "nothing opens";
  }
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
