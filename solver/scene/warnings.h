// SPDX-License-Identifier: MIT
// Warnings about a valid scene that looks like a mistake; `bake info` prints them.
#pragma once

#include <string>
#include <vector>

namespace bake {

struct Scene;

/// One line for every effect that is listed although it can change nothing in this scene (it only costs time), and one for every effect
/// that is not listed although a material in use has a coefficient of it (which is then ignored). Materials that no body and no emitter
/// uses are not checked.
std::vector<std::string> warnings_about(const Scene& scene);

}  // namespace bake
