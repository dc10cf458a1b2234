// SPDX-License-Identifier: MIT
// The sections of the report page.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "experiments/make/items.h"
#include "experiments/report/html.h"

namespace bake::report {

enum class ItemVerdict { reproduced, not_reproduced, not_run, not_there_yet };

/// An item, and its claims.json if the item was made.
struct ReportedItem {
  const Item* item;
  std::filesystem::path folder;
  std::optional<nlohmann::json> made;

  ItemVerdict verdict() const;
};

Html badge(ItemVerdict verdict);
/// The badge of a claim or band: whether it holds.
Html badge(bool holds);

/// The anchor of the item on the page: "figure-15".
std::string anchor(const Item& item);

/// The pictures, charts, claims and runs of an item that was made; else the command that makes it.
Html item_section(const ReportedItem& reported);
/// The items that do not exist yet, and what must be measured for them; empty if there are none.
Html missing_section(const std::vector<ReportedItem>& missing);

/// The tables of those studies whose results are in <root>/paper.
Html orders_section(const std::filesystem::path& root);
Html departures_section(const std::filesystem::path& root);
Html stability_section(const std::filesystem::path& root);
Html effects_section(const std::filesystem::path& root);
Html accuracy_section(const std::filesystem::path& root);

/// Reads a JSON file; nothing if it does not exist. Throws InputError if it is damaged.
std::optional<nlohmann::json> read_json(const std::filesystem::path& file);

}  // namespace bake::report
