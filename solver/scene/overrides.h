// SPDX-License-Identifier: MIT
// Changing single values of a scene file from the command line.
#pragma once

#include <toml++/toml.h>

#include <string>

namespace bake {

/// Puts the value of `key=value` into the parsed file, creating tables (never list members) on the way. The new value
/// carries the override's own text as its place. Throws InputError if there is no such place or no such value.
void apply_override(toml::table& root, const std::string& text);

}  // namespace bake
