// SPDX-License-Identifier: MIT
// What can be chosen besides dx, each value a curve of its own.
#pragma once

#include <string>
#include <vector>

#include "experiments/accuracy/case.h"

namespace bake::studies::accuracy {

/// Every variant of a case that this effort measures; the default's come first, each curve's with rising cells.
std::vector<Variant> variants_of(const Case& c, Effort effort);

}  // namespace bake::studies::accuracy
