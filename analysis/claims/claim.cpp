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

/// Returns the range of what is measured.
Range check_computed(const SceneEntry& entry, const Claim& claim, const std::vector<KnownNumber>& computed) {
  if (entry.find("of")) entry.complain_at("of", "found [], allowed: a run or surface, or a list of them");
  if (!claim.measured.empty()) entry.complain_at("measured", "needs `of`: the run whose metric is compared");
  std::vector<std::string> names;
  for (const KnownNumber& number : computed) {
    names.push_back(number.name);
    if (number.name != claim.metric) continue;
    if (!claim.greater_than.empty()) entry.complain_at("greater_than", "needs `of`: a number that is computed has no other run");
    return number.range;
  }
  entry.complain_at("metric", fmt::format("unknown number '{}'; {}", claim.metric,
                                          names.empty() ? "a metric needs `of`: the run or surface that it is measured of"
                                                        : suggestion(claim.metric, names)));
}

/// Returns the range of what is measured.
Range check_metric(const SceneEntry& entry, const Claim& claim, const std::vector<KnownNumber>& computed) {
  if (claim.of.empty()) return check_computed(entry, claim, computed);
  for (std::size_t i = 1; i < claim.of.size(); ++i)
    if (std::count(claim.of.begin(), claim.of.end(), claim.of[i]) > 1)
      entry.complain_at("of", fmt::format("found '{}' again, allowed: each once", quotable(claim.of[i])));
  if (contains(claim.of, claim.greater_than))
    entry.complain_at("greater_than", fmt::format("found '{}', which is measured itself, allowed: another", quotable(claim.greater_than)));
  const Metric* metric = nullptr;
  try {
    metric = &find_metric(claim.metric);
  } catch (const InputError& error) {
    entry.complain_at("metric", error.what());
  }
  check_place(entry, *metric, claim.place);
  if (claim.measured.empty()) return metric->range;
  if (!metric->is_of_run() || !contains(metric->knows, "time_s"))
    entry.complain_at("measured", fmt::format("found '{}' for {}, allowed: for a metric of a run that has a time", quotable(claim.measured),
                                              claim.metric));
  if (claim.place.time_s) entry.complain_at("time_s", "measured points have their own times");
  return non_negative;
}

/// Refuses a bound that nothing in the range of the measured number can miss.
void check_bounds(const SceneEntry& entry, const Claim& claim, const Range& range) {
  if (claim.at_least && *claim.at_least <= range.low)
    entry.complain_at("at_least",
                      fmt::format("found {}, allowed: above {}: no {} is below it", *claim.at_least, range.low, quotable(claim.metric)));
  if (claim.at_most && *claim.at_most >= range.high)
    entry.complain_at("at_most",
                      fmt::format("found {}, allowed: below {}: no {} is above it", *claim.at_most, range.high, quotable(claim.metric)));
  if (claim.expected && *claim.expected - *claim.tolerance <= range.low && *claim.expected + *claim.tolerance >= range.high)
    entry.complain_at("tolerance", fmt::format("found {}, allowed: less: every {} is within it", *claim.tolerance, quotable(claim.metric)));
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
  if (claim.expected) return std::abs(measured - *claim.expected) <= *claim.tolerance;
  return (!claim.at_least || measured >= *claim.at_least) && (!claim.at_most || measured <= *claim.at_most);
}

ClaimVerdict verdict(const Claim& claim, const MetricWords& words, const std::string& of, const Measurement& m) {
  return {claim.metric, words.meaning, of, words.unit, "", claim.why, claim.kind, m.value, false, claim.says, {}, {}, m.problem};
}

/// Judges one measured number against a number or another run.
ClaimVerdict judge_one(const Claim& claim, const MetricWords& words, const std::string& of, const Measure& measure) {
  ClaimVerdict v = verdict(claim, words, of, measure(claim, of));
  if (claim.greater_than.empty()) {
    v.condition = words_of_bounds(claim);
    v.low = claim.expected ? *claim.expected - *claim.tolerance : claim.at_least;
    v.high = claim.expected ? *claim.expected + *claim.tolerance : claim.at_most;
    v.holds = v.problem.empty() && is_within_bounds(claim, v.measured);
    return v;
  }
  const Measurement other = measure(claim, claim.greater_than);
  v.condition = fmt::format("> {}{} ({:.4g})", claim.factor == 1 ? "" : fmt::format("{:g} x ", claim.factor), claim.greater_than,
                            claim.factor * other.value);
  v.low = claim.factor * other.value;
  if (v.problem.empty()) v.problem = other.problem;
  v.holds = v.problem.empty() && v.measured > claim.factor * other.value;
  return v;
}

/// Judges each measured number against the one before it.
std::vector<ClaimVerdict> judge_order(const Claim& claim, const MetricWords& words, const Measure& measure) {
  std::vector<ClaimVerdict> verdicts;
  for (const std::string& of : claim.of) {
    ClaimVerdict v = verdict(claim, words, of, measure(claim, of));
    const char* sign = *claim.order == Trend::rising ? ">" : "<";
    v.condition = verdicts.empty() ? "first of the list" : fmt::format("{} {}", sign, verdicts.back().of);
    v.holds = v.problem.empty();
    if (!verdicts.empty() && v.holds) {
      const double before = verdicts.back().measured;
      (*claim.order == Trend::rising ? v.low : v.high) = before;
      v.holds = std::isfinite(before) && (*claim.order == Trend::rising ? v.measured > before : v.measured < before);
    }
    verdicts.push_back(v);
  }
  return verdicts;
}

}  // namespace

void check_place(const SceneEntry& entry, const Metric& metric, const MetricPlace& place) {
  for (const std::string& key : keys_of<MetricPlace>()) {
    const bool needed = contains(metric.needs, key), known = needed || contains(metric.knows, key);
    if (needed && !entry.find(key)) entry.refuse_missing(key, fmt::format("what {} needs: {}", metric.name, fmt::join(metric.needs, ", ")));
    if (!known && entry.find(key)) entry.complain_at(key, fmt::format("'{}' knows no such key", metric.name));
  }
  for (std::size_t axis = 0; place.low_m && place.high_m && axis < 3; ++axis)
    if (!((*place.low_m)[axis] < (*place.high_m)[axis]))
      entry.complain_at(
          "high_m", fmt::format("found {} along {}, allowed: above low_m, {}", (*place.high_m)[axis], "xyz"[axis], (*place.low_m)[axis]));
}

Claim read_claim(const SceneEntry& entry, const std::vector<KnownNumber>& computed) {
  entry.expect_table();
  std::vector<std::string> known = keys_of<Claim, MetricPlace>();
  entry.refuse_unknown(known);
  Claim claim;
  read_members(entry, claim, Demand::required_keys);
  read_members(entry, claim.place, Demand::nothing);
  const Range range = check_metric(entry, claim, computed);
  check_condition(entry, claim);
  check_bounds(entry, claim, range);
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
                        word_of(v.kind), v.holds ? "holds" : "MISSED: " + (v.problem.empty() ? "" : v.problem + "; ") + v.why);
  return text;
}

}  // namespace bake
