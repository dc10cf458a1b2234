// SPDX-License-Identifier: MIT
#include "analysis/claims/claim.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/scene/nearest.h"
#include "solver/scene/read_value.h"

namespace bake {
namespace {

bool contains(const std::vector<std::string>& list, std::string_view word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

void check_metric(const SceneEntry& entry, const Claim& claim, const std::vector<std::string>& computed) {
  if (claim.of.empty()) {
    if (!contains(computed, claim.metric))
      entry.complain_at("metric", fmt::format("unknown number '{}'; {}", claim.metric,
                                              computed.empty() ? "a metric needs `of`: the run or surface that it is measured of"
                                                               : suggestion(claim.metric, computed)));
    return;
  }
  const Metric* metric = nullptr;
  try {
    metric = &find_metric(claim.metric);
  } catch (const InputError& error) {
    entry.complain_at("metric", error.what());
  }
  check_place(entry, *metric);
}

void check_condition(const SceneEntry& entry, const Claim& claim) {
  if (claim.expected.has_value() != claim.tolerance.has_value())
    entry.complain_at("expected", "needs a tolerance beside it, and a tolerance needs it");
  const int conditions =
      claim.expected.has_value() + (claim.at_least || claim.at_most) + !claim.greater_than.empty() + claim.order.has_value();
  if (conditions != 1) entry.complain("allowed: one condition: expected with tolerance; at_least, at_most or both; greater_than; or order");
  if (claim.order && claim.of.size() < 2) entry.complain_at("order", "needs a list `of` at least two");
  if (claim.factor != 1 && claim.greater_than.empty()) entry.complain_at("factor", "needs greater_than");
  if (claim.kind == Evidence::regression && !claim.expected) entry.complain_at("kind", "found a regression without an expected value");
  if (claim.kind == Evidence::regression && !claim.quality)
    entry.complain_at("kind", "found a regression without the quality that it holds for");
  if (claim.why.empty()) entry.complain_at("why", "found \"\", allowed: the reason");
}

/// "2.59 +- 0.01", ">= 1.5"
std::string words_of_bounds(const Claim& claim) {
  if (claim.expected) return fmt::format("{:.6g} +- {:.2g}", *claim.expected, *claim.tolerance);
  if (claim.at_least && claim.at_most) return fmt::format("{:.6g} to {:.6g}", *claim.at_least, *claim.at_most);
  return claim.at_least ? fmt::format(">= {:.6g}", *claim.at_least) : fmt::format("<= {:.6g}", *claim.at_most);
}

bool is_within_bounds(const Claim& claim, double measured) {
  if (!std::isfinite(measured)) return false;
  if (claim.expected) return std::abs(measured - *claim.expected) <= *claim.tolerance;
  return (!claim.at_least || measured >= *claim.at_least) && (!claim.at_most || measured <= *claim.at_most);
}

ClaimVerdict verdict(const Claim& claim, const MetricWords& words, const std::string& of, double measured) {
  return {claim.metric, words.meaning, of, words.unit, "", claim.why, claim.kind, measured, false};
}

/// Judges one measured number against a number or another run.
ClaimVerdict judge_one(const Claim& claim, const MetricWords& words, const std::string& of, const Measure& measure) {
  ClaimVerdict v = verdict(claim, words, of, measure(claim, of));
  if (claim.greater_than.empty()) {
    v.condition = words_of_bounds(claim);
    v.holds = is_within_bounds(claim, v.measured);
    return v;
  }
  const double other = measure(claim, claim.greater_than);
  v.condition = fmt::format("> {}{} ({:.4g})", claim.factor == 1 ? "" : fmt::format("{:g} x ", claim.factor), claim.greater_than,
                            claim.factor * other);
  v.holds = v.measured > claim.factor * other;
  return v;
}

/// Judges each measured number against the one before it.
std::vector<ClaimVerdict> judge_order(const Claim& claim, const MetricWords& words, const Measure& measure) {
  std::vector<ClaimVerdict> verdicts;
  for (const std::string& of : claim.of) {
    ClaimVerdict v = verdict(claim, words, of, measure(claim, of));
    const char* sign = *claim.order == Trend::rising ? ">" : "<";
    v.condition = verdicts.empty() ? "first of the list" : fmt::format("{} {}", sign, verdicts.back().of);
    v.holds = std::isfinite(v.measured);
    if (!verdicts.empty()) {
      const double before = verdicts.back().measured;
      v.holds = *claim.order == Trend::rising ? v.measured > before : v.measured < before;
    }
    verdicts.push_back(v);
  }
  return verdicts;
}

}  // namespace

void check_place(const SceneEntry& entry, const Metric& metric) {
  for (const std::string& key : keys_of<MetricPlace>()) {
    const bool needed = contains(metric.needs, key), known = needed || contains(metric.knows, key);
    if (needed && !entry.find(key)) entry.refuse_missing(key, fmt::format("what {} needs: {}", metric.name, fmt::join(metric.needs, ", ")));
    if (!known && entry.find(key)) entry.complain_at(key, fmt::format("'{}' knows no such key", metric.name));
  }
}

Claim read_claim(const SceneEntry& entry, const std::vector<std::string>& computed) {
  entry.expect_table();
  std::vector<std::string> known = keys_of<Claim, MetricPlace>();
  entry.refuse_unknown(known);
  Claim claim;
  read_members(entry, claim, Demand::required_keys);
  read_members(entry, claim.place, Demand::nothing);
  check_metric(entry, claim, computed);
  check_condition(entry, claim);
  return claim;
}

std::vector<ClaimVerdict> judge(const Claim& claim, const MetricWords& words, const Measure& measure) {
  if (claim.order) return judge_order(claim, words, measure);
  if (claim.of.empty()) return {judge_one(claim, words, "", measure)};
  std::vector<ClaimVerdict> verdicts;
  for (const std::string& of : claim.of) verdicts.push_back(judge_one(claim, words, of, measure));
  return verdicts;
}

std::string table(const std::vector<ClaimVerdict>& verdicts) {
  const auto name_of = [](const ClaimVerdict& v) { return v.of.empty() ? v.metric : fmt::format("{} of {}", v.metric, v.of); };
  std::size_t what = 20, condition = 22;
  for (const ClaimVerdict& v : verdicts) {
    what = std::max(what, name_of(v).size());
    condition = std::max(condition, v.condition.size());
  }
  std::string text = fmt::format("  {:<{}} {:>12} {:<6} {:<{}} {:<10}  {}\n", "metric", what, "measured", "unit", "expected", condition,
                                 "kind", "verdict");
  for (const ClaimVerdict& v : verdicts)
    text += fmt::format("  {:<{}} {:>12.6g} {:<6} {:<{}} {:<10}  {}\n", name_of(v), what, v.measured, v.unit, v.condition, condition,
                        word_of(v.kind), v.holds ? "holds" : "MISSED: " + v.why);
  return text;
}

}  // namespace bake
