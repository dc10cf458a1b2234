// SPDX-License-Identifier: MIT
#include "solver/scene/entry.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <system_error>

#include "solver/core/errors.h"
#include "solver/core/parameter.h"

namespace bake {
namespace {

const toml::table k_empty_table;

std::string describe(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::string:
      return fmt::format("\"{}\"", quotable(node.as_string()->get()));
    case toml::node_type::integer:
      return fmt::format("{}", node.as_integer()->get());
    case toml::node_type::floating_point:
      return fmt::format("{}", node.as_floating_point()->get());
    case toml::node_type::boolean:
      return node.as_boolean()->get() ? "true" : "false";
    case toml::node_type::array:
      return fmt::format("a list of {}", node.as_array()->size());
    case toml::node_type::table:
      return "a table";
    default:
      return "a date or time";
  }
}

std::string in_one_line(std::string_view text) {
  std::string line(text);
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return line;
}

/// Whether the dot at `i` is that of a number that stands by itself, as in [0.5, 1.5e3]. Parts of a dotted key may look like numbers, 1.2
/// .3, but a dot is between them: at least every second one counts.
bool is_dot_of_number(std::string_view text, std::size_t i) {
  constexpr std::string_view k_number = "0123456789_eE+-.", k_before = " \t\n,[={", k_after = " \t\r\n,]}#";
  const std::size_t begin = text.find_last_not_of(k_number, i) + 1;  // npos + 1 is 0
  const std::size_t end = std::min(text.find_first_not_of(k_number, i), text.size());
  return std::count(text.begin() + static_cast<std::ptrdiff_t>(begin), text.begin() + static_cast<std::ptrdiff_t>(end), '.') == 1 &&
         (begin == 0 || k_before.find(text[begin - 1]) != std::string_view::npos) &&
         (end == text.size() || k_after.find(text[end]) != std::string_view::npos);
}

/// The parser follows dotted keys by recursion, to any depth. A key ends with its line, so a bound on the dots per line bounds the stack.
void refuse_endless_keys(std::string_view text, const std::string& name) {
  constexpr int k_most_dots = 1500;
  int line = 1, dots = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '.' && !is_dot_of_number(text, i) && ++dots > k_most_dots) {
      throw InputError(
          fmt::format("{}:{}: found more than {} dots outside of numbers in one line, allowed: shorter lines", name, line, k_most_dots));
    }
    if (c == '\n') {
      ++line;
      dots = 0;
    }
  }
}

}  // namespace

std::string quotable_path(const std::filesystem::path& path) { return in_one_line(path.string()); }

std::string quotable(std::string_view text) {
  constexpr std::size_t k_longest = 60;
  std::string line = in_one_line(text.substr(0, k_longest));
  if (text.size() <= k_longest) return line;
  while (!line.empty() && (static_cast<unsigned char>(line.back()) & 0xc0) == 0x80) line.pop_back();  // keeps UTF-8 characters whole
  return line + "...";
}

SceneEntry::SceneEntry(const Document& document, const toml::table& root) : document_(&document), node_(&root), place_(document.name) {
  place_ = place_of(root.source());
}

SceneEntry::SceneEntry(const SceneEntry& parent, const toml::node& node, std::string name)
    : document_(parent.document_), node_(&node), name_(std::move(name)), place_(parent.place_of(node.source())) {}

std::string SceneEntry::place_of(const toml::source_region& source) const {
  if (!source.path || source.begin.line == 0) return place_;
  if (*source.path != document_->name) return *source.path;
  return fmt::format("{}:{}", document_->name, source.begin.line);
}

SceneEntry SceneEntry::kept() const {
  document_->places[name_] = place_;
  return *this;
}

std::string SceneEntry::child_name(std::string_view key) const {
  return name_.empty() ? std::string(key) : fmt::format("{}.{}", name_, quotable(key));
}

std::optional<SceneEntry> SceneEntry::find(std::string_view key) const {
  const toml::node* member = node_->as_table()->get(key);
  if (!member) return std::nullopt;
  return SceneEntry(*this, *member, child_name(key)).kept();
}

std::optional<SceneEntry> SceneEntry::find(std::string_view key, const char* former) const {
  auto named_now = find(key), named_before = former ? find(former) : std::nullopt;
  if (!named_before) return named_now;
  if (named_now) named_before->complain(fmt::format("found beside {}, its new name, allowed: one of them", key));
  document_->notices.push_back(fmt::format("{}: {} is now called {}; the old name is read until {}", named_before->place_,
                                           named_before->name_, key, k_former_keys_end));
  return named_before;
}

SceneEntry SceneEntry::absent_table(std::string_view key) const { return SceneEntry(*this, k_empty_table, child_name(key)); }

std::vector<SceneEntry> SceneEntry::elements() const {
  std::vector<SceneEntry> entries;
  for (const toml::node& element : *node_->as_array()) {
    entries.push_back(SceneEntry(*this, element, child_name(std::to_string(entries.size()))).kept());
  }
  return entries;
}

std::vector<SceneEntry> SceneEntry::tables(std::string_view key) const {
  const auto list = find(key);
  if (!list) return {};
  if (!list->node().is_array()) list->refuse(fmt::format("tables under [[{}]]", key));
  return list->elements();
}

SceneEntry SceneEntry::renamed(std::string_view last_part) const {
  SceneEntry other = *this;
  other.name_ = fmt::format("{}.{}", name_.substr(0, name_.rfind('.')), quotable(last_part));
  return other.kept();
}

void SceneEntry::complain(std::string_view problem) const {
  throw InputError(name_.empty() ? fmt::format("{}: {}", place_, problem) : fmt::format("{}: {}: {}", place_, name_, problem));
}

void SceneEntry::complain_at(std::string_view key, std::string_view problem) const { find(key).value_or(*this).complain(problem); }

void SceneEntry::refuse(std::string_view allowed) const { complain(fmt::format("found {}, allowed: {}", describe(*node_), allowed)); }

void SceneEntry::refuse_missing(std::string_view key, std::string_view allowed) const {
  throw InputError(fmt::format("{}: {}: missing, allowed: {}", place_, child_name(key), allowed));
}

void SceneEntry::refuse_unknown(const std::vector<std::string>& known, const FormerNames& former) const {
  for (auto&& [key, member] : *node_->as_table()) {
    if (former.contains(std::string(key.str())) || std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
    SceneEntry at_key = *this;
    at_key.place_ = place_of(key.source());
    at_key.complain(fmt::format("unknown key '{}', {}", quotable(key.str()), suggestion(key.str(), known, former)));
  }
}

void SceneEntry::expect_table() const {
  if (!node_->is_table()) refuse("a table");
}

std::string read_text_file(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) throw InputError(fmt::format("{}: no such file", quotable_path(file)));
  if (std::filesystem::is_directory(status)) throw InputError(fmt::format("{}: found a folder, allowed: a TOML file", quotable_path(file)));
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!stream.is_open() || stream.bad()) throw InputError(fmt::format("{}: cannot be read", quotable_path(file)));
  return text;
}

toml::table parse_toml(std::string_view text, const std::string& name) {
  refuse_endless_keys(text, name);
  try {
    return toml::parse(text, std::string_view(name));
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    throw InputError(fmt::format("{}:{}:{}: no valid TOML: {}", name, at.line, at.column, in_one_line(error.description())));
  }
}

}  // namespace bake
