// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "meshing/fracture/topology.h"

namespace bake {

/// The distance of a point from the boundary of the mesh [m].
std::function<double(const Point&)> depth_in(const Topology& topology);

}  // namespace bake
