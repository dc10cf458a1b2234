// SPDX-License-Identifier: MIT
// Guards changes of stored numbers: only a person may change them, with a reason and from a commit.
#pragma once

#include <string>

namespace bake::cli {

/// The commit of the sources, 40 hexadecimal digits. Throws InputError in continuous integration (CI in the environment), without a
/// reason, without git, or if the sources have uncommitted changes.
std::string commit_to_bless(const std::string& why);

}  // namespace bake::cli
