// SPDX-License-Identifier: MIT
#include "experiments/make/items.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "solver/core/errors.h"
#include "solver/scene/nearest.h"
#include "solver/scene/read_value.h"

namespace bake {
namespace {

namespace fs = std::filesystem;

/// "figure 3", "table 2", "experiment 1".
bool is_number(const std::string& text) {
  const auto space = text.find(' ');
  const std::string kind = text.substr(0, space), digits = space == std::string::npos ? "" : text.substr(space + 1);
  return (kind == "figure" || kind == "table" || kind == "experiment") && !digits.empty() &&
         digits.find_first_not_of("0123456789") == std::string::npos;
}

void check_scenes(const SceneEntry& entry, const Items& items, const Item& item) {
  for (const std::string& scene : item.scenes)
    if (!fs::is_regular_file(items.experiment_of(item) / (scene + ".toml")))
      entry.complain_at("scenes", fmt::format("found '{}', allowed: a scene in experiments/{}", scene, item.experiment));
}

void check_item(const SceneEntry& entry, const Items& items, const Item& item) {
  if (!is_number(item.number))
    entry.complain_at("number", fmt::format("found '{}', allowed: figure N, table N or experiment N", item.number));
  for (const Item& other : items.items) {
    if (other.number == item.number) entry.complain_at("number", fmt::format("found '{}' again", item.number));
    if (other.name == item.name) entry.complain_at("name", fmt::format("found '{}' again", item.name));
  }
  if (item.status != ItemStatus::not_there_yet && !fs::is_directory(items.experiment_of(item)))
    entry.complain_at("experiment", fmt::format("found '{}', allowed: a folder in experiments", item.experiment));
  const bool has_figure = fs::exists(items.figure_file_of(item));
  if (item.status == ItemStatus::done) {
    if (!has_figure) entry.complain_at("status", fmt::format("found done without experiments/{}/figure.toml", item.experiment));
    if (!item.scenes.empty() || !item.claims.empty())
      entry.complain("found scenes or claims of an item that is done: its figure.toml names them");
    return;
  }
  if (has_figure) entry.complain_at("status", "found a figure.toml of an item that is not done");
  if (item.claims.empty()) entry.refuse_missing("claims", "what must be measured to call it reproduced");
  if (item.status == ItemStatus::scene_only && item.scenes.empty()) entry.refuse_missing("scenes", "the scenes that are there");
  check_scenes(entry, items, item);
}

void check_other(const SceneEntry& entry, const Items& items, const OtherExperiment& other) {
  if (!fs::is_directory(items.root / "experiments" / other.experiment))
    entry.complain_at("experiment", fmt::format("found '{}', allowed: a folder in experiments", other.experiment));
}

/// Folders that hold only sources, of studies and of what makes figures, are no experiments.
bool has_scene_or_figure(const fs::path& folder) {
  return std::any_of(fs::directory_iterator(folder), {}, [](const auto& file) { return file.path().extension() == ".toml"; });
}

/// Checks that every experiment belongs to an item or has a stated purpose.
void check_experiments(const SceneEntry& root, const Items& items) {
  std::set<std::string> known;
  for (const Item& item : items.items) known.insert(item.experiment);
  for (const OtherExperiment& other : items.others) known.insert(other.experiment);
  for (const auto& entry : fs::directory_iterator(items.root / "experiments"))
    if (const std::string folder = entry.path().filename().string();
        entry.is_directory() && has_scene_or_figure(entry.path()) && !known.contains(folder))
      root.complain(fmt::format("found experiments/{}, which no [[item]] or [[other]] names", folder));
}

}  // namespace

fs::path items_root(const fs::path& built_from) {
  std::error_code ignored;
  for (fs::path folder = fs::current_path(ignored); !folder.empty(); folder = folder.parent_path()) {
    if (fs::exists(folder / "paper/items.toml", ignored)) return folder;
    if (folder == folder.root_path()) break;
  }
  return built_from;
}

Items read_items(const fs::path& root) {
  const fs::path file = root / "paper/items.toml";
  const Document document{file.string(), file.parent_path()};
  const toml::table table = parse_toml(read_text_file(file), document.name);
  const SceneEntry entry(document, table);
  entry.refuse_unknown({"item", "other"});
  Items items{root, {}, {}};
  for (const SceneEntry& one : entry.tables("item")) {
    const Item item = read_table<Item>(one);
    check_item(one, items, item);
    items.items.push_back(item);
  }
  for (const SceneEntry& one : entry.tables("other")) {
    items.others.push_back(read_table<OtherExperiment>(one));
    check_other(one, items, items.others.back());
  }
  check_experiments(entry, items);
  return items;
}

const Item& find_item(const Items& items, const std::string& words, const std::string& kind) {
  const std::string number = kind + " " + words;
  std::vector<std::string> names;
  for (const Item& item : items.items) {
    const bool is_folder = !words.empty() && words == item.experiment;
    if (words == item.name || words == item.number || number == item.number || is_folder) return item;
    if ((kind == "table") == item.number.starts_with("table")) names.push_back(item.name);
  }
  throw InputError(fmt::format("unknown {} '{}'; {} (bake list figures)", kind, quotable(words), suggestion(words, names)));
}

}  // namespace bake
