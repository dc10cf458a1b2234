// SPDX-License-Identifier: MIT
// The textbook baker: one step of the method of [Ding19] as plain loops over a dense grid. Slow, in double precision, on one
// thread, and independent of the solver: it shares no line of code with it.
#pragma once

#include <vector>

#include "reference/textbook/grid.h"
#include "reference/textbook/particle.h"
#include "reference/textbook/recipe.h"
#include "reference/textbook/skin.h"

namespace bake::textbook {

/// How a particle starts.
struct Beginning {
  std::int64_t id = 0;
  int material = 0;
  Vector x, v;
  double volume = 0;
  Vector angular_velocity;  ///< of the body around it, about which C turns [rad/s]
  double theta = 0;         ///< [C]
  double saturation = 0;
  double leavener = 1;
};

class Baker {
 public:
  explicit Baker(const Recipe& recipe) : recipe_(recipe), grid_(recipe_) {}
  Baker(const Baker&) = delete;
  Baker& operator=(const Baker&) = delete;

  void add(const Beginning&);
  /// A skin of the sheet that is at rest where its points are, with what each covers, its velocity and its angular velocity.
  void cover(const Sheet&, const std::vector<Vector>& points, const std::vector<std::array<int, 3>>& triangles,
             const std::vector<double>& covers, const std::vector<Vector>& velocities, const std::vector<Vector>& angular_velocities);
  /// One step: scatter (P2G), grid update, gather (G2P). A run begins with a step of no duration, which finds the first fluxes.
  void step(double dt, const Surroundings&);

  /// Rounds the state of all particles to single precision. If this is done before every step, it shows how a scene amplifies round-off.
  void round_to_single();

  const std::vector<Particle>& particles() const { return particles_; }
  const std::vector<Skin>& skins() const { return skins_; }
  /// Memory that a recipe needs for its nodes [bytes].
  static double bytes(const Recipe& recipe) { return static_cast<double>(Grid::count(recipe)) * (sizeof(Node) + 10 * sizeof(double)); }

 private:
  void scatter(double dt, const Vector& gravity);
  void update_nodes(double dt, const Surroundings&);
  void gather(double dt, const Surroundings&);
  void update_stress(Particle&) const;
  const Material& material(const Particle& p) const { return recipe_.materials[static_cast<std::size_t>(p.material)]; }

  const Recipe recipe_;
  Grid grid_;
  std::vector<Particle> particles_;
  std::vector<Skin> skins_;
};

}  // namespace bake::textbook
