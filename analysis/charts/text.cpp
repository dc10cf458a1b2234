// SPDX-License-Identifier: MIT
#include "analysis/charts/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace bake::charts {
namespace {

/// Bytes of the UTF-8 character that begins with `first`.
std::size_t length_of_character(char first) {
  const auto byte = static_cast<unsigned char>(first);
  return byte < 0xc0 ? 1 : byte < 0xe0 ? 2 : byte < 0xf0 ? 3 : 4;
}

/// Latin and Greek letters are variables; digits and signs are not.
bool is_letter(std::string_view character) {
  const auto byte = static_cast<unsigned char>(character[0]);
  return byte < 0x80 ? std::isalpha(byte) != 0 : byte == 0xce || byte == 0xcf;
}

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (std::string_view("^_{}@&~\\").find(c) != std::string_view::npos) result += '\\';
    if (c == '\'') result += '\'';  // gnuplot's escape within single quotes
    result += c == '\n' ? ' ' : c;
  }
  return result;
}

/// Removes the character or {group} at the beginning of `text` and returns it.
std::string_view take_group(std::string_view& text) {
  const bool braces = !text.empty() && text[0] == '{';
  std::size_t size = 0;
  if (braces) {
    int depth = 0;
    do {
      depth += text[size] == '{' ? 1 : text[size] == '}' ? -1 : 0;
      ++size;
    } while (depth > 0 && size < text.size());
  } else if (!text.empty()) {
    size = std::min(length_of_character(text[0]), text.size());
  }
  std::string_view group = text.substr(0, size);
  text.remove_prefix(size);
  return braces ? group.substr(1, group.size() - 2) : group;
}

std::size_t letters_in(std::string_view text) {
  std::size_t count = 0;
  while (!text.empty()) {
    count += is_letter(text) ? 1 : 0;
    text.remove_prefix(std::min(length_of_character(text[0]), text.size()));
  }
  return count;
}

std::string mathematics(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const bool script = text[0] == '_' || text[0] == '^';
    if (script) {
      result += text[0];
      text.remove_prefix(1);
    }
    const std::string_view group = take_group(text);
    const bool single = !group.empty() && group.size() <= length_of_character(group[0]);
    const bool upright = script && letters_in(group) > 1 && group.find_first_of("_^") == std::string_view::npos;
    std::string set;
    if (group == "-")
      set = "−";
    else if (single)
      set = is_letter(group) ? fmt::format("{{/:Italic {}}}", group) : escaped(group);
    else
      set = upright ? escaped(group) : mathematics(group);
    result += script ? fmt::format("{{{}}}", set) : set;
  }
  return result;
}

/// Calls `words` and `formula` with the stretches outside and between dollar signs.
template <class Words, class Formula>
void walk(std::string_view text, Words words, Formula formula) {
  while (!text.empty()) {
    const std::size_t dollar = text.find('$');
    words(text.substr(0, dollar));
    if (dollar == std::string_view::npos) return;
    const std::size_t next = text.find('$', dollar + 1);
    if (next == dollar + 1 || next == std::string_view::npos)
      words("$");
    else
      formula(text.substr(dollar + 1, next - dollar - 1));
    text.remove_prefix(next == std::string_view::npos ? dollar + 1 : next + 1);
  }
}

}  // namespace

std::string gnuplot_text(std::string_view text) {
  std::string result = "'";
  walk(
      text, [&](std::string_view words) { result += escaped(words); }, [&](std::string_view formula) { result += mathematics(formula); });
  return result + "'";
}

std::string plain_text(std::string_view text) {
  std::string result;
  const auto formula = [&](std::string_view words) {
    for (const char c : words)
      if (c != '{' && c != '}') result += c;
  };
  walk(
      text, [&](std::string_view words) { result += words; }, formula);
  return result;
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + '"';
}

}  // namespace bake::charts
