// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "analysis/image/image.h"

namespace bake {

/// What a colour stands for.
struct ColourBar {
  ColourMap map = ColourMap::viridis;
  double low = 0, high = 1;  ///< values at the map's start and end
  std::string label;
  bool operator==(const ColourBar&) const = default;
};

/// "oven temperature [C]" for the field oven_temperature of unit C; numbers without unit have none.
std::string label_of_field(std::string field, const std::string& unit);

/// Height of a bar with its numbers and label, for letters of `text` pixels.
constexpr int colour_bar_height(int text) { return text * 10 / 3; }

/// Draws the map from left to right, `width` pixels around `centre`, downwards from `top`; below it three numbers and the label. All pixels
/// lie within the image.
void draw_colour_bar(Image& image, const ColourBar& bar, int centre, int top, int width, int text, const Colour& ink);

}  // namespace bake
