// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/tets/effort.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

#include "solver/core/errors.h"

namespace bake {
namespace {

constexpr double k_most_seconds = 3600;

std::string time_text(double seconds) {
  if (seconds < 120) return fmt::format("{:.0f} s", seconds);
  if (seconds < 7200) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.3g} h", seconds / 3600);
}

}  // namespace

Effort lattice_effort(double vertices) { return {2 + 5e-5 * vertices, 1e8 + 1e3 * vertices}; }
Effort feature_effort(double vertices) { return {2 + 1e-4 * vertices, 1e8 + 5e3 * vertices}; }

Effort skin_effort(double area_m2, double edge_length_m) {
  const double triangles = area_m2 / (std::sqrt(3.0) / 4 * edge_length_m * edge_length_m);
  return {1 + 2e-5 * triangles, 1e8 + 400 * triangles};
}

void require_effort(const std::string& what, const Effort& effort) {
  const double memory = static_cast<double>(::sysconf(_SC_PHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  if (effort.bytes > memory || effort.seconds > k_most_seconds)
    throw InputError(fmt::format("{} would take about {} and {:.3g} GB of memory, allowed: {} and the {:.3g} GB of this machine", what,
                                 time_text(effort.seconds), effort.bytes / 1e9, time_text(k_most_seconds), memory / 1e9));
}

}  // namespace bake
