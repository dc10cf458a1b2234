// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "experiments/make/computed.h"
#include "experiments/make/published.h"
#include "solver/core/errors.h"
#include "solver/scene/reader.h"
#include "solver/scene/resolved.h"

namespace bake {
namespace {

namespace fs = std::filesystem;

/// A row of table2.toml.
struct PublishedParameter {
  std::string name;
  std::vector<std::string> values;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"name", &PublishedParameter::name, "", any_number, "as printed", Presence::required},
        Parameter{"values", &PublishedParameter::values, "", any_number, "as printed, one for each column", Presence::required},
    };
  }
};

/// Of table2_scenes.toml.
struct ColumnScene {
  std::string name, scene;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"name", &ColumnScene::name, "", any_number, "of the column", Presence::required},
        Parameter{"scene", &ColumnScene::scene, "", any_number, "<experiment>/<scene>", Presence::required},
    };
  }
};
struct RowKey {
  std::string name, key;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"name", &RowKey::name, "", any_number, "of the row", Presence::required},
        Parameter{"key", &RowKey::key, "", any_number, "where the resolved scene has it; without, no scene states it"},
    };
  }
};
struct Reason {
  std::string column, parameter, why;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"column", &Reason::column, "", any_number, "whose scene states another value than the paper", Presence::required},
        Parameter{"parameter", &Reason::parameter, "", any_number, "which one", Presence::required},
        Parameter{"why", &Reason::why, "", any_number, "of the difference", Presence::required},
    };
  }
};

/// What a place of the resolved scene says; nothing if it is not there or not one number.
std::optional<double> number_at(const nlohmann::json& scene, const std::string& key) {
  const nlohmann::json::json_pointer place(key);
  if (!scene.contains(place)) return {};
  const nlohmann::json& value = scene[place];
  if (value.is_number()) return value.get<double>();
  if (!value.is_array() || value.empty()) return {};
  if (value[0].is_number()) return value[0].get<double>();  // over temperature: at the start
  for (const auto& point : value)                           // over time: [time, value]
    if (point[1] != value[0][1]) return {};
  return value[0][1].get<double>();
}

/// Numbers of the cells of each kind.
struct Counts {
  int equal = 0, explained = 0, unexplained = 0, absent = 0, chosen = 0, not_applicable = 0;
};

class Comparison {
 public:
  explicit Comparison(const fs::path& root) {
    const PublishedFile published(root / "reference/published/table2.toml", {"columns", "parameter"});
    const PublishedFile ours(root / "reference/published/table2_scenes.toml", {"column", "row", "reason"});
    columns_ = published.texts("columns");
    parameters_ = published.list<PublishedParameter>("parameter");
    for (const PublishedParameter& p : parameters_)
      if (p.values.size() != columns_.size())
        throw InputError(fmt::format("{}: {}: found {} values, allowed: one for each of the {} columns", published.name(), p.name,
                                     p.values.size(), columns_.size()));
    rows_ = ours.list<RowKey>("row");
    reasons_ = ours.list<Reason>("reason");
    for (const ColumnScene& c : ours.list<ColumnScene>("column")) {
      const fs::path file = root / "experiments" / (c.scene + ".toml");
      scenes_[c.name] = fs::exists(file) ? resolved(read_scene(file)) : nlohmann::json();
    }
    check_names(ours.name());
  }

  Computed computed() {
    ComputedTable table{"parameters", "Table 2: what the paper publishes, and what our scenes state", {"parameter"}, {}};
    table.header.insert(table.header.end(), columns_.begin(), columns_.end());
    for (const PublishedParameter& p : parameters_) {
      std::vector<std::string> row{p.name};
      for (std::size_t c = 0; c < columns_.size(); ++c) row.push_back(cell(p, c));
      table.rows.push_back(row);
    }
    Computed computed;
    computed.tables = {table, notes()};
    const double stale = static_cast<double>(reasons_.size() - used_reasons_.size());
    computed.numbers = {
        {"equal_values", "1", "values that a scene states as the paper prints them", static_cast<double>(counts_.equal)},
        {"explained_differences", "1", "values that a scene states otherwise, for a stated reason", static_cast<double>(counts_.explained)},
        {"unexplained_differences", "1", "values that a scene states otherwise, without a reason",
         static_cast<double>(counts_.unexplained)},
        {"values_without_a_scene", "1", "published values of which there is no scene yet", static_cast<double>(counts_.absent)},
        {"values_no_scene_states", "1", "published time steps of scenes that are there: the solver chooses its own",
         static_cast<double>(counts_.chosen)},
        {"stale_reasons", "1", "reasons without a difference", stale},
    };
    return computed;
  }

