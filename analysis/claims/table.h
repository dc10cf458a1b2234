// SPDX-License-Identifier: MIT
// The table of verdicts for the terminal.
#pragma once

#include <string>
#include <vector>

#include "analysis/claims/reference.h"

namespace bake {

struct TableRow {
  std::string what;
  double measured;
  std::string unit, condition;
  Evidence kind;
  bool holds;
  std::string why;  ///< shown if it does not hold
};

/// Makes each column as wide as its widest cell.
std::string table(const std::vector<TableRow>& rows);

}  // namespace bake
