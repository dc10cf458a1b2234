// SPDX-License-Identifier: MIT
// Avoids making files again: beside each file that was made from others, a record tells from what.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace bake {

/// Whether `output` exists and was made from exactly these sources.
bool is_up_to_date(const std::filesystem::path& output, const nlohmann::json& from);
/// Records in <output>.from.json from what `output` was made.
void record_sources(const std::filesystem::path& output, const nlohmann::json& from);

/// Identifies the present version of a file without reading it: its size and the time of its last change.
nlohmann::json stamp(const std::filesystem::path& file);

}  // namespace bake
