// SPDX-License-Identifier: MIT
// Which numbers a parameter may be.
#pragma once

#include <limits>

namespace bake {

/// Allowed values of a number. `words` is what a user reads when a value is refused.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;
  bool high_open = false;
  const char* words = "any number";

  constexpr bool contains(double value) const {
    const bool above = low_open ? value > low : value >= low;
    const bool below = high_open ? value < high : value <= high;
    return above && below;  // false for NaN
  }
};

inline constexpr double k_infinity = std::numeric_limits<double>::infinity();
inline constexpr Range any_number{-k_infinity, k_infinity, true, true, "any finite number"};
inline constexpr Range positive{0, k_infinity, true, true, "a number above 0"};
inline constexpr Range non_negative{0, k_infinity, false, true, "a number of at least 0"};
inline constexpr Range positive_or_infinite{0, k_infinity, true, false, "a number above 0, or inf"};
inline constexpr Range fraction{0, 1, false, false, "a number from 0 to 1"};
inline constexpr Range open_fraction{0, 1, true, true, "a number strictly between 0 and 1"};
inline constexpr Range above_absolute_zero{-273.15, k_infinity, true, true, "a temperature above -273.15 degrees Celsius"};

}  // namespace bake
