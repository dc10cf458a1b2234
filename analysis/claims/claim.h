// SPDX-License-Identifier: MIT
// Claims: a number that is measured of an item's runs must fulfil a condition. Each claim states its kind of evidence and its reason.
//
//     [[claim]]
//     metric = "distance_gain"
//     of = ["one_slit", "three_slits"]
//     from_m = [-0.05, 0, 0.3]
//     to_m = [0.05, 0, 0.3]
//     at_least = 1.2
//     kind = "published"
//     why = "figure 15: slits open"
//
// A regression is a claim like the others that holds for one quality; `bake bless` measures its expected value anew.
#pragma once

#include <functional>

#include "analysis/claims/metric.h"
#include "solver/core/errors.h"
#include "solver/scene/entry.h"
#include "solver/scene/settings.h"

namespace bake {

/// Only the first three are evidence that the result is right; a regression value only tells that it changed.
enum class Evidence { analytic, published, measured, regression };
constexpr auto choice_names(Evidence) { return std::array{"analytic", "published", "measured", "regression"}; }

/// How the numbers change along the list `of`.
enum class Trend { rising, falling };
constexpr auto choice_names(Trend) { return std::array{"rising", "falling"}; }

struct Claim {
  std::string metric;
  std::vector<std::string> of;
  MetricPlace place;  ///< its keys stand directly in [[claim]]
  std::string measured;
  std::optional<double> expected, tolerance, at_least, at_most;
  std::string greater_than;
  double factor = 1;
  std::optional<Trend> order;
  std::optional<Quality> quality;
  Evidence kind{};
  std::string why;
  std::string says;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"metric", &Claim::metric, "", any_number, "what is measured; without `of`, a number that the item's function computes",
                  Presence::required},
        Parameter{"of", &Claim::of, "", any_number, "the run or surface that it is measured of, or a list: the condition holds for each"},
        Parameter{"measured", &Claim::measured, "", any_number,
                  "a [[measured]] of the figure: what is judged is how far the metric over time is from its points, root mean square"},
        Parameter{"expected", &Claim::expected, "", any_number, "the number that it must be"},
        Parameter{"tolerance", &Claim::tolerance, "", non_negative, "how far it may be from that"},
        Parameter{"at_least", &Claim::at_least, "", any_number, "lower bound"},
        Parameter{"at_most", &Claim::at_most, "", any_number, "upper bound"},
        Parameter{"greater_than", &Claim::greater_than, "", any_number,
                  "another run or surface: the number must be greater than the same metric of that one"},
        Parameter{"factor", &Claim::factor, "1", positive, "... times this"},
        Parameter{"order", &Claim::order, "", any_number, "along the list `of`"},
        Parameter{"quality", &Claim::quality, "", any_number, "it is judged at this quality only; needed of a regression"},
        Parameter{"kind", &Claim::kind, "", any_number, "what evidence it is", Presence::required},
        Parameter{"why", &Claim::why, "", any_number, "the reason for the condition and its numbers", Presence::required},
        Parameter{"says", &Claim::says, "", any_number,
                  "the paper's own words that are measured; claims with the same words are one statement on the report's page"},
    };
  }
  /// `asked`: "draft".
  bool is_judged_at(std::string_view asked) const { return !quality || word_of(*quality) == asked; }
};

/// A number that an item's function computes, and where it can be.
struct KnownNumber {
  std::string name;
  Range range = any_number;
};

/// Checks that a table has the keys of MetricPlace that the metric needs, none that it does not know, and no empty box.
/// Throws InputError.
void check_place(const SceneEntry& entry, const Metric& metric, const MetricPlace& place);

/// Reads a table [[claim]] and checks it: a known metric with the keys that it needs and no others, and one condition.
/// A condition that cannot be missed is refused. `computed`: the numbers that the item's function computes. Throws InputError.
Claim read_claim(const SceneEntry& entry, const std::vector<KnownNumber>& computed);

/// One line of the table of claims.
struct ClaimVerdict {
  std::string metric, meaning, of, unit, condition, why;
  Evidence kind;
  double measured;
  bool holds;
  std::string says = {};
  std::optional<double> low = {}, high = {};  ///< what it must not be below or above
  std::string problem = {};  ///< why there is no number, of this run or of the one it is compared with; then it does not hold
};

/// Unit and meaning of what is measured.
struct MetricWords {
  std::string unit, meaning;
};

/// Measures a metric of the run or surface with that name; if `of` is empty, returns the number that the item's function computes.
using Measure = std::function<Measurement(const Claim& claim, const std::string& of)>;

/// The verdicts of a claim, one per run.
std::vector<ClaimVerdict> judge(const Claim& claim, const MetricWords& words, const Measure& measure);

/// The verdicts as a table for the terminal, with the reason where a claim does not hold.
std::string table(const std::vector<ClaimVerdict>& verdicts);

}  // namespace bake
