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

/// The badge of an item: a sign and words, "✗ 2 of 3 statements". Colour alone tells nothing.
Html badge(const ReportedItem& reported);
Html badge(ItemVerdict verdict);
/// The badge of a statement, claim or band: whether it holds.
Html badge(bool holds);

/// A # that leads to an anchor; `words` say to what.
Html link_to(const std::string& anchor, std::string_view words);

/// The anchor of the item on the page: "figure-15".
std::string anchor(const Item& item);

/// The bodies, statements, charts, pictures and runs of an item that was made; else the command that makes it. Data of the bodies, which
/// stand at the end of the page so that it is seen before they are read, are added to `data`.
Html item_section(const ReportedItem& reported, std::vector<Html>& data);
/// "Figure 15: bread with ...".
std::string heading_of(const ReportedItem& reported);
/// The items that do not exist yet, and what must be measured for them, folded into one line; empty if there are none.
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
