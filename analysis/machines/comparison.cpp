// SPDX-License-Identifier: MIT
#include "analysis/machines/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/core/errors.h"

namespace bake::studies {
namespace {

/// The limit that applies to a benchmark, for the number of threads in its name; parts of the law run with one thread.
double rate_for(const std::string& name, const MachineLimit& limit) {
  const bool all = name.find("/threads:") != std::string::npos && !name.ends_with("/threads:1");
  return all ? limit.all_threads : limit.one_thread;
}

double fma_for(const std::string& name, const BenchFile& bench) {
  return rate_for(name, name.find("/double") != std::string::npos ? bench.double_GFLOPs : bench.single_GFLOPs);
}

BenchRatio::Verdict verdict_of(const MannWhitney& test, double ratio) {
  using enum BenchRatio::Verdict;
  if (test.p_smallest >= k_significant) return too_few;
  if (test.p >= k_significant) return noise;
  return ratio > 1 ? faster : slower;
}

std::string word_of(BenchRatio::Verdict verdict) {
  switch (verdict) {
    case BenchRatio::Verdict::faster:
      return "faster";
    case BenchRatio::Verdict::slower:
      return "SLOWER";
    case BenchRatio::Verdict::noise:
      return "noise";
    default:
      return "too few repeats to tell";
  }
}

std::string interval(const Estimate& e) { return e.low ? fmt::format("{:.3f} to {:.3f}", *e.low, *e.high) : "-"; }

std::string time_in_words(double seconds) {
  if (seconds >= 1) return fmt::format("{:.3f} s", seconds);
  if (seconds >= 1e-3) return fmt::format("{:.3f} ms", 1e3 * seconds);
  if (seconds >= 1e-6) return fmt::format("{:.3f} us", 1e6 * seconds);
  return fmt::format("{:.3f} ns", 1e9 * seconds);
}

std::string p_in_words(double p) { return p < 1e-4 ? "<1e-4" : fmt::format("{:.4f}", p); }

std::string limits_in_words(const BenchFile& b) {
  const auto pair = [](const MachineLimit& limit) { return fmt::format("{:.1f} / {:.1f}", limit.one_thread, limit.all_threads); };
  return fmt::format("triad {} GB/s, multiply-add {} GFLOP/s single, {} double (1 thread / all)", pair(b.triad_GB_per_s),
                     pair(b.single_GFLOPs), pair(b.double_GFLOPs));
}

/// Warns of a machine that did other work at the same time, which the times then include.
std::string warning_of_load(const BenchFile& b) {
  if (b.load <= 0.5 * b.logical_cores) return "";
  return fmt::format("warning: {} was measured at a load of {:.1f} on {:.0f} cores: other work slowed its benchmarks and limits down\n",
                     b.file.string(), b.load, b.logical_cores);
}

std::size_t count(const std::vector<BenchRatio>& ratios, BenchRatio::Verdict verdict) {
  return static_cast<std::size_t>(std::count_if(ratios.begin(), ratios.end(), [&](const BenchRatio& r) { return r.verdict == verdict; }));
}

std::string conclusion(const std::vector<BenchRatio>& ratios) {
  using enum BenchRatio::Verdict;
  const std::size_t few = count(ratios, too_few), told = ratios.size() - few;
  std::string text = fmt::format("{} benchmarks in both: {} faster, {} slower, {} no different beyond noise", ratios.size(),
                                 count(ratios, faster), count(ratios, slower), count(ratios, noise));
  if (few > 0) text += fmt::format(", {} with too few repeats to tell (five each are enough: --benchmark_repetitions=5)", few);
  text += fmt::format("; geometric mean of the ratios {:.3f}\n", mean_ratio(ratios));
  if (told >= 10)
    text += fmt::format("(of {} tests at {:.0f} % about {:.0f} would be told apart if nothing differed)\n", told, 100 * k_significant,
                        std::round(static_cast<double>(told) * k_significant));
  return text;
}

}  // namespace

std::vector<BenchRatio> compare(const BenchFile& base, const BenchFile& here) {
  std::vector<BenchRatio> ratios;
  for (const std::string& name : base.names) {
    const auto found = here.seconds.find(name);
    if (found == here.seconds.end()) continue;
    const std::vector<double>&before = base.seconds.at(name), &now = found->second;
    const MannWhitney test = mann_whitney(before, now);
    const Estimate ratio = ratio_of(before, now);
    ratios.push_back({name, now.size(), before.size(), median(before), median(now), ratio, test.p,
                      rate_for(name, here.triad_GB_per_s) / rate_for(name, base.triad_GB_per_s), fma_for(name, here) / fma_for(name, base),
                      verdict_of(test, ratio.value)});
  }
  if (ratios.empty())
    throw InputError(fmt::format("{}: found no benchmark that {} has, too, allowed: files with benchmarks in common", here.file.string(),
                                 base.file.string()));
  return ratios;
}

double mean_ratio(const std::vector<BenchRatio>& ratios) {
  double sum = 0;
  for (const BenchRatio& r : ratios) sum += std::log(r.ratio.value);
  return std::exp(sum / static_cast<double>(ratios.size()));
}

std::string in_words(const BenchFile& base, const BenchFile& here, const std::vector<BenchRatio>& ratios) {
  std::string text = warning_of_load(base) + warning_of_load(here);
  for (const auto& [role, b] : {std::pair("baseline", &base), std::pair("compared", &here)})
    text += fmt::format("{} {}: {}; {}\n  {}\n", role, b->file.string(), b->machine, b->program, limits_in_words(*b));
  std::size_t width = 10;
  for (const BenchRatio& r : ratios) width = std::max(width, r.name.size());
  constexpr const char* k_line = "{:<{}} {:>12} {:>12} {:>7} {:>16} {:>7} {:>7} {:>10} {:>9}  {}\n";
  text += '\n';
  text += fmt::format(k_line, "", width, "baseline", "compared", "times", "95 % interval", "p", "repeats", "per triad", "per FMA", "");
  text += fmt::format(k_line, "", width, "", "", "as fast", "", "", "", "", "", "");
  for (const BenchRatio& r : ratios)
    text += fmt::format(k_line, r.name, width, time_in_words(r.seconds_base), time_in_words(r.seconds_here),
                        fmt::format("{:.3f}", r.ratio.value), interval(r.ratio),
                        r.verdict == BenchRatio::Verdict::too_few ? "-" : p_in_words(r.p),
                        fmt::format("{}, {}", r.repetitions_base, r.repetitions_here), fmt::format("{:.3f}", r.per_triad()),
                        fmt::format("{:.3f}", r.per_fma()), word_of(r.verdict));
  return text + '\n' + conclusion(ratios);
}

namespace {

/// A logarithmic axis of ratios about 1 with all of them on it.
charts::Axis ratio_axis(const std::vector<BenchRatio>& ratios) {
  double low = 0.8, high = 1.25;
  for (const BenchRatio& r : ratios)
    for (const double x : {r.ratio.value, r.ratio.low.value_or(1), r.ratio.high.value_or(1), r.triad_ratio, r.fma_ratio})
      low = std::min(low, x / 1.05), high = std::max(high, x * 1.05);
  charts::Axis axis{"times as fast", "", charts::Scale::logarithmic, std::pair(low, high)};
  const bool narrow = high < 4 * low;
  for (const double ten : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1., 10., 100., 1e3, 1e4, 1e5})
    for (const double step : {1., 1.2, 1.5, 2., 3., 4., 5., 6., 7., 8., 9.}) {
      const bool wanted = narrow || step == 1 || step == 2 || step == 5;
      if (wanted && step * ten >= low && step * ten <= high) axis.tics.push_back({step * ten, fmt::format("{:.4g}", step * ten)});
    }
  return axis;
}

}  // namespace

