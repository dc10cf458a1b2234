// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace bake {

/// A mistake of the user: wrong file, key, value or option. `what()` is one line: file:line: key: found, allowed.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace bake
