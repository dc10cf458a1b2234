// SPDX-License-Identifier: MIT
// Texts of a chart (see chart.h for their markup) in the words of gnuplot and of plain text.
#pragma once

#include <string>
#include <string_view>

namespace bake::charts {

/// A quoted string for gnuplot's enhanced mode: what is special there is escaped, mathematics becomes italics, lower and raised text.
std::string gnuplot_text(std::string_view text);
/// The same as plain text: dollar signs and groups' braces are dropped.
std::string plain_text(std::string_view text);
/// A cell of a CSV file: quoted if need be (RFC 4180).
std::string csv_cell(const std::string& text);

}  // namespace bake::charts
