// SPDX-License-Identifier: MIT
// Does independent work side by side.
#pragma once

#include <cstddef>
#include <functional>

namespace bake {

/// Calls `work(i)` once for each i below `count`, in order, at most `at_once` of them (1 or more) at the same time, each by a thread of its
/// own. Once one has thrown no further one begins; when those that have begun are done, what the one with the lowest number threw is
/// thrown.
void side_by_side(std::size_t count, int at_once, const std::function<void(std::size_t)>& work);

}  // namespace bake
