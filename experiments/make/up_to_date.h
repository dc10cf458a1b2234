// SPDX-License-Identifier: MIT
// Files that are made from others are made once: what each was made from stands beside it.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace bake {

/// Is `output` there, and was it made from exactly this?
bool is_up_to_date(const std::filesystem::path& output, const nlohmann::json& from);
/// Notes in <output>.from.json what it was made from.
void record_sources(const std::filesystem::path& output, const nlohmann::json& from);

/// What tells a file from another of the same name, without reading all of it: size and time of its last change.
nlohmann::json stamp(const std::filesystem::path& file);

}  // namespace bake
