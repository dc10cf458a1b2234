// SPDX-License-Identifier: MIT
// Which solids and faces of a scene are booked one by one (`ledger = true`).
#pragma once

#include <string>
#include <vector>

namespace bake {

struct Scene;

/// A collider, a grip or a face of the domain whose gifts to the dough the ledger tells.
struct Giver {
  std::string name;  ///< how its columns begin: "collider_plate"
  bool gives_heat;   ///< else impulse alone
};

/// Those of a scene in the order in which they are numbered from 0: colliders, grips and faces, each in the order of the file.
std::vector<Giver> givers_of(const Scene& scene);

}  // namespace bake
