// SPDX-License-Identifier: MIT
// What each scene key means, for people: made from the same declarations that the reader checks against.
#pragma once

#include <string>
#include <string_view>

namespace bake {

/// Meaning, unit, allowed values, default and effect of `key`: a full key (`oven.temperature_C`), a bare one
/// (`temperature_C`: every table that has it), or the name of a table, an effect or a shape. Empty: an overview of all keys.
/// Ends with a newline. Throws InputError, with the nearest name, for anything else.
std::string explain(std::string_view key);

/// All of it as one Markdown page: docs/scene.md.
std::string documentation_page();

}  // namespace bake
