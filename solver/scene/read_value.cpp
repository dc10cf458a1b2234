// SPDX-License-Identifier: MIT
#include "solver/scene/read_value.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "solver/scene/nearest.h"

namespace bake {

double read_number(const SceneEntry& entry, const Range& range, std::string_view allowed_words) {
  const auto number = entry.node().is_number() ? entry.node().value<double>() : std::nullopt;
  if (!number || !range.contains(*number)) entry.refuse(allowed_words);
  return *number;
}

int read_whole_number(const SceneEntry& entry, const Range& range) {
  const auto* number = entry.node().as_integer();
  const bool fits = number && number->get() >= std::numeric_limits<int>::min() && number->get() <= std::numeric_limits<int>::max();
  if (number && !fits) entry.refuse(fmt::format("{}, up to {}", range.words, std::numeric_limits<int>::max()));
  if (!fits || !range.contains(static_cast<double>(number->get()))) entry.refuse(range.words);
  return static_cast<int>(number->get());
}

bool read_truth(const SceneEntry& entry) {
  const auto* truth = entry.node().as_boolean();
  if (!truth) entry.refuse(allowed<bool>({}));
  return truth->get();
}

std::string read_text(const SceneEntry& entry) {
  const auto* text = entry.node().as_string();
  if (!text) entry.refuse(allowed<std::string>({}));
  return text->get();
}

std::size_t read_choice(const SceneEntry& entry, const std::vector<std::string>& names) {
  const auto* text = entry.node().as_string();
  if (!text) entry.refuse(fmt::format("\"{}\"", fmt::join(names, "\", \"")));
  const auto found = std::find(names.begin(), names.end(), text->get());
  if (found == names.end()) entry.complain(fmt::format("unknown name '{}', {}", quotable(text->get()), suggestion(text->get(), names)));
  return static_cast<std::size_t>(found - names.begin());
}

void read_numbers(const SceneEntry& entry, const Range& range, std::string_view allowed_words, double* numbers, std::size_t count) {
  const auto* list = entry.node().as_array();
  if (!list || list->size() != count) entry.refuse(allowed_words);
  for (const SceneEntry& element : entry.elements()) *numbers++ = read_number(element, range, range.words);
}

std::vector<std::string> read_texts(const SceneEntry& entry) {
  if (entry.node().is_string()) return {read_text(entry)};
  if (!entry.node().is_array()) entry.refuse(allowed<std::vector<std::string>>({}));
  std::vector<std::string> texts;
  for (const SceneEntry& element : entry.elements()) texts.push_back(read_text(element));
  return texts;
}

std::vector<double> read_number_list(const SceneEntry& entry, const Range& range) {
  const std::string words = allowed<std::vector<double>>(range);
  if (!entry.node().is_array()) return {read_number(entry, range, words)};
  std::vector<double> numbers;
  for (const SceneEntry& element : entry.elements()) numbers.push_back(read_number(element, range, range.words));
  return numbers;
}

namespace {

template <class Value>
constexpr const char* k_curve_point = "a pair [time_s, value]";
template <>
constexpr const char* k_curve_point<Vector3> = "a pair [time_s, [x, y, z]]";

template <class Value>
typename CurveOf<Value>::Point read_curve_point(const SceneEntry& entry, const Range& range) {
  const auto* pair = entry.node().as_array();
  if (!pair || pair->size() != 2) entry.refuse(k_curve_point<Value>);
  const std::vector<SceneEntry> parts = entry.elements();
  return {read_number(parts[0], any_number, any_number.words), read_value<Value>(parts[1], range)};
}

/// The constant that an entry is, if it is no list of pairs.
std::optional<double> read_constant(const SceneEntry& entry, const Range& range, const std::string& words, double) {
  if (!entry.node().is_number()) return {};
  return read_number(entry, range, words);
}

std::optional<Vector3> read_constant(const SceneEntry& entry, const Range& range, const std::string& words, const Vector3&) {
  const auto* list = entry.node().as_array();
  if (!list || list->empty() || list->front().is_array()) return {};
  Vector3 vector;
  read_numbers(entry, range, words, vector.data(), vector.size());
  return vector;
}

}  // namespace

template <class Value>
CurveOf<Value> read_curve(const SceneEntry& entry, const Range& range) {
  const std::string words = allowed<CurveOf<Value>>(range);
  if (const auto constant = read_constant(entry, range, words, Value{})) return {*constant};
  const auto* list = entry.node().as_array();
  if (!list || list->empty()) entry.refuse(words);
  CurveOf<Value> curve;
  for (const SceneEntry& element : entry.elements()) {
    const auto point = read_curve_point<Value>(element, range);
    const bool rises = curve.points.empty() || point.at > curve.points.back().at;
    if (!rises) {
      element.complain(fmt::format("found time {} after time {}, allowed: rising times", point.at, curve.points.back().at));
    }
    curve.points.push_back(point);
  }
  return curve;
}

template Curve read_curve(const SceneEntry&, const Range&);
template VectorCurve read_curve(const SceneEntry&, const Range&);

}  // namespace bake
