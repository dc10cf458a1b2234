// SPDX-License-Identifier: MIT
#include "solver/scene/scene.h"

#include <algorithm>

namespace bake {

bool Scene::lists(std::string_view effect) const { return std::find(effects.begin(), effects.end(), effect) != effects.end(); }

/// The place of the key, or else of the table or list that it belongs to, or else the file.
std::string Scene::at(const std::string& key) const {
  for (std::size_t end = key.size(); end != std::string::npos; end = key.rfind('.', end - 1))
    if (const auto place = places.find(key.substr(0, end)); place != places.end()) return place->second + ": " + key;
  return file.string() + ": " + key;
}

}  // namespace bake
