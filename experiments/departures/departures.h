// SPDX-License-Identifier: MIT
// What running the equations as printed does to a small case, beside what the standard forms do; and every DEPARTS comment of the
// sources, so that paper/departures.md is written by no hand.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bake::studies {

/// One printed form, run.
struct Consequence {
  std::string equation;  ///< "[Ding19 Eq. 25, 27]"
  std::string printed;   ///< what the printed form is
  std::string instead;   ///< what is done instead, and why
  std::string measured;  ///< what the number is, with its unit
  std::string expected;  ///< what is right, and why
  double standard, published;
  bool departs;  ///< does the number show the difference that is claimed?
};

std::vector<Consequence> all_consequences(bool quick);

/// A DEPARTS comment of the sources.
struct Departure {
  std::string file;      ///< from the root of the sources
  std::string equation;  ///< as it stands in the brackets
  std::string text;      ///< the comment, in one line
};
/// All of them, by file. Throws InputError if the sources are not there.
std::vector<Departure> find_departures(const std::filesystem::path& sources);

}  // namespace bake::studies
