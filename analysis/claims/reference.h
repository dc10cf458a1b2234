// SPDX-License-Identifier: MIT
// Reference metrics: numbers that an item must reproduce, each with its kind of evidence, tolerance and reason, in
// reference/metrics/<item>.json:
//
//   { "item": "bread", "scene": "fig15_bread/bread", "quality": "draft",
//     "metrics": [
//       { "name": "volume_gain", "kind": "published", "at_least": 1.5, "why": "..." },
//       { "name": "height", "kind": "regression", "expected": 0.45, "tolerance": 0.002, "why": "..." } ],
//     "blessed": { "why": "...", "commit": "..." } }
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/claims/metric.h"
#include "solver/scene/settings.h"

namespace bake {

/// Only the first three are evidence that the result is right; a regression value only tells that it changed.
enum class Evidence { analytic, published, measured, regression };
constexpr auto choice_names(Evidence) { return std::array{"analytic", "published", "measured", "regression"}; }

/// expected +- tolerance, or a bound on one or both sides.
struct Expectation {
  std::string name;  ///< of the metric
  Evidence kind;
  std::optional<double> expected, tolerance, at_least, at_most;
  std::string why;  ///< of the number and its tolerance

  bool holds(double measured) const;
  std::string words() const;  ///< "2.59 +- 0.01", ">= 1.5"
};

struct Reference {
  std::filesystem::path file;
  std::string item, scene;
  Quality quality;
  std::vector<Expectation> metrics;
  nlohmann::json blessed;  ///< why and from which commit the regression values are
};

/// Throws InputError: file, entry, what was found and what is allowed.
Reference read_reference(const std::filesystem::path& file);
void write_reference(const Reference& reference);

struct Verdict {
  Expectation expectation;
  double measured;
  bool holds() const { return expectation.holds(measured); }
};
std::vector<Verdict> check(const Reference& reference, const Results& results);
/// measured, expected, verdict of every metric, as a table for people.
std::string table(const std::vector<Verdict>& verdicts);

}  // namespace bake
