// SPDX-License-Identifier: MIT
// Pieces of HTML. Text becomes HTML here and nowhere else.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace bake::report {

/// A complete piece of HTML, whose texts have been escaped.
struct Html {
  std::string code;
};

/// Makes HTML of plain text: escapes & < > " ' and omits control characters.
Html text(std::string_view words);
/// Concatenates the parts.
Html join(const std::vector<Html>& parts);
/// <name attributes>inside</name>; `attributes` is not escaped, so it must come from our own code, such as class="note".
Html element(std::string_view name, const Html& inside, std::string_view attributes = "");
/// Makes HTML of text in which Markdown's `code` becomes <code>.
Html text_with_code(std::string_view words);

/// A table with a heading row. On a narrow page it scrolls sideways or, with many columns, shows a card for each row. `caption` may be
/// empty.
Html table(const std::vector<std::string>& header, const std::vector<std::vector<Html>>& rows, std::string_view caption = "");

/// An embedded picture (.png, .jpg or .svg) with its alternative text; the .jpg beside a .png stands for it. Throws InputError if the file
/// cannot be read.
Html picture(const std::filesystem::path& file, std::string_view alternative);

/// "data:<type>;base64,..."
std::string data_address(std::string_view type, std::string_view bytes);
/// The bytes as letters, digits, + and / [RFC 4648].
std::string base64(std::string_view bytes);

/// A number with three to five digits for people: "0.0231", "1.2 × 10⁻⁷", "620 000" for whole numbers. It does not break.
std::string number(double value);
/// The same for the numbers in words that bake wrote, and their signs: ">= 1.2e-07 +- 1" becomes "≥ 1.2 × 10⁻⁷ ± 1".
std::string with_signs(std::string words);

}  // namespace bake::report
