// SPDX-License-Identifier: MIT
#include "tests/bench/summary.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "analysis/machines/statistics.h"

namespace bake::bench {

using studies::median;

namespace {

std::string number(double value, int digits) { return value > 0 ? fmt::format("{:.{}f}", value, digits) : "-"; }
std::string percent(double share) { return share > 0 ? fmt::format("{:.0f} %", 100 * share) : "-"; }
std::string ratio(double a, double b) { return a > 0 && b > 0 ? fmt::format("{:.2f}", a / b) : "-"; }

}  // namespace

SummaryReporter::SummaryReporter(const Limits& limits)
    : ConsoleReporter(isatty(STDOUT_FILENO) ? OO_ColorTabular : OO_Tabular), limits_(limits) {}

void SummaryReporter::ReportRuns(const std::vector<Run>& runs) {
  ConsoleReporter::ReportRuns(runs);
  for (const Run& run : runs) {
    const std::string& full = run.run_name.function_name;
    const auto threads = full.find("/threads:");
    if (run.run_type != Run::RT_Iteration || run.error_occurred || !full.starts_with("Step/") || threads == std::string::npos) continue;
    const std::string name = full.substr(5, threads - 5);
    auto row = std::find_if(rows_.begin(), rows_.end(), [&](const Row& r) { return r.name == name; });
    if (row == rows_.end()) row = rows_.insert(rows_.end(), {name, {}, {}});
    Figures& figures = full.ends_with("/threads:1") ? row->one : row->all;
    figures.rate.push_back(run.counters.at("M/s"));
    figures.peak.push_back(run.counters.at("peak"));
    figures.triad.push_back(run.counters.at("triad"));
    figures.cpu_ns.push_back(run.counters.at("cpu_ns"));
  }
}

void SummaryReporter::print_limits() {
  GetOutputStream() << fmt::format("\n{:<32}{:>10}{:>14}\n", "this machine's limits", "1 thread",
                                   fmt::format("{} threads", limits_.threads));
  const auto line = [&](const char* name, const Rate& rate) {
    GetOutputStream() << fmt::format("{:<32}{:>10.1f}{:>14.1f}\n", name, rate.one, rate.all);
  };
  line("triad, GB/s", limits_.triad_GB_per_s);
  line("multiply-add single, GFLOP/s", limits_.single_GFLOPs);
  line("multiply-add double, GFLOP/s", limits_.double_GFLOPs);
}

const SummaryReporter::Row* SummaryReporter::row_of(const std::string& name) const {
  const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const Row& r) { return r.name == name; });
  return found == rows_.end() ? nullptr : &*found;
}

void SummaryReporter::Finalize() {
  print_limits();
  if (rows_.empty()) return;
  constexpr const char* k_line = "{:<36}{:>10}{:>11}{:>7}{:>9}{:>9}{:>9}{:>9}{:>9}\n";
  GetOutputStream() << "\nmillion particle-steps/s\n"
                    << fmt::format(k_line, "", "1 thread", fmt::format("{} threads", limits_.threads), "ratio", "of peak", "of peak",
                                   "of triad", "double/", "cpu ns")
                    << fmt::format(k_line, "", "", "", "", "1", "all", "all", "single", "");
  for (const Row& row : rows_) {
    const double one = median(row.one.rate), all = median(row.all.rate);
    const bool parallel = all > 0;
    std::string in_single = row.name;
    const auto precision = in_single.find("/double/");
    if (precision != std::string::npos) in_single.replace(precision, 8, "/single/");
    const Row* single = precision == std::string::npos ? nullptr : row_of(in_single);
    const double base = !single ? 0 : median(parallel ? single->all.rate : single->one.rate);
    const double cpu_ns = median(row.one.cpu_ns.empty() ? row.all.cpu_ns : row.one.cpu_ns);
    GetOutputStream() << fmt::format(k_line, row.name, number(one, 1), number(all, 1), ratio(all, one), percent(median(row.one.peak)),
                                     percent(median(row.all.peak)), percent(median(row.all.triad)), ratio(parallel ? all : one, base),
                                     number(cpu_ns, 1));
  }
  GetOutputStream() << std::flush;
}

}  // namespace bake::bench
