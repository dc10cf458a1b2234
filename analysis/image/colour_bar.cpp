// SPDX-License-Identifier: MIT
#include "analysis/image/colour_bar.h"

#include <fmt/format.h>

#include <algorithm>

namespace bake {

std::string label_of_field(std::string field, const std::string& unit) {
  std::replace(field.begin(), field.end(), '_', ' ');
  return unit.empty() || unit == "1" ? field : fmt::format("{} [{}]", field, unit);
}

void draw_colour_bar(Image& image, const ColourBar& bar, int centre, int top, int width, int text, const Colour& ink) {
  const int height = text * 2 / 3, left = centre - width / 2;
  for (int x = std::max(0, -left); x < std::min(width, image.width - left); ++x)
    for (int y = 0; y < std::min(height, image.height - top); ++y)
      image.at(left + x, top + y) = pixel(map_colour(bar.map, (static_cast<float>(x) + 0.5f) / static_cast<float>(width)));
  for (int i = 0; i <= 2; ++i) {
    const double value = bar.low + (bar.high - bar.low) * i / 2;
    draw_text(image, fmt::format("{:.3g}", value), left + width * i / 2, top + height + text * 3 / 4, text, Anchor::centre, ink);
  }
  draw_text(image, bar.label, centre, top + height + text * 7 / 4, text, Anchor::centre, ink);
}

}  // namespace bake
