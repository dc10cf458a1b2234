// SPDX-License-Identifier: MIT
// Changes single values of a scene file from the command line.
#pragma once

#include <toml++/toml.h>

#include <string>

namespace bake {

/// Puts the value of `key=value` into the parsed file, creating tables (never list members) on the way. Error messages
/// about the new value name the override's text as its place. Throws InputError if the key leads nowhere or the value is no TOML.
void apply_override(toml::table& root, const std::string& text);

}  // namespace bake
