// SPDX-License-Identifier: MIT
// The study of the surface measure: the area that bodies of known area are found to have.
#pragma once

#include <string>
#include <vector>

namespace bake::studies {

/// Cells in a metre up to which orders are fitted: beyond, the noise of the particles shows (see claim_of).
inline constexpr double k_finest_fitted = 16;

/// One body at one form of the measure and one density of particles.
struct Areas {
  std::string body;
  bool smooth;                 ///< has it no edges?
  std::string form;            ///< "standard" or "published"
  double particles_per_cell;   ///< on a jittered lattice
  std::vector<double> cells;   ///< in a metre, rising; the bodies measure about two
  std::vector<double> ratios;  ///< area found over true area

  double order() const;  ///< of |ratio - 1|, up to k_finest_fitted cells
};

/// What is claimed of a standard form: a band of orders, and why. None for the published form, whose ratios do not go to 1.
/// Bounds of `figure`.
struct AreaClaim {
  double low, high;
  const char* why;
};
AreaClaim claim_of(const Areas& areas);
double figure(const Areas& areas);  ///< what is claimed of them: of smooth bodies the largest error, of others its order
bool holds(const Areas& areas);

/// All bodies, forms and densities.
std::vector<Areas> measure_areas(bool quick);

}  // namespace bake::studies
