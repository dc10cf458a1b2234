// SPDX-License-Identifier: MIT
// Where the paper's own form of an equation can be run beside ours.
#pragma once

#include <array>

namespace bake {

/// `standard` is this project's form; `published` is the equation as printed. Departures are marked
/// DEPARTS where they are made.
enum class Form { standard, published };
constexpr auto choice_names(Form) { return std::array{"standard", "published"}; }

}  // namespace bake
