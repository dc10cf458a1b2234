// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "experiments/accuracy/result.h"

namespace bake::studies::accuracy {

namespace {

std::string or_dash(const std::optional<double>& value) { return value ? fmt::format("{:.2f}", *value) : "-"; }

std::string seconds(const Spread& s) {
  return s.low < s.high ? fmt::format("{} ({} to {})", brief(s.median), brief(s.low), brief(s.high)) : brief(s.median);
}

std::string front_table(const CaseResult& result) {
  std::string text = "| | on the front | error | particle-steps | processor time [s] | wall time [s] |\n|---|---|---|---|---|---|\n";
  int number = 0;
  for (const Point* p : front(result.curves(), particle_steps))
    text += fmt::format("| {} | {} | {} | {:.2g} | {} | {} |\n", ++number, words_of(*p), percent(p->settled), p->particle_steps,
                        brief(p->cpu_s.median), seconds(p->wall_s));
  return text;
}

std::string goals_table(const CaseResult& result) {
  std::string text = "| error at most | cheapest in particle-steps | cheapest in processor time |\n|---|---|---|\n";
  for (const double goal : k_goals) {
    const Point *steps = cheapest(result.curves(), goal, particle_steps), *cpu = cheapest(result.curves(), goal, cpu_seconds);
    text += fmt::format("| {:g} % | {} | {} |\n", 100 * goal,
                        steps ? fmt::format("{}: {:.2g}", words_of(*steps), steps->particle_steps) : "not reached",
                        cpu ? fmt::format("{}: {} s", words_of(*cpu), brief(cpu->cpu_s.median)) : "not reached");
  }
  return text;
}

std::string knobs_table(const CaseResult& result) {
  std::string text =
      "| setting | order in dx | at so many cells | error | over the default's | particle-steps, times the default's | processor time, "
      "times "
      "the default's |\n|---|---|---|---|---|---|---|\n";
  for (const Curve& curve : result.curves()) {
    const auto [base, p] = result.common(curve);
    if (!p) {
      text += fmt::format("| {} | - | - | failed: {} | | | |\n", curve.label, curve.points.back().failure);
      continue;
    }
    text += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", curve.label, or_dash(order(curve)), p->variant.cells, percent(p->error),
                        brief(p->error / base->error), brief(p->particle_steps / base->particle_steps),
                        brief(p->cpu_s.median / base->cpu_s.median));
  }
  return text;
}

std::string range(const Spread& s) {
  return s.high > 1.02 * s.low ? fmt::format("{:.0f} ({:.0f} to {:.0f})", s.median, s.low, s.high) : fmt::format("{:.0f}", s.median);
}

/// What one of the machine's cores could do at the time.
std::string limits(const MachineSpeed& speed) {
  if (speed.known == 0) return "its own speed was not measured beside.";
  return fmt::format(
      "one thread of it moved {} GB/s (triad) and did {} GFLOP/s in single and {} in double precision (multiply-adds in registers), "
      "measured by the same program before each pass.",
      range(speed.triad_GB_per_s), range(speed.single_GFLOPs), range(speed.double_GFLOPs));
}

/// What `load` processes that waited or ran did to the times: a run that waits for its core takes longer than its processor time.
std::string disturbance(double load, double wall_over_cpu) {
  if (wall_over_cpu > 1.05)
    return "other programs shared the processors, so that **the times are not to be concluded from**; errors and particle-steps do not "
           "depend on it";
  const std::string waited =
      fmt::format("no run waited for its core (wall time at most {:.1f} % over processor time)", 100 * (wall_over_cpu - 1));
  return load > 1.5 ? "other programs ran beside; " + waited + ", but caches and memory it shared" : waited;
}

/// How often, under which load.
std::string timing(const std::vector<CaseResult>& results) {
  constexpr double k_measurable_s = 0.05;
  int variants = 0, often = 0;
  double load = 0, wall_over_cpu = 1;
  for (const CaseResult& r : results)
    for (const Curve& curve : r.curves())
      for (const Point& p : curve.points) {
        if (!p.failed()) ++variants, often += p.repeats >= k_repeats;
        load = std::max(load, p.load_average.high);
        if (p.cpu_s.median > k_measurable_s) wall_over_cpu = std::max(wall_over_cpu, p.wall_s.median / p.cpu_s.median);
      }
  const std::string repeated =
      often == variants
          ? fmt::format("each at least {} times", k_repeats)
          : fmt::format("{} of {} at least {} times, the rest fewer (--quick, or a study that was stopped)", often, variants, k_repeats);
  return fmt::format("The variants were run in turn, {}; medians are given, with the spread. The load average went up to {:.1f}: {}.",
                     repeated, load, disturbance(load, wall_over_cpu));
}

/// The default's errors of each quantity; empty if the case has but one.
std::string quantities_table(const CaseResult& result) {
  const Curve* base = result.default_curve();
  if (!base || base->points.front().parts.size() < 2) return "";
  std::string head = "| error of the default, at so many cells |", rule = "|---|", rows;
  for (const auto& [quantity, error] : base->points.front().parts) head += fmt::format(" {} |", quantity), rule += "---|";
  for (const Point& p : base->points) {
    if (p.failed()) continue;
    rows += fmt::format("| {} |", p.variant.cells);
    for (const auto& [quantity, error] : p.parts) rows += fmt::format(" {} |", percent(error));
    rows += fmt::format(" {} |\n", percent(p.error));
  }
  return fmt::format("\n{} rms |\n{}---|\n{}", head, rule, rows);
}

std::string section(const CaseResult& result) {
  const Case& c = result.of();
  std::string text = fmt::format("\n## {}\n\n{}{}. Cells are those of {}.\n\n", c.name, static_cast<char>(std::toupper(c.measured[0])),
                                 c.measured.substr(1), c.cells_of);
  text += fmt::format("![error against cost](accuracy/{}.svg)\n\n", c.name);
  for (const std::string& sentence : conclusions(result)) text += fmt::format("- {}\n", sentence);
  return text + quantities_table(result) + "\n" + front_table(result) + "\n" + goals_table(result) + "\n" + knobs_table(result);
}

/// The paper's staged step beside the fused one, both in double precision and with the same steps; empty if it was not measured.
std::string staged(const CaseResult& result) {
  for (const Curve& curve : result.curves()) {
    if (curve.points.front().variant.by != By::textbook) continue;
    const auto [fused, textbook] = finest_common(result.curve_of("double"), &curve);
    if (!fused) continue;
    return fmt::format(
        "The paper's staged step, as the textbook baker takes it, has at {} cells an error of {}, that of the fused step with the same dt "
        "in double precision to {:.0e} of it, and takes {} times its processor time: an upper bound of what staging costs.",
        textbook->variant.cells, percent(textbook->error), std::max(std::abs(textbook->error / fused->error - 1), 1e-16),
        brief(textbook->cpu_s.median / fused->cpu_s.median));
  }
  return "";
}

std::string listed(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, ", ")); }

}  // namespace

