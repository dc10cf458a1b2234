// SPDX-License-Identifier: MIT
#include "solver/scene/reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "solver/effects/all_effects.h"
#include "solver/scene/checks.h"
#include "solver/scene/layout.h"
#include "solver/scene/nearest.h"
#include "solver/scene/overrides.h"
#include "solver/scene/read_value.h"

namespace bake {
namespace {

std::vector<std::string> top_level_keys() {
  std::vector<std::string> keys = {"title", "effects"};
  for (const std::string& table : table_names()) keys.push_back(table);
  for (const std::string& effect : effect_names()) keys.push_back(effect);
  return keys;
}

void check_needs(const SceneEntry& entry, const Scene& scene) {
  for_each_effect([&]<class E>() {
    for (const char* need : E::needs)
      if (scene.lists(E::name) && !scene.lists(need)) entry.complain(fmt::format("'{}' needs '{}'", E::name, need));
  });
}

/// The listed effects in the order of AllEffects.
std::vector<std::string> read_effects(const SceneEntry& entry) {
  if (!entry.node().is_array()) entry.refuse("a list of effects in quotes");
  const std::vector<std::string> known = effect_names();
  std::vector<bool> listed(known.size());
  for (const SceneEntry& element : entry.elements()) {
    const std::size_t effect = read_choice(element, known);
    if (listed[effect]) element.complain(fmt::format("found '{}' again, allowed: each effect once", known[effect]));
    listed[effect] = true;
  }
  std::vector<std::string> effects;
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (listed[i]) effects.push_back(known[i]);
  }
  return effects;
}

Demand demand_of(std::string_view effect, const Scene& scene) { return scene.lists(effect) ? Demand::required_keys : Demand::nothing; }

template <class Value>
void read_section(const SceneEntry& root, const Section<Value>& section, Scene& scene) {
  const SceneEntry entry = root.find(section.name).value_or(root.absent_table(section.name));
  scene.*section.member = read_table<Value>(entry);
  check(entry, scene.*section.member, scene);
}

template <class Effect>
void read_settings(const SceneEntry& root, Scene& scene) {
  using Settings = typename Effect::Settings;
  const SceneEntry entry = root.find(Effect::name).value_or(root.absent_table(Effect::name));
  scene.settings.get<Settings>() = read_table<Settings>(entry, demand_of(Effect::name, scene));
  BAKE_CALL(Effect, check_settings, scene.settings.get<Settings>(), Complaint(entry));
}

template <class T>
T read_list_member(const SceneEntry& entry, const Scene&) {
  return read_table<T>(entry);
}

/// The table of a material holds the keys of every effect beside its own keys.
template <>
Material read_list_member<Material>(const SceneEntry& entry, const Scene& scene) {
  entry.expect_table();
  std::vector<std::string> known = keys_of<Material>();
  FormerNames former = former_names_of<Material>();
  for_each_effect([&]<class Effect>() {
    for (const std::string& key : keys_of<typename Effect::Material>()) known.push_back(key);
    former.merge(former_names_of<typename Effect::Material>());
  });
  entry.refuse_unknown(known, former);
  Material material;
  read_members(entry, material, Demand::required_keys);
  for_each_effect([&]<class Effect>() {
    auto& values = material.effects.template get<typename Effect::Material>();
    read_members(entry, values, demand_of(Effect::name, scene));
  });
  return material;
}

/// Members of lists are called by their name if they have one: material.dough.
SceneEntry named(const SceneEntry& entry) {
  if (!entry.node().is_table()) return entry;
  const auto* name = entry.node().as_table()->get_as<std::string>("name");
  return name && !name->get().empty() ? entry.renamed(name->get()) : entry;
}

template <class T>
void read_section(const SceneEntry& root, const Section<std::vector<T>>& section, Scene& scene) {
  for (const SceneEntry& element : root.tables(section.name)) {
    const SceneEntry entry = named(element);
    T member = read_list_member<T>(entry, scene);
    check(entry, member, scene);
    (scene.*section.member).push_back(std::move(member));
  }
}

void read_root(const SceneEntry& root, Scene& scene) {
  root.refuse_unknown(top_level_keys());
  if (const auto title = root.find("title")) scene.title = read_text(*title);
  if (const auto effects = root.find("effects")) {
    scene.effects = read_effects(*effects);
    check_needs(*effects, scene);
  }
  std::apply([&](const auto&... section) { (read_section(root, section, scene), ...); }, k_tables);
  for_each_effect([&]<class Effect>() { read_settings<Effect>(root, scene); });
  std::apply([&](const auto&... section) { (read_section(root, section, scene), ...); }, k_lists);
}

}  // namespace

Scene parse_scene(std::string_view text, const std::filesystem::path& name, const ReadOptions& options) {
  const Document document{quotable_path(name), name.parent_path()};
  toml::table table = parse_toml(text, document.name);
  for (const std::string& text_of_override : options.overrides) apply_override(table, text_of_override);
  Scene scene;
  scene.file = name;
  scene.quality = options.quality;
  read_root(SceneEntry(document, table), scene);
  scene.notices = document.notices;
  scene.places = document.places;
  return scene;
}

Scene read_scene(const std::filesystem::path& file, const ReadOptions& options) { return parse_scene(read_text_file(file), file, options); }

}  // namespace bake
