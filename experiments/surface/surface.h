// SPDX-License-Identifier: MIT
// The study of the surface measure: the area that bodies of known area are found to have.
#pragma once

#include <string>
#include <vector>

namespace bake::studies {

/// One body at one form of the measure and one density of particles.
struct Areas {
  std::string body;
  bool smooth;                 ///< has it no edges?
  std::string form;            ///< "standard" or "published"
  double particles_per_cell;   ///< on a jittered lattice
  std::vector<double> cells;   ///< in a metre, rising; the bodies measure about two
  std::vector<double> ratios;  ///< area found over true area
};

/// What is claimed of a standard form: how large its error is at most, and why. None for the published form, whose ratios do not go to 1.
struct AreaClaim {
  double most;
  const char* why;
};
AreaClaim claim_of(const Areas& areas);
double largest_error(const Areas& areas);
bool holds(const Areas& areas);

/// All bodies, forms and densities.
std::vector<Areas> measure_areas(bool quick);

}  // namespace bake::studies
