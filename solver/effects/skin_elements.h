// SPDX-License-Identifier: MIT
// The elements of a skin, an elastic sheet of triangles: the membrane in a triangle, the hinge between two. Forces are the gradients of an
// energy, to round-off. [Ding19 Sec. 7.1; Jiang et al. 2015, doi:10.1145/2766918]
//
// All functions work on packs of W elements. Lengths are in any unit, as long as it is the same; energies are in that of the stiffnesses.
#pragma once

#include "solver/core/lanes.h"

namespace bake {

/// A corner's three numbers in W elements.
template <class V>
using Corner = V[3];

template <class V>
BAKE_INLINE V dot_of(const V (&a)[3], const V (&b)[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class V>
BAKE_INLINE void cross_of(const V (&a)[3], const V (&b)[3], V (&c)[3]) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    c[i] = a[j] * b[k] - a[k] * b[j];
  }
}

/// A thin sheet in plane stress, neo-Hookean:
///     E = A_0 h (mu/2 (tr C - 2 - ln det C) + lambda/8 ln^2 det C),  C = F^T F,  F = [a b] D_m^-1,  lambda = 2 l mu / (l + 2 mu)
/// `a`, `b`: from a triangle's first corner to its second and third; `inverse`: D_m^-1 by rows, of the triangle at rest; `mu`, `lambda`:
/// A_0 h times the moduli. Writes the forces on the second and third corner; the first has the opposite of their sum. Returns the energy.
/// A triangle whose area is below a millionth of that at rest is taken for one of a millionth: what is collapsed stays finite.
template <class V>
BAKE_INLINE V membrane(const V (&a)[3], const V (&b)[3], const V (&inverse)[4], V mu, V lambda, V (&force_1)[3], V (&force_2)[3]) {
  using Real = std::decay_t<decltype(mu[0])>;
  V F1[3], F2[3];
  for (int i = 0; i < 3; ++i) {
    F1[i] = inverse[0] * a[i] + inverse[2] * b[i];
    F2[i] = inverse[1] * a[i] + inverse[3] * b[i];
  }
  const V c11 = dot_of(F1, F1), c12 = dot_of(F1, F2), c22 = dot_of(F2, F2);
  const V det = max(c11 * c22 - c12 * c12, lanes<Real>(Real(1e-12))), ln = log(det), per_det = 1 / det;
  // the second Piola-Kirchhoff stress, mu (I - C^-1) + lambda/2 ln(det C) C^-1
  const V pull = (Real(0.5) * lambda * ln - mu) * per_det;
  const V s11 = mu + pull * c22, s12 = -pull * c12, s22 = mu + pull * c11;
  for (int i = 0; i < 3; ++i) {
    const V P1 = s11 * F1[i] + s12 * F2[i], P2 = s12 * F1[i] + s22 * F2[i];
    force_1[i] = -(inverse[0] * P1 + inverse[1] * P2);
    force_2[i] = -(inverse[2] * P1 + inverse[3] * P2);
  }
  return Real(0.5) * mu * (c11 + c22 - 2 - ln) + Real(0.125) * lambda * ln * ln;
}

/// The bending of two triangles that share an edge e:
///     E = B/2 |e|^2 / (A_1 + A_2) (theta - theta_0)^2,  B = E h^3 / (12 (1 - nu^2))
/// with the angle theta between their normals. On even meshes a plate of rigidity B that is rolled to a cylinder of radius R has the energy
/// B / (2 R^2) per area.
/// [Ding19] does not tell how the sheet bends; without hinges mesh and grid would decide how finely it folds.
/// `e`: from the edge's first corner to its second; `a`, `b`: from its first corner to the tips of the triangles left and right of it;
/// `stiffness`: B |e|^2 / (A_1 + A_2) at rest; `rest`: theta_0; `edge_2`: |e|^2 at rest. Writes the forces on the edge's second corner and
/// on both tips; its first has the opposite of their sum. Returns the energy. A triangle lower than a thousandth of the edge at rest is
/// taken for one of that height: what is collapsed stays finite.
template <class V>
BAKE_INLINE V hinge(const V (&e)[3], const V (&a)[3], const V (&b)[3], V stiffness, V rest, V edge_2, V (&force_1)[3], V (&force_a)[3],
                    V (&force_b)[3]) {
  using Real = std::decay_t<decltype(rest[0])>;
  V n_a[3], n_b[3], across[3];
  cross_of(e, a, n_a);
  cross_of(b, e, n_b);
  cross_of(n_a, n_b, across);
  const V least = Real(1e-6) * edge_2, length_2 = max(dot_of(e, e), least), length = sqrt(length_2);
  const V a_2 = max(dot_of(n_a, n_a), least * edge_2), b_2 = max(dot_of(n_b, n_b), least * edge_2), both = sqrt(a_2 * b_2);
  // tan(theta/2) = sin / (1 + cos); a sheet that is folded back onto itself has a large one
  const V sine = dot_of(across, e) / length, one_and_cosine = max(both + dot_of(n_a, n_b), Real(1e-6) * both);
  const V bent = 2 * atan(sine / one_and_cosine) - rest, moment = stiffness * bent;
  // grad theta is -|e| n / |n|^2 at the tips, and divided among the corners of the edge as the tip stands above it
  const V per_a = moment / a_2, per_b = moment / b_2, per_length = 1 / length;
  const V share_a = dot_of(a, e) * per_length * per_a, share_b = dot_of(b, e) * per_length * per_b;
  for (int i = 0; i < 3; ++i) {
    force_a[i] = length * per_a * n_a[i];
    force_b[i] = length * per_b * n_b[i];
    force_1[i] = -(share_a * n_a[i] + share_b * n_b[i]);
  }
  return Real(0.5) * moment * bent;
}

}  // namespace bake
