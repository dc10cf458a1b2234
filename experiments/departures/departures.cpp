// SPDX-License-Identifier: MIT
#include "experiments/departures/departures.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "experiments/common/study.h"
#include "solver/core/errors.h"

namespace bake::studies {

namespace {

constexpr std::string_view k_mark = "DEPARTS [Ding19 ";

/// The text of a comment line, without its slashes; nothing if the line is no comment.
std::string comment_text(const std::string& line) {
  const std::size_t at = line.find("//");
  if (at == std::string::npos || line.find_first_not_of(' ') != at) return {};
  const std::size_t text = line.find_first_not_of("/ ", at);
  return text == std::string::npos ? "" : line.substr(text);
}

/// A mark goes on to the end of the comment, an empty line or the next mark.
void read_departures(const std::filesystem::path& file, const std::string& name, std::vector<Departure>& all) {
  std::ifstream in(file);
  bool open = false;
  for (std::string line; std::getline(in, line);) {
    const std::string text = comment_text(line);
    if (text.rfind(k_mark, 0) == 0) {
      const std::size_t end = text.find("]: ");
      if (end == std::string::npos) continue;
      all.push_back({name, text.substr(k_mark.size(), end - k_mark.size()), text.substr(end + 3)});
      open = true;
    } else if (text.empty()) {
      open = false;
    } else if (open) {
      all.back().text += " " + text;
    }
  }
}

std::string as_markdown(const std::vector<Consequence>& consequences, const std::vector<Departure>& departures) {
  std::string text =
      "<!-- SPDX-License-Identifier: MIT. Generated: bake study departures --out paper writes it anew. -->\n"
      "# Where this solver departs from the printed equations\n\n"
      "Ding et al. 2019, doi:10.1145/3355089.3356537, is the method; some of its equations cannot be meant as printed. Where the "
      "printed form can be run (`form = \"published\"`, `subgrid_diffusion = 0`), this is what it does to a small case.\n\n"
      "## Measured\n\n| equation | printed | instead | measured | right is | as printed | here |\n|---|---|---|---|---|---|---|\n";
  for (const Consequence& c : consequences)
    text += fmt::format("| {} | {} | {} | {} | {} | {:.3g} | {:.3g} |\n", c.equation, c.printed, c.instead, c.measured, c.expected,
                        c.published, c.standard);
  text += "\n## All departures, as they stand in the sources\n\n| equation | file | departure |\n|---|---|---|\n";
  for (const Departure& d : departures) text += fmt::format("| {} | `{}` | {} |\n", d.equation, d.file, d.text);
  return text;
}

}  // namespace

std::vector<Departure> find_departures(const std::filesystem::path& sources) {
  if (!std::filesystem::is_directory(sources / "solver"))
    throw InputError(fmt::format("{}: found no sources, allowed: the folder that the program was built from", sources.string()));
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(sources / "solver"))
    if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<Departure> all;
  for (const auto& file : files) read_departures(file, file.lexically_relative(sources).generic_string(), all);
  return all;
}

bool run_departures(const StudyOptions& options) {
  const std::vector<Departure> departures = find_departures(BAKE_SOURCE_DIR);
  const std::vector<Consequence> consequences = all_consequences(options.quick);
  bool held = true;
  nlohmann::json rows = nlohmann::json::array();
  for (const Consequence& c : consequences) {
    held &= c.departs;
    fmt::print("{:<12} {}: here {:.4g}, as printed {:.4g}{}\n", c.equation, c.measured, c.standard, c.published,
               c.departs ? "" : "   THE DIFFERENCE IS NOT THERE");
    rows.push_back({{"equation", c.equation},
                    {"printed", c.printed},
                    {"instead", c.instead},
                    {"measured", c.measured},
                    {"expected", c.expected},
                    {"standard", c.standard},
                    {"published", c.published},
                    {"departs", c.departs}});
  }
  write_tables(options, "departures", {{"study", "departures"}, {"consequences", rows}}, as_markdown(consequences, departures));
  fmt::print("\n{} departures in the sources; written to {}\n", departures.size(), options.out.string());
  return held;
}

}  // namespace bake::studies
