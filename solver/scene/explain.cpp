// SPDX-License-Identifier: MIT
#include "solver/scene/explain.h"

#include <fmt/format.h>

#include <algorithm>

#include "solver/core/errors.h"
#include "solver/core/parameter.h"
#include "solver/scene/catalogue.h"
#include "solver/scene/entry.h"
#include "solver/scene/nearest.h"

namespace bake {
namespace {

std::string full_key(const CatalogueSection& section, const std::string& key) {
  return section.name.empty() ? key : section.name + "." + key;
}

std::string explain_key(const CatalogueSection& section, const CatalogueKey& key) {
  std::string text = fmt::format("{}\n  {}\n", full_key(section, key.key), key.meaning);
  text += fmt::format("  written  {}\n", section.heading);
  if (!key.unit.empty()) text += fmt::format("  unit     {}\n", key.unit);
  text += fmt::format("  allowed  {}\n  default  {}\n", key.allowed, key.standard);
  if (!section.effect.empty()) text += fmt::format("  effect   {}\n", section.effect);
  if (!key.former.empty()) text += fmt::format("  formerly {}, which is read until {}\n", key.former, k_former_keys_end);
  return text;
}

std::string explain_section(const CatalogueSection& section) {
  std::string text = fmt::format("{}\n  {}\n", section.heading, section.meaning);
  if (section.keys.empty()) text += "  (no keys of its own)\n";
  for (const CatalogueKey& key : section.keys) text += fmt::format("  {:<30} {:<14} {}\n", key.key, key.unit, key.meaning);
  return text;
}

std::string overview(const std::vector<CatalogueSection>& sections) {
  std::string text;
  for (const CatalogueSection& section : sections) {
    std::vector<std::string> keys;
    for (const CatalogueKey& key : section.keys) keys.push_back(key.key);
    text += fmt::format("{}: {}\n    {}\n", section.heading, section.meaning,
                        keys.empty() ? "no keys of its own" : fmt::format("{}", fmt::join(keys, ", ")));
  }
  return text;
}

/// Everything that is called `name`: sections, and keys by their full or bare name.
std::string explain_all(const std::vector<CatalogueSection>& sections, std::string_view name) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : "\n") + part; };
  for (const CatalogueSection& section : sections) {
    if (section.name == name || section.effect == name) add(explain_section(section));
    for (const CatalogueKey& key : section.keys) {
      for (const std::string& called : {key.key, key.former}) {
        if (!called.empty() && (called == name || full_key(section, called) == name)) add(explain_key(section, key));
      }
    }
  }
  return text;
}

/// How a key may be meant that an error message calls "material.dough.density_kg_per_m3" or
/// "body.0.shape.sphere.radius_m": itself, without what lies between, its last two parts, its last part.
std::vector<std::string> readings(std::string_view key) {
  const std::size_t first = key.find('.'), last = key.rfind('.');
  std::vector<std::string> names{std::string(key)};
  if (first == std::string_view::npos) return names;
  const std::string bare(key.substr(last + 1));
  const std::size_t parent = key.substr(0, last).rfind('.');
  names.push_back(std::string(key.substr(0, first + 1)) + bare);
  names.emplace_back(parent == std::string_view::npos ? key : key.substr(parent + 1));
  names.push_back(bare);
  return names;
}

[[noreturn]] void complain_unknown(const std::vector<CatalogueSection>& sections, std::string_view name,
                                   const std::vector<std::string>& columns) {
  const bool full = name.find('.') != std::string_view::npos;
  std::vector<std::string> known;
  FormerNames former;
  for (const CatalogueSection& section : sections) {
    const auto called = [&](const std::string& key) { return full ? full_key(section, key) : key; };
    if (!section.name.empty()) known.push_back(section.name);
    for (const CatalogueKey& key : section.keys) {
      known.push_back(called(key.key));
      if (!key.former.empty()) former.emplace(called(key.former), called(key.key));
    }
  }
  known.insert(known.end(), columns.begin(), columns.end());
  const std::string guess = nearest(name, known, former);
  throw InputError(fmt::format("no scene key, table, effect, shape or column is called '{}', {}", quotable(name),
                               guess.empty() ? "allowed: those of `bake explain`" : fmt::format("did you mean '{}'?", guess)));
}

std::string escaped_for_markdown(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return escaped;
}

std::string markdown_section(const CatalogueSection& section) {
  const std::string quote = section.name.empty() ? "" : "`";
  std::string text = fmt::format("\n## {1}{0}{1}\n\n{2}\n", section.heading, quote, escaped_for_markdown(section.meaning));
  if (section.keys.empty()) return text + "\nNo keys of its own.\n";
  text += "\n| key | unit | default | allowed | meaning |\n|---|---|---|---|---|\n";
  for (const CatalogueKey& key : section.keys) {
    text += fmt::format("| `{}` | {} | {} | {} | {}{} |\n", key.key, key.unit, key.standard, escaped_for_markdown(key.allowed),
                        escaped_for_markdown(key.meaning),
                        key.former.empty() ? "" : fmt::format("; formerly `{}`, read until {}", key.former, k_former_keys_end));
  }
  return text;
}

constexpr const char* k_page_head =
    R"(<!-- SPDX-License-Identifier: MIT. Generated: BAKE_WRITE_DOCS=1 scene_tests --gtest_filter='DocumentationPage.*' writes it anew. -->
# The scene file

A scene is one TOML file in SI units; temperatures are in degrees Celsius. Every key says its unit in its name. What is not given
takes its default, what is wrong is refused in one line that names file, line, key, what was found and what is allowed.

Single values can be changed from the command line with `--set key=value`, members of lists by index or name: `run.end_s=2`,
`body.0.temperature_C=5`, `material.dough.density_kg_per_m3=500`, `oven.temperature_C=[[0,20],[60,200]]`. `bake explain <key>`
prints what this page says of a key.

A quantity that changes with time is a number or a list of `[time_s, value]` with rising times: linear between them, constant
before the first and after the last. Gravity is a vector `[x, y, z]` or a list of `[time_s, [x, y, z]]` of the same kind.
)";

}  // namespace

std::string explain(std::string_view key, const std::vector<std::string>& columns) {
  const std::vector<CatalogueSection> sections = catalogue();
  if (key.empty()) return overview(sections);
  for (const std::string& name : readings(key)) {
    std::string text = explain_all(sections, name);
    if (!text.empty()) return text;
  }
  complain_unknown(sections, key, columns);
}

std::string documentation_page() {
  std::string page = k_page_head;
  for (const CatalogueSection& section : catalogue()) page += markdown_section(section);
  return page;
}

}  // namespace bake
