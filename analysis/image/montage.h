// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/image/image.h"
#include "analysis/image/layout.h"

namespace bake {

/// Puts pictures side by side on white, row by row, all scaled to the height of the lowest, each with its label below (`labels` may be
/// empty). `columns` of at least 1. Throws std::invalid_argument if there are no pictures, or labels of another number.
Image montage(const std::vector<Image>& pictures, const std::vector<std::string>& labels, int columns);

/// Puts pictures into a grid of equal cells on white, the first picture at the first place and so on. Each is scaled to cover its place,
/// and what stands out of it is cut off, on both sides alike. Throws std::invalid_argument unless there is a picture for each place.
Image tiled(const std::vector<Image>& pictures, const Layout& layout, int cell_width, int cell_height);

}  // namespace bake
