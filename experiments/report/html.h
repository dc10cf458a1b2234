// SPDX-License-Identifier: MIT
// Pieces of HTML. Text becomes HTML here and nowhere else.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace bake::report {

/// HTML that is complete: what makes one of these has escaped its texts.
struct Html {
  std::string code;
};

/// Text as it is to be read: & < > " ' escaped, control characters left out.
Html text(std::string_view words);
/// The parts, one after the other.
Html join(const std::vector<Html>& parts);
/// <name attributes>inside</name>; `attributes` is code of ours, such as class="note".
Html element(std::string_view name, const Html& inside, std::string_view attributes = "");
/// Markdown's `code` becomes <code>, the rest is text.
Html text_with_code(std::string_view words);

/// Columns with a heading row. On a narrow page it scrolls by itself, or with many columns has a card in place of each row. `caption` may
/// be empty.
Html table(const std::vector<std::string>& header, const std::vector<std::vector<Html>>& rows, std::string_view caption = "");

/// An embedded picture (.png or .svg) with its alternative text. Throws InputError if the file cannot be read.
Html picture(const std::filesystem::path& file, std::string_view alternative);

/// Three to five digits, as people read them: "0.0231", "1.2e-07", "620 000" for whole numbers.
std::string number(double value);

}  // namespace bake::report
