// SPDX-License-Identifier: MIT

#include "solver/effects/plasticity.h"
#include "solver/engine/physics.h"
#include "tests/unit/engine/scene_of_everything.h"
#include "tests/unit/laws/law.h"

namespace bake {
namespace {

/// A state and a material at random, before and after the return mapping.
template <class Real>
struct Flow {
  using L = Law<Real>;
  Plasticity::Constants<Real> k;
  ParticleOfEverything<Real> p;
  BooksOfEverything<Real> books;
  double a, tau_y;  ///< of the yield surface in this step
  Symmetric<double> before, after;
  double J_P_before, J_P_after;

  /// `least`, `most`: decades of the yield stress relative to the trial.
  explicit Flow(bool with_viscosity = true, double least = -5, double most = 0.3) : k(constants()) {
    k.bulk = static_cast<Real>(decades(2, 6, "K"));
    k.mu = static_cast<Real>(decades(2, 6, "mu"));
    k.n_0 = static_cast<Real>(between(0.01, 0.9, "n_0"));
    k.quadratic = *rc::gen::arbitrary<bool>().as("quadratic norm");
    const double size = decades(-5, 0, "size");
    const Symmetric<double> strain = random_symmetric(0.3, "strain");
    for (int i = 0; i < 6; ++i) p[field::epsilon][i] = L::all(size * strain.at[i]);
    p[field::V_0] = L::all(1);
    p[field::J_P] = L::all(between(0.5, 3, "J_P"));
    a = L::first(Plasticity::cap(Plasticity::porosity(p[field::J_P], k)));
    if (L::first(Plasticity::porosity(p[field::J_P], k)) <= 1.001 * Plasticity::k_no_pores && trace(strain) < 0)
      a = 0;  // nothing to compact

    before = strain_now();
    tau_y = L::seen(r(before) * decades(least, most, "yield to trial"));
    const double eta = with_viscosity ? decades(-3, 6, "eta") : 0;
    for (int i = 0; i < 4; ++i) k.tau_y[i] = static_cast<Real>(tau_y), k.eta[i] = static_cast<Real>(eta);
    J_P_before = L::first(p[field::J_P]);
    Step<Real> step;
    step.dt = static_cast<Real>(decades(-5, -1, "dt"));
    Plasticity::gather(p, 0, k, step, books);
    after = strain_now();
    J_P_after = L::first(p[field::J_P]);
  }

