// SPDX-License-Identifier: MIT
#include "solver/scene/checks.h"

#include <fmt/format.h>

#include <cmath>

#include "solver/effects/leavening.h"
#include "solver/effects/plasticity.h"
#include "solver/effects/water.h"
#include "solver/scene/nearest.h"

namespace bake {
namespace {

/// Complains at the member `key` if it is there, else at the table.
[[noreturn]] void complain_at(const SceneEntry& table, std::string_view key, std::string_view problem) {
  table.find(key).value_or(table).complain(problem);
}

void check_material_name(const SceneEntry& entry, const std::string& name, const Scene& scene) {
  std::vector<std::string> names;
  for (const Material& material : scene.materials) {
    if (material.name == name) return;
    names.push_back(quotable(material.name));
  }
  complain_at(entry, "material", fmt::format("unknown material '{}', {}", quotable(name), suggestion(name, names)));
}

void check_rising(const SceneEntry& table, std::string_view key, const std::vector<double>& numbers) {
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    if (numbers[i] > numbers[i - 1]) continue;
    const SceneEntry member = table.find(key).value_or(table);
    const SceneEntry place = member.node().is_array() ? member.elements().at(i) : member;  // one number may stand for all four
    place.complain(fmt::format("found {} after {}, allowed: rising numbers", numbers[i], numbers[i - 1]));
  }
}

void check_keyframes(const SceneEntry& entry, const std::vector<Keyframe>& motion) {
  std::vector<double> times;
  times.reserve(motion.size());
  for (const Keyframe& key : motion) times.push_back(key.time_s);
  check_rising(entry, "motion", times);
}

template <class T>
void check_span(const SceneEntry& entry, const T& value) {
  if (value.from_s < value.until_s) return;
  const char* key = entry.find("until_s") ? "until_s" : "from_s";
  complain_at(entry, key, fmt::format("found from_s = {} and until_s = {}, allowed: from_s before until_s", value.from_s, value.until_s));
}

/// A shape that is filled with particles must be bounded.
void check_bounded(const SceneEntry& entry, const Shape& shape) {
  const Box3 box = shape.bounds();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (std::isfinite(box.low[axis]) && std::isfinite(box.high[axis])) continue;
    complain_at(entry, "shape", "found a shape without end, allowed: a bounded one (cut it with an intersection)");
  }
}

/// The mixture must be heavier than its water, so that mass is left for the solid.
void check_water(const SceneEntry& entry, const Material& material) {
  const double water = material.initial_saturation * of<Water>(material).water_density_kg_per_m3;
  if (water < material.density_kg_per_m3) return;
  complain_at(entry, "initial_saturation",
              fmt::format("found {} kg/m^3 of water in a mixture of {} kg/m^3, allowed: less water than mixture", water,
                          material.density_kg_per_m3));
}

}  // namespace

void check(const SceneEntry& entry, const DomainSettings& value, const Scene&) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (value.max_m[axis] > value.min_m[axis]) continue;
    complain_at(entry, "max_m",
                fmt::format("found {} = {}, allowed: a number above {} (min_m)", "xyz"[axis], value.max_m[axis], value.min_m[axis]));
  }
}

void check(const SceneEntry& entry, const TimeSettings& value, const Scene&) {
  if (value.smallest_step_s <= value.largest_step_s) return;
  complain_at(entry, "smallest_step_s",
              fmt::format("found {}, allowed: at most largest_step_s = {}", value.smallest_step_s, value.largest_step_s));
}

void check(const SceneEntry& entry, const Leavening::Settings& value, const Scene&) {
  if (value.pores == Leavening::Pores::open && value.form == Form::published)
    complain_at(entry, "pores", "found \"open\", allowed: \"closed\" with form = \"published\", which knows no atmosphere");
}

void check(const SceneEntry& entry, const Material& value, const Scene& scene) {
  if (value.name.empty()) complain_at(entry, "name", "found \"\", allowed: a name");
  for (const Material& other : scene.materials) {
    if (other.name == value.name)
      complain_at(entry, "name", fmt::format("found '{}' again, allowed: a name of its own", quotable(value.name)));
  }
  const auto& temperatures = of<Plasticity>(value).temperatures_C;
  check_rising(entry, "temperatures_C", {temperatures.begin(), temperatures.end()});
  if (scene.lists(Water::name)) check_water(entry, value);
}

void check(const SceneEntry& entry, const Body& value, const Scene& scene) {
  check_material_name(entry, value.material, scene);
  const bool from_file = !value.particles_file.empty();
  if (value.shape && from_file) entry.complain("found both shape and particles_file, allowed: one of them");
  if (!value.shape && !from_file) entry.complain("found neither shape nor particles_file, allowed: one of them");
  if (value.shape) check_bounded(entry, *value.shape);
}

void check(const SceneEntry& entry, const Collider& value, const Scene&) {
  check_keyframes(entry, value.motion);
  check_span(entry, value);
}

void check(const SceneEntry& entry, const Grip& value, const Scene&) {
  check_keyframes(entry, value.motion);
  check_span(entry, value);
}

void check(const SceneEntry& entry, const Emitter& value, const Scene& scene) {
  check_material_name(entry, value.material, scene);
  check_span(entry, value);
  check_bounded(entry, *value.shape);
  if (value.velocity_m_per_s == Vector3{0, 0, 0})
    complain_at(entry, "velocity_m_per_s", "found [0, 0, 0], allowed: a velocity that is not zero");
}

}  // namespace bake
