// SPDX-License-Identifier: MIT
// Translates texts of a chart (chart.h describes their markup) for gnuplot and into plain text.
#pragma once

#include <string>
#include <string_view>

namespace bake::charts {

/// A quoted string for gnuplot's enhanced mode: special characters are escaped; mathematics becomes italic, lowered and raised text.
std::string gnuplot_text(std::string_view text);
/// The text as plain text, without dollar signs and the braces of groups.
std::string plain_text(std::string_view text);
/// A cell of a CSV file: quoted if necessary (RFC 4180).
std::string csv_cell(const std::string& text);

}  // namespace bake::charts
