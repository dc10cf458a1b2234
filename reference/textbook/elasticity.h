// SPDX-License-Identifier: MIT
// Hencky elasticity.   [Ding19 Sec. 5.2]
#pragma once

#include "reference/textbook/particle.h"

namespace bake::textbook {

/// b_tr = (I + dt grad v) b_E (I + dt grad v)^T   [Ding19 Eq. 11 without flow]
inline Matrix trial_strain(const Particle& p, double dt) {
  const Matrix step = identity() + dt * p.grad_v;
  return step * p.b_E * transposed(step);
}

/// epsilon = 1/2 log b_E. A stretch below 0.05 counts as 0.05.
inline Matrix hencky_strain(const Matrix& b_E) {
  return of_eigenvalues(b_E, [](double stretch2) { return 0.5 * std::log(std::max(stretch2, 0.0025)); });
}

/// b_E = exp(2 epsilon)
inline Matrix left_cauchy_green(const Matrix& epsilon) {
  return of_eigenvalues(epsilon, [](double e) { return std::exp(2 * e); });
}

/// tau_E = C : epsilon = lambda tr(epsilon) I + 2 mu epsilon
inline Matrix elastic_stress(const Matrix& epsilon, const Material& m) {
  return m.lambda() * trace(epsilon) * identity() + 2 * m.mu() * epsilon;
}

}  // namespace bake::textbook
