// SPDX-License-Identifier: MIT
// Makes particles of bodies and emitters.
#pragma once

#include <vector>

#include "solver/engine/engine_types.h"
#include "solver/scene/scene.h"

namespace bake {

/// Particles of all bodies at the start. `scene` must outlive them.
std::vector<NewParticle> fill_bodies(const Scene& scene);

/// The state of an emitter. It pours its shape filled with particles, again each time the last filling has moved away by its own length.
class EmitterState {
 public:
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
