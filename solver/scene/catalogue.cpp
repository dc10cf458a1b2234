// SPDX-License-Identifier: MIT
#include "solver/scene/catalogue.h"

#include <fmt/format.h>

#include "solver/boundary/shapes.h"
#include "solver/effects/all_effects.h"
#include "solver/scene/json_value.h"
#include "solver/scene/layout.h"
#include "solver/scene/resolved.h"

namespace bake {
namespace {

/// The default as TOML, or the word "required" or "none".
template <class P, class Owner>
std::string standard_value(const P& parameter, const Owner& fresh) {
  if (parameter.presence == Presence::required) return "required";
  return default_text(json_value(fresh.*parameter.member));
}

template <Declared T>
std::vector<CatalogueKey> described_keys() {
  std::vector<CatalogueKey> keys;
  for_each_parameter<T>([&](const auto& parameter) {
    keys.push_back({parameter.key, parameter.unit, allowed<ValueOf<decltype(parameter)>>(parameter.range), standard_value(parameter, T{}),
                    parameter.meaning, parameter.former ? parameter.former : ""});
  });
  return keys;
}

/// ", elasticity with motion, ...": effects that need others.
std::string needs() {
  std::string text;
  for_each_effect([&]<class E>() {
    if (!E::needs.empty()) text += fmt::format(", {} with {}", E::name, fmt::join(E::needs, " and "));
  });
  return text;
}

CatalogueSection top_of_file() {
  return {"",
          "top of the file",
          "",
          "what the scene is called and which physics it has",
          {{"title", "", allowed<std::string>({}), "none", "one line for people"},
           {"effects", "", fmt::format("a list of \"{}\"", fmt::join(effect_names(), "\", \"")), "[]",
            fmt::format("the physics that is on{}; what is not listed costs nothing, and its keys are checked but not used", needs())}}};
}

template <class Value>
CatalogueSection described(const Section<Value>& section) {
  return {section.name, fmt::format("[{}]", section.name), "", section.meaning, described_keys<Value>()};
}

template <class T>
CatalogueSection described(const Section<std::vector<T>>& section) {
  return {section.name, fmt::format("[[{}]]", section.name), "", section.meaning, described_keys<T>()};
}

/// "leavening makes CO2 ...; needs plasticity, heat"
template <class Effect>
std::string meaning_with_needs() {
  const std::vector<std::string> needs(Effect::needs.begin(), Effect::needs.end());
  return needs.empty() ? Effect::meaning : fmt::format("{}; needs {}", Effect::meaning, fmt::join(needs, " and "));
}

template <class Effect>
void add_effect(std::vector<CatalogueSection>& sections) {
  sections.push_back({Effect::name, fmt::format("[{}]", Effect::name), Effect::name, meaning_with_needs<Effect>(),
                      described_keys<typename Effect::Settings>()});
  auto keys = described_keys<typename Effect::Material>();
  if (keys.empty()) return;
  sections.push_back({"material", fmt::format("[[material]] with {}", Effect::name), Effect::name,
                      fmt::format("what the effect {} needs to know of each material", Effect::name), std::move(keys)});
}

template <class S>
CatalogueSection described_shape() {
  return {S::name, fmt::format("shape = {{ {} = {{ ... }} }}", S::name), "", S::meaning, described_keys<S>()};
}

/// The keys that every shape can have beside its own table.
CatalogueSection shapes_in_general() {
  CatalogueSection section{"shape", "shape = { <one shape> = { ... }, ... }", "",
                           "a solid: one named shape or combination, and where it is put", described_keys<Placement>()};
  section.keys.push_back({k_union, "", "a list of shapes", "none", "what is inside any of them"});
  section.keys.push_back({k_intersection, "", "a list of shapes", "none", "what is inside all of them"});
  section.keys.push_back({k_difference, "", "a list of at least 2 shapes", "none", "what is inside the first and in none of the others"});
  return section;
}

}  // namespace

std::vector<CatalogueSection> catalogue() {
  std::vector<CatalogueSection> sections{top_of_file()};
  const auto add = [&](const auto&... section) { (sections.push_back(described(section)), ...); };
  std::apply(add, k_tables);
  std::apply(add, k_lists);
  for_each_effect([&]<class Effect>() { add_effect<Effect>(sections); });
  sections.push_back({"keyframe", "motion = [{ time_s = 0 }, { ... }]", "",
                      "one pose of a moving collider or grip; between keyframes it moves evenly", described_keys<Keyframe>()});
  sections.push_back(shapes_in_general());
  [&]<class... S>(std::tuple<S...>*) { (sections.push_back(described_shape<S>()), ...); }(static_cast<AllShapes*>(nullptr));
  return sections;
}

}  // namespace bake
