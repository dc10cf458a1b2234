// SPDX-License-Identifier: MIT
#include "solver/scene/checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "solver/boundary/scripted.h"
#include "solver/effects/all_effects.h"
#include "solver/effects/needs_of_scene.h"
#include "solver/effects/skin_of_scene.h"
#include "solver/scene/describe.h"
#include "solver/scene/nearest.h"

namespace bake {
namespace {

void check_material_name(const SceneEntry& entry, const std::string& name, const Scene& scene) {
  std::vector<std::string> names;
  for (const Material& material : scene.materials) {
    if (material.name == name) return;
    names.push_back(quotable(material.name));
  }
  Complaint(entry).at("material", "unknown material '{}', {}", quotable(name), suggestion(name, names));
}

void check_keyframes(const SceneEntry& entry, const std::vector<Keyframe>& motion) {
  std::vector<double> times;
  times.reserve(motion.size());
  for (const Keyframe& key : motion) times.push_back(key.time_s);
  Complaint(entry).unless_rising("motion", times);
}

template <class T>
void check_span(const SceneEntry& entry, const T& value) {
  if (value.from_s < value.until_s) return;
  const char* key = entry.find("until_s") ? "until_s" : "from_s";
  Complaint(entry).at(key, "found from_s = {} and until_s = {}, allowed: from_s before until_s", value.from_s, value.until_s);
}

/// What is water cannot be gas.
template <class T>
void check_saturation(const SceneEntry& entry, const T& value, const Scene& scene) {
  for (const Material& material : scene.materials)
    if (material.name == value.material && value.saturation.value_or(0) + material.initial_porosity > 1)
      Complaint(entry).at("saturation",
                          "found {} of the volume water and {} gas (the material's initial_porosity), allowed: together at most 1",
                          *value.saturation, material.initial_porosity);
}

/// The columns of the ledger are called by the name of what has `ledger = true`: it needs one of its own.
template <class T>
void check_ledger(const SceneEntry& entry, const T& value, const std::vector<T>& before) {
  if (!value.ledger) return;
  const auto fits = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; };
  if (value.name.empty() || !std::all_of(value.name.begin(), value.name.end(), fits))
    Complaint(entry).at("ledger",
                        "found true and the name \"{}\", allowed: with a name of letters, digits and _, by which its columns are called",
                        quotable(value.name));
  for (const T& other : before)
    if (other.ledger && other.name == value.name)
      Complaint(entry).at("ledger", "found true and the name '{}' again, allowed: with a name of its own", value.name);
}

/// A shape that is filled with particles must be bounded.
void check_bounded(const SceneEntry& entry, const Shape& shape) {
  const Box3 box = shape.bounds();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (std::isfinite(box.high[axis] - box.low[axis])) continue;
    Complaint(entry).at("shape", "found a shape without end, allowed: a bounded one (cut it with an intersection)");
  }
}

}  // namespace

void Complaint::unless_rising(std::string_view key, const std::vector<double>& numbers) const {
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    if (numbers[i] > numbers[i - 1]) continue;
    const SceneEntry member = table_.find(key).value_or(table_);
    const SceneEntry place = member.node().is_array() ? member.elements().at(i) : member;  // one number may stand for all
    place.complain(fmt::format("found {} after {}, allowed: rising numbers", numbers[i], numbers[i - 1]));
  }
}

