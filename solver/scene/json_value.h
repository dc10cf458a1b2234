// SPDX-License-Identifier: MIT
// Any declared value as JSON.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

#include "solver/scene/describe.h"

namespace bake {

/// A number, or "inf" and "-inf", which JSON numbers cannot say. A zero has no sign: equal scenes have equal JSON.
inline nlohmann::json json_number(double number) {
  if (std::isinf(number)) return number > 0 ? "inf" : "-inf";
  return number + 0.0;
}

/// What `read_shape` made this shape from, defaults filled in; null for no shape and for one that was made in code.
nlohmann::json json_shape(const ShapePtr& shape);

template <Declared T>
nlohmann::json json_members(const T& owner);

/// The value as a scene would write it. Paths are given as they are.
template <class T>
nlohmann::json json_value(const T& value) {
  if constexpr (k_is_optional<T>) {
    return value ? json_value(*value) : nlohmann::json();
  } else if constexpr (std::is_same_v<T, double>) {
    return json_number(value);
  } else if constexpr (Choice<T>) {
    return names_of<T>().at(static_cast<std::size_t>(value));
  } else if constexpr (std::is_same_v<T, std::filesystem::path>) {
    return value.empty() ? nlohmann::json() : nlohmann::json(value.generic_string());
  } else if constexpr (std::is_same_v<T, ShapePtr>) {
    return json_shape(value);
  } else if constexpr (k_is_curve<T>) {
    if (value.points.size() == 1) return json_value(value.points.front().value);
    nlohmann::json list = nlohmann::json::array();
    for (const auto& point : value.points) list.push_back({json_number(point.at), json_value(point.value)});
    return list;
  } else if constexpr (Declared<T>) {
    return json_members(value);
  } else if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
    return value;
  } else {  // std::array and std::vector
    nlohmann::json list = nlohmann::json::array();
    for (const auto& element : value) list.push_back(json_value(element));
    return list;
  }
}

/// The declared members of a struct as an object.
template <Declared T>
nlohmann::json json_members(const T& owner) {
  nlohmann::json object = nlohmann::json::object();
  for_each_parameter<T>([&](const auto& parameter) { object[parameter.key] = json_value(owner.*parameter.member); });
  return object;
}

}  // namespace bake
