// SPDX-License-Identifier: MIT
// The parts of the page.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "experiments/make/items.h"
#include "experiments/report/html.h"

namespace bake::report {

enum class ItemVerdict { reproduced, not_reproduced, not_run, not_there_yet };

/// An item with its claims.json, if it was made.
struct ReportedItem {
  const Item* item;
  std::filesystem::path folder;
  std::optional<nlohmann::json> made;

  ItemVerdict verdict() const;
};

Html badge(ItemVerdict verdict);
/// Of a claim or a band.
Html badge(bool holds);

/// The item's place on the page: "figure-15".
std::string anchor(const Item& item);

/// Pictures, charts, claims and runs of an item that is done, or how it is made.
Html item_section(const ReportedItem& reported);
/// The items that are not there yet, with what must be measured; nothing if there are none.
Html missing_section(const std::vector<ReportedItem>& missing);

/// The tables of studies that stand in <root>/paper, those that are there.
Html orders_section(const std::filesystem::path& root);
Html departures_section(const std::filesystem::path& root);
Html stability_section(const std::filesystem::path& root);
Html effects_section(const std::filesystem::path& root);
Html accuracy_section(const std::filesystem::path& root);

/// A file of JSON; nothing if it is not there. Throws InputError if it is damaged.
std::optional<nlohmann::json> read_json(const std::filesystem::path& file);

}  // namespace bake::report
