// SPDX-License-Identifier: MIT
#include "studies/convergence/errors.h"

#include <algorithm>

#include "studies/convergence/cases.h"
#include "studies/order.h"

namespace bake::studies {

double Errors::value() const {
  return figure == Figure::order ? fitted_order(refinements, errors) : *std::max_element(errors.begin(), errors.end());
}

const std::vector<Case>& all_cases() {
  static const std::vector<Case> cases{
      {"slab_cosine", "an insulated slab with a cosine of temperature: it decays with exp(-pi^2 Fo)", slab_cosine},
      {"slab_halves", "a hot and a cold half of an insulated slab: cosine series", slab_halves},
      {"slab_held", "a slab whose faces are held at 1 and 0: sine series", slab_held},
      {"slab_held_and_insulated", "a slab held at 1 on one face, insulated on the other: sine series", slab_held_and_insulated},
      {"robin", "a slab that cools in air at Bi = 0.1, 1, 10: series over the roots of z tan z = Bi", robin},
      {"square", "a square section whose sides are held at 1: double sine series", square},
      {"eulers", "forward and backward Euler of heat: the same grid with half the step", eulers},
      {"fick", "a small cosine of saturation: it decays with exp(-pi^2 Fo)", fick},
      {"barenblatt", "water that spreads by q = -K theta rho s grad s into dry solid: Barenblatt's parabola, front ~ t^(1/3)", barenblatt},
      {"pulse_wave", "a pulse of velocity that parts in two: d'Alembert", pulse_wave},
      {"free_bar", "an elastic bar with free ends at its first period", free_bar},
      {"clamped_bar", "an elastic bar between walls at its first period", clamped_bar},
      {"hencky_fan", "the halves of a bar fly apart: the fan of finite strain in Hencky's material", hencky_fan},
      {"adiabatic", "dough squeezed without conduction: theta_K ~ J^(-beta_T / (rho_0 c))", adiabatic},
  };
  return cases;
}

}  // namespace bake::studies
