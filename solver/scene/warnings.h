// SPDX-License-Identifier: MIT
// What in a valid scene looks like a slip: `bake info` says it.
#pragma once

#include <string>
#include <vector>

namespace bake {

struct Scene;

/// One line for every effect that is listed though the scene leaves it nothing to do, which only costs time, and for every effect that
/// is not listed though a material that is used has a coefficient of it, which then means nothing. Materials no body and no emitter
/// is made of are not looked at.
std::vector<std::string> warnings_about(const Scene& scene);

}  // namespace bake
