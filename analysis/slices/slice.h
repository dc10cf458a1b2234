// SPDX-License-Identifier: MIT
// Technical pictures: bodies cut open and painted by fields, side by side, each field with a colour bar.
#pragma once

#include <filesystem>
#include <vector>

#include "analysis/image/image.h"
#include "analysis/pictures/view.h"

namespace bake {

/// One row for each file and one column for each [[panel]] of the view; with one panel, one column for each file. All bodies are
/// drawn to the same scale, which a bar shows; all rows of a column share its colours.
/// Throws InputError: no [[panel]], a missing field or run, a plane that misses a body.
Image take_slices(const View& view, const std::vector<std::filesystem::path>& files, const std::vector<std::filesystem::path>& results,
                  int threads);

}  // namespace bake