charts::Chart chart_of(const BenchFile& base, const std::vector<BenchFile>& others, const std::vector<std::vector<BenchRatio>>& ratios) {
  using namespace charts;
  Chart chart;
  chart.name = "compare";
  chart.title = "How many times as fast as the first file";
  chart.columns = 1;
  std::size_t most = 0;
  for (std::size_t i = 0; i < others.size(); ++i) {
    Panel panel;
    panel.title = fmt::format("{} against {}", others[i].file.filename().string(), base.file.filename().string());
    panel.x = ratio_axis(ratios[i]);
    panel.y.range = {0, static_cast<double>(ratios[i].size()) + 1};
    Series intervals{"95 %", Kind::line}, told{"told apart", Kind::points}, noise{"noise, or too few repeats", Kind::points};
    Series triad{"ratio of the triads", Kind::points}, fma{"ratio of the multiply-adds", Kind::points};
    intervals.colour = told.colour = noise.colour = palette(0);
    noise.marker = Marker::circle, triad.marker = Marker::triangle, fma.marker = Marker::diamond;
    triad.colour = palette(1), fma.colour = palette(2);
    double row = static_cast<double>(ratios[i].size());
    for (const BenchRatio& r : ratios[i]) {
      panel.y.tics.push_back({row, r.name});
      if (r.ratio.low) {
        for (const double x : {*r.ratio.low, *r.ratio.high}) intervals.x.push_back(x), intervals.y.push_back(row);
        intervals.x.push_back(*r.ratio.high), intervals.y.push_back(NAN);
      }
      const bool apart = r.verdict == BenchRatio::Verdict::faster || r.verdict == BenchRatio::Verdict::slower;
      Series& points = apart ? told : noise;
      points.x.push_back(r.ratio.value), points.y.push_back(row);
      triad.x.push_back(r.triad_ratio), triad.y.push_back(row);
      fma.x.push_back(r.fma_ratio), fma.y.push_back(row);
      row -= 1;
    }
    for (const Series* series : {&triad, &fma, &intervals, &told, &noise})
      if (!series->x.empty()) panel.series.push_back(*series);
    panel.rules.push_back({true, 1, ""});
    panel.legend = Legend::below;
    chart.panels.push_back(panel);
    most = std::max(most, ratios[i].size());
  }
  chart.panel_width_in = 6.5;
  chart.panel_height_in = 1.4 + 0.17 * static_cast<double>(most);
  return chart;
}

}  // namespace bake::studies
