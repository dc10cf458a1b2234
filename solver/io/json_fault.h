// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

namespace bake {

/// What is wrong with a JSON file, in our words: the library's are for programmers.
inline std::string json_fault(const nlohmann::json::exception& error) {
  if (const auto* parsing = dynamic_cast<const nlohmann::json::parse_error*>(&error))
    return fmt::format("no JSON from byte {} on", parsing->byte);
  if (dynamic_cast<const nlohmann::json::out_of_range*>(&error) != nullptr) return "a key is missing";
  return "a value is of another kind";
}

}  // namespace bake
