// SPDX-License-Identifier: MIT
// What a skin has to do with the effects of a scene.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "solver/effects/elasticity.h"
#include "solver/effects/motion.h"

namespace bake {

/// What a scene lacks that has a skin, in one clause; "" if nothing.
std::string what_skin_needs(const auto& scene) {
  if (!scene.lists(Motion::name)) return "found a skin without the effect 'motion', allowed: with it";
  if (scene.template of<Motion>().transfer == Motion::Transfer::flip)
    return "found a skin with motion.transfer = \"flip\", allowed: \"apic\" or \"pic\"";
  if (scene.surface.form == Form::published) return "found a skin with surface.form = \"published\", allowed: \"standard\"";
  return {};
}

/// The material of a body that a skin covers.
const auto& flesh_under(const auto& scene, double body) {
  const auto& name = scene.bodies[static_cast<std::size_t>(body)].material;
  return *std::find_if(scene.materials.begin(), scene.materials.end(), [&](const auto& m) { return m.name == name; });
}

/// Mass per area of half a cell of flesh, which moves along with a skin; of the lightest that it covers [kg/m^2].
double flesh_that_moves_along(const auto& scene, const auto& skin) {
  double least = std::numeric_limits<double>::infinity();
  for (const double body : skin.body) least = std::min(least, flesh_under(scene, body).density_kg_per_m3 * scene.dx() / 2);
  return least;
}

/// The skin's inertia over its mass, beside the scene's own inertia_scale: it has at least that of the flesh that moves along with it.
/// Where flesh dries or leaves, the skin would else be so light that it wanted far shorter steps. Its weight stays.
double inertia_of_skin(const auto& scene, const auto& skin) {
  return std::max(1., flesh_that_moves_along(scene, skin) / skin.mass_per_area());
}

/// A scene whose only material is a skin, in which its vertices move.
template <class Scene, class Material>
Scene scene_of_skin(Scene scene, const Material& sheet, double inertia) {
  scene.materials = {sheet};
  scene.settings.template get<Motion::Settings>().inertia_scale *= inertia;
  return scene;
}

/// The length of the folds of a film on soft elastic ground that it may not slide on, 2 pi (2 B / G)^(1/3) with G = 4 mu (1 - nu) / (3 - 4
/// nu) [m]; infinite without elasticity. `bending_stiffness`: B [N m].
double fold_length(const auto& scene, const auto& material, double bending_stiffness) {
  const auto& elastic = material.effects.template get<Elasticity::Material>();
  const double nu = elastic.poisson_ratio, mu = elastic.young_modulus_Pa / (2 * (1 + nu));
  if (!scene.lists(Elasticity::name) || !(mu > 0)) return std::numeric_limits<double>::infinity();
  return 2 * std::numbers::pi * std::cbrt(2 * bending_stiffness * (3 - 4 * nu) / (4 * mu * (1 - nu)));
}

}  // namespace bake
