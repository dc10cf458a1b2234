// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>

#include "solver/boundary/shapes.h"
#include "solver/scene/json_value.h"
#include "solver/scene/layout.h"
#include "solver/scene/nearest.h"
#include "solver/scene/read_value.h"

namespace bake {
namespace {

constexpr int k_deepest_shape = 32;  // shapes within shapes

/// Keeps a shape alive together with its description in the scene. It is the deleter of the scene's pointer to the shape, so that shapes
/// stay pure geometry and a distance costs no further indirection.
struct Drawing {
  ShapePtr shape;
  nlohmann::json drawn;
  void operator()(const Shape*) const {}
};

struct Drawn {
  ShapePtr shape;
  nlohmann::json drawn;
};

Drawn draw(const SceneEntry& entry, int depth);

std::vector<std::string> combination_names() { return {k_union, k_intersection, k_difference}; }

std::vector<std::string> solid_names() {
  std::vector<std::string> names;
  [&]<class... S>(std::tuple<S...>*) { (names.emplace_back(S::name), ...); }(static_cast<AllShapes*>(nullptr));
  const std::vector<std::string> combinations = combination_names();
  names.insert(names.end(), combinations.begin(), combinations.end());
  return names;
}

template <class S>
ShapePtr draw_solid(const SceneEntry& entry, nlohmann::json& drawn) {
  auto solid = std::make_shared<S>(read_table<S>(entry));
  const std::string problem = solid->check();
  if (!problem.empty()) entry.complain(problem);
  drawn = json_members(*solid);
  return solid;
}

ShapePtr draw_combination(const SceneEntry& entry, const std::string& name, int depth, nlohmann::json& drawn) {
  const std::size_t fewest = name == k_difference ? 2 : 1;
  const auto* list = entry.node().as_array();
  if (!list || list->size() < fewest) entry.refuse(fmt::format("a list of at least {} shape{}", fewest, fewest == 1 ? "" : "s"));
  std::vector<ShapePtr> parts;
  for (const SceneEntry& element : entry.elements()) {
    Drawn part = draw(element, depth + 1);
    parts.push_back(std::move(part.shape));
    drawn.push_back(std::move(part.drawn));
  }
  if (name == k_union) return make_union(std::move(parts));
  if (name == k_intersection) return make_intersection(std::move(parts));
  return make_difference(parts.front(), {parts.begin() + 1, parts.end()});
}

ShapePtr draw_named(const SceneEntry& entry, const std::string& name, int depth, nlohmann::json& drawn) {
  ShapePtr shape;
  const auto try_solid = [&]<class S>() {
    if (name == S::name) shape = draw_solid<S>(entry, drawn);
  };
  [&]<class... S>(std::tuple<S...>*) { (try_solid.template operator()<S>(), ...); }(static_cast<AllShapes*>(nullptr));
  return shape ? shape : draw_combination(entry, name, depth, drawn);
}

/// The one key of a shape's table that names the kind of shape.
std::string name_of_solid(const SceneEntry& entry) {
  const std::vector<std::string> solids = solid_names();
  std::vector<std::string> known = solids;
  for (const std::string& key : keys_of<Placement>()) known.push_back(key);
  entry.refuse_unknown(known);
  std::vector<std::string> found;
  for (const std::string& name : solids) {
    if (entry.find(name)) found.push_back(name);
  }
  if (found.size() == 1) return found.front();
  entry.complain(fmt::format("found {}, allowed: exactly one of {}",
                             found.empty() ? "no shape" : fmt::format("{}", fmt::join(found, " and ")), fmt::join(solids, ", ")));
}

Drawn draw(const SceneEntry& entry, int depth) {
  if (!entry.node().is_table()) entry.refuse(allowed<ShapePtr>({}));
  if (depth > k_deepest_shape) entry.complain(fmt::format("shapes within shapes too deep, allowed: {} levels", k_deepest_shape));
  const std::string name = name_of_solid(entry);
  Drawn result;
  result.shape = draw_named(*entry.find(name), name, depth, result.drawn[name]);
  Placement placement;
  read_members(entry, placement, Demand::nothing);
  const bool stays = placement.scale == 1 && placement.move_m == Vector3{} && placement.rotate_deg == Vector3{};
  if (!stays) result.shape = make_transformed(result.shape, placement.scale, placement.rotate_deg, placement.move_m);
  result.drawn.update(json_members(placement));
  return result;
}

}  // namespace

ShapePtr read_shape(const SceneEntry& entry) {
  Drawn result = draw(entry, 1);
  const Shape* shape = result.shape.get();
  return ShapePtr(shape, Drawing{std::move(result.shape), std::move(result.drawn)});
}

nlohmann::json json_shape(const ShapePtr& shape) {
  const Drawing* drawing = std::get_deleter<Drawing>(shape);
  return drawing ? drawing->drawn : nlohmann::json();
}

}  // namespace bake
