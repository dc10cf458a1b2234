// SPDX-License-Identifier: MIT
// Laws of motion: the volume that a particle carries along.
#include <map>

#include "solver/effects/motion.h"
#include "solver/engine/physics.h"
#include "tests/unit/engine/scene_of_everything.h"
#include "tests/unit/laws/law.h"

namespace bake {
namespace {

/// Nodes that say the same everywhere: the velocity gradient C.
template <class Real>
struct Nodes {
  using V = Lanes<Real>;
  double C[9] = {};
  V value(auto, int) const { return V{}; }
  V gradient(auto, int i, int j) const { return lanes<Real>(static_cast<Real>(C[3 * i + j])); }
};

template <class Real>
struct OneParticle {
  using L = Law<Real>;
  Scene scene = scene_of_everything("yield_stress_Pa = 1\n", "[leavening]\npores = \"open\"\n");
  Motion::Constants<Real> k{scene, scene.materials[0]};
  ParticleOfEverything<Real> p;
  Step<Real> step;
  Report<Real> report{};
  double room = std::pow(0.1 * 20 / 11, 3);  ///< dx^3 over the cube of the integral of N^2 [m^3]

  /// Fresh dough, n particles a cell, whose nodes say C.
  void open(double n, const double (&C)[9], double dt) {
    p[field::V_0] = L::all(1e-3 / n);
    p[field::J] = L::all(1);
    again(C, dt);
  }
  void again(const double (&C)[9], double dt) {
    Nodes<Real> nodes;
    std::copy(C, C + 9, nodes.C);
    step.dx = Real(0.1);
    step.dt = static_cast<Real>(dt);
    Motion::gather(p, nodes, k, step, report);
  }
  double volume() { return L::first(p.volume()); }
};

template <class Real>
class MotionLaw : public Law<Real> {};
TYPED_TEST_SUITE(MotionLaw, Reals);

TYPED_TEST(MotionLaw, AVolumeFollowsTheDeterminantOfItsGradientAndTheGradientStays) {
  EXPECT_TRUE(rc::check([] {
    OneParticle<TypeParam> law;
    double C[9];
    for (double& c : C) c = between(-1, 1, "C");
    const double dt = between(0, 0.1, "dt");
    law.open(between(1, 64, "n"), C, dt);
    const auto a = [&](int i, int j) { return (i == j) + dt * C[3 * i + j]; };
    const double det = a(0, 0) * (a(1, 1) * a(2, 2) - a(1, 2) * a(2, 1)) - a(0, 1) * (a(1, 0) * a(2, 2) - a(1, 2) * a(2, 0)) +
                       a(0, 2) * (a(1, 0) * a(2, 1) - a(1, 1) * a(2, 0));
    expect_near(TestFixture::first(law.p[field::J]), det, 16 * TestFixture::eps);
    for (int i = 0; i < 9; ++i) RC_ASSERT(TestFixture::first(law.p[field::C][i]) == TestFixture::seen(C[i]));
  }));
}

TYPED_TEST(MotionLaw, AParticleThatGetsBackItsOwnGradientOpensNoFurtherThanTheRoomOfItsNodes) {
  EXPECT_TRUE(rc::check([] {
    OneParticle<TypeParam> law;
    double C[9];
    for (double& c : C) c = between(-1, 1, "C");
    for (int i = 0; i < 9; i += 4) C[i] = between(0.1, 1, "C");
    law.open(between(1, 64, "n"), C, 0.1);
    for (int i = 0; i < 1000; ++i) {
      for (int c = 0; c < 9; ++c) C[c] = TestFixture::first(law.p[field::C][c]);
      law.again(C, 0.1);
      RC_ASSERT(law.volume() <= law.room * (1 + 8 * TestFixture::eps));
    }
  }));
}

TYPED_TEST(MotionLaw, APorousParticleWhosePoresHoldAVacuumOpensAsItsNodesSay) {
  OneParticle<TypeParam> law;
  law.scene = scene_of_everything("yield_stress_Pa = 1\n");
  law.k = Motion::Constants<TypeParam>(law.scene, law.scene.materials[0]);
  const double opening[9] = {10, 0, 0, 0, 10, 0, 0, 0, 10};
  law.open(1, opening, 0.1);
  EXPECT_NEAR(law.volume(), 8e-3, 8e-3 * 8 * TestFixture::eps);
  EXPECT_GT(law.volume(), law.room);
}

TYPED_TEST(MotionLaw, AParticleThatFillsTheRoomOfItsNodesForgetsThatItOpenedAndNothingElse) {
  EXPECT_TRUE(rc::check([] {
    OneParticle<TypeParam> law;
    double C[9];
    for (double& c : C) c = between(-1, 1, "C");
    for (int i = 0; i < 9; i += 4) C[i] = between(2, 3, "C");
    law.open(0.17, C, 0.1);  // as large as its nodes' room when it opens
    const double third = (C[0] + C[4] + C[8]) / 3;
    expect_near(law.volume(), law.room, 8 * TestFixture::eps * law.room);
    for (int i = 0; i < 9; ++i)
      expect_near(TestFixture::first(law.p[field::C][i]), C[i] - (i % 4 == 0 ? third : 0), 8 * TestFixture::eps * 3);
    const double closing[9] = {-1, 0, 0, 0, -1, 0, 0, 0, -1};
    law.again(closing, 0.1);
    expect_near(law.volume(), law.room * 0.729, 16 * TestFixture::eps * law.room);
  }));
}

TYPED_TEST(MotionLaw, AParticleLargerThanTheRoomOfItsNodesMayShrinkAndOpensNoFurther) {
  OneParticle<TypeParam> law;
  const double opening[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  law.open(0.01, opening, 0.1);
  EXPECT_EQ(TestFixture::first(law.p[field::J]), 1);
}

/// Takes down what effects report.
template <class Real>
struct MostSeen {
  std::map<std::string_view, double> seen;  ///< by symbol, of the first lane
  void bound(auto quantity, Lanes<Real> value) { seen[decltype(quantity)::symbol] = static_cast<double>(value[0]); }
};

/// |frequency|^2 of the volume of 1 kg in a litre, of stiffness K + 4/3 mu = 7 Pa and mu = 3 Pa, d = 1/400 m^2.
template <class Real>
double own_frequency_squared(double J) {
  using L = Law<Real>;
  OneParticle<Real> law;
  law.open(1, {0, 0, 0, 0, 0, 0, 0, 0, 0}, 0.1);
  law.p[field::m_s] = L::all(1);
  law.p[field::J] = L::all(J);
  law.p.stiffness = L::all(7);
  law.p.shear_stiffness = L::all(3);
  law.step.inverse_d = 400;
  MostSeen<Real> most;
  Motion::bounds(law.p, law.k, law.step, most);
  EXPECT_NEAR(most.seen.at(bound::sound_speed_squared.symbol), 7e-3, 7e-3 * 4 * L::eps);
  return most.seen.at(bound::own_frequency_squared.symbol);
}

TYPED_TEST(MotionLaw, AParticleAloneVibratesByThreeBulkModuliOverItsDensityAndD) {
  EXPECT_NEAR(own_frequency_squared<TypeParam>(1), 3 * (7 - 4) * 1e-3 * 400, 3.6 * 8 * TestFixture::eps);
}

TYPED_TEST(MotionLaw, AVolumeThatIsNoneLeavesNoStep) {
  for (const double J : {0.0, -1e-24, -2.0}) EXPECT_EQ(own_frequency_squared<TypeParam>(J), k_infinity);
}

}  // namespace
}  // namespace bake
