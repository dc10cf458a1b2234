// SPDX-License-Identifier: MIT
// A particle of the solid, with all that it carries from one step to the next.
#pragma once

#include <algorithm>
#include <cstdint>

#include "reference/textbook/recipe.h"

namespace bake::textbook {

struct Particle {
  std::int64_t id = 0;
  int material = 0;
  Vector x;        ///< [m]
  double V_0 = 0;  ///< volume at the start [m^3]
  double m_s = 0;  ///< mass of the solid, for ever the same [kg]

  Vector v;                 ///< [m/s]
  Matrix C;                 ///< affine velocity [1/s]
  Matrix grad_v;            ///< [1/s]; the same as C if gradients are moments
  double J = 1;             ///< V / V_0
  double V_before = 0;      ///< V of which the nodes know [m^3]
  Matrix b_E = identity();  ///< elastic left Cauchy-Green strain
  double J_P = 1;           ///< plastic part of J
  double dilation = 0;      ///< d ln J_P / dt [1/s]
  Matrix tau;               ///< Kirchhoff stress of the mixture [Pa]
  double theta = 0;         ///< [C]
  double theta_peak = 0;    ///< highest theta so far [C]
  double theta_lent = 0;    ///< what subgrid diffusion gave and the nodes take back in the next step [K]
  Vector grad_theta;        ///< [C/m]
  double m_w = 0;           ///< mass of water [kg]
  double m_w_lent = 0;      ///< as theta_lent [kg]
  double water_spread = 0;  ///< integral of K theta dt [m^2]
  Vector q;                 ///< flux of water relative to the solid [kg/(m^2 s)]
  Vector j_v;               ///< flux of vapour, a part of q [kg/(m^2 s)]
  Vector Q_scattered;       ///< V q, as the last scatter knew it [kg m/s]
  double nu = 0;            ///< gas made, per initial volume [mol/m^3]
  double c = 1;             ///< leavener left, as a share

  double V() const { return J * V_0; }
  double mass() const { return m_s + m_w; }
  Vector Q() const { return V() * q; }                                 ///< momentum of the water relative to the solid [kg m/s]
  double clamped_temperature() const { return std::max(theta, 0.0); }  ///< below 0 C water stays where it is
  double div_v() const { return trace(grad_v); }
};

}  // namespace bake::textbook
