// SPDX-License-Identifier: MIT
// Visits declared parameters, and describes in words which values each kind of parameter allows.
#pragma once

#include <fmt/format.h>

#include <concepts>
#include <filesystem>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "solver/boundary/motion_path.h"
#include "solver/boundary/shape.h"
#include "solver/core/parameter.h"
#include "solver/scene/nearest.h"

namespace bake {

/// A struct that declares its parameters.
template <class T>
concept Declared = requires {
  T::parameters();
};

template <class T>
inline constexpr bool k_is_optional = false;
template <class T>
inline constexpr bool k_is_optional<std::optional<T>> = true;

template <class T>
inline constexpr bool k_is_curve = std::is_same_v<T, Curve> || std::is_same_v<T, VectorCurve>;
template <class T>
using ValueOfCurve = decltype(T::Point::value);

/// Calls `visit(parameter)` for each declared parameter of T, in their order.
template <Declared T, class Visit>
void for_each_parameter(Visit visit) {
  std::apply([&](const auto&... parameter) { (visit(parameter), ...); }, T::parameters());
}

/// The type of the member that a Parameter stands for.
template <class P>
struct ValueOfParameter;
template <class Owner, class Value>
struct ValueOfParameter<Parameter<Owner, Value>> {
  using type = Value;
};
template <class P>
using ValueOf = typename ValueOfParameter<std::remove_cvref_t<P>>::type;

/// Keys of all the structs, in order.
template <Declared... Structs>
std::vector<std::string> keys_of() {
  std::vector<std::string> keys;
  (for_each_parameter<Structs>([&](const auto& parameter) { keys.emplace_back(parameter.key); }), ...);
  return keys;
}

/// Former names of keys of all the structs.
template <Declared... Structs>
FormerNames former_names_of() {
  FormerNames names;
  const auto add = [&](const auto& parameter) {
    if (parameter.former) names.emplace(parameter.former, parameter.key);
  };
  (for_each_parameter<Structs>(add), ...);
  return names;
}

/// Names of an enumeration: "apic", "pic", "flip".
template <Choice E>
std::vector<std::string> names_of() {
  const auto names = choice_names(E{});
  return {names.begin(), names.end()};
}

/// The name of one of them: "apic".
template <Choice E>
const char* word_of(E choice) {
  return choice_names(choice)[static_cast<std::size_t>(choice)];
}

/// The allowed values of type T in words, for error messages and explanations.
template <class T>
std::string allowed(const Range& range) {
  if constexpr (k_is_optional<T>) {
    return allowed<typename T::value_type>(range);
  } else if constexpr (std::is_same_v<T, bool>) {
    return "true or false";
  } else if constexpr (std::is_arithmetic_v<T>) {
    return range.words;
  } else if constexpr (Choice<T>) {
    return fmt::format("\"{}\"", fmt::join(names_of<T>(), "\", \""));
  } else if constexpr (std::is_same_v<T, std::string>) {
    return "text in quotes";
  } else if constexpr (std::is_same_v<T, std::filesystem::path>) {
    return "a file in quotes, from the folder of the scene";
  } else if constexpr (std::is_same_v<T, std::vector<std::string>>) {
    return "text in quotes, or a list of such";
  } else if constexpr (std::is_same_v<T, std::vector<double>>) {
    return fmt::format("{}, or a list of such", range.words);
  } else if constexpr (std::is_same_v<T, Vector3>) {
    return fmt::format("[x, y, z], each {}", range.words);
  } else if constexpr (std::is_same_v<T, std::array<double, 4>>) {
    return fmt::format("one number or a list of 4, each {}", range.words);
  } else if constexpr (std::is_same_v<T, Curve>) {
    return fmt::format("{}, or [[time_s, value], ...] with rising times", range.words);
  } else if constexpr (std::is_same_v<T, VectorCurve>) {
    return fmt::format("{}, or [[time_s, [x, y, z]], ...] with rising times", allowed<Vector3>(range));
  } else if constexpr (std::is_same_v<T, ShapePtr>) {
    return "a shape, e.g. { sphere = { centre_m = [0, 0, 0.1], radius_m = 0.05 } }";
  } else {
    static_assert(Declared<typename T::value_type>, "a kind of value that scenes do not know");
    return fmt::format("a list of tables with {}", fmt::join(keys_of<typename T::value_type>(), ", "));
  }
}

}  // namespace bake
