// SPDX-License-Identifier: MIT
// What a run refuses of a scene that could be read: one answer for `bake validate`, `bake info` and `bake run`.
#pragma once

namespace bake {

struct Scene;

/// Throws InputError if no model has the scene's effects, or if its particles or its grid do not fit into this machine's memory. Allocates
/// nothing large.
void check_size(const Scene& scene);
/// [bytes] that a particle takes at least.
double bytes_per_particle(const Scene& scene);

/// Throws whatever beginning a run of the scene would throw as InputError: beside check_size, a body or an emitter without a particle or
/// with one outside the domain, a file of particles that cannot be used, or more frames than can be counted.
void check_scene(const Scene& scene);

}  // namespace bake
