// SPDX-License-Identifier: MIT
// One declaration per scene parameter.
//
// A struct that can be read from a scene lists its members once, in a static function `parameters()`:
//
//     struct Heat::Material {
//       double conductivity_W_per_mK = 0.5;
//       static constexpr auto parameters() {
//         return std::tuple{Parameter{"conductivity_W_per_mK", &Material::conductivity_W_per_mK, "W/(m K)",
//                                     non_negative, "kappa: heat conductivity of the mixture"}};
//       }
//     };
//
// The reader, the validation, `bake explain`, the documentation page and the resolved scene in run.json are all
// made from that list. The default is the value in a default-constructed struct.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

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

enum class Presence { optional, required };

/// One scene key: where it is stored and everything a user may want to know of it.
template <class Owner, class Value>
struct Parameter {
  const char* key;       ///< name in the scene file, with its unit as a suffix where it has one
  Value Owner::*member;  ///< where the value goes; its default is that of a default-constructed Owner
  const char* unit;      ///< "Pa", "W/(m K)", "1" for a pure number, "" for words and shapes
  Range range;           ///< for numbers; applies to every entry of a vector or curve
  const char* meaning;   ///< one sentence, with the symbol and equation of the paper where there is one
  Presence presence = Presence::optional;
};

template <class Owner, class Value, class... Rest>
Parameter(const char*, Value Owner::*, Rest...) -> Parameter<Owner, Value>;  // Clang 14 does not deduce aggregates

using Vector3 = std::array<double, 3>;

/// A quantity that changes with time (or stays constant: one point). Linear between points, flat outside.
/// In a scene: a number, or a list of [time_s, value] pairs with rising times.
struct Curve {
  struct Point {
    double at;
    double value;
  };
  std::vector<Point> points;

  Curve() = default;
  Curve(double constant) : points{{0.0, constant}} {}  // NOLINT: a number is a curve
  double operator()(double at) const;
};

/// Names of an enumeration in the scene file, found by argument-dependent lookup:
///     enum class Transfer { apic, pic, flip };
///     constexpr auto choice_names(Transfer) { return std::array{"apic", "pic", "flip"}; }
/// The enumerators must count up from 0 in the order of the names.
template <class Enum>
concept Choice = std::is_enum_v<Enum> && requires(Enum e) {
  choice_names(e);
};

}  // namespace bake
