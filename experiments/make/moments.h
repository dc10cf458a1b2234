// SPDX-License-Identifier: MIT
// Chooses the moments of a run that are worth showing.
#pragma once

#include <vector>

namespace bake {

/// `count` rows, at least two, from row `first` to the last, rising, such that about as much happens between each two of them: what happens
/// is the way through the columns, each in units of its own range. Fewer if there are fewer rows. What is not finite counts as no change.
/// `columns`: of equal length, at least one, with at least one row.
std::vector<int> moments(const std::vector<std::vector<double>>& columns, int count, int first = 0);

}  // namespace bake
