// SPDX-License-Identifier: MIT
#include "solver/scene/scene.h"

#include <algorithm>

namespace bake {

bool Scene::lists(std::string_view effect) const { return std::find(effects.begin(), effects.end(), effect) != effects.end(); }

}  // namespace bake
