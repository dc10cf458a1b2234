// SPDX-License-Identifier: MIT
// From a scene to what the textbook baker needs of it.
#pragma once

#include "reference/textbook/baker.h"
#include "solver/engine/engine.h"
#include "solver/scene/scene.h"

namespace bake {

textbook::Recipe recipe_of(const Scene& scene);
/// Air, colliders and grips as they are at one time.
textbook::Surroundings surroundings_of(const Scene& scene, double time_s);
textbook::Beginning beginning_of(const Scene& scene, const NewParticle& particle, std::int64_t id);

}  // namespace bake
