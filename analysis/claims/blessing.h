// SPDX-License-Identifier: MIT
// Stored numbers change by people's will only, with a reason and a commit they come from.
#pragma once

#include <string>

namespace bake::cli {

/// The commit of the sources, 40 hexadecimal digits. Throws InputError in continuous integration (CI in the environment), without a
/// reason, without git, and if the sources have uncommitted changes.
std::string commit_to_bless(const std::string& why);

}  // namespace bake::cli
