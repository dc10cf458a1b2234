// SPDX-License-Identifier: MIT
// The tables of a scene file. The reader, the resolved scene and the documentation go through these lists.
#pragma once

#include <array>
#include <string>
#include <tuple>
#include <vector>

#include "solver/scene/scene.h"

namespace bake {

/// A table of the scene file and the member of Scene that it fills.
template <class Value>
struct Section {
  const char* name;
  Value Scene::*member;
  const char* meaning;
};

template <class Value>
Section(const char*, Value Scene::*, const char*) -> Section<Value>;  // Clang 14 does not deduce aggregates

/// [run], [grid], ...: tables that a scene has once.
inline constexpr std::tuple k_tables{
    Section{"run", &Scene::run, "how long, how often and how exactly"},
    Section{"grid", &Scene::grid, "the grid of nodes"},
    Section{"domain", &Scene::domain, "the box that is simulated; its far corner is rounded outwards to a whole number of cells"},
    Section{"time", &Scene::time, "choice of the time step: the smallest limit of the effects that are on, times `safety`"},
    Section{"surface", &Scene::surface, "how the area that touches air is measured"},
    Section{"oven", &Scene::oven, "the surroundings of every free surface"},
};

/// [[material]], [[body]], ...: lists of tables. Materials come first because the others refer to them.
inline constexpr std::tuple k_lists{
    Section{"material", &Scene::materials, "what bodies are made of; the keys of effects stand directly in it"},
    Section{"body", &Scene::bodies, "dough at the start: a shape filled with particles, or particles from a file"},
    Section{"collider", &Scene::colliders, "a rigid thing that dough cannot enter"},
    Section{"grip", &Scene::grips, "a region in which everything follows a prescribed motion"},
    Section{"face", &Scene::faces,
            "heat that a face of the domain passes, and whether the ledger tells of it; its rule for motion stands in [domain]"},
    Section{"emitter", &Scene::emitters,
            "pours material: the shape is filled again each time the last filling has moved away by its own length"},
    Section{"skin", &Scene::skins, "an elastic sheet of triangles on bodies, as fruit has it; needs motion"},
};

/// Where a shape is put: scaled and turned about its own origin, then moved. Stands beside the shape's own table.
struct Placement {
  Vector3 move_m = {0, 0, 0};
  Vector3 rotate_deg = {0, 0, 0};
  double scale = 1;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"move_m", &Placement::move_m, "m", any_number, "moves the shape, after scaling and turning"},
        Parameter{"rotate_deg", &Placement::rotate_deg, "deg", any_number,
                  "turns it about its own origin: rotation vector, axis times angle; after scaling"},
        Parameter{"scale", &Placement::scale, "1", positive, "makes it larger in all directions alike"},
    };
  }
};

inline constexpr const char* k_union = "union";
inline constexpr const char* k_intersection = "intersection";
inline constexpr const char* k_difference = "difference";

/// Names of all tables and lists except those of effects.
inline std::vector<std::string> table_names() {
  std::vector<std::string> names;
  const auto add = [&](const auto&... section) { (names.emplace_back(section.name), ...); };
  std::apply(add, k_tables);
  std::apply(add, k_lists);
  return names;
}

}  // namespace bake