 private:
  /// Every name of our file is one of the paper's, and none of the paper's is missing.
  void check_names(const std::string& file) const {
    const auto refuse = [&](const std::string& what) { throw InputError(fmt::format("{}: {}", file, what)); };
    for (const std::string& column : columns_)
      if (!scenes_.contains(column)) refuse(fmt::format("no [[column]] '{}'", column));
    for (const PublishedParameter& p : parameters_)
      if (!find_named(rows_, p.name)) refuse(fmt::format("no [[row]] '{}'", p.name));
    for (const Reason& r : reasons_)
      if (!scenes_.contains(r.column) || !find_named(rows_, r.parameter))
        refuse(fmt::format("reason: found {}, {}, allowed: a column and a row of the table", r.column, r.parameter));
  }

  const Reason* reason_of(const std::string& column, const std::string& parameter) {
    for (const Reason& r : reasons_)
      if (r.column == column && r.parameter == parameter) return &r;
    return nullptr;
  }

  /// "2000 =", "400 (paper 20) [1]", "2e3 (no scene)"; the notes say what each means.
  std::string cell(const PublishedParameter& parameter, std::size_t c) {
    const std::string &printed = parameter.values[c], &column = columns_[c];
    if (printed == "N/A") {
      ++counts_.not_applicable;
      return printed;
    }
    if (scenes_[column].is_null()) {
      ++counts_.absent;
      return printed + " (no scene)";
    }
    const std::string& key = find_named(rows_, parameter.name)->key;
    if (key.empty()) {
      ++counts_.chosen;
      return printed + " (chosen)";
    }
    const std::optional<double> ours = number_at(scenes_[column], key);
    if (ours && *ours == std::stod(printed)) {
      ++counts_.equal;
      return printed + " =";
    }
    const std::string other = fmt::format("{} (paper {})", ours ? fmt::format("{:g}", *ours) : "not one value", printed);
    const Reason* reason = reason_of(column, parameter.name);
    if (!reason) {
      ++counts_.unexplained;
      return other + " !";
    }
    ++counts_.explained;
    used_reasons_.insert(reason);
    return fmt::format("{} [{}]", other, used_reasons_.size());
  }

  ComputedTable notes() {
    ComputedTable notes{"notes", "What the cells mean", {"mark", "meaning", "cells"}, {}};
    const auto add = [&](const char* mark, const char* meaning, int count) {
      if (count > 0) notes.rows.push_back({mark, meaning, fmt::format("{}", count)});
    };
    add("=", "the scene states the published value", counts_.equal);
    add("[n]", "the scene states another value, for reason n", counts_.explained);
    add("!", "the scene states another value, without a reason", counts_.unexplained);
    add("(chosen)", "no scene states it: the solver takes the largest stable step, times a safety", counts_.chosen);
    add("(no scene)", "of this simulation there is no scene yet", counts_.absent);
    add("N/A", "not published", counts_.not_applicable);
    int number = 0;
    for (const Reason* reason : used_reasons_)
      notes.rows.push_back({fmt::format("[{}]", ++number), fmt::format("{}, {}: {}", reason->column, reason->parameter, reason->why), ""});
    return notes;
  }

  std::vector<std::string> columns_;
  std::vector<PublishedParameter> parameters_;
  std::vector<RowKey> rows_;
  std::vector<Reason> reasons_;
  std::map<std::string, nlohmann::json> scenes_;  ///< resolved, by column; null: not there yet
  std::set<const Reason*> used_reasons_;
  Counts counts_;
};

}  // namespace

Computed table02_parameters() { return compare_parameters(BAKE_SOURCE_DIR); }

Computed compare_parameters(const fs::path& root) { return Comparison(root).computed(); }

}  // namespace bake
