// SPDX-License-Identifier: MIT
#include "experiments/report/html.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

#include "solver/scene/entry.h"

namespace bake::report {
namespace {

std::string base64(std::string_view bytes) {
  constexpr const char* k_letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? k_letters[three >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

/// "620 000": groups of three, narrow no-break spaces between.
std::string grouped(std::string digits) {
  for (std::ptrdiff_t at = std::ssize(digits) - 3; at > (digits[0] == '-' ? 1 : 0); at -= 3)
    digits.insert(static_cast<std::size_t>(at), "\u202f");
  return digits;
}

}  // namespace

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
  std::string cells;
  for (const std::string& name : header) cells += element("th", text(name), "scope=\"col\"").code;
  code += element("thead", element("tr", {cells})).code;
  std::string body;
  for (const auto& row : rows) {
    cells.clear();
    for (std::size_t column = 0; column < row.size(); ++column)
      cells += element("td", row[column], fmt::format("data-head=\"{}\"", text(header.at(column)).code)).code;
    body += element("tr", {cells}).code;
  }
  code += element("tbody", {body}).code;
  constexpr std::size_t k_narrow = 4;  // the columns that fit on a phone
  return element("div", element("table", {code}),
                 header.size() > k_narrow ? "class=\"wide cards\" tabindex=\"0\"" : "class=\"wide\" tabindex=\"0\"");
}

Html picture(const std::filesystem::path& file, std::string_view alternative) {
  const char* type = file.extension() == ".svg" ? "image/svg+xml" : "image/png";
  return {fmt::format("<img class=\"{}\" alt=\"{}\" src=\"data:{};base64,{}\">\n", file.extension() == ".svg" ? "chart" : "photo",
                      text(alternative).code, type, base64(read_text_file(file)))};
}

std::string number(double value) {
  if (!std::isfinite(value)) return std::isnan(value) ? "none" : value > 0 ? "never" : "-inf";
  if (value == std::floor(value) && std::abs(value) < 1e15) return grouped(fmt::format("{:.0f}", value));
  return fmt::format("{:.4g}", value);
}

}  // namespace bake::report
