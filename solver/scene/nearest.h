// SPDX-License-Identifier: MIT
// Guesses which known name a user meant by an unknown one.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace bake {

/// Former names of keys, each with the present name.
using FormerNames = std::map<std::string, std::string>;

/// The known name that the fewest edits make from `word` (insert, delete, replace, swap neighbours; case is ignored),
/// or that is `word` with its unit; empty if none is similar. Where a former name is nearest, the present one is returned.
std::string nearest(std::string_view word, std::vector<std::string> known, const FormerNames& former = {});

/// The end of a message about an unknown word: "did you mean 'x'?", or "allowed: x, y, z" if nothing is similar.
std::string suggestion(std::string_view word, const std::vector<std::string>& known, const FormerNames& former = {});

}  // namespace bake
