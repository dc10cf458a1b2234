// SPDX-License-Identifier: MIT
#include "experiments/effects/effects.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "analysis/charts/chart.h"
#include "analysis/machines/statistics.h"
#include "experiments/common/study.h"
#include "solver/core/errors.h"

namespace bake::studies {
namespace {

using nlohmann::json;

/// An effect of a scene: what it adds to a particle-step there, and the most that it changes, in units of the discretisation's error.
struct Point {
  std::string scene, effects;
  Spread added_ns;
  double influence;
  std::string quantity;
  double cpu_saved;  ///< share of the run's processor time that leaving it out saves, steps and all
};

std::vector<Point> points_of(const std::vector<Cost>& costs, const std::vector<Influence>& influences) {
  std::vector<Point> points;
  for (const Influence& i : influences)
    for (const Outcome& without : i.without) {
      if (without.combination == i.whole.combination) continue;  // a setting: compiled in whether used or not
      const auto [largest, quantity] = i.largest(without);
      points.push_back({i.whole.scene, fmt::format("{}", fmt::join(without.left_out, " and ")),
                        spread_of(added_ns(costs, i.whole.combination, without.combination)), largest, quantity,
                        1 - without.cpu_s / i.whole.cpu_s});
    }
  return points;
}

std::string in_words(const Spread& s) { return fmt::format("{:.1f} ({:.1f} to {:.1f})", s.median, s.low, s.high); }

// ---------------------------------------------------------------- JSON

json as_json(const Cost& c) {
  return {{"combination", c.name},
          {"effects", c.effects},
          {"numbers_per_particle", c.columns},
          {"scattered_numbers_per_node", c.scattered},
          {"gathered_numbers_per_node", c.gathered},
          {"bytes_per_particle", c.bytes_per_particle},
          {"bytes_per_node", c.bytes_per_node},
          {"step_limit_s", c.step_limit_s},
          {"cpu_ns_per_particle_step", c.cpu_ns},
          {"wall_ns_per_particle_step", c.wall_ns}};
}

json as_json(const Outcome& o) {
  json quantities = json::array();
  for (const Quantity& q : o.quantities) quantities.push_back({{"name", q.name}, {"unit", q.unit}, {"value", q.value}});
  return {{"left_out", o.left_out},   {"combination", o.combination},       {"dx_m", o.dx_m},
          {"quantities", quantities}, {"particle_steps", o.particle_steps}, {"cpu_s", o.cpu_s}};
}

json as_json(const std::vector<Cost>& costs, const std::vector<Influence>& influences) {
  json all{{"study", "effects"}};
  for (const Cost& c : costs) all["costs"].push_back(as_json(c));
  for (const Margin& m : all_margins())
    all["margins"].push_back({{"effect", m.effect},
                              {"kind", m.kind},
                              {"beside", m.beside},
                              {"with", m.with},
                              {"without", m.without},
                              {"added_cpu_ns", added_ns(costs, m.with, m.without)}});
  for (const Influence& i : influences) {
    json scene{{"scene", i.whole.scene}, {"whole", as_json(i.whole)}, {"other_grid", as_json(i.other)}};
    for (const Outcome& o : i.without) scene["without"].push_back(as_json(o));
    all["influence"].push_back(scene);
  }
  for (const Point& p : points_of(costs, influences))
    all["points"].push_back({{"scene", p.scene},
                             {"effects", p.effects},
                             {"added_cpu_ns", p.added_ns.median},
                             {"largest_change_over_error", p.influence},
                             {"of", p.quantity},
                             {"run_cpu_share", p.cpu_saved}});
  return all;
}

// ---------------------------------------------------------------- Markdown

std::string costs_as_markdown(const std::vector<Cost>& costs) {
  std::string text =
      "## What a combination costs\n\nThe loaf of the benchmarks, one thread, single precision: processor time per particle-step, the "
      "median of the repeats with the smallest and the largest; every repeat times every combination once, in turn. Numbers per node are "
      "those scattered and those gathered; bytes are what is stored. The step limit is the rule's for this loaf.\n\n"
      "| effects | ns per particle-step | numbers per particle | bytes | numbers per node | bytes | step limit [ms] |\n"
      "|---|---|---|---|---|---|---|\n";
  for (const Cost& c : costs)
    text += fmt::format("| {} | {} | {} | {:.0f} | {}, {} | {:.0f} | {:.3g} |\n", fmt::join(c.effects, ", "), in_words(spread_of(c.cpu_ns)),
                        c.columns, c.bytes_per_particle, c.scattered, c.gathered, c.bytes_per_node, 1e3 * c.step_limit_s);
  text +=
      "\n## What an effect adds\n\nDifferences of two combinations, repeat by repeat. \"alone\": with the least that it needs; \"last\": "
      "with all others that do not need it.\n\n| effect | | beside | adds [ns per particle-step] | of the whole |\n|---|---|---|---|---|\n";
  for (const Margin& m : all_margins()) {
    const auto whole = std::find_if(costs.begin(), costs.end(), [&](const Cost& c) { return c.name == m.with; });
    const Spread added = spread_of(added_ns(costs, m.with, m.without));
    text += fmt::format("| {} | {} | {} | {} | {:.0f} % |\n", m.effect, m.kind, m.beside, in_words(added),
                        100 * added.median / spread_of(whole->cpu_ns).median);
  }
  return text;
}

std::string influence_as_markdown(const Influence& i) {
  std::string text = fmt::format("### {}\n\n| | ", i.whole.scene);
  for (const Quantity& q : i.whole.quantities) text += fmt::format("{}{} | ", q.name, q.unit == "1" ? "" : fmt::format(" [{}]", q.unit));
  text += "particle-steps | processor time [s] |\n|---|";
  for (std::size_t q = 0; q < i.whole.quantities.size() + 2; ++q) text += "---|";
  text += "\n";
  const auto cost = [](const Outcome& o) { return fmt::format(" {:.3g} | {:.1f} |\n", o.particle_steps, o.cpu_s); };
  const auto values = [&](const std::string& name, const Outcome& o) {
    text += fmt::format("| {} |", name);
    for (const Quantity& q : o.quantities) text += fmt::format(" {:.4g} |", q.value);
    text += cost(o);
  };
  values(fmt::format("dx = {:.4g} m", i.whole.dx_m), i.whole);
  values(fmt::format("dx = {:.4g} m", i.other.dx_m), i.other);
  text += "| yardstick: their difference |";
  for (std::size_t q = 0; q < i.whole.quantities.size(); ++q) text += fmt::format(" {:.2g} |", i.error_of(q));
  text += " | |\n";
  for (const Outcome& o : i.without) {
    text += fmt::format("| change without {} |", fmt::join(o.left_out, " and "));
    for (std::size_t q = 0; q < i.whole.quantities.size(); ++q)
      text += fmt::format(" {:+.3g} ({:.2g} times) |", i.change_of(q, o), std::abs(i.change_of(q, o)) / i.error_of(q));
    text += cost(o);
  }
  return text + "\n";
}

std::string as_markdown(const std::vector<Cost>& costs, const std::vector<Influence>& influences, bool quick) {
  std::string text =
      "<!-- SPDX-License-Identifier: MIT. Generated: bake study effects --out paper writes it anew. -->\n# What each effect costs, and "
      "what "
      "it changes\n\n";
  if (quick) text += "**The quick form: few particles, coarse grids, short runs. It shows that the study works, and no more.**\n\n";
  text += costs_as_markdown(costs);
  text +=
      "\n## What leaving it out changes\n\nEach scene at draft, at the end of its run, then with one effect after the other left out, and "
      "with it those that need it. The yardstick is the difference to the same scene on a grid of "
      "another node distance: a measure of the error that the grid makes. Where an effect is left out, what it "
      "would have changed counts as it was at the start. \"(3 times)\": three yardsticks. Subgrid diffusion is a setting of heat and "
      "water, off as `subgrid_diffusion = 0`; it is computed all the same, so its cost cannot be told this way.\n\n";
  for (const Influence& i : influences) text += influence_as_markdown(i);
  text +=
      "## Cost against influence\n\n| scene | without | adds [ns per particle-step] | of the run's processor time | largest change over "
      "its "
      "yardstick | of |\n|---|---|---|---|---|---|\n";
  for (const Point& p : points_of(costs, influences))
    text += fmt::format("| {} | {} | {} | {:.0f} % | {:.2g} | {} |\n", p.scene, p.effects, in_words(p.added_ns), 100 * p.cpu_saved,
                        p.influence, p.quantity);
  return text;
}

// ---------------------------------------------------------------- the chart

charts::Chart chart_of(const std::vector<Cost>& costs, const std::vector<Influence>& influences) {
  using namespace charts;
  Panel cost{"(a) what a combination costs", {"processor time per particle-step", "ns"}, {""}};
  Series bars{"smallest to largest", Kind::line}, middles{"median", Kind::points};
  bars.colour = middles.colour = palette(0);
  auto row = static_cast<double>(costs.size());
  cost.y.range = {0, row + 1};
  double most = 0;
  for (const Cost& c : costs) {
    const Spread s = spread_of(c.cpu_ns);
    cost.y.tics.push_back({row, c.name});
    for (const double x : {s.low, s.high}) bars.x.push_back(x), bars.y.push_back(row);
    bars.x.push_back(s.high), bars.y.push_back(NAN);
    middles.x.push_back(s.median), middles.y.push_back(row);
    most = std::max(most, s.high);
    row -= 1;
  }
  cost.x.range = {0, 1.05 * most};
  cost.series = {bars, middles};
  cost.legend = Legend::below;

  Panel influence{"(b) cost against influence",
                  {"added by the effect", "ns per particle-step"},
                  {"largest change over discretisation error", "", Scale::logarithmic}};
  constexpr Marker k_markers[] = {Marker::disc, Marker::triangle, Marker::diamond};
  std::vector<Series> scenes;
  double left = 0, right = 1, low = 1, high = 1;
  for (const Point& p : points_of(costs, influences)) {
    if (scenes.empty() || scenes.back().name != p.scene) {
      scenes.push_back({p.scene, Kind::points});
      scenes.back().marker = k_markers[(scenes.size() - 1) % std::size(k_markers)];
      scenes.back().colour = palette(scenes.size() - 1);
    }
    const double shown = std::max(p.influence, 1e-3);
    scenes.back().x.push_back(p.added_ns.median), scenes.back().y.push_back(shown);
    influence.marks.push_back({p.added_ns.median, shown, p.effects, Side::free, false, scenes.back().colour});
    left = std::min(left, p.added_ns.median), right = std::max(right, p.added_ns.median);
    low = std::min(low, shown), high = std::max(high, shown);
  }
  influence.series = scenes;
  influence.x.range = {left - 0.15 * (right - left), right + 0.25 * (right - left)};
  influence.y.range = {low / 2, high * 2};
  influence.rules.push_back({false, 1, ""});
  influence.legend = Legend::below;
  return {"effects", "What each effect costs, and what leaving it out changes", {cost, influence}, 1, 6, 3.6};
}

}  // namespace

bool run_effects(const StudyOptions& options) {
  const std::vector<Cost> costs = measure_costs(options.quick ? CostOptions{5e3, 10, 3, 5} : CostOptions{2e5, 40, 20, 9});
  const std::vector<Influence> influences = measure_influence(options.quick ? InfluenceOptions{2, 4, 0.1} : InfluenceOptions{1, 0.5, 1});
  const std::string text = as_markdown(costs, influences, options.quick);
  fmt::print("{}", text);
  write_tables(options, "effects", as_json(costs, influences), text);
  try {
    charts::write_chart(chart_of(costs, influences), options.out);
  } catch (const InputError& error) {  // no gnuplot
    fmt::print("\nno chart is drawn: {}\n", error.what());
  }
  fmt::print("\nwritten to {}\n", options.out.string());
  return true;
}

}  // namespace bake::studies
