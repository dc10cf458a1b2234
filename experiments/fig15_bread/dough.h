// SPDX-License-Identifier: MIT
// Bread's dough by itself, for figures that need no loaf.
#pragma once

#include <string>
#include <vector>

#include "solver/scene/scene.h"

namespace bake {

/// The scene of figure 15 with these overrides (`key=value`). Throws InputError.
Scene bread_scene(const std::vector<std::string>& overrides = {});

/// Makes a scene of the dough into a small block of it in a warm hand: held still, all of it at the temperature `held` over time, in
/// steps of at most a thousandth of that.
void hold_block(Scene& scene, const Curve& held);

}  // namespace bake
