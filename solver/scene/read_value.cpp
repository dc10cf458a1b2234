// SPDX-License-Identifier: MIT
#include "solver/scene/read_value.h"

#include <algorithm>
#include <cstdint>

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

Curve::Point read_curve_point(const SceneEntry& entry, const Range& range) {
  const auto* pair = entry.node().as_array();
  if (!pair || pair->size() != 2) entry.refuse("a pair [time_s, value]");
  const std::vector<SceneEntry> parts = entry.elements();
  return {read_number(parts[0], any_number, any_number.words), read_number(parts[1], range, range.words)};
}

}  // namespace

Curve read_curve(const SceneEntry& entry, const Range& range) {
  if (entry.node().is_number()) return {read_number(entry, range, allowed<Curve>(range))};
  const auto* list = entry.node().as_array();
  if (!list || list->empty()) entry.refuse(allowed<Curve>(range));
  Curve curve;
  for (const SceneEntry& element : entry.elements()) {
    const Curve::Point point = read_curve_point(element, range);
    const bool rises = curve.points.empty() || point.at > curve.points.back().at;
    if (!rises) {
      element.complain(fmt::format("found time {} after time {}, allowed: rising times", point.at, curve.points.back().at));
    }
    curve.points.push_back(point);
  }
  return curve;
}

}  // namespace bake
