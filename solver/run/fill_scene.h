// SPDX-License-Identifier: MIT
// From bodies and emitters to particles.
#pragma once

#include <vector>

#include "solver/engine/engine_types.h"
#include "solver/scene/scene.h"

namespace bake {

/// Particles of all bodies at the start. `scene` must outlive them.
std::vector<NewParticle> fill_bodies(const Scene& scene);

/// An emitter at work: pours its shape again and again, each time what was poured has moved its own length away.
class EmitterState {
 public:
  EmitterState(const Scene& scene, const Emitter& emitter, std::size_t number);
  /// Time of the next pouring, infinity if none.
  double next_time() const;
  /// The particles of the next pouring; moves on to the one after.
  std::vector<NewParticle> pour();
  std::int64_t poured() const { return poured_; }
  void skip_to(std::int64_t poured) { poured_ = poured; }  ///< after a checkpoint was read

 private:
  double from_, until_, period_;
  std::int64_t poured_ = 0;
  Body body_;  ///< what the particles are made of
  std::vector<NewParticle> portion_;
};

}  // namespace bake
