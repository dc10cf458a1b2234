// SPDX-License-Identifier: MIT
// Statements of the paper, each with what was measured for it: a card with its verdict, and a bar for each number.
#pragma once

#include <nlohmann/json.hpp>

#include "experiments/report/html.h"

namespace bake::report {

/// A statement and the claims that measure it, as claims.json has them.
struct Statement {
  std::string words;  ///< the paper's, if the claims quote it, else the reason for the claims
  bool is_quoted = false;
  std::vector<nlohmann::json> claims;

  bool holds() const;  ///< whether all of its claims do
};

/// The statements that the claims measure, in their order: claims with the same quotation, or without one with the same reason, are one.
std::vector<Statement> statements_of(const nlohmann::json& claims);

/// Cards of the statements. `place`: the anchor of the item, with which those of the cards begin.
Html cards(const std::vector<Statement>& statements, const std::string& place);

}  // namespace bake::report