namespace {

/// A period is a whole number of blocks of nodes, so that nodes beyond a face are those at the opposite one.
void check_periodic(const SceneEntry& entry, const DomainSettings& value, const Scene& scene, std::size_t axis) {
  const auto low = static_cast<DomainSide>(2 * axis), high = static_cast<DomainSide>(2 * axis + 1);
  for (const auto& [face, opposite] : {std::pair(low, high), std::pair(high, low)})
    if (value.face(face) == Face::periodic && value.face(opposite) != Face::periodic)
      Complaint(entry).at(word_of(face), "found 'periodic' opposite {} = '{}', allowed: both periodic or none", word_of(opposite),
                          word_of(value.face(opposite)));
  if (value.face(low) != Face::periodic) return;
  const double cells = (value.max_m[axis] - value.min_m[axis]) / scene.dx(), blocks = std::round(cells / 4);
  if (!(blocks >= 1 && std::abs(cells - 4 * blocks) < 1e-6))
    Complaint(entry).at("max_m",
                        "found {:.6g} cells of {:g} m along {} at {} quality, allowed between periodic faces: a multiple of 4 cells (with "
                        "multiples of 16 at paper quality all qualities have one)",
                        cells, scene.dx(), "xyz"[axis], word_of(scene.quality));
}

/// A collider or grip has no image beyond a periodic face. So it goes through both faces or stays away from both, where it stands at its
/// keyframes.
template <class T>
void check_beside_periodic(const SceneEntry& entry, const T& value, const Scene& scene) {
  const double reach = 3 * scene.dx(), rounding = 1e-6 * scene.dx();
  const ScriptedShape scripted{value.shape, RigidPath(value.motion, value.pivot_m), value.from_s, value.until_s};
  std::vector<double> times{0};
  for (const Keyframe& key : value.motion) times.push_back(key.time_s);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!scene.domain.is_periodic(static_cast<int>(axis))) continue;
    const double low_face = scene.domain.min_m[axis], high_face = scene.domain.max_m[axis];
    for (const double time : times) {
      const Box3 box = scripted.bounds(scripted.path.at(time));
      const double low = box.low[axis], high = box.high[axis];
      const bool through = low <= low_face + rounding && high >= high_face - rounding,
                 between = low >= low_face + reach && high <= high_face - reach,
                 outside = high <= low_face - reach || low >= high_face + reach;
      if (!through && !between && !outside)
        Complaint(entry).at(
            "shape",
            "found from {:.4g} to {:.4g} m along {} at {:g} s, allowed beside periodic faces, beyond which it has no image: "
            "through both ({:.4g} and {:.4g} m) or 3 cells away from both",
            low, high, "xyz"[axis], time, low_face, high_face);
    }
  }
}

}  // namespace

void check(const SceneEntry& entry, const DomainSettings& value, const Scene& scene) {
  constexpr double k_most_cells = 1e9, k_fewest_cells = 1e-6;  // nodes are counted by int; a cell is not a million domains
  constexpr double k_told_apart = 1e-4;                        // positions are, to this share of a cell
  const double furthest = k_told_apart * scene.dx() / std::numeric_limits<double>::epsilon();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const char name = "xyz"[axis];
    if (!(value.max_m[axis] > value.min_m[axis]))
      Complaint(entry).at("max_m", "found {} = {}, allowed: a number above {} (min_m)", name, value.max_m[axis], value.min_m[axis]);
    const double cells = (value.max_m[axis] - value.min_m[axis]) / scene.grid.dx_m;
    if (cells > k_most_cells || cells < k_fewest_cells)
      Complaint(entry).at("max_m", "found {:.3g} cells along {}, allowed: {:g} to {:g}", cells, name, k_fewest_cells, k_most_cells);
    if (std::max(std::abs(value.min_m[axis]), std::abs(value.max_m[axis])) > furthest)
      Complaint(entry).at("max_m",
                          "found {} from {:g} to {:g} m in cells of {:g} m, allowed: up to {:.3g} m from the origin, so that positions "
                          "in a cell are told apart; move the scene",
                          name, value.min_m[axis], value.max_m[axis], scene.dx(), furthest);
    check_periodic(entry, value, scene, axis);
  }
}

void check(const SceneEntry& entry, const TimeSettings& value, const Scene&) {
  if (value.smallest_step_s <= value.largest_step_s) return;
  Complaint(entry).at("smallest_step_s", "found {}, allowed: at most largest_step_s = {}", value.smallest_step_s, value.largest_step_s);
}

void check(const SceneEntry& entry, const Material& value, const Scene& scene) {
  if (value.name.empty()) Complaint(entry).at("name", "found \"\", allowed: a name");
  for (const Material& other : scene.materials) {
    if (other.name == value.name) Complaint(entry).at("name", "found '{}' again, allowed: a name of its own", quotable(value.name));
  }
  for_each_effect([&]<class E>() { BAKE_CALL(E, check_material, scene, value, of<E>(value), Complaint(entry)); });
}

