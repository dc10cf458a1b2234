// SPDX-License-Identifier: MIT
#include "analysis/image/montage.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bake {

Image montage(const std::vector<Image>& pictures, const std::vector<std::string>& labels, int columns) {
  if (pictures.empty() || (!labels.empty() && labels.size() != pictures.size()))
    throw std::invalid_argument("a montage needs pictures, and a label for each or none");
  const int height =
      std::min_element(pictures.begin(), pictures.end(), [](const Image& a, const Image& b) { return a.height < b.height; })->height;
  std::vector<Image> cells;
  int width = 0;
  for (const Image& picture : pictures) {
    const int w = std::max(1, static_cast<int>(std::lround(static_cast<double>(picture.width) * height / picture.height)));
    cells.push_back(picture.height == height ? picture : scaled(picture, w, height));
    width = std::max(width, cells.back().width);
  }
  const int gap = std::max(2, height / 60), text = labels.empty() ? 0 : std::max(12, height / 14);
  const int count = static_cast<int>(cells.size()), across = std::min(columns, count), rows = (count + columns - 1) / columns;
  const int step_x = width + gap, step_y = height + text + gap;
  Image image(across * step_x + gap, rows * step_y + gap, Colour::Ones());
  for (int i = 0; i < count; ++i) {
    const Image& cell = cells[static_cast<std::size_t>(i)];
    const int x = gap + i % columns * step_x, y = gap + i / columns * step_y;
    paste(image, cell, x + (width - cell.width) / 2, y);
    if (!labels.empty())
      draw_text(image, labels[static_cast<std::size_t>(i)], x + width / 2, y + height + text / 2, text * 3 / 4, Anchor::centre,
                Colour::Constant(0.1f));
  }
  return image;
}

}  // namespace bake
