// SPDX-License-Identifier: MIT
// Gas: made by leavener, pressing in the pores.   [Ding19 Sec. 5.4]
#pragma once

#include "reference/textbook/plasticity.h"

namespace bake::textbook {

/// d nu/dt = alpha_g R_0 exp(-((theta - theta_r) / Delta theta)^2) [mol/(m^3 s)]
inline double reaction_rate(double theta, const Material& m) {
  const double distance = (theta - m.theta_r) / m.delta_theta;
  return m.alpha_g * m.density * std::exp(-distance * distance);
}

/// nu += dt rate c, with dc/dt = -(rate / total) c implicit in c where the leavener is finite.
/// DEPARTS [Ding19 Sec. 5.4]: printed without end.
inline void react(const Material& m, double dt, Particle& p) {
  const double made = dt * reaction_rate(p.theta, m);
  if (m.leavener_total < std::numeric_limits<double>::infinity()) {
    const double z = made / m.leavener_total, spent = p.c * z / (1 + z);
    p.c -= spent;
    p.nu += m.leavener_total * spent;
  } else {
    p.nu += made * p.c;
  }
}

/// The pore fraction n is held between 0.02 and 0.97, or a little wider so that fresh dough lies inside.
inline double hold_pores(double n, const Material& m) {
  return std::clamp(n, std::min(0.02, m.initial_porosity / 2), std::max(0.97, m.initial_porosity));
}

/// J p_gas = J [(nu_0 + nu) R theta_K / (J n) - p_ref], J n = J - (1 - n_0). A lower p_ref has moles scaled alike.
/// DEPARTS [Ding19 Eq. 13]: as printed nu R theta / n counts only the CO2, theta is not absolute and nothing pushes back.
inline double gas_pressure(const Particle& p, const Recipe& recipe, const Material& m) {
  if (recipe.leavening_form == Form::published)
    return p.nu * k_gas_constant * p.theta / hold_pores(plastic_porosity(p, m, recipe.porosity_form), m);
  const double nu_0 = recipe.reference_pressure * m.initial_porosity / (k_gas_constant * (m.theta_0 + k_zero_celsius));
  const double moles = nu_0 + p.nu * recipe.reference_pressure / k_one_atmosphere;
  const double n = hold_pores((p.J - (1 - m.initial_porosity)) / p.J, m);
  const double pressure = moles * k_gas_constant * (p.theta + k_zero_celsius) / n - p.J * recipe.reference_pressure;
  return recipe.pores_open ? std::max(pressure, 0.) : pressure;  // air enters
}

}  // namespace bake::textbook
