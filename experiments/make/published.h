// SPDX-License-Identifier: MIT
// Reads the numbers that the paper publishes: reference/published/*.toml.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/scene/read_value.h"

namespace bake {

/// A TOML file of lists of tables. All members throw InputError with file, line, found and allowed.
class PublishedFile {
 public:
  /// `known`: the names that the file may have.
  PublishedFile(const std::filesystem::path& file, const std::vector<std::string>& known)
      : document_{quotable_path(file), file.parent_path()}, table_(parse_toml(read_text_file(file), document_.name)) {
    root().refuse_unknown(known);
  }

  const std::string& name() const { return document_.name; }
  std::vector<std::string> texts(std::string_view key) const {
    const auto entry = root().find(key);
    if (!entry) root().refuse_missing(key, allowed<std::vector<std::string>>({}));
    return read_texts(*entry);
  }
  /// The tables [[key]], each with the declared members of T and no others; none if there are none.
  template <Declared T>
  std::vector<T> list(std::string_view key) const {
    const auto tables = root().find(key);
    return tables ? read_list<T>(*tables) : std::vector<T>();
  }

 private:
  SceneEntry root() const { return SceneEntry(document_, table_); }

  Document document_;
  toml::table table_;
};

}  // namespace bake
