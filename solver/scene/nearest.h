// SPDX-License-Identifier: MIT
// Guessing what was meant by a name that does not exist.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace bake {

/// What keys were called before, and what they are called now.
using FormerNames = std::map<std::string, std::string>;

/// The known name that the fewest edits make from `word` (insert, delete, replace, swap neighbours; case is ignored),
/// or that is `word` with its unit; empty if none is similar. A former name stands for the present one.
std::string nearest(std::string_view word, std::vector<std::string> known, const FormerNames& former = {});

/// The end of a message about an unknown word: "did you mean 'x'?", or "allowed: x, y, z" if nothing is similar.
std::string suggestion(std::string_view word, const std::vector<std::string>& known, const FormerNames& former = {});

}  // namespace bake
