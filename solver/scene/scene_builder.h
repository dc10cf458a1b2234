// SPDX-License-Identifier: MIT
// A scene in pieces, for studies, benchmarks and tests: what a piece does not say is as in a scene file.
#pragma once

#include <string>
#include <vector>

#include "solver/core/vector3.h"
#include "solver/scene/scene.h"

namespace bake {

inline constexpr const char* k_everything = "motion, heat, water, elasticity, plasticity, leavening";

struct SceneBuilder {
  std::string effects = "heat";  ///< "motion, heat"
  std::string precision = "double";
  double frame_s = 1;  ///< from one frame to the next [s]
  double dx = 0.1;     ///< [m]
  std::string kernel = "quadratic";
  Vector3 low{-1, -1, -1}, high{1, 1, 1};                          ///< of the domain [m]
  std::string gravity = "[0, 0, 0]";                               ///< [m/s^2]; empty: that of the Earth
  std::string run, faces, motion, heat, leavening, surface, time;  ///< further keys of [run], [domain], [motion], ...
  std::string material;                                            ///< keys of the material "dough"
  std::string tables;                                              ///< further tables, other bodies among them
  std::string shape;                                               ///< of a body of dough, the last; none unless given
  std::string body;                                                ///< further keys of it
  double particles_per_cell = 8;                                   ///< of it
  std::vector<std::string> overrides;                              ///< `key=value`, as for parse_scene

  std::string text() const;  ///< without the overrides
  Scene scene() const;
};

}  // namespace bake
