// SPDX-License-Identifier: MIT
// Makes particles of bodies and emitters. All particles of a body's shape have the same volume, and together they have the shape's,
// whatever the filling and the grid. (It counts wholly if it reaches out of the domain by less than a particle; by more, it is refused.)
// An emitter pours its shape again and again, each time with other particles: the same ones would follow each other on the same paths,
// and leave gaps between them where dough spreads.
#pragma once

#include <cstdint>
#include <functional>
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
/// The same in portions of at most `most` particles of one body; calls visit(portion, how many of the body are still to come).
void fill_bodies(const Scene& scene, std::size_t most,
                 const std::function<void(std::vector<NewParticle> portion, std::size_t left)>& visit);

/// Throws what fill_bodies or EmitterState would throw, but takes less time and memory: it looks for one particle of each shape, and at
/// those near the domain's faces.
void check_filling(const Scene& scene);

/// The state of an emitter: a column of dough, one filling of the shape behind the other, is pushed through the plane of the shape's rear
/// end. Slices of it, about one spacing thick, arrive as soon as they are through.
class EmitterState {
 public:
  /// Throws InputError as fill_bodies. `scene` and `emitter` must outlive it.
  EmitterState(const Scene& scene, const Emitter& emitter, std::size_t number);
  /// Time at which the next slice is through; infinity if there is none.
  double next_time() const;
  /// Returns the particles of the next slice as they are at next_time(), and advances to the one after it.
  std::vector<NewParticle> pour();
  std::int64_t poured() const { return poured_; }
  /// Particles that it has poured by the time `end`, about; `mean`: on average over the time from 0 to `end`.
  double particles_by(double end, bool mean) const;
  void skip_to(std::int64_t poured) { poured_ = poured; }  ///< used when a checkpoint is read

 private:
  std::vector<Point> filling(std::int64_t portion) const;

  const Scene& scene_;
  const Emitter& emitter_;
  ShapeToFill shape_;
  Body body_;  ///< what the particles are made of
  double speed_;
  Vector3 direction_;
  double front_, rear_;        ///< of the shape, along the direction [m]
  std::int64_t slices_;        ///< of a portion
  double slice_s_;             ///< time in which a slice passes
  double per_second_;          ///< particles
  std::int64_t poured_ = 0;    ///< slices
  std::int64_t portion_ = -1;  ///< whose points are kept
  std::vector<Point> points_;
};

}  // namespace bake
