// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <variant>

#include "meshing/tets/tet_mesh.h"

namespace bake {

/// What work may take before it is ended.
struct WorkBounds {
  double seconds = 0;
  double bytes = 0;  ///< of memory, besides what the program has; not heeded by builds with sanitizers
};

/// Why there is no mesh, for one line to the user.
struct NoMesh {
  std::string why;
};

/// Does the work in a process of its own, so that a library that never ends, takes all memory or dies takes nothing else with it.
/// What the work tells is passed on. What it throws, and how it ended otherwise, is said in NoMesh. What it prints is dropped.
/// To be called while the program has one thread. Throws RunError if no process can be made.
std::variant<TetMesh, NoMesh> in_own_process(const std::function<TetMesh(const Tell&)>& work, const WorkBounds& bounds, const Tell& tell);

}  // namespace bake
