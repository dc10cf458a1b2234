// SPDX-License-Identifier: MIT
#include "experiments/stability/stability.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "experiments/common/study.h"
#include "solver/scene/settings.h"

namespace bake::studies {

namespace {

/// time.safety unless a scene says otherwise.
double rule_safety() { return TimeSettings{}.safety; }

std::string in_words(const Edge& e) {
  const std::string found = e.largest_safety >= k_most_safety ? fmt::format("over {:.3g}", e.factor) : fmt::format("{:.2f}", e.factor);
  return fmt::format("{:<34} {:<24} {:>9.4g}   {:>9}   {}", e.probe.map, e.probe.knob, e.probe.value, found,
                     !e.safe()    ? "UNSAFE"
                     : !e.sharp() ? "TOO CAREFUL"
                                  : "holds");
}

nlohmann::json as_json(const Edge& e) {
  return {{"map", e.probe.map},
          {"knob", e.probe.knob},
          {"value", e.probe.value},
          {"has_limit", e.probe.has_limit},
          {"largest_safety", e.largest_safety},
          {"factor", e.factor},
          {"safe", e.safe()},
          {"sharp", e.sharp()}};
}

std::string as_markdown(const std::vector<Edge>& edges) {
  std::string text =
      "<!-- SPDX-License-Identifier: MIT. Generated: bake study stability --out paper writes it anew. -->\n"
      "# Where the method breaks, and where the time-step rule stops before it\n\n"
      "Largest step with which nothing grows in 300 steps, over the step that the rule takes. The rule must be safe (above 1) and no more "
      "than three times too careful; backward Euler has no edge to be found.\n\n"
      "| map | knob | value | largest stable step over the rule's | verdict |\n|---|---|---|---|---|\n";
  for (const Edge& e : edges)
    text += fmt::format("| {} | {} | {:g} | {}{:.3g} | {} |\n", e.probe.map, e.probe.knob, e.probe.value,
                        e.largest_safety >= k_most_safety ? "over " : "", e.factor,
                        !e.safe()    ? "**unsafe**"
                        : !e.sharp() ? "**too careful**"
                                     : "holds");
  return text;
}

}  // namespace

bool Edge::safe() const { return factor >= 1; }
bool Edge::sharp() const { return !probe.has_limit || factor <= 3; }

Edge find_edge(const Probe& probe) {
  double low = rule_safety() / 4, high = k_most_safety;
  const auto edge = [&](double safety) { return Edge{probe, safety, probe.step(safety) / probe.step(rule_safety())}; };
  if (!probe.holds(low)) return {probe, 0, 0};
  if (probe.holds(high)) return edge(high);
  while (high > 1.03 * low) {
    const double middle = std::sqrt(low * high);
    (probe.holds(middle) ? low : high) = middle;
  }
  return edge(low);
}

bool run_stability(const StudyOptions& options) {
  const std::vector<Probe> probes = all_probes(options.quick);
  std::vector<Edge> edges;
  bool held = true;
  for (const Probe& probe : probes) {
    edges.push_back(find_edge(probe));
    held &= edges.back().safe() && edges.back().sharp();
    fmt::print("{}\n", in_words(edges.back()));
    std::fflush(stdout);
  }
  nlohmann::json rows = nlohmann::json::array();
  for (const Edge& e : edges) rows.push_back(as_json(e));
  write_tables(options, "stability", {{"study", "stability"}, {"rule_safety", rule_safety()}, {"edges", rows}}, as_markdown(edges));
  fmt::print("\n{}; written to {}\n", held ? "the rule is safe and sharp everywhere" : "the rule is NOT safe and sharp everywhere",
             options.out.string());
  return held;
}

}  // namespace bake::studies
