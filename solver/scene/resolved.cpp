// SPDX-License-Identifier: MIT
#include "solver/scene/resolved.h"

#include <fmt/format.h>

#include <cstdint>
#include <utility>

#include "solver/effects/all_effects.h"
#include "solver/scene/catalogue.h"
#include "solver/scene/json_value.h"
#include "solver/scene/layout.h"

namespace bake {
namespace {

/// A file name may hold any bytes, but JSON must be UTF-8.
nlohmann::json json_path(const std::filesystem::path& path) {
  using nlohmann::json;
  return json::parse(json(path.generic_string()).dump(-1, ' ', false, json::error_handler_t::replace));
}

/// The path as the scene file would write it: relative to the scene's folder if possible.
nlohmann::json json_path_in_scene(const std::filesystem::path& path, const Scene& scene) {
  if (path.empty()) return {};
  const std::filesystem::path relative = path.lexically_relative(scene.file.parent_path());
  return json_path(scene.file.parent_path().empty() || relative.empty() ? path : relative);
}

template <class T>
nlohmann::json json_list_member(const T& member, const Scene&) {
  return json_members(member);
}

template <>
nlohmann::json json_list_member<Material>(const Material& material, const Scene&) {
  nlohmann::json object = json_members(material);
  for_each_effect([&]<class Effect>() { object.update(json_members(of<Effect>(material))); });
  return object;
}

template <>
nlohmann::json json_list_member<Body>(const Body& body, const Scene& scene) {
  nlohmann::json object = json_members(body);
  object["particles_file"] = json_path_in_scene(body.particles_file, scene);
  return object;
}

template <>
nlohmann::json json_list_member<Skin>(const Skin& skin, const Scene& scene) {
  nlohmann::json object = json_members(skin);
  object["mesh_file"] = json_path_in_scene(skin.mesh_file, scene);
  return object;
}

template <class Value>
nlohmann::json json_section(const Value& value, const Scene&) {
  return json_members(value);
}

template <class T>
nlohmann::json json_section(const std::vector<T>& list, const Scene& scene) {
  nlohmann::json array = nlohmann::json::array();
  for (const T& member : list) array.push_back(json_list_member(member, scene));
  return array;
}

/// Renames every key that has a former name to it, in an object and in all objects inside it.
void take_former_names(nlohmann::json& values, const FormerNames& former) {
  if (!values.is_structured()) return;
  for (nlohmann::json& value : values) take_former_names(value, former);
  if (!values.is_object()) return;
  for (const auto& [old, name] : former) {
    if (!values.contains(name)) continue;
    values[old] = std::move(values[name]);
    values.erase(name);
  }
}

/// Keys and lists that scenes got after data had been kept by their fingerprints. While they have their defaults they are left out, so that
/// what was measured before stays valid.
void leave_out_later_keys(nlohmann::json& values, const Scene& scene) {
  const auto leave_out = [](nlohmann::json& object, const nlohmann::json& standard) {
    for (const char* key : {"stress_in_frames", "settle_damping_per_s", "settle_still_m_per_s", "settle_longest_s", "ledger", "covers",
                            "vapour_diffusivity_m2_per_s", "vapour_transfer_m_per_s", "hygroscopic_water_kg_per_kg", "keep_dx"})
      if (object.contains(key) && object[key] == standard.at(key)) object.erase(key);
  };
  leave_out(values["run"], json_members(RunSettings{}));
  leave_out(values["surface"], json_members(SurfaceSettings{}));
  for_each_effect([&]<class Effect>() { leave_out(values[Effect::name], json_members(std::decay_t<decltype(scene.of<Effect>())>{})); });
  for (nlohmann::json& collider : values["collider"]) leave_out(collider, json_members(Collider{}));
  for (nlohmann::json& grip : values["grip"]) leave_out(grip, json_members(Grip{}));
  if (values["face"].empty()) values.erase("face");
  nlohmann::json material;
  for_each_effect([&]<class Effect>() { material.update(json_members(typename Effect::Material{})); });
  for (nlohmann::json& own : values["material"]) leave_out(own, material);
}

std::uint64_t fnv1a(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

/// A basic string of TOML. JSON's escapes are valid in TOML, but TOML wants DEL escaped, too.
std::string toml_string(const std::string& text) {
  std::string quoted = nlohmann::json(text).dump();
  for (std::size_t at = quoted.find('\x7f'); at != std::string::npos; at = quoted.find('\x7f', at)) quoted.replace(at, 1, "\\u007f");
  return quoted;
}

std::string toml_list(const nlohmann::json& list) {
  std::string parts;
  for (const auto& element : list) parts += (parts.empty() ? "" : ", ") + toml_text(element);
  return "[" + parts + "]";
}

std::string toml_inline_table(const nlohmann::json& object) {
  std::string parts;
  for (const auto& [key, value] : object.items()) {
    if (!value.is_null()) parts += fmt::format("{}{} = {}", parts.empty() ? "" : ", ", key, toml_text(value));
  }
  return parts.empty() ? "{}" : "{ " + parts + " }";
}

}  // namespace

nlohmann::json resolved(const Scene& scene) {
  nlohmann::json object;
  object["title"] = scene.title;
  object["file"] = json_path(scene.file);
  object["effects"] = scene.effects;
  object["quality"] = json_value(scene.quality);
  const auto add = [&](const auto&... section) { ((object[section.name] = json_section(scene.*section.member, scene)), ...); };
  std::apply(add, k_tables);
  std::apply(add, k_lists);
  for_each_effect([&]<class Effect>() { object[Effect::name] = json_members(scene.of<Effect>()); });
  return object;
}

nlohmann::json under_former_names(nlohmann::json resolved_scene) {
  FormerNames former;
  for (const CatalogueSection& section : catalogue()) {
    for (const CatalogueKey& key : section.keys)
      if (!key.former.empty()) former.emplace(key.former, key.key);
  }
  take_former_names(resolved_scene, former);
  return resolved_scene;
}

std::string scene_fingerprint(const Scene& scene) {
  nlohmann::json values = resolved(scene);
  values.erase("file");
  values["run"].erase("end_s");
  values["run"].erase("checkpoint_every_frames");
  leave_out_later_keys(values, scene);
  return fmt::format("{:016x}", fnv1a(under_former_names(std::move(values)).dump()));
}

std::string default_text(const nlohmann::json& value) {
  const bool is_empty = value.is_null() || (value.is_string() && value.get_ref<const std::string&>().empty());
  return is_empty ? "none" : toml_text(value);
}

std::string toml_text(const nlohmann::json& value) {
  if (value.is_array()) return toml_list(value);
  if (value.is_object()) return toml_inline_table(value);
  if (value.is_number_float()) return fmt::format("{}", value.get<double>());
  if (!value.is_string()) return value.dump();
  const auto& text = value.get_ref<const std::string&>();
  return text == "inf" || text == "-inf" ? text : toml_string(text);
}

}  // namespace bake
