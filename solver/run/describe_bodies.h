// SPDX-License-Identifier: MIT
// What `bake info` says of a scene's bodies.
#pragma once

#include <string>

namespace bake {

struct Scene;

/// Lines as describe_scene has them: mass, volume and water of every body at the start; which bodies overlap, and which lie in colliders
/// that are there at time 0, where they share at least a thousandth of the smaller one; a warning of each body whose shape is too thin or
/// too small for its particles at the scene's quality. (Two bodies from files of particles are not compared: neither has a shape.)
/// Throws InputError as fill_bodies.
std::string describe_bodies(const Scene& scene);

}  // namespace bake
