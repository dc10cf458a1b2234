// SPDX-License-Identifier: MIT
// One declaration per scene parameter.
//
// A struct that can be read from a scene lists its members once, in a static function `parameters()`:
//
//     struct Material {
//       double conductivity_W_per_mK = 0.5;
//       static constexpr auto parameters() {
//         return std::tuple{Parameter{"conductivity_W_per_mK", &Material::conductivity_W_per_mK, "W/(m K)",
//                                     non_negative, "kappa: heat conductivity of the mixture"}};
//       }
//     };
//
// The reader, the validation, overrides, `bake explain`, the documentation page and the resolved scene in run.json are all
// made from that list. The default is the value in a default-constructed struct.
#pragma once

#include <array>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "solver/core/curve.h"
#include "solver/core/range.h"
#include "solver/core/vector3.h"

namespace bake {

enum class Presence { optional, required };

inline constexpr const char* k_former_keys_end = "1.0";  ///< version that no longer reads former keys

/// One scene key: where it is stored and everything a user may want to know of it.
template <class Owner, class Value>
struct Parameter {
  const char* key;       ///< name in the scene file, with its unit as a suffix where it has one
  Value Owner::*member;  ///< where the value goes; its default is that of a default-constructed Owner
  const char* unit;      ///< "Pa", "W/(m K)", "1" for a pure number, "" for words and shapes
  Range range;           ///< for numbers; applies to every entry of a vector or curve
  const char* meaning;   ///< one sentence, with the symbol and equation of the paper where there is one
  Presence presence = Presence::optional;
  const char* former = nullptr;  ///< what the key was called before: read until k_former_keys_end, with a notice
};

template <class Owner, class Value, class... Rest>
Parameter(const char*, Value Owner::*, Rest...) -> Parameter<Owner, Value>;  // Clang 14 does not deduce aggregates

/// Names of an enumeration in the scene file, found by argument-dependent lookup:
///     enum class Transfer { apic, pic, flip };
///     constexpr auto choice_names(Transfer) { return std::array{"apic", "pic", "flip"}; }
/// The enumerators must count up from 0 in the order of the names.
template <class Enum>
concept Choice = std::is_enum_v<Enum> && requires(Enum e) {
  choice_names(e);
};

}  // namespace bake
