// SPDX-License-Identifier: MIT
#include "solver/scene/overrides.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "solver/core/errors.h"
#include "solver/scene/catalogue.h"
#include "solver/scene/entry.h"

namespace bake {
namespace {

constexpr std::size_t k_deepest = 100;  // names in a dotted key; no scene key needs as many

/// One `key=value`, split into its parts.
struct Override {
  std::string place;  ///< what messages call it
  std::vector<std::string> keys;
  std::string value;

  [[noreturn]] void complain(std::string_view problem) const { throw InputError(fmt::format("{}: {}", place, problem)); }
};

std::vector<std::string> split_at_dots(std::string_view text) {
  std::vector<std::string> parts{""};
  for (const char c : text) {
    if (c == '.') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

Override take_apart(const std::string& text) {
  Override change{fmt::format("override '{}'", quotable(text)), {}, {}};
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) change.complain("found no '=', allowed: key=value");
  change.keys = split_at_dots(std::string_view(text).substr(0, equals));
  change.value = text.substr(equals + 1);
  const bool nameless = std::any_of(change.keys.begin(), change.keys.end(), [](const std::string& key) { return key.empty(); });
  if (nameless) change.complain("found an empty name, allowed: key=value with a dotted key");
  if (change.keys.size() > k_deepest) change.complain(fmt::format("found {} names, allowed: at most {}", change.keys.size(), k_deepest));
  return change;
}

/// The value of `value = ...` if that is one line of TOML.
std::optional<toml::table> parse_value(const std::string& value, const std::string& place) {
  try {
    toml::table holder = parse_toml(fmt::format("value = {}", value), place);
    if (holder.size() == 1) return holder;
  } catch (const InputError&) {  // the caller reports it, since it also tries another reading of the value
  }
  return std::nullopt;
}

/// A table whose single member is the new value: moving it out keeps its source position, copying would not.
toml::table value_holder(const Override& change) {
  if (auto holder = parse_value(change.value, change.place)) return std::move(*holder);
  const std::size_t first = change.value.find_first_not_of(' ');
  const bool is_word = first == std::string::npos || std::string_view("[{\"'").find(change.value[first]) == std::string_view::npos;
  if (is_word) {
    if (auto holder = parse_value(fmt::format("'{}'", change.value), change.place)) return std::move(*holder);
  }
  change.complain(fmt::format("found '{}', allowed: a TOML value or one word", quotable(change.value)));
}

std::size_t position(const Override& change, const toml::array& list, const std::string& key) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    const toml::table* member = list[i].as_table();
    const auto* name = member ? member->get_as<std::string>("name") : nullptr;
    if (key == std::to_string(i) || (name && name->get() == key)) return i;
  }
  if (list.empty()) change.complain(fmt::format("there is no '{}', the list is empty", quotable(key)));
  change.complain(fmt::format("there is no '{}', allowed: an index from 0 to {} or a name", quotable(key), list.size() - 1));
}

/// The part `key` of a table or list; a table that is not there yet is created.
toml::node& step_into(const Override& change, toml::node& node, const std::string& key) {
  if (toml::array* list = node.as_array()) return (*list)[position(change, *list, key)];
  toml::table* table = node.as_table();
  if (!table) change.complain(fmt::format("'{}' is part of a single value, allowed: the key of that value", quotable(key)));
  if (toml::node* member = table->get(key)) return *member;
  toml::table holder = *parse_value("{}", change.place);
  toml::table& fresh = *holder.get("value")->as_table();
  return table->insert_or_assign(toml::key(key, toml::source_region(fresh.source())), std::move(fresh)).first->second;
}

/// Erases the member under the other name, former or present, of the key that is overridden.
void forget_other_name(const Override& change, toml::table& table) {
  for (const CatalogueSection& section : catalogue()) {
    if (section.name != change.keys.front()) continue;
    for (const CatalogueKey& key : section.keys) {
      if (key.former.empty()) continue;
      if (key.key == change.keys.back()) table.erase(key.former);
      if (key.former == change.keys.back()) table.erase(key.key);
    }
  }
}

void put(const Override& change, toml::node& node, const std::string& key, toml::node&& value) {
  if (toml::array* list = node.as_array()) {
    const auto at = list->erase(list->cbegin() + static_cast<std::ptrdiff_t>(position(change, *list, key)));
    std::move(value).visit([&](auto&& concrete) { list->insert(at, std::forward<decltype(concrete)>(concrete)); });
  } else if (toml::table* table = node.as_table()) {
    forget_other_name(change, *table);
    toml::key place(key, toml::source_region(value.source()));
    std::move(value).visit([&](auto&& concrete) { table->insert_or_assign(std::move(place), std::forward<decltype(concrete)>(concrete)); });
  } else {
    change.complain(fmt::format("'{}' is part of a single value, allowed: the key of that value", quotable(key)));
  }
}

}  // namespace

void apply_override(toml::table& root, const std::string& text) {
  const Override change = take_apart(text);
  toml::table holder = value_holder(change);
  toml::node* node = &root;
  for (std::size_t i = 0; i + 1 < change.keys.size(); ++i) node = &step_into(change, *node, change.keys[i]);
  put(change, *node, change.keys.back(), std::move(*holder.get("value")));
}

}  // namespace bake
