// SPDX-License-Identifier: MIT
#include "experiments/report/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <regex>

#include "solver/scene/entry.h"

namespace bake::report {
namespace {

/// "-7" raised: "⁻⁷".
std::string raised(int power) {
  constexpr const char* k_digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string words;
  for (const char digit : std::to_string(power)) words += digit == '-' ? "⁻" : k_digits[digit - '0'];
  return words;
}

constexpr const char* k_times_ten = "\u00a0×\u00a010";  // no-break spaces

/// Whether a cell holds a number, perhaps with unit or sign: it does not break, and stands at the right.
bool is_number(const Html& cell) {
  const std::string& code = cell.code;
  constexpr std::size_t k_longest = 40;
  return !code.empty() && code.size() < k_longest && code.find('<') == std::string::npos &&
         (std::isdigit(static_cast<unsigned char>(code[0])) || (code[0] == '-' && code.size() > 1));
}

/// "620 000": groups of three, narrow no-break spaces between.
std::string grouped(std::string digits) {
  for (std::ptrdiff_t at = std::ssize(digits) - 3; at > (digits[0] == '-' ? 1 : 0); at -= 3)
    digits.insert(static_cast<std::size_t>(at), "\u202f");
  return digits;
}

}  // namespace

std::string base64(std::string_view bytes) {
  constexpr const char* k_letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve(bytes.size() * 4 / 3 + 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? k_letters[three >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

std::string data_address(std::string_view type, std::string_view bytes) { return fmt::format("data:{};base64,{}", type, base64(bytes)); }

Html text(std::string_view words) {
  std::string code;
  for (const char c : words) {
    if (c == '&')
      code += "&amp;";
    else if (c == '<')
      code += "&lt;";
    else if (c == '>')
      code += "&gt;";
    else if (c == '"')
      code += "&quot;";
    else if (c == '\'')
      code += "&#39;";
    else if (static_cast<unsigned char>(c) >= 0x20 || c == '\n')
      code += c;
  }
  return {code};
}

Html join(const std::vector<Html>& parts) {
  std::string code;
  for (const Html& part : parts) code += part.code;
  return {code};
}

Html element(std::string_view name, const Html& inside, std::string_view attributes) {
  return {fmt::format("<{0}{1}{2}>{3}</{0}>\n", name, attributes.empty() ? "" : " ", attributes, inside.code)};
}

Html text_with_code(std::string_view words) {
  std::string code;
  bool inside = false;
  while (true) {
    const auto tick = words.find('`');
    code += inside ? fmt::format("<code>{}</code>", text(words.substr(0, tick)).code) : text(words.substr(0, tick)).code;
    if (tick == std::string_view::npos) return {code};
    words.remove_prefix(tick + 1);
    inside = !inside;
  }
}

Html table(const std::vector<std::string>& header, const std::vector<std::vector<Html>>& rows, std::string_view caption) {
  std::string code = caption.empty() ? "" : element("caption", text(caption)).code;
  std::vector<const char*> look(header.size(), "");  // columns of numbers stand at the right
  for (std::size_t column = 0; column < header.size() && !rows.empty(); ++column)
    if (std::all_of(rows.begin(), rows.end(), [&](const auto& row) { return column < row.size() && is_number(row[column]); }))
      look[column] = " class=\"number\"";
  std::string cells;
  for (std::size_t column = 0; column < header.size(); ++column)
    cells += element("th", text(header[column]), fmt::format("scope=\"col\"{}", look[column])).code;
  code += element("thead", element("tr", {cells})).code;
  std::string body;
  for (const auto& row : rows) {
    cells.clear();
    for (std::size_t column = 0; column < row.size(); ++column) {
      const char* one = *look.at(column) || !is_number(row[column]) ? look[column] : " class=\"whole\"";
      cells += element("td", row[column], fmt::format("data-head=\"{}\"{}", text(header[column]).code, one)).code;
    }
    body += element("tr", {cells}).code;
  }
  code += element("tbody", {body}).code;
  constexpr std::size_t k_narrow = 4;  // the columns that fit on a phone
  return element("div", element("table", {code}),
                 header.size() > k_narrow ? "class=\"wide cards\" tabindex=\"0\"" : "class=\"wide\" tabindex=\"0\"");
}

Html picture(const std::filesystem::path& file, std::string_view alternative) {
  std::filesystem::path small = file;
  small.replace_extension(".jpg");
  const std::filesystem::path& found = file.extension() == ".png" && std::filesystem::exists(small) ? small : file;
  const std::string kind = found.extension().string();
  const char* type = kind == ".svg" ? "image/svg+xml" : kind == ".jpg" ? "image/jpeg" : "image/png";
  return {fmt::format("<img class=\"{}\" alt=\"{}\" src=\"{}\">\n", kind == ".svg" ? "chart" : "photo", text(alternative).code,
                      data_address(type, read_text_file(found)))};
}

std::string number(double value) {
  if (!std::isfinite(value)) return std::isnan(value) ? "none" : value > 0 ? "never" : "-inf";
  if (value == std::floor(value) && std::abs(value) < 1e15) return grouped(fmt::format("{:.0f}", value));
  return with_signs(fmt::format("{:.4g}", value));
}

std::string with_signs(std::string words) {
  for (const auto& [plain, sign] : {std::pair{"+-", "±"}, {">=", "≥"}, {"<=", "≤"}})
    for (std::size_t at; (at = words.find(plain)) != std::string::npos;) words.replace(at, 2, sign);
  static const std::regex k_power("([0-9])e([+-]?[0-9]+)");
  std::smatch found;
  while (std::regex_search(words, found, k_power))
    words = found.prefix().str() + found[1].str() + k_times_ten + raised(std::stoi(found[2])) + found.suffix().str();
  return words;
}

}  // namespace bake::report
