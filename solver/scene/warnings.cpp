// SPDX-License-Identifier: MIT
#include "solver/scene/warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/core/vector3.h"
#include "solver/effects/all_effects.h"
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

bool is_ever_above_zero(const Curve& curve) {
  return std::any_of(curve.points.begin(), curve.points.end(), [](const Curve::Point& p) { return p.value > 0; });
}

template <class Things, class Predicate>
bool any_of(const Things& things, Predicate predicate) {
  return std::any_of(things.begin(), things.end(), predicate);
}

// Each function returns why a listed effect can change nothing, or "" if it can.

std::string idle_motion(const Scene& scene, const std::vector<const Material*>& materials) {
  const auto moves = [](const auto& thing) { return thing.motion.size() > 1; };
  const bool pushed =
      length(scene.of<Motion>().gravity_m_per_s2) > 0 || !scene.emitters.empty() || any_of(scene.colliders, moves) ||
      any_of(scene.grips, moves) ||
      any_of(scene.bodies, [](const Body& b) { return length(b.velocity_m_per_s) > 0 || length(b.angular_velocity_rad_per_s) > 0; });
  const bool swells =
      scene.lists(Leavening::name) || any_of(materials, [&](const Material* m) {
        return (scene.lists(Heat::name) && of<Heat>(*m).expansion_per_K > 0) || (scene.lists(Water::name) && of<Water>(*m).pressure_Pa > 0);
      });
  return pushed || swells ? "" : "there is no gravity, nothing else moves and nothing swells";
}

std::string idle_heat(const Scene& scene, const std::vector<const Material*>& materials) {
  if (scene.lists(Leavening::name)) return "";  // leavening needs plasticity
  const bool exchanged =
      is_ever_above_zero(scene.oven.heat_transfer_coefficient_W_per_m2K) ||
      any_of(scene.colliders, [](const Collider& c) { return c.temperature_C && c.heat_transfer_coefficient_W_per_m2K > 0; }) ||
      any_of(scene.grips, [](const Grip& g) { return g.temperature_C.has_value(); });
  const bool cooled = scene.lists(Water::name) && scene.of<Water>().latent_heat_J_per_kg > 0 &&
                      any_of(materials, [](const Material* m) { return of<Water>(*m).evaporation_kg_per_m2sK > 0; });
  const bool uneven =
      any_of(scene.bodies, [](const Body& b) { return b.temperature_C.has_value(); }) ||
      any_of(scene.emitters, [](const Emitter& e) { return e.temperature_C.has_value(); }) ||
      any_of(materials, [&](const Material* m) { return m->initial_temperature_C != materials.front()->initial_temperature_C; });
  return exchanged || cooled || uneven ? "" : "no heat_transfer_coefficient_W_per_m2K is above zero and everything starts equally warm";
}

std::string idle_water(const Scene&, const std::vector<const Material*>& materials) {
  const bool acts = any_of(materials, [](const Material* m) {
    const auto& water = of<Water>(*m);
    return water.diffusivity_m2_per_sK > 0 || water.evaporation_kg_per_m2sK > 0 || water.pressure_Pa > 0;
  });
  return acts ? "" : "diffusivity_m2_per_sK, evaporation_kg_per_m2sK and pressure_Pa are zero: water only counts as mass and heat capacity";
}

std::string idle_leavening(const Scene& scene, const std::vector<const Material*>& materials) {
  const bool makes = any_of(materials, [](const Material* m) { return of<Leavening>(*m).production_mol_per_kgs > 0; });
  const bool has_any = !scene.emitters.empty() || any_of(scene.bodies, [](const Body& b) { return b.leavener > 0; });
  if (!makes) return "production_mol_per_kgs is zero: no gas is made, only the air of the pores pushes";
  return has_any ? "" : "leavener is zero in every body: no gas is made, only the air of the pores pushes";
}

// Each function returns a coefficient of an unlisted effect that a material has, or "" if it has none.

const char* coefficient_of_heat(const Material& m) {
  const auto& heat = of<Heat>(m);
  if (heat.specific_heat_J_per_kgK > 0) return "specific_heat_J_per_kgK";
  return heat.conductivity_W_per_mK > 0 ? "conductivity_W_per_mK" : heat.expansion_per_K > 0 ? "expansion_per_K" : "";
}

const char* coefficient_of_water(const Material& m) {
  const auto& water = of<Water>(m);
  if (water.diffusivity_m2_per_sK > 0) return "diffusivity_m2_per_sK";
  return water.evaporation_kg_per_m2sK > 0 ? "evaporation_kg_per_m2sK" : water.pressure_Pa > 0 ? "pressure_Pa" : "";
}

const char* coefficient_of_elasticity(const Material& m) { return of<Elasticity>(m).young_modulus_Pa > 0 ? "young_modulus_Pa" : ""; }

const char* coefficient_of_plasticity(const Material& m) {
  const auto is_set = [](const std::array<double, 4>& curve) { return any_of(curve, [](double value) { return value > 0; }); };
  const auto& plastic = of<Plasticity>(m);
  return is_set(plastic.yield_stress_Pa) ? "yield_stress_Pa" : is_set(plastic.viscosity_Pa_s) ? "viscosity_Pa_s" : "";
}

const char* coefficient_of_leavening(const Material& m) {
  return of<Leavening>(m).production_mol_per_kgs > 0 ? "production_mol_per_kgs" : "";
}

/// The functions that find the warnings about one effect. To add an effect, add a line; a missing function finds nothing.
struct Suspect {
  const char* effect;
  std::string (*idle)(const Scene&, const std::vector<const Material*>&) = nullptr;
  const char* (*coefficient)(const Material&) = nullptr;
};
constexpr Suspect k_suspects[] = {
    {Motion::name, idle_motion, nullptr},
    {Heat::name, idle_heat, coefficient_of_heat},
    {Water::name, idle_water, coefficient_of_water},
    {Elasticity::name, nullptr, coefficient_of_elasticity},
    {Plasticity::name, nullptr, coefficient_of_plasticity},
    {Leavening::name, idle_leavening, coefficient_of_leavening},
};

}  // namespace

std::vector<std::string> warnings_about(const Scene& scene) {
  const std::vector<const Material*> materials = used_materials(scene);
  std::vector<std::string> warnings;
  if (materials.empty()) return warnings;
  for (const Suspect& suspect : k_suspects) {
    if (scene.lists(suspect.effect)) {
      const std::string why = suspect.idle ? suspect.idle(scene, materials) : "";
      if (!why.empty()) warnings.push_back(fmt::format("effects lists {}, which cannot matter: {}", suspect.effect, why));
      continue;
    }
    for (const Material* material : materials) {
      const std::string key = suspect.coefficient ? suspect.coefficient(*material) : "";
      if (key.empty()) continue;
      warnings.push_back(fmt::format("material.{}.{} is given, but effects does not list {}", material->name, key, suspect.effect));
      break;
    }
  }
  return warnings;
}

}  // namespace bake
