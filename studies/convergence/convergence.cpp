// SPDX-License-Identifier: MIT
#include "studies/convergence/convergence.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "solver/io/atomic_file.h"
#include "solver/io/provenance.h"
#include "studies/convergence/cases.h"

namespace bake::studies {

namespace {

struct Measured {
  const Case* of;
  std::vector<Errors> errors;
  double seconds;
};

Measured measure(const Case& c, bool quick) {
  const auto start = std::chrono::steady_clock::now();
  std::vector<Errors> errors = c.measure(quick);
  return {&c, std::move(errors), std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()};
}

nlohmann::json table(const std::vector<Measured>& all, bool quick) {
  nlohmann::json rows = nlohmann::json::array();
  for (const Measured& m : all)
    for (const Errors& e : m.errors) {
      nlohmann::json row = as_json(e);
      row["case"] = m.of->name;
      row["exact_solution"] = m.of->solution;
      rows.push_back(row);
    }
  return {{"study", "convergence"}, {"quick", quick}, {"provenance", provenance()}, {"orders", rows}};
}

std::string as_markdown(const std::vector<Measured>& all) {
  std::string text =
      "<!-- SPDX-License-Identifier: MIT. Generated: bake study convergence --out paper writes it anew. -->\n"
      "# Orders of convergence\n\nRelative errors against exact solutions. An order is the least-squares slope of the errors in double "
      "logarithmic scale.\n\n| case | quantity | refined | errors | figure | band | verdict |\n|---|---|---|---|---|---|---|\n";
  for (const Measured& m : all)
    for (const Errors& e : m.errors)
      text += fmt::format("| {} | {} | {} {} | {} | {} {:.3g} | {} | {} |\n", m.of->name, e.quantity, fmt::join(e.refinements, ", "),
                          e.refined, fmt::join(short_numbers(e.errors), ", "), e.figure == Errors::Figure::order ? "order" : "largest",
                          e.value(), band_in_words(e), e.holds() ? "holds" : "MISSED");
  text += "\n## The cases, and why the bands are what they are\n";
  for (const Measured& m : all) {
    text += fmt::format("\n**{}**: {}.\n", m.of->name, m.of->solution);
    for (const Errors& e : m.errors) text += fmt::format("- {}: {}.\n", e.quantity, e.why);
  }
  return text;
}

}  // namespace

bool run_convergence(const StudyOptions& options) {
  std::vector<Measured> all;
  bool held = true;
  for (const Case& c : all_cases()) {
    all.push_back(measure(c, options.quick));
    fmt::print(stderr, "{} of {}: {}, {:.1f} s\n", all.size(), all_cases().size(), c.name, all.back().seconds);
    fmt::print("{}: {}\n", c.name, c.solution);
    for (const Errors& e : all.back().errors) {
      fmt::print("  {}\n", in_words(e));
      held &= e.holds();
    }
  }
  std::filesystem::create_directories(options.out);
  write_text_atomically(options.out / "orders.json", table(all, options.quick).dump(2) + "\n");
  write_text_atomically(options.out / "orders.md", as_markdown(all));
  fmt::print("{}; written to {}\n", held ? "every band holds" : "NOT every band holds", options.out.string());
  return held;
}

}  // namespace bake::studies
