// SPDX-License-Identifier: MIT
// Fills a shape with points, one per spacing^3 of its volume, and measures this volume.
//
// The points depend on shape, spacing and seed alone. They are sorted by position (x slowest, z fastest), and their random numbers
// are the same on every platform.
// All throw std::invalid_argument if the spacing is not positive and finite, if the shape's bounds are infinite, or if
// the spacing is so small that the bounds would hold more than k_most_places cells.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "solver/boundary/shape.h"

namespace bake {

/// Points of a cubic lattice centred in the shape's bounds, each displaced evenly by up to jitter * spacing_m / 2 along
/// each axis (jitter 0..1; 1: anywhere in its own cube), that end up inside.
std::vector<Point> fill_lattice(const Shape& shape, double spacing_m, double jitter, std::uint64_t seed);

/// Calls found(x) for the same points one by one, but only for those whose place in the lattice is wanted(place). A point lies within
/// jitter * spacing_m / 2 of its place along each axis.
void visit_lattice(const Shape& shape, double spacing_m, double jitter, std::uint64_t seed, const std::function<bool(const Point&)>& wanted,
                   const std::function<void(const Point&)>& found);

/// Random points, no two of them closer than k_poisson_radius * spacing_m, packed so densely that hardly another one fits in. Interior
/// and rim are equally dense.
std::vector<Point> fill_poisson(const Shape& shape, double spacing_m, std::uint64_t seed);

/// Smallest distance of Poisson points, in spacings: the one at which the dense packing has one point per spacing^3
/// (measured on fillings of 10^6 points).
inline constexpr double k_poisson_radius = 0.8358;

/// Most cells of spacing_m that the bounds of a shape may hold.
inline constexpr double k_most_places = 1e10;

/// How large a filling will be.
struct FillingSize {
  double points;  ///< one per spacing^3 of its volume; a shape thinner than the spacing takes more
  double places;  ///< cells of spacing_m in the shape's bounds
};
FillingSize estimate_filling(const Shape& shape, double spacing_m);

/// Volume of a shape from its signed distance alone [m^3], infinite if its bounds are. Cubes that are surely inside count wholly, of each
/// cube that the surface may cut two opposite points at random decide. So it has no bias. Cubes get smaller until the standard error is at
/// most 0.02 % of the volume, or of `at_least_m3` if that is more, or until the surface has some 10^6 of them: a sheet of less than a 500th
/// of its length may be off by more. The same bits every time.
double sampled_volume(const Shape& shape, double at_least_m3 = 0);

}  // namespace bake
