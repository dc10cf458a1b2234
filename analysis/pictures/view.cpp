// SPDX-License-Identifier: MIT
#include "analysis/pictures/view.h"

#include <fmt/format.h>

#include <algorithm>

#include "solver/scene/json_value.h"
#include "solver/scene/overrides.h"
#include "solver/scene/read_value.h"
#include "solver/scene/resolved.h"

namespace bake {
namespace {

template <class T>
struct ViewTable {
  const char* name;
  T View::*member;
  const char* meaning;
};

constexpr std::tuple k_tables{
    ViewTable<PictureSettings>{"picture", &View::picture, "size and quality"},
    ViewTable<CameraSettings>{"camera", &View::camera, "where it is seen from"},
    ViewTable<LightSettings>{"light", &View::light, "a square lamp"},
    ViewTable<SkySettings>{"sky", &View::sky, "light from all around"},
    ViewTable<GroundSettings>{"ground", &View::ground, "the table, which rises to a wall far behind the objects"},
    ViewTable<BrowningLaw>{"browning", &View::browning,
                           "how crust browns: dB/dt = 1/t_ref 10^((theta - theta_ref)/theta_10) min(1, w/w_ref)"},
    ViewTable<CrustSettings>{"crust", &View::crust, "how browned dough looks"},
    ViewTable<SliceSettings>{"slice", &View::slice, "the plane of technical pictures (bake-render slice)"},
};

bool is_zero(const Vector3& v) { return v == Vector3{0, 0, 0}; }

void check_ramp(const SceneEntry& crust, const char* key, const std::vector<BrowningStop>& ramp) {
  const auto unsorted = [](const BrowningStop& a, const BrowningStop& b) { return a.degree >= b.degree; };
  const bool rises = std::adjacent_find(ramp.begin(), ramp.end(), unsorted) == ramp.end();
  if (ramp.empty() || !rises)
    crust.find(key)->complain("found no rising degrees, allowed: at least one stop, each degree larger than the one before");
}

void check(const SceneEntry& root, const View& view) {
  const auto table = [&](const char* name) { return root.find(name).value_or(root.absent_table(name)); };
  const SceneEntry camera = table("camera");
  if (is_zero(view.camera.direction)) camera.find("direction")->complain("found no direction, allowed: not all zero");
  if (is_zero(view.slice.normal)) table("slice").find("normal")->complain("found no direction, allowed: not all zero");
  if (view.slice.up && is_zero(cross(*view.slice.up, view.slice.normal)))
    table("slice").find("up")->complain("found no direction across the normal, allowed: one across it");
  if (is_zero(view.light.direction)) table("light").find("direction")->complain("found no direction, allowed: not all zero");
  if (!view.camera.fit && (!view.camera.eye_m || !view.camera.target_m || view.camera.eye_m == view.camera.target_m))
    camera.complain("fit = false needs eye_m and target_m, two different points");
  if (view.camera.fit && (view.camera.eye_m || view.camera.target_m)) camera.complain("eye_m and target_m need fit = false");
  check_ramp(table("crust"), "skin", view.crust.skin);
  check_ramp(table("crust"), "crumb", view.crust.crumb);
}

template <class T>
void check_range(const SceneEntry& entry, const T& value) {
  if (value.range_low && value.range_high && *value.range_low >= *value.range_high)
    entry.complain(fmt::format("found range_low {} and range_high {}, allowed: a rising range", *value.range_low, *value.range_high));
}

void check(const SceneEntry& entry, const PanelSettings& panel) { check_range(entry, panel); }

void check(const SceneEntry& entry, const ObjectSettings& object) {
  check_range(entry, object);
  if (object.cut_point_m.has_value() != object.cut_normal.has_value()) entry.complain("a cut needs both cut_point_m and cut_normal");
  if (object.mirrored.find_first_not_of("xyz") != std::string::npos)
    entry.find("mirrored")->complain(fmt::format("found '{}', allowed: letters x, y and z", object.mirrored));
  if (object.cut_normal && is_zero(*object.cut_normal)) entry.find("cut_normal")->complain("found no direction, allowed: not all zero");
}

template <class T>
void read_all_of(const SceneEntry& root, const char* name, std::vector<T>& values) {
  for (const SceneEntry& entry : root.tables(name)) {
    values.push_back(read_table<T>(entry));
    check(entry, values.back());
  }
}

template <Declared T>
std::string explained(const std::string& heading, const std::string& meaning) {
  std::string text = fmt::format("{}: {}\n", heading, meaning);
  const T fresh{};
  for_each_parameter<T>([&](const auto& parameter) {
    std::string standard = default_text(json_value(fresh.*parameter.member));
    if (standard.size() > 40) standard = "a ramp";
    text += fmt::format("  {:<26} {:<8} {}; default {}\n", parameter.key, parameter.unit, parameter.meaning, standard);
  });
  return text;
}

}  // namespace

View parse_view(std::string_view text, const std::filesystem::path& name, const std::vector<std::string>& overrides) {
  const Document document{quotable_path(name), name.parent_path()};
  toml::table table = parse_toml(text, document.name);
  for (const std::string& text_of_override : overrides) apply_override(table, text_of_override);
  const SceneEntry root(document, table);
  std::vector<std::string> known = {"panel", "object"};
  std::apply([&](const auto&... t) { (known.emplace_back(t.name), ...); }, k_tables);
  root.refuse_unknown(known);

  View view;
  view.file = name;
  const auto read = [&]<class T>(const ViewTable<T>& t) {
    if (const auto entry = root.find(t.name)) view.*t.member = read_table<T>(*entry);
  };
  std::apply([&](const auto&... t) { (read(t), ...); }, k_tables);
  check(root, view);
  read_all_of(root, "panel", view.panels);
  read_all_of(root, "object", view.objects);
  if (view.objects.empty()) view.objects.emplace_back();
  return view;
}

View read_view(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  return parse_view(read_text_file(file), file, overrides);
}

std::string explain_view() {
  std::string text;
  const auto add = [&]<class T>(const ViewTable<T>& t) { text += explained<T>(fmt::format("[{}]", t.name), t.meaning); };
  std::apply([&](const auto&... t) { (add(t), ...); }, k_tables);
  text += explained<PanelSettings>("[[panel]]", "one for each field of a technical picture (bake-render slice)");
  return text + explained<ObjectSettings>("[[object]]", "one for each file on the command line, in order; none is like one with defaults");
}

}  // namespace bake
