// SPDX-License-Identifier: MIT
// Viscoplastic Cam clay whose strength follows temperature and porosity.   [Ding19 Sec. 5.3, 6.5]
#pragma once

#include "reference/textbook/elasticity.h"
#include "reference/textbook/heat.h"

namespace bake::textbook {

/// Fig. 8: linear between theta_1 ... theta_4, flat outside; gelatinised dough (past theta_4) keeps the last value.
inline double of_temperature(const double (&value)[4], const Particle& p, const Material& m) {
  if (p.theta_peak >= m.theta[3] || p.theta >= m.theta[3]) return value[3];
  if (p.theta <= m.theta[0]) return value[0];
  int i = 0;
  while (p.theta > m.theta[i + 1]) ++i;
  return value[i] + (value[i + 1] - value[i]) * (p.theta - m.theta[i]) / (m.theta[i + 1] - m.theta[i]);
}

inline constexpr double k_no_pores = 1e-6, k_only_pores = 0.97;

/// n = 1 - (1 - n_0) / J_P, or n = J_P - 1 + n_0 as printed   [Ding19 Sec. 5.4]
inline double plastic_porosity(const Particle& p, const Material& m, Form form) {
  return form == Form::published ? p.J_P - 1 + m.initial_porosity : 1 - (1 - m.initial_porosity) / p.J_P;
}

/// a(n) of the yield function f = a p^2 + q^2 - tau_y^2   [Ding19 Eq. 12]
inline double cap(double n) { return 9 / (4 * std::log(1 / n) * std::log(1 / n) * (3.5 * n + 1)); }

/// What the viscous return must solve: with z = 2 Lambda the mapped state is p = p_tr / (1 + a K z), q = q_tr / (1 + 3 mu z).
struct ViscousReturn {
  double p_tr, q_tr;  ///< pressure and effective stress of the trial state [Pa]
  double a, K, mu, tau_y, eta_per_dt;
  Norm norm;

  double p(double z) const { return p_tr / (1 + a * K * z); }
  double q(double z) const { return q_tr / (1 + 3 * mu * z); }
  double stress_norm(double z) const { return std::sqrt(a * p(z) * p(z) + q(z) * q(z)); }
  bool flows() const { return a * p_tr * p_tr + q_tr * q_tr > tau_y * tau_y; }

  /// Overstress less what viscosity asks for it: falls with z, zero at the solution.
  ///     distance:   r (1 - (eta/dt) z) - tau_y
  ///     quadratic:  r^2 - tau_y^2 - (eta/dt) z / 2      [Ding19 Eq. 12 and g = f^2 / 2]
  double excess(double z) const {
    const double r = stress_norm(z);
    return norm == Norm::distance ? r * (1 - eta_per_dt * z) - tau_y : r * r - tau_y * tau_y - 0.5 * eta_per_dt * z;
  }

  /// By bisection, until no double lies between the bounds.
  double solve() const {
    const double most = 1e12 / (3 * mu);
    double low = 0, high = std::min(1 / (3 * mu), most);
    while (excess(high) > 0 && high < most) low = high, high = std::min(2 * high, most);
    for (;;) {
      const double middle = low + 0.5 * (high - low);
      if (middle <= low || middle >= high) return middle;
      (excess(middle) > 0 ? low : high) = middle;
    }
  }
};

/// Maps a trial state back towards the yield surface: new b_E and J_P. The stress is the solid's, C : (epsilon - thermal strain).
/// [Ding19 Eq. 10-12, Sec. 6.5]
inline void return_mapping(const Recipe& recipe, const Material& m, double dt, Particle& p) {
  const Matrix epsilon = hencky_strain(p.b_E);
  const double volumetric = trace(epsilon);
  const Matrix deviator = epsilon - (volumetric / 3) * identity();
  const double n = std::clamp(plastic_porosity(p, m, recipe.porosity_form), k_no_pores, k_only_pores);
  ViscousReturn flow;
  const double unstressed = thermal_strain(p, recipe, m);
  flow.p_tr = -m.bulk() * (volumetric - unstressed);
  flow.q_tr = std::sqrt(1.5 * frobenius_squared(2 * m.mu() * deviator));
  const bool never_porous = m.initial_porosity <= k_no_pores;                // then nothing opens, either
  flow.a = never_porous || (n <= k_no_pores && flow.p_tr > 0) ? 0 : cap(n);  // without pores there is nothing to compact
  flow.K = m.bulk();
  flow.mu = m.mu();
  flow.tau_y = of_temperature(m.tau_y, p, m);
  flow.eta_per_dt = of_temperature(m.eta, p, m) / dt;
  flow.norm = recipe.norm;
  p.dilation = 0;
  if (!flow.flows()) return;
  const double z = flow.solve();
  const double mapped_volumetric = unstressed + (volumetric - unstressed) / (1 + flow.a * flow.K * z);
  p.dilation = dt > 0 ? (volumetric - mapped_volumetric) / dt : 0;
  p.J_P *= std::exp(volumetric - mapped_volumetric);  // what is no longer elastic is plastic
  p.b_E = left_cauchy_green((1 / (1 + 3 * flow.mu * z)) * deviator + (mapped_volumetric / 3) * identity());
}

}  // namespace bake::textbook
