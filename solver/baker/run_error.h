// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>

namespace bake {

/// The run cannot go on: names particle, quantity and step where it can. What was written before is kept.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace bake