  /// A material whose curves are flat.
  static Plasticity::Constants<Real> constants() {
    static const Scene scene = scene_of_everything("yield_stress_Pa = 1\n");
    return {scene, scene.materials[0]};
  }
  Symmetric<double> strain_now() {
    Symmetric<double> e;
    for (int i = 0; i < 6; ++i) e.at[i] = L::first(p[field::epsilon][i]);
    return e;
  }
  static Symmetric<double> deviator(Symmetric<double> e) {
    const double mean = trace(e) / 3;
    for (int i = 0; i < 3; ++i) e.at[i] -= mean;
    return e;
  }
  double pressure(const Symmetric<double>& e) const { return -static_cast<double>(k.bulk) * trace(e); }
  /// sqrt(a p^2 + q^2), with q^2 = 3/2 s:s.
  double r(const Symmetric<double>& e) const {
    const double mu = static_cast<double>(k.mu);
    return std::sqrt(a * std::pow(pressure(e), 2) + 6 * mu * mu * norm_squared(deviator(e)));
  }
  /// Rounding of r: strains are sums of components that may cancel.
  double rounding(const Symmetric<double>& e) const {
    return 64 * L::eps * static_cast<double>(std::sqrt(a) * k.bulk + 3 * k.mu) * std::sqrt(norm_squared(e));
  }
  double dissipated() const { return L::first(books(booked::dissipated)); }
};

template <class Real>
class FlowLaw : public Law<Real> {};
TYPED_TEST_SUITE(FlowLaw, Reals);

TYPED_TEST(FlowLaw, DissipationIsNeverNegative) {
  EXPECT_TRUE(rc::check([] {
    const Flow<TypeParam> flow;
    RC_ASSERT(std::isfinite(flow.dissipated()));
    RC_ASSERT(flow.dissipated() >= 0);
  }));
}

TYPED_TEST(FlowLaw, BelowYieldNothingChanges) {
  EXPECT_TRUE(rc::check([] {
    const Flow<TypeParam> flow(true, 1e-3, 3);
    RC_PRE(flow.r(flow.before) < flow.tau_y - flow.rounding(flow.before));
    for (int i = 0; i < 6; ++i) RC_ASSERT(flow.after.at[i] == flow.before.at[i]);
    RC_ASSERT(flow.J_P_after == flow.J_P_before);
    RC_ASSERT(flow.dissipated() == 0);
  }));
}

TYPED_TEST(FlowLaw, WithoutViscosityStressEndsInsideTheYieldSurfaceOrOnIt) {
  EXPECT_TRUE(rc::check([] {
    const Flow<TypeParam> flow(false);
    constexpr double k_least = sizeof(TypeParam) == 4 ? 1e-9 : 0;  // single precision tells no stress below a nanopascal from none
    const double bound = 64 * TestFixture::eps * flow.tau_y + flow.rounding(flow.after) + k_least;
    if (flow.r(flow.before) > flow.tau_y + flow.rounding(flow.before))
      expect_near(flow.r(flow.after), flow.tau_y, bound);
    else
      RC_ASSERT(flow.r(flow.after) <= flow.tau_y + bound + flow.rounding(flow.before));
  }));
}

TYPED_TEST(FlowLaw, WithViscosityStressEndsBetweenTheTrialAndTheYieldSurface) {
  EXPECT_TRUE(rc::check([] {
    const Flow<TypeParam> flow(true, -5, -1e-3);
    constexpr double k_least = sizeof(TypeParam) == 4 ? 1e-9 : 0;
    RC_PRE(flow.r(flow.before) > flow.tau_y);
    RC_ASSERT(flow.r(flow.after) <= flow.r(flow.before) + flow.rounding(flow.before));
    RC_ASSERT(flow.r(flow.after) >= flow.tau_y * (1 - 64 * TestFixture::eps) - flow.rounding(flow.after) - k_least);
  }));
}

TYPED_TEST(FlowLaw, StrainFlowsAlongTheNormalOfTheYieldSurface) {
  EXPECT_TRUE(rc::check([] {
    const Flow<TypeParam> flow;
    Symmetric<double> lost;
    for (int i = 0; i < 6; ++i) lost.at[i] = flow.before.at[i] - flow.after.at[i];
    // half the gradient of a p^2 + q^2: -(a p / 3) I + (3/2) s, here its trace and its deviator
    const double normal_trace = -flow.a * flow.pressure(flow.after), mu3 = 3 * static_cast<double>(flow.k.mu);
    const auto lost_shear = flow.deviator(lost), shear = flow.deviator(flow.after);
    const double size = std::sqrt(norm_squared(flow.before)), normal_size = std::abs(normal_trace) + mu3 * std::sqrt(norm_squared(shear));
    // strains are known to a few roundings of the largest; the normal, made of them, likewise
    const double stiff = flow.a * static_cast<double>(flow.k.bulk) + mu3, lost_size = std::sqrt(norm_squared(lost));
    const double bound = 64 * TestFixture::eps * (size * normal_size + lost_size * stiff * std::sqrt(norm_squared(flow.after)));
    for (int i = 0; i < 6; ++i) expect_near(lost_shear.at[i] * normal_trace, trace(lost) * mu3 * shear.at[i], bound);
    RC_ASSERT(trace(lost) * normal_trace >= -bound);  // outwards
  }));
}

TYPED_TEST(FlowLaw, PlasticVolumeTakesWhatTheElasticVolumeLoses) {
  EXPECT_TRUE(rc::check([] {
    const Flow<TypeParam> flow;
    const double lost = trace(flow.before) - trace(flow.after);
    expect_near(flow.J_P_after / flow.J_P_before, std::exp(lost), 64 * TestFixture::eps * std::exp(std::abs(lost)));
  }));
}

}  // namespace
}  // namespace bake
