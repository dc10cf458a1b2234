// SPDX-License-Identifier: MIT
// Describes every scene key in words, from the declarations.
#pragma once

#include <string>
#include <vector>

namespace bake {

/// One key of a table.
struct CatalogueKey {
  std::string key;
  std::string unit;      ///< empty for words and shapes
  std::string allowed;   ///< which values it takes
  std::string standard;  ///< its default as TOML, or "required" or "none"
  std::string meaning;
  std::string former = {};  ///< what it was called before, or empty
};

/// A table of the scene file, or the part of [[material]] that belongs to one effect.
struct CatalogueSection {
  std::string name;     ///< first part of a full key: "oven", "material", "sphere"; empty for the top of the file
  std::string heading;  ///< how it is written: "[oven]", "[[material]]", "shape = { sphere = { ... } }"
  std::string effect;   ///< the effect that uses it, or empty
  std::string meaning;
  std::vector<CatalogueKey> keys;
};

/// All sections in the order in which they are documented.
std::vector<CatalogueSection> catalogue();

}  // namespace bake
