// SPDX-License-Identifier: MIT
// Plasticity: temperature- and porosity-dependent Cam clay with viscous flow. [Ding19 Sec. 5.3, 6.5]
#pragma once

#include <algorithm>
#include <utility>

#include "solver/core/parameter.h"
#include "solver/core/symmetric.h"
#include "solver/effects/effect.h"
#include "solver/effects/elasticity.h"
#include "solver/effects/form.h"

namespace bake {

namespace booked {
BAKE_FIELD(dissipated, Dissipated, 1, "dissipated", "J", "plastic work");
}  // namespace booked

struct Plasticity : Effect {
  static constexpr const char* name = "plasticity";
  static constexpr const char* meaning = "viscoplastic flow beyond a yield stress that follows temperature";

  static constexpr std::array needs{"elasticity"};

  /// `distance`: overstress is a stress, eta in Pa s. `quadratic`: [Ding19 Eq. 12] as printed, eta in Pa^3 s.
  enum class Norm { distance, quadratic };
  friend constexpr auto choice_names(Norm) { return std::array{"distance", "quadratic"}; }

  struct Settings {
    Norm norm = Norm::distance;
    Form porosity_form = Form::standard;
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"norm", &Settings::norm, "", any_number,
                    "overstress of the viscous law: \"distance\" (viscosity in Pa s) or \"quadratic\" as printed (Pa^3 s)"},
          Parameter{"porosity_form", &Settings::porosity_form, "", any_number,
                    "n = 1 - (1 - n_0)/J_P (standard) or J_P - 1 + n_0 (published)"},
      };
    }
  };
  struct Material {
    std::array<double, 4> temperatures_C = {4, 20, 45, 85};
    std::array<double, 4> yield_stress_Pa = {0, 0, 0, 0};
    std::array<double, 4> viscosity_Pa_s = {0, 0, 0, 0};
    double fracture_energy_J_per_m2 = k_infinity;
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"temperatures_C", &Material::temperatures_C, "C", above_absolute_zero,
                    "theta_1..theta_4 of fig. 8: fridge, room, fat melting, gelatinisation; strictly rising"},
          Parameter{"yield_stress_Pa", &Material::yield_stress_Pa, "Pa", non_negative,
                    "tau_y at theta_1..theta_4, in pulling or pressing along one axis (in shear it yields at tau_y / sqrt 3); linear "
                    "between, frozen "
                    "past theta_4; one number means constant",
                    Presence::required},
          Parameter{
              "viscosity_Pa_s", &Material::viscosity_Pa_s, "Pa s", non_negative,
              "eta at theta_1..theta_4, of pulling along one axis (that of shear is eta / 3); Pa^3 s with norm = \"quadratic\"; one number "
              "means constant"},
          Parameter{"fracture_energy_J_per_m2", &Material::fracture_energy_J_per_m2, "J/m^2", positive_or_infinite,
                    "G_f: work that parts set dough (past theta_4), per area of the crack; inf is the paper's, which never breaks"},
      };
    }
  };

  using Stored = FieldList<field::PlasticVolumeRatio>;
  using Transient = FieldList<field::PlasticDilation>;
  using Booked = FieldList<booked::Dissipated>;

  template <class Real>
  struct Constants {
    Real bulk, mu, n_0;
    Real theta[4], tau_y[4], eta[4];
    Real tau_y_slope[3], eta_slope[3];  ///< of the three pieces of fig. 8
    bool quadratic, published_porosity, never_porous;
    template <class Scene, class SceneMaterial>
    Constants(const Scene& scene, const SceneMaterial& material) : n_0(static_cast<Real>(material.initial_porosity)) {
      const Elasticity::Constants<Real> elastic(scene, material);
      bulk = elastic.bulk;
      mu = elastic.mu;
      never_porous = material.initial_porosity <= k_no_pores;
      const auto& m = material.effects.template get<Material>();
      for (int i = 0; i < 4; ++i) {
        theta[i] = static_cast<Real>(m.temperatures_C[i]);
        tau_y[i] = static_cast<Real>(m.yield_stress_Pa[i]);
        eta[i] = static_cast<Real>(m.viscosity_Pa_s[i]);
      }
      for (int i = 0; i < 3; ++i) {
        tau_y_slope[i] = (tau_y[i + 1] - tau_y[i]) / (theta[i + 1] - theta[i]);
        eta_slope[i] = (eta[i + 1] - eta[i]) / (theta[i + 1] - theta[i]);
      }
      const auto& settings = scene.settings.template get<Settings>();
      quadratic = settings.norm == Norm::quadratic;
      published_porosity = settings.porosity_form == Form::published;
    }
  };

  static void fill(auto& p, int lane, const auto&) { p[field::J_P][lane] = 1; }

  /// Yield stress and viscosity of fig. 8: piecewise linear, flat outside; past theta_4 they stay at their last values
  /// whatever the temperature does later, since gelatinisation is not undone. [Ding19 Sec. 5.3.2]
  template <class V, class K>
  BAKE_INLINE static void curves(V theta, V theta_peak, const K& k, V& tau_y, V& eta) {
    using Real = std::decay_t<decltype(k.mu)>;
    const V at = theta_peak >= k.theta[3] ? lanes<Real>(k.theta[3]) : theta;
    tau_y = lanes<Real>(k.tau_y[0]);
    eta = lanes<Real>(k.eta[0]);
    for (int i = 0; i < 3; ++i) {
      const V into = clamp(at - k.theta[i], lanes<Real>(0), lanes<Real>(k.theta[i + 1] - k.theta[i]));
      tau_y += k.tau_y_slope[i] * into;
      eta += k.eta_slope[i] * into;
    }
  }

  static constexpr double k_no_pores =
      1e-6;  ///< least porosity; at it compression is elastic, and tension, too, if it is that of the start

  /// a(n) = 9 / (4 ln^2(1/n) (7/2 n + 1)).   [Ding19 Eq. 12]
  template <class V>
  BAKE_INLINE static V cap(V n) {
    const V ln = log(n);
    return 9 / (4 * ln * ln * (3.5f * n + 1));
  }

  /// n = 1 - (1 - n_0) / J_P: the skeleton is incompressible.
  /// DEPARTS [Ding19 Sec. 5.4]: the printed n = J_P - 1 + n_0 is its linearisation and passes 1 for any real loaf.
  template <class V, class K>
  BAKE_INLINE static V porosity(V J_P, const K& k) {
    using Real = std::decay_t<decltype(k.mu)>;
    const V n = k.published_porosity ? J_P - 1 + k.n_0 : 1 - (1 - k.n_0) / J_P;
    return clamp(n, lanes<Real>(Real(k_no_pores)), lanes<Real>(Real(0.97)));
  }

  /// Watches solve() and sees nothing; tests count iterations with one of their own.
  struct Unwatched {
    BAKE_INLINE void operator()(auto) const {}
  };

  /// Keeps what is squared or divided by off zero.
  template <class Real>
  static constexpr Real k_tiny = sizeof(Real) == 4 ? Real(1e-18) : Real(1e-100);

  /// A lower bound of the z at which r0^2 / (1 + rate z)^2 falls to tau_y^2 + (eta/dt) z / 2, near it if it is far from 0: where the
  /// first of both terms that grow, (1 + rate z)^2 tau_y^2 and less than (1 + rate z)^3 eta / (2 dt rate), reaches r0^2 / 2.
  template <class Real, class V>
  BAKE_INLINE static V far_start(V r0_squared, V rate, V tau_y, V eta_dt) {
    constexpr Real k_largest = Real(1e36);
    const V by_yield = sqrt(Real(0.5) * r0_squared / (tau_y * tau_y + k_tiny<Real>));
    const V cube = min(r0_squared * (rate / (eta_dt + k_tiny<Real>)), lanes<Real>(k_largest));
    const V by_viscosity = exp(log(cube + k_tiny<Real>) * Real(1. / 3));
    return (min(by_yield, by_viscosity) - 1) / (rate + k_tiny<Real>);
  }

  /// p / p_tr = 1 / (1 + aK z) and s / s_tr = 1 / (1 + mu3 z) with one division: it takes as long as a score of products.
  template <class V, class Real>
  BAKE_INLINE static std::pair<V, V> shrunk(V aK, Real mu3, V z) {
    const V P = 1 + aK * z, Q = 1 + mu3 * z, both = 1 / (P * Q);
    return {Q * both, P * both};
  }

  /// Newton's method for the root of a concave function that is negative at 0: from below it rises to the root and never passes it, from
  /// above its first step falls below. So it needs no bracket but 0 and `far`, where it ends if nothing resists (step(z), Newton's, is
  /// infinite then). Lanes that are not `flowing` keep their z; `watch` is called in every iteration with the lanes that still move.
  template <class Real, class V, class Mask, class Step, class Watch>
  BAKE_INLINE static V newton(V z, V far, Mask flowing, Step step, Watch watch) {
    constexpr Real k_close = sizeof(Real) == 4 ? Real(3e-4) : Real(1e-8);  // of z; convergence is quadratic
    constexpr int k_most = sizeof(Real) == 4 ? 40 : 60;
    z = min(z, far);
    Mask active = flowing;
    for (int iteration = 0; iteration < k_most; ++iteration) {
      watch(active);
      const V next = clamp(z + step(z), lanes<Real>(0), far);
      const V moved = abs(next - z);
      z = active ? next : z;
      active = active & (moved > k_close * next);
      if (!any(active)) break;
    }
    return z;
  }

  /// Solves the viscous return. With z = 2 Lambda the mapped state is p = p_tr / (1 + a K z), s = s_tr / (1 + 3 mu z), and
  /// with r(z) = sqrt(a p^2 + q^2) the two laws are
  ///     distance:   r (1 - (eta/dt) z) = tau_y        solved as  tau_y / r + (eta/dt) z - 1 = 0
  ///     quadratic:  r^2 = tau_y^2 + (eta/dt) z / 2    solved as  1 / r - (tau_y^2 + (eta/dt) z / 2)^(-1/2) = 0
  /// 1/r is a power mean of linear functions with exponent -2, hence concave, and so are both left sides. Returns z, 0 in lanes that are
  /// not `flowing`.
  template <class V, class Mask, class Real, class Watch = Unwatched>
  BAKE_INLINE static V solve(V ap2, V q2, V aK, Real mu3, V tau_y, V eta_dt, Mask flowing, bool quadratic, Watch watch = {}) {
    return quadratic ? solve_quadratic(ap2, q2, aK, mu3, tau_y, eta_dt, flowing, watch)
                     : solve_distance(ap2, q2, aK, mu3, tau_y, eta_dt, flowing, watch);
  }

  /// Stresses are counted in r(0) and z in 1 / (3 mu) here. With P = 1 + alpha z, Q = 1 + z and N = (P Q r)^2 = A Q^2 + B P^2,
  ///     1/r = P Q N^(-1/2),   (1/r)' = (A (P + alpha - 1) Q^2 + B P^3) N^(-3/2),   (1/r)" = -3 A B (1 - alpha)^2 P Q N^(-5/2);
  /// Newton's step is multiplied out: an iteration waits for one root and one division. The first, from 0, is Chebyshev's of third
  /// order, at most twice Newton's.
  template <class V, class Mask, class Real, class Watch>
  BAKE_INLINE static V solve_distance(V ap2, V q2, V aK, Real mu3, V tau_y, V eta_dt, Mask flowing, Watch watch) {
    constexpr Real k_least = sizeof(Real) == 4 ? Real(1e-36) : Real(1e-200);
    constexpr Real k_far = sizeof(Real) == 4 ? Real(1e12) : Real(1e30);  // of P and Q; its cube is in range
    const V none = lanes<Real>(0);
    const V inverse_r0 = 1 / sqrt(flowing ? ap2 + q2 : 1 + none);
    const V A = ap2 * inverse_r0 * inverse_r0, B = q2 * inverse_r0 * inverse_r0, y = tau_y * inverse_r0;
    const V alpha = aK * (1 / mu3), alpha_1 = alpha - 1, e = eta_dt * (1 / mu3);
    const V run = 1 / ((A * alpha + B) * y + e + k_least), first = (1 - y) * run;
    const V bend = Real(1.5) * A * B * alpha_1 * alpha_1 * y;
    const V z = newton<Real>(
        flowing ? first * (1 + min(bend * first * run, 1 + none)) : none, lanes<Real>(k_far), flowing,
        [&](V z) {
          const V P = min(1 + alpha * z, lanes<Real>(k_far)), Q = 1 + z, P2 = P * P, Q2 = Q * Q;
          const V N = A * Q2 + B * P2, root = sqrt(N);
          return N * (root * (1 - e * z) - y * (P * Q)) / (y * (A * Q2 * (P + alpha_1) + B * (P2 * P)) + e * (N * root) + k_least);
        },
        watch);
    return z * (1 / mu3);
  }

  /// g is scaled by the root of tau_y^2 + (eta/dt) z / 2.
  template <class V, class Mask, class Real, class Watch>
  BAKE_INLINE static V solve_quadratic(V ap2, V q2, V aK, Real mu3, V tau_y, V eta_dt, Mask flowing, Watch watch) {
    // lower bounds to start from, the first one Newton step on the convex r^2 - tau_y^2 - (eta/dt) z / 2
    const V near = (ap2 + q2 - tau_y * tau_y) / (2 * (ap2 * aK + q2 * mu3) + Real(0.5) * eta_dt + k_tiny<Real>);
    const V far = max(far_start<Real>(ap2, aK, tau_y, eta_dt), far_start<Real>(q2, lanes<Real>(mu3), tau_y, eta_dt));
    return newton<Real>(
        flowing ? max(near, far) : 0 * near, lanes<Real>(Real(1e12) / mu3), flowing,
        [&](V z) {
          const auto [pa, qa] = shrunk(aK, mu3, z);
          const V A = ap2 * pa * pa, B = q2 * qa * qa, r2 = A + B + k_tiny<Real>, r = sqrt(r2);
          const V bend = (A * pa * aK + B * qa * mu3) / r2;
          const V R = tau_y * tau_y + Real(0.5) * eta_dt * z + k_tiny<Real>, ratio = sqrt(R) / r;
          return (1 - ratio) / (bend * ratio + Real(0.25) * eta_dt / R + k_tiny<Real>);
        },
        watch);
  }

  /// Return mapping of the trial state on the solid's own stress, C : (epsilon - thermal strain), whatever gas and water push (Terzaghi).
  /// Were it on tau_E alone, nothing would hold the thermal stress of dough that yields.   [Ding19 Eq. 10-12, Sec. 6.5]
  BAKE_INLINE static void gather(auto& p, const auto&, const auto& k, const auto& step, auto& report) {
    using P = std::decay_t<decltype(p)>;
    using V = typename P::V;
    using Real = typename P::Real;
    const auto& e = p[field::epsilon];
    const V tr = e[0] + e[1] + e[2], mean = tr * Real(1. / 3);
    Symmetric<V> d;
    for (int i = 0; i < 6; ++i) d.at[i] = i < 3 ? e[i] - mean : e[i];
    V free = 0 * tr;  // of stress
    if constexpr (P::template has<field::ThermalStrain>) free = p[field::thermal_strain];
    const V stressed = tr - free, p_tr = -k.bulk * stressed, shear2 = norm_squared(d), q2 = (6 * k.mu * k.mu) * shear2;
    V tau_y, eta;
    curves<V>(p.temperature(), p.peak_temperature(), k, tau_y, eta);
    if constexpr (P::template has<field::Broken>) tau_y *= sqrt(1 - p[field::broken]);
    const V n = porosity<V>(p[field::J_P], k);
    // without pores there is nothing to compact, and where there were none at the start, nothing to open: von Mises' law, both ways
    const V a = k.never_porous ? 0 * n : ((n <= Real(k_no_pores)) & (p_tr > 0)) ? 0 * n : cap<V>(n);
    const V ap2 = a * p_tr * p_tr;
    const auto flowing = ap2 + q2 > tau_y * tau_y;
    p[field::plastic_dilation] = 0 * tr;
    if constexpr (P::template has<field::PlasticWork>) p[field::plastic_work] = 0 * tr;
    if (!any(flowing)) return;

    const V z = solve<V>(ap2, q2, a * k.bulk, 3 * k.mu, tau_y, eta * (1 / step.dt), flowing, k.quadratic);
    const auto [pa, qa] = shrunk(a * k.bulk, 3 * k.mu, z);
    const V tr_new = free + stressed * pa, flown = stressed * (1 - pa);
    if (step.dt > 0) p[field::plastic_dilation] = flowing ? flown * (1 / step.dt) : 0 * tr;
    p[field::J_P] = flowing ? p[field::J_P] * exp(flown) : p[field::J_P];
    Symmetric<V> mapped;
    for (int i = 0; i < 6; ++i) mapped.at[i] = d.at[i] * qa + (i < 3 ? tr_new * Real(1. / 3) : 0 * tr);
    const auto b = expm1_twice<Real>(mapped);
    for (int i = 0; i < 6; ++i) {  // elastic lanes keep their trial state untouched: exp(log) would cost digits
      p[field::epsilon][i] = flowing ? mapped.at[i] : e[i];
      p[field::b_E][i] = flowing ? b.at[i] : p[field::b_E][i];
    }
    // tau_new : (eps_tr - eps_new), never negative
    const V work = k.bulk * stressed * pa * flown + 2 * k.mu * qa * (1 - qa) * shear2;
    if constexpr (P::template has<field::PlasticWork>) p[field::plastic_work] = flowing ? work : 0 * tr;
    report.book(booked::dissipated, p[field::V_0] * work);
  }

  static void show(auto& frame) {
    frame.stored(field::J_P);
    frame.made("porosity", "1", "share of the volume that is gas, 1 - (1 - n_0) / J", [](const auto& material) {
      return [n_0 = material.initial_porosity](const auto& p) { return 1 - (1 - n_0) / p[field::J]; };
    });
  }

  static void check_material(const auto&, const auto&, const Material& own, const auto& complaint) {
    complaint.unless_rising("temperatures_C", {own.temperatures_C.begin(), own.temperatures_C.end()});
  }

  static const char* coefficient(const Material& own) {
    const auto is_set = [](const auto& curve) { return std::any_of(curve.begin(), curve.end(), [](double value) { return value > 0; }); };
    return is_set(own.yield_stress_Pa) ? "yield_stress_Pa" : is_set(own.viscosity_Pa_s) ? "viscosity_Pa_s" : "";
  }
};

}  // namespace bake
