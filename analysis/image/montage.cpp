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

namespace {

/// The middle of the picture at the scale at which it just covers that size.
Image covering(const Image& picture, int width, int height) {
  const double scale = std::max(static_cast<double>(width) / picture.width, static_cast<double>(height) / picture.height);
  const int w = std::max(width, static_cast<int>(std::lround(scale * picture.width)));
  const int h = std::max(height, static_cast<int>(std::lround(scale * picture.height)));
  Image cut(width, height, Colour::Ones());
  paste(cut, w == picture.width && h == picture.height ? picture : scaled(picture, w, h), (width - w) / 2, (height - h) / 2);
  return cut;
}

}  // namespace

Image tiled(const std::vector<Image>& pictures, const Layout& layout, int cell_width, int cell_height) {
  if (pictures.empty() || pictures.size() != layout.places.size())
    throw std::invalid_argument("tiles need a picture for each place of the layout");
  const int gap = std::max(2, cell_height / 60);
  const auto extent = [gap](int cells, int cell) { return cells * (cell + gap) - gap; };
  Image image(extent(layout.columns, cell_width), extent(layout.rows, cell_height), Colour::Ones());
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const Place& place = layout.places[i];
    paste(image, covering(pictures[i], extent(place.columns, cell_width), extent(place.rows, cell_height)),
          place.column * (cell_width + gap), place.row * (cell_height + gap));
  }
  return image;
}

}  // namespace bake
