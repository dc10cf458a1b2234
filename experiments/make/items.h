// SPDX-License-Identifier: MIT
// Reads paper/items.toml, which lists every figure and table of the paper, and experiments that explain them, with the folder that makes
// each.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/core/parameter.h"

namespace bake {

/// done: experiments/<experiment>/figure.toml makes and checks it. scene_only: it can be simulated.
enum class ItemStatus { done, scene_only, not_there_yet };
constexpr auto choice_names(ItemStatus) { return std::array{"done", "scene only", "not there yet"}; }

/// [[item]]
struct Item {
  std::string number;               ///< "figure 15"
  std::string name;                 ///< "bread"
  std::string shows;                ///< what the paper shows, one line
  std::string experiment;           ///< "fig15_bread"
  std::vector<std::string> scenes;  ///< "fig03_cookies/cookie"
  std::vector<std::string> claims;
  ItemStatus status{};
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"number", &Item::number, "", any_number,
                  "\"figure 15\", \"table 2\" or, of an experiment that explains one of them, \"experiment 1\"", Presence::required},
        Parameter{"name", &Item::name, "", any_number, "one word, also in the name of the folder of its results", Presence::required},
        Parameter{"shows", &Item::shows, "", any_number, "what the paper shows, in one line", Presence::required},
        Parameter{"status", &Item::status, "", any_number,
                  "done: a command makes it and checks its claims; whether these hold, the report says (reproduced or not)",
                  Presence::required},
        Parameter{"experiment", &Item::experiment, "", any_number,
                  "its folder in experiments; required unless the status is \"not there yet\""},
        Parameter{"scenes", &Item::scenes, "", any_number, "its scenes while it is not done; after that its figure.toml names them"},
        Parameter{"claims", &Item::claims, "", any_number,
                  "what must be measured, while it is not done; after that its figure.toml has the claims"},
    };
  }
};

/// [[other]]: a folder in experiments/ that belongs to no item.
struct OtherExperiment {
  std::string experiment;
  std::string purpose;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"experiment", &OtherExperiment::experiment, "", any_number, "a folder in experiments", Presence::required},
        Parameter{"purpose", &OtherExperiment::purpose, "", any_number, "its purpose", Presence::required},
    };
  }
};

/// The items, and the root of the sources that holds paper/items.toml and experiments/.
struct Items {
  std::filesystem::path root;
  std::vector<Item> items;
  std::vector<OtherExperiment> others;

  std::filesystem::path experiment_of(const Item& item) const { return root / "experiments" / item.experiment; }
  std::filesystem::path figure_file_of(const Item& item) const { return experiment_of(item) / "figure.toml"; }
};

/// The nearest folder at or above the working folder with a paper/items.toml; without one, the sources that the program was built from.
std::filesystem::path items_root(const std::filesystem::path& built_from);

/// Reads <root>/paper/items.toml. Throws InputError for a link that leads nowhere: no such experiment, scene or figure.toml, a number or
/// name twice, an experiment that neither an item nor an [[other]] names.
Items read_items(const std::filesystem::path& root);

/// The item that "15", "figure 15", "bread" or "fig15_bread" stands for; a number alone means the `kind`. Throws InputError.
const Item& find_item(const Items& items, const std::string& words, const std::string& kind = "figure");

}  // namespace bake
