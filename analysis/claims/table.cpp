// SPDX-License-Identifier: MIT
#include "analysis/claims/table.h"

#include <fmt/format.h>

#include <algorithm>

#include "solver/scene/describe.h"

namespace bake {

std::string table(const std::vector<TableRow>& rows) {
  std::size_t what = 20, condition = 22;
  for (const TableRow& row : rows) {
    what = std::max(what, row.what.size());
    condition = std::max(condition, row.condition.size());
  }
  std::string text = fmt::format("  {:<{}} {:>12} {:<6} {:<{}} {:<10}  {}\n", "metric", what, "measured", "unit", "expected", condition,
                                 "kind", "verdict");
  for (const TableRow& row : rows)
    text += fmt::format("  {:<{}} {:>12.6g} {:<6} {:<{}} {:<10}  {}\n", row.what, what, row.measured, row.unit, row.condition, condition,
                        word_of(row.kind), row.holds ? "holds" : "MISSED: " + row.why);
  return text;
}

}  // namespace bake
