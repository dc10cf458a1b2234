// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/image/image.h"

namespace bake {

/// Puts pictures side by side on white, row by row, all scaled to the height of the lowest, each with its label below (`labels` may be
/// empty). `columns` of at least 1. Throws std::invalid_argument if there are no pictures, or labels of another number.
Image montage(const std::vector<Image>& pictures, const std::vector<std::string>& labels, int columns);

}  // namespace bake
