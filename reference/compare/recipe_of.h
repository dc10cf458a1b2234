// SPDX-License-Identifier: MIT
// Converts a scene for the textbook baker.
#pragma once

#include "reference/textbook/baker.h"
#include "solver/engine/engine.h"
#include "solver/run/skins.h"
#include "solver/scene/scene.h"

namespace bake {

/// Throws InputError if the scene lists an effect that the textbook does not know.
textbook::Recipe recipe_of(const Scene& scene);
/// The air, colliders and grips at the begin of a step of length `dt`, and gravity over it.
textbook::Surroundings surroundings_of(const Scene& scene, double time_s, double dt);
textbook::Beginning beginning_of(const Scene& scene, const NewParticle& particle, std::int64_t id);
/// Gives the baker the scene's skins; `vertices`: of all of them.
void cover(const Scene& scene, const std::vector<MadeSkin>& skins, const std::vector<NewParticle>& vertices, textbook::Baker& baker);

}  // namespace bake
