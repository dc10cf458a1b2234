// SPDX-License-Identifier: MIT
// The cases of the study by name. Each has a file of its own with its exact solution and what is expected of the solver.
#pragma once

#include "experiments/common/errors.h"

namespace bake::studies {

/// An exact solution with which the solver is compared.
struct ConvergenceCase {
  const char* name;
  const char* solution;  ///< one line for the table
  std::vector<Errors> (*measure)(bool quick);
};

/// All cases. To add one, add a line.
const std::vector<ConvergenceCase>& all_cases();

std::vector<Errors> slab_cosine(bool quick);
std::vector<Errors> slab_halves(bool quick);
std::vector<Errors> slab_held(bool quick);
std::vector<Errors> slab_held_and_insulated(bool quick);
std::vector<Errors> robin(bool quick);
std::vector<Errors> plates(bool quick);
std::vector<Errors> melting(bool quick);
std::vector<Errors> square(bool quick);
std::vector<Errors> eulers(bool quick);
std::vector<Errors> fick(bool quick);
std::vector<Errors> barenblatt(bool quick);
std::vector<Errors> vapour_cosine(bool quick);
std::vector<Errors> vapour_in_a_bar(bool quick);
std::vector<Errors> pulse_wave(bool quick);
std::vector<Errors> free_bar(bool quick);
std::vector<Errors> clamped_bar(bool quick);
std::vector<Errors> hencky_fan(bool quick);
std::vector<Errors> axis_aligned_waves(bool quick);
std::vector<Errors> generalised_vortex(bool quick);
std::vector<Errors> adiabatic(bool quick);
std::vector<Errors> free_fall(bool quick);
std::vector<Errors> spinning_disc(bool quick);
std::vector<Errors> slope(bool quick);
std::vector<Errors> lumped_sphere(bool quick);
std::vector<Errors> drying_ball(bool quick);
std::vector<Errors> thermal_strain(bool quick);
std::vector<Errors> open_pores(bool quick);
std::vector<Errors> closed_pores(bool quick);
std::vector<Errors> perzyna(bool quick);
std::vector<Errors> wrinkles(bool quick);
std::vector<Errors> wrinkles_of_skin(bool quick);

}  // namespace bake::studies
