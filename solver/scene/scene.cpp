// SPDX-License-Identifier: MIT
#include "solver/scene/scene.h"

#include <algorithm>

namespace bake {

bool Scene::lists(std::string_view effect) const { return std::find(effects.begin(), effects.end(), effect) != effects.end(); }

/// The place of the key, or else of the table or list that it belongs to, or else the file.
std::string Scene::at(const std::string& key) const {
  for (std::string name = key; !name.empty(); name.resize(name.find('.') == std::string::npos ? 0 : name.rfind('.')))
    if (const auto place = places.find(name); place != places.end()) return place->second + ": " + key;
  return file.string() + ": " + key;
}

}  // namespace bake
