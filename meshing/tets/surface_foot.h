// SPDX-License-Identifier: GPL-3.0-or-later
// Finds points on the surface of a solid from its signed distance alone, even if that is right to first order only.
#pragma once

#include <optional>

#include "solver/boundary/shape.h"

namespace bake {

/// A point of the surface near x: Newton's method along the normals. Empty if it does not come within `tolerance_m` of the surface, or
/// strays farther than `reach_m` from x.
std::optional<Point> foot_on_surface(const Shape& solid, const Point& x, double tolerance_m, double reach_m);

/// How many faces meet at a point: 1 on a smooth surface, 2 on a crease, 3 in a corner.
struct Sharpest {
  Point at;
  int faces = 1;
};

/// The crease or corner within about `reach_m` of the surface point x, if there is one; x itself with one face if not.
/// The tangent planes around x are brought to intersect in the sense of least squares [Kobbelt, Botsch, Schwanecke, Seidel 2001,
/// "Feature sensitive surface extraction"], repeatedly and in ever smaller neighbourhoods: a round bend becomes flat, a crease
/// does not.
Sharpest sharpest_near(const Shape& solid, const Point& x, double reach_m);

}  // namespace bake
