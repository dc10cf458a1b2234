// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshing/fracture/material_shape.h"

namespace bake {

/// The positions of the nodes of a cut surface when its vertices are at `positions` in frame `frame` [m].
///
/// A node that all its vertices own is interpolated, x = sum_a share_a x_a. Any other is extrapolated by its owners,
///     x = sum_a share_a (x_a + G_a (X - X_a)) / sum_a share_a,
/// where G_a is the linear map that fits the whole edges at a best; if these are few or strongly distorted, it is their best rotation.
/// A node moves from the first place to the second over the four frames after the last of its edges broke, so that cracks open smoothly.
std::vector<Point> node_positions(const Topology& topology, const CutSurface& surface, const MaterialShape& shape,
                                  const std::vector<std::int32_t>& broken_at, int frame, const std::vector<Point>& positions);

/// A quantity at the nodes, interpolated between their owners. `values`: `components` numbers per vertex.
std::vector<double> node_values(const CutSurface& surface, const MaterialShape& shape, const std::vector<float>& values,
                                std::size_t components);

}  // namespace bake
