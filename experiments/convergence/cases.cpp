// SPDX-License-Identifier: MIT
#include "experiments/convergence/cases.h"

namespace bake::studies {

const std::vector<ConvergenceCase>& all_cases() {
  static const std::vector<ConvergenceCase> cases{
      {"slab_cosine", "an insulated slab with a cosine of temperature: it decays with exp(-pi^2 Fo)", slab_cosine},
      {"slab_halves", "a hot and a cold half of an insulated slab: cosine series", slab_halves},
      {"slab_held", "a slab whose faces are held at 1 and 0: sine series", slab_held},
      {"slab_held_and_insulated", "a slab held at 1 on one face, insulated on the other: sine series", slab_held_and_insulated},
      {"robin", "a slab that cools in air at Bi = 0.1, 1, 10: series over the roots of z tan z = Bi", robin},
      {"plates", "a bar between a hot and a cold collider at Bi = 1, 10: a line and the first mode", plates},
      {"melting", "a slab that melts from a held face: Neumann's solution, over a range of temperatures", melting},
      {"square", "a square section whose sides are held at 1: double sine series", square},
      {"eulers", "forward and backward Euler of heat: the same grid with half the step", eulers},
      {"fick", "a small cosine of saturation: it decays with exp(-pi^2 Fo)", fick},
      {"barenblatt", "water that spreads by q = -K theta rho s grad s into dry solid: Barenblatt's parabola, front ~ t^(1/3)", barenblatt},
      {"vapour_cosine",
       "a small cosine of temperature in wet dough: it decays by kappa + L_v n D_v rho_sat', and water goes to the cold end",
       vapour_cosine},
      {"pore_vapour", "vapour that goes from the hot to the cold end of a closed wet bar: heat and water by finite volumes",
       vapour_in_a_bar},
      {"pulse_wave", "a pulse of velocity that parts in two: d'Alembert", pulse_wave},
      {"free_bar", "an elastic bar with free ends at its first period", free_bar},
      {"clamped_bar", "an elastic bar between walls at its first period", clamped_bar},
      {"hencky_fan", "the halves of a bar fly apart: the fan of finite strain in Hencky's material", hencky_fan},
      {"axis_aligned", "manufactured: a cube stretched by 16 % along each axis by standing waves u_i = A sin(pi X_i) sin(pi (c t + phi_i))",
       axis_aligned_waves},
      {"vortex", "manufactured: rings of an annulus that turn by A sin(pi c t) (1 - 32 (R - 1)^2 + 256 (R - 1)^4)", generalised_vortex},
      {"adiabatic", "dough squeezed without conduction: theta_K ~ J^(-beta_T / (rho_0 c))", adiabatic},
      {"free_fall", "a cube that falls freely: v = g t", free_fall},
      {"spinning_disc", "an elastic disc that spins freely: it widens by omega^2 r (3 R^2 - r^2) rho / 8 E and keeps its momentum",
       spinning_disc},
      {"slope", "a block on a slope: Coulomb's g (sin a - mu cos a) t", slope},
      {"lumped_sphere", "a conductive sphere that cools in air: exp(-3 beta t / (rho c R))", lumped_sphere},
      {"drying_ball", "a wet ball at rest in hot air: heat and water along its radius by finite volumes", drying_ball},
      {"thermal_strain", "a warm cube at rest: ln J = 3 alpha (theta - theta_0)", thermal_strain},
      {"open_pores", "pores heated and leavened at the pressure of the atmosphere: ideal gas", open_pores},
      {"closed_pores", "pores heated at fixed volume: p theta_0K = p_ref (theta_K - theta_0K)", closed_pores},
      {"perzyna", "a viscoplastic bar that is pressed at constant speed, in both norms", perzyna},
      {"wrinkles", "a stiff film on deep soft ground that is compressed: wavelength and onset of its wrinkles", wrinkles},
      {"skin", "a skin on deep soft ground that is compressed: wavelength and onset of its wrinkles", wrinkles_of_skin},
  };
  return cases;
}

}  // namespace bake::studies