std::vector<std::string> conclusions(const CaseResult& result) {
  std::vector<std::string> all;
  const Curve* base = result.default_curve();
  if (!base) return all;
  if (const auto p = exponent(*base, particle_steps); p && *p > 0)
    all.push_back(
        fmt::format("With the default settings the error falls with dx to the power {} and with the particle-steps to the power "
                    "{:.2f}: half the error costs {} times the particle-steps.",
                    or_dash(order(*base)), *p, brief(cost_of_halving(*p))));
  else
    all.push_back("With the default settings the error does not fall with dx.");
  std::vector<std::string> better, worse, failed;
  for (const Curve& curve : result.curves()) {
    const auto [a, b] = result.common(curve);
    if (curve.label == "default" || curve.points.front().variant.by == By::textbook) continue;
    if (std::any_of(curve.points.begin(), curve.points.end(), [](const Point& p) { return p.failed(); })) failed.push_back(curve.label);
    if (!b) continue;
    const double error = b->error / a->error;
    if (error < 0.8)
      better.push_back(fmt::format("{} ({} of the error for {} times the processor time)", curve.label, brief(error),
                                   brief(b->cpu_s.median / a->cpu_s.median)));
    if (error > 1.25) worse.push_back(fmt::format("{} ({} times)", curve.label, brief(error)));
  }
  if (!better.empty()) all.push_back(fmt::format("Less error than the default at the same dx: {}.", listed(better)));
  if (!worse.empty()) all.push_back(fmt::format("More error at the same dx: {}.", listed(worse)));
  if (!failed.empty()) all.push_back(fmt::format("Failed at some dx: {}.", listed(failed)));
  if (const std::string sentence = staged(result); !sentence.empty()) all.push_back(sentence);
  for (const QualityResult& q : result.qualities())
    all.push_back(q.excess_particle_steps <= k_allowed_excess
                      ? fmt::format("The scene's {} is {} ({}), {} times the cheapest that is as good: within {}.", q.quality,
                                    percent(q.point->error), words_of(*q.point), brief(q.excess_particle_steps), k_allowed_excess)
                      : fmt::format("The scene's {} has an error of {}; {} is as good for a part of the cost: 1/{} of the particle-steps, "
                                    "1/{} of the processor time.",
                                    q.quality, percent(q.point->error), words_of(*q.better), brief(q.excess_particle_steps),
                                    brief(q.point->cpu_s.median / q.better->cpu_s.median)));
  return all;
}

std::string as_markdown(const std::vector<CaseResult>& results, const nlohmann::json& provenance) {
  std::string text =
      "<!-- SPDX-License-Identifier: MIT. Generated: bake study accuracy --out paper writes it anew. -->\n"
      "# What accuracy costs\n\n"
      "Relative errors, against exact solutions or against a fine run in double precision ([reference/accuracy](../reference/accuracy)), "
      "beside what the run cost: its particle-steps, which no machine changes, and its time with one thread. Each setting is turned alone "
      "from the solver's defaults, at several dx; some are turned together. An error counts as *settled*, and only then for fronts and "
      "tables, if no finer grid of the same setting has a larger one. A particle-step is not the same work for every setting: a cubic "
      "kernel has 64 nodes instead of 27, double precision halves the lanes, backward Euler solves a system in each step; processor time "
      "tells that.\n\n"
      "*Textbook* is the paper's step in its stages, scatter, grid, gather, as [reference/textbook](../reference/textbook/README.md) takes "
      "it, with the lengths of step that the solver chooses. It is written to be read: double precision, no vectors, a dense grid over the "
      "whole domain, cleared in each step. So its time bounds from above what staging costs and is no measure of a staged program that is "
      "written for speed; it is on no front. It has the coarsest dx only; the vortex, whose force it does not know, dough_pull, whose "
      "plastic work it does not book, and cookie and bread, too large for it, are without it.\n\n"
      "Scenes without a case: the tear, whose loaf is the bread's with the bread's settings; the falling ball, whose second bounce no "
      "affordable grid settles (radius of 30 cells: still 5 % from that of 20) and whose settings are the elastic bar's; and those of "
      "single features, which are there to show how a thing is written.\n\n";
  text +=
      fmt::format("{} Machine: {}; {} Every finished measurement stands in accuracy/*.jsonl with its date, the load and these limits.\n",
                  timing(results), provenance.at("machine").at("cpu").get<std::string>(), limits(speed_of(results)));
  for (const CaseResult& r : results) text += section(r);
  return text;
}

}  // namespace bake::studies::accuracy
