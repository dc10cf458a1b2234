// SPDX-License-Identifier: MIT
#include "solver/scene/warnings.h"

#include <fmt/format.h>

#include <algorithm>

#include "solver/core/vector3.h"
#include "solver/effects/all_effects.h"
#include "solver/effects/needs_of_scene.h"
#include "solver/scene/scene.h"

namespace bake {
namespace {

std::vector<const Material*> used_materials(const Scene& scene) {
  std::vector<const Material*> used;
  for (const Material& material : scene.materials) {
    const auto is_of_it = [&](const auto& thing) { return thing.material == material.name; };
    if (std::any_of(scene.bodies.begin(), scene.bodies.end(), [&](const Body& b) { return is_of_it(b) || !b.particles_file.empty(); }) ||
        std::any_of(scene.emitters.begin(), scene.emitters.end(), is_of_it))
      used.push_back(&material);
  }
  return used;
}

/// What the effects' own `idle` may ask of a scene.
struct Here {
  const Scene& scene;
  const std::vector<const Material*>& materials;  ///< those that are used
  bool swells = false;                            ///< does any effect that is listed change a material's volume?

  template <class Things, class Predicate>
  static bool any(const Things& things, Predicate predicate) {
    return std::any_of(things.begin(), things.end(), predicate);
  }
  static bool is_ever_above_zero(const Curve& curve) {
    return any(curve.points, [](const Curve::Point& p) { return p.value > 0; });
  }
  template <class E>
  bool cools() const {
    return scene.lists(E::name) && any(materials, [&](const Material* m) { return E::cools(scene, of<E>(*m)); });
  }
};

template <class E>
bool swells(const std::vector<const Material*>& materials) {
  if constexpr (has_hook::swells<E>) return Here::any(materials, [](const Material* m) { return E::swells(of<E>(*m)); });
  return false;
}

/// The warning about one effect, "" if there is none.
template <class E>
std::string warning_about(const Here& here) {
  if (here.scene.lists(E::name)) {
    std::string why;
    if constexpr (has_hook::idle<E>) why = E::idle(here);
    return why.empty() ? why : fmt::format("effects lists {}, which cannot matter: {}", E::name, why);
  }
  if constexpr (has_hook::coefficient<E>)
    for (const Material* material : here.materials)
      if (const std::string key = E::coefficient(of<E>(*material)); !key.empty())
        return fmt::format("material.{}.{} is given, but effects does not list {}", material->name, key, E::name);
  return {};
}

}  // namespace

std::vector<std::string> warnings_about(const Scene& scene) {
  const std::vector<const Material*> materials = used_materials(scene);
  std::vector<std::string> warnings;
  if (materials.empty()) return warnings;
  Here here{scene, materials};
  for_each_effect([&]<class E>() { here.swells |= scene.lists(E::name) && swells<E>(materials); });
  for_each_effect([&]<class E>() {
    if (const std::string warning = warning_about<E>(here); !warning.empty()) warnings.push_back(warning);
  });
  const auto ignored = [&](const char* table, const auto& all) {
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].temperature_C && !tells_temperatures_apart(scene))
        warnings.push_back(
            fmt::format("{}.{}.temperature_C is given, but effects does not list heat: it has that of its material", table, i));
  };
  if (scene.surface.form == Form::published && scene.surface.keep_dx > 0)
    warnings.push_back("surface.keep_dx is given, but surface.form is published: that surface is measured in every step");
  ignored("body", scene.bodies);
  ignored("emitter", scene.emitters);
  return warnings;
}

}  // namespace bake
