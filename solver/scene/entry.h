// SPDX-License-Identifier: MIT
// A value in a scene file together with its place, so that every error message can name the place.
#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/scene/nearest.h"

namespace bake {

/// The name of the scene file in messages, and the folder at which its relative paths start.
struct Document {
  std::string name;
  std::filesystem::path folder;
  mutable std::vector<std::string> notices = {};           ///< lines for the user, added while reading: keys under former names
  mutable std::map<std::string, std::string> places = {};  ///< of all entries that were read, by dotted name: "bread.toml:12"
};

/// A node of the parsed file with its dotted name. The entry refers to the document and the node, which must outlive it.
class SceneEntry {
 public:
  SceneEntry(const Document& document, const toml::table& root);

  const toml::node& node() const { return *node_; }
  const Document& document() const { return *document_; }
  std::string_view name() const { return name_; }  ///< "material.dough.density_kg_per_m3", empty for the whole file

  /// The member of this table, if it is there. This entry must be a table.
  std::optional<SceneEntry> find(std::string_view key) const;
  /// The member `key`, or the one under the key's former name, if it has one: then the document gets a notice. Complains if both are there.
  std::optional<SceneEntry> find(std::string_view key, const char* former) const;
  /// An empty table that stands for a missing member.
  SceneEntry absent_table(std::string_view key) const;
  /// The members of this array. This entry must be an array.
  std::vector<SceneEntry> elements() const;
  /// The tables [[key]] of this table; none if it has no such key. Throws InputError if the key is not a list.
  std::vector<SceneEntry> tables(std::string_view key) const;
  /// The same entry under another name: `material.dough` instead of `material.0`.
  SceneEntry renamed(std::string_view last_part) const;

  // Each of these throws an InputError of one line that begins with the place.
  [[noreturn]] void complain(std::string_view problem) const;
  /// Complains about the member of this table, or about this table if it is not there.
  [[noreturn]] void complain_at(std::string_view key, std::string_view problem) const;
  [[noreturn]] void refuse(std::string_view allowed) const;  ///< "found <this value>, allowed: ..."
  [[noreturn]] void refuse_missing(std::string_view key, std::string_view allowed) const;
  /// Complains about the first member of this table that is neither in `known` nor a former name.
  void refuse_unknown(const std::vector<std::string>& known, const FormerNames& former = {}) const;
  /// Complains if this is not a table.
  void expect_table() const;

 private:
  SceneEntry(const SceneEntry& parent, const toml::node& node, std::string name);
  std::string place_of(const toml::source_region& source) const;
  std::string child_name(std::string_view key) const;
  SceneEntry kept() const;  ///< this entry, its place now among those of the document

  const Document* document_;
  const toml::node* node_;
  std::string name_;
  std::string place_;  ///< "bread.toml:12", or the override that the value comes from
};

/// Makes the user's text fit for a message: one line, shortened, without control characters.
std::string quotable(std::string_view text);

/// The name of a file for a message: complete, but in one line.
std::string quotable_path(const std::filesystem::path& path);

/// Reads all bytes of a file. Throws InputError if it is missing, a folder or unreadable.
std::string read_text_file(const std::filesystem::path& file);

/// Parses TOML; messages call it `name`. Throws InputError with line and column.
toml::table parse_toml(std::string_view text, const std::string& name);

}  // namespace bake
