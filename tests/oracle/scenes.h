// SPDX-License-Identifier: MIT
// Small scenes drawn at random: blobs of dough that spin and meet, an oven, a hot tray, walls.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "solver/scene/scene_builder.h"

namespace bake {

/// What a comparison is made of; everything else of its scene follows from the seed.
struct RandomScene {
  std::string name;          ///< of the test
  std::string effects = {};  ///< "motion, elasticity"
  std::string kernel = "quadratic";
  std::string motion = {};  ///< further keys of [motion]
  std::string heat = {};    ///< of [heat]
  std::string water = {};   ///< of [water]
  std::string plasticity = {};
  std::string leavening = {};
  std::string surface = {};
  std::string material = {};                                   ///< further keys of both materials
  std::string tables = {};                                     ///< further tables
  std::string gravity = {};                                    ///< drawn if empty
  std::string faces = "x_min = \"sticky\"\ny_min = \"slip\"";  ///< keys of [domain]
  std::vector<std::string> overrides = {};                     ///< `key=value`, as for parse_scene
  bool colliders = true;                                       ///< a hot floor and a ball that moves
  Vector3 far_corner{0.6, 0.6, 0.6};                           ///< of the domain
  int seed = 1;
  std::string precision = "double";

  Scene scene() const;
};
inline void PrintTo(const RandomScene& r, std::ostream* out) { *out << r.name; }

}  // namespace bake
