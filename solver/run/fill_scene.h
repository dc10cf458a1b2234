// SPDX-License-Identifier: MIT
// Makes particles of bodies and emitters. All particles of a body's shape have the same volume, and together they have the shape's,
// whatever the filling and the grid. (It counts wholly if it reaches out of the domain by less than a particle; by more, it is refused.)
// An emitter has no volume but a rate, a portion's over the time in which it moves away by its own length: both are those of the lattice,
// each particle a cell of it, so that their errors cancel.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "solver/engine/engine_types.h"
#include "solver/scene/scene.h"

namespace bake {

/// A shape that is to be filled with particles: a body's or an emitter's.
struct ShapeToFill {
  std::string name;  ///< for messages: "body.0", "emitter.jug"
  ShapePtr shape;
  Filling filling;
  double spacing;  ///< [m]
  double jitter;
  std::uint64_t seed;
};
std::vector<ShapeToFill> shapes_to_fill(const Scene& scene);

/// Particles of all bodies at the start. `scene` must outlive them. Throws InputError if a body has no particle, has one outside the
/// domain, or its file cannot be read.
std::vector<NewParticle> fill_bodies(const Scene& scene);

/// Throws what fill_bodies or EmitterState would throw, but takes less time and memory: it looks for one particle of each shape, and at
/// those near the domain's faces.
void check_filling(const Scene& scene);

/// The state of an emitter. It pours its shape filled with particles, again each time the last filling has moved away by its own length.
class EmitterState {
 public:
  /// Throws InputError as fill_bodies.
  EmitterState(const Scene& scene, const Emitter& emitter, std::size_t number);
  /// Time of the next pouring; infinity if there is none.
  double next_time() const;
  /// Returns the particles of the next pouring and advances to the one after it.
  std::vector<NewParticle> pour();
  std::int64_t poured() const { return poured_; }
  void skip_to(std::int64_t poured) { poured_ = poured; }  ///< used when a checkpoint is read

 private:
  double from_, until_, period_;
  std::int64_t poured_ = 0;
  Body body_;  ///< what the particles are made of
  std::vector<NewParticle> portion_;
};

}  // namespace bake
