// SPDX-License-Identifier: MIT
// Reads an entry of a scene file as a value of any declared kind.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "solver/scene/describe.h"
#include "solver/scene/entry.h"

namespace bake {

// Each throws an InputError that says what is allowed if the entry is of another type or out of range.
double read_number(const SceneEntry& entry, const Range& range, std::string_view allowed_words);
int read_whole_number(const SceneEntry& entry, const Range& range);
bool read_truth(const SceneEntry& entry);
std::string read_text(const SceneEntry& entry);
std::size_t read_choice(const SceneEntry& entry, const std::vector<std::string>& names);  ///< index into names
template <class Value>
CurveOf<Value> read_curve(const SceneEntry& entry, const Range& range);
/// Fills `numbers[0..count)` from a list of exactly `count` numbers.
void read_numbers(const SceneEntry& entry, const Range& range, std::string_view allowed_words, double* numbers, std::size_t count);
/// Reads a list; a single value stands for a list of one.
std::vector<std::string> read_texts(const SceneEntry& entry);
std::vector<double> read_number_list(const SceneEntry& entry, const Range& range);
/// A table with one key that names a shape or a combination, beside the keys of Placement.
ShapePtr read_shape(const SceneEntry& entry);

template <class T>
std::vector<T> read_list(const SceneEntry& entry);

template <class T>
T read_value(const SceneEntry& entry, const Range& range) {
  if constexpr (k_is_optional<T>) {
    return read_value<typename T::value_type>(entry, range);
  } else if constexpr (std::is_same_v<T, double>) {
    return read_number(entry, range, range.words);
  } else if constexpr (std::is_same_v<T, int>) {
    return read_whole_number(entry, range);
  } else if constexpr (std::is_same_v<T, bool>) {
    return read_truth(entry);
  } else if constexpr (std::is_same_v<T, std::string>) {
    return read_text(entry);
  } else if constexpr (std::is_same_v<T, std::filesystem::path>) {
    return entry.document().folder / read_text(entry);
  } else if constexpr (Choice<T>) {
    return static_cast<T>(read_choice(entry, names_of<T>()));
  } else if constexpr (std::is_same_v<T, std::vector<std::string>>) {
    return read_texts(entry);
  } else if constexpr (std::is_same_v<T, std::vector<double>>) {
    return read_number_list(entry, range);
  } else if constexpr (std::is_same_v<T, Vector3>) {
    Vector3 vector;
    read_numbers(entry, range, allowed<T>(range), vector.data(), vector.size());
    return vector;
  } else if constexpr (std::is_same_v<T, std::array<double, 4>>) {
    std::array<double, 4> values;
    if (entry.node().is_number()) {
      values.fill(read_number(entry, range, range.words));
    } else {
      read_numbers(entry, range, allowed<T>(range), values.data(), values.size());
    }
    return values;
  } else if constexpr (k_is_curve<T>) {
    return read_curve<ValueOfCurve<T>>(entry, range);
  } else if constexpr (std::is_same_v<T, ShapePtr>) {
    return read_shape(entry);
  } else {
    return read_list<typename T::value_type>(entry);
  }
}

/// Whether a table must have the keys that are declared as required.
enum class Demand { required_keys, nothing };

/// Fills the declared members of `target` from the table `entry`; missing keys keep their defaults. Keys that T does not declare are
/// ignored.
template <Declared T>
void read_members(const SceneEntry& entry, T& target, Demand demand) {
  for_each_parameter<T>([&](const auto& parameter) {
    using Value = ValueOf<decltype(parameter)>;
    if (const auto member = entry.find(parameter.key, parameter.former)) {
      target.*parameter.member = read_value<Value>(*member, parameter.range);
    } else if (demand == Demand::required_keys && parameter.presence == Presence::required) {
      entry.refuse_missing(parameter.key, allowed<Value>(parameter.range));
    }
  });
}

/// Reads a table that has the keys of T and no others.
template <Declared T>
T read_table(const SceneEntry& entry, Demand demand = Demand::required_keys) {
  entry.expect_table();
  entry.refuse_unknown(keys_of<T>(), former_names_of<T>());
  T target;
  read_members(entry, target, demand);
  return target;
}

/// Reads a list of such tables.
template <class T>
std::vector<T> read_list(const SceneEntry& entry) {
  if (!entry.node().is_array()) entry.refuse("a list of tables");
  std::vector<T> list;
  for (const SceneEntry& element : entry.elements()) list.push_back(read_table<T>(element));
  return list;
}

}  // namespace bake
