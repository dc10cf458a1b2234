// SPDX-License-Identifier: MIT
// Explains each scene key to the user, from the same declarations against which the reader checks.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bake {

/// Meaning, unit, allowed values, default and effect of `key`: a full key (`oven.temperature_C`), a bare one
/// (`temperature_C`: every table that has it), or the name of a table, an effect or a shape. Empty: an overview of all keys.
/// Ends with a newline. Throws InputError for anything else, with the nearest name, which may also be one of `columns` of results.
std::string explain(std::string_view key, const std::vector<std::string>& columns = {});

/// The explanations of all keys as one Markdown page: docs/scene.md.
std::string documentation_page();

}  // namespace bake
