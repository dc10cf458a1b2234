// SPDX-License-Identifier: MIT
#include "solver/scene/givers.h"

#include "solver/scene/describe.h"
#include "solver/scene/scene.h"

namespace bake {

std::vector<Giver> givers_of(const Scene& scene) {
  std::vector<Giver> givers;
  for (const Collider& collider : scene.colliders)
    if (collider.ledger) givers.push_back({"collider_" + collider.name, true});
  for (const Grip& grip : scene.grips)
    if (grip.ledger) givers.push_back({"grip_" + grip.name, false});
  for (const DomainFace& face : scene.faces)
    if (face.ledger) givers.push_back({std::string("face_") + word_of(face.at), true});
  return givers;
}

}  // namespace bake
