// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace bake {

/// What making a mesh takes, about, by the number of its vertices.
struct Effort {
  double seconds = 0;
  double bytes = 0;
};

/// Twice what a cube took in meshes of 10 000 to 300 000 vertices on one core: surfaces of many triangles take longer. Memory is the peak.
Effort lattice_effort(double vertices);
Effort feature_effort(double vertices);

/// ... of the skin of a surface with triangles of this edge length.
Effort skin_effort(double area_m2, double edge_length_m);

/// Throws InputError if the effort is more than this machine's memory or more than an hour: `what` (as "100 vertices"), the estimate,
/// and what is allowed.
void require_effort(const std::string& what, const Effort& effort);

}  // namespace bake