void check(const SceneEntry& entry, const Body& value, const Scene& scene) {
  check_material_name(entry, value.material, scene);
  const bool from_file = !value.particles_file.empty();
  if (value.shape && from_file) entry.complain("found both shape and particles_file, allowed: one of them");
  if (!value.shape && !from_file) entry.complain("found neither shape nor particles_file, allowed: one of them");
  if (value.shape) check_bounded(entry, *value.shape);
  check_saturation(entry, value, scene);
}

void check(const SceneEntry& entry, const Collider& value, const Scene& scene) {
  check_keyframes(entry, value.motion);
  check_span(entry, value);
  check_ledger(entry, value, scene.colliders);
  if (value.temperature_C && !value.covers)
    Complaint(entry).at("covers", "found false with temperature_C, allowed: true, since heat passes where it covers");
  check_beside_periodic(entry, value, scene);
}

void check(const SceneEntry& entry, const Grip& value, const Scene& scene) {
  check_keyframes(entry, value.motion);
  check_span(entry, value);
  check_ledger(entry, value, scene.grips);
  check_beside_periodic(entry, value, scene);
}

void check(const SceneEntry& entry, const DomainFace& value, const Scene& scene) {
  const char* name = word_of(value.at);
  for (const DomainFace& other : scene.faces)
    if (other.at == value.at) Complaint(entry).at("at", "found '{}' again, allowed: each face once", name);
  if (const Face rule = scene.domain.face(value.at); rule == Face::open || rule == Face::periodic)
    Complaint(entry).at("at", "found '{}', which is {}: nothing is there that could give anything, allowed: a closed face", name,
                        word_of(rule));
  if (value.temperature_C && value.heat_flux_W_per_m2)
    Complaint(entry).at("heat_flux_W_per_m2", "found beside temperature_C, allowed: one of them");
  if (value.heat_transfer_coefficient_W_per_m2K && !value.temperature_C)
    Complaint(entry).at("heat_transfer_coefficient_W_per_m2K", "found without temperature_C, allowed: with it");
  for_each_effect([&]<class E>() { BAKE_CALL(E, check_face, scene, value, Complaint(entry)); });
}

void check(const SceneEntry& entry, const Emitter& value, const Scene& scene) {
  check_material_name(entry, value.material, scene);
  check_span(entry, value);
  check_bounded(entry, *value.shape);
  check_saturation(entry, value, scene);
  if (value.from_s < 0) Complaint(entry).at("from_s", "found {}, allowed: 0 or later", value.from_s);
  if (value.velocity_m_per_s == Vector3{0, 0, 0})
    Complaint(entry).at("velocity_m_per_s", "found [0, 0, 0], allowed: a velocity that is not zero");
  if (const std::string needs = what_emitter_needs(scene); !needs.empty()) entry.complain(needs);
}

void check(const SceneEntry& entry, const Skin& value, const Scene& scene) {
  const Complaint complaint(entry);
  if (const std::string needs = what_skin_needs(scene); !needs.empty()) entry.complain(needs);
  if (scene.domain.is_periodic())
    entry.complain("found a skin in a domain with periodic faces, allowed: no skin, or faces that are not periodic");
  if (value.body.empty()) complaint.at("body", "found none, allowed: numbers of bodies");
  if (value.body.size() > 1 && !value.mesh_file.empty())
    complaint.at("mesh_file", "found one mesh for {} bodies, allowed: a [[skin]] for each of them", value.body.size());
  for (std::size_t i = 0; i < value.body.size(); ++i) {
    const double number = value.body[i];
    if (number != std::floor(number) || !(number < static_cast<double>(scene.bodies.size())))
      complaint.at("body", "found {}, allowed: {}", number,
                   scene.bodies.empty() ? "none, since the scene has no [[body]]"
                                        : fmt::format("whole numbers from 0 to {}", scene.bodies.size() - 1));
    if (std::find(value.body.begin(), value.body.begin() + static_cast<std::ptrdiff_t>(i), number) !=
        value.body.begin() + static_cast<std::ptrdiff_t>(i))
      complaint.at("body", "found {} again, allowed: each body once", number);
    if (value.mesh_file.empty() && !scene.bodies[static_cast<std::size_t>(number)].shape)
      complaint.at("body", "found body.{}, whose particles come from a file, allowed: with it a mesh_file", number);
  }
}

}  // namespace bake
