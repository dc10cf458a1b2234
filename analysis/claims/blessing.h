// SPDX-License-Identifier: MIT
// Guards changes of stored numbers: only a person may change them, with a reason and from a commit.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace bake::cli {

/// The commit of the sources, 40 hexadecimal digits. Throws InputError in continuous integration (CI in the environment), without a
/// reason, without git, or if the sources have uncommitted changes.
std::string commit_to_bless(const std::string& why);

struct Blessing {
  std::vector<std::optional<double>> expected;  ///< of each [[claim]], where it is measured anew
  std::string why, commit;
};

/// The text of a file of claims with other numbers for `expected`, and with [blessed] at its end; comments and all else stay. Throws
/// InputError for a number that is not finite.
std::string bless_claims(const std::string& text, const Blessing& blessing);

}  // namespace bake::cli
