// SPDX-License-Identifier: MIT
#include "experiments/common/errors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/claims/finite.h"
#include "experiments/common/order.h"

namespace bake::studies {

namespace {
const char* word(Errors::Figure figure) { return figure == Errors::Figure::order ? "order" : "largest error"; }
}  // namespace

double Errors::value() const { return figure == Figure::order ? fitted_order(refinements, errors) : largest_of(errors); }

std::string band_in_words(const Errors& e) {
  return e.figure == Errors::Figure::order ? fmt::format("{} to {}", e.low, e.high) : fmt::format("at most {:.3g}", e.high);
}

std::vector<std::string> short_numbers(const std::vector<double>& values) {
  std::vector<std::string> words;
  words.reserve(values.size());
  for (const double x : values) words.push_back(fmt::format("{:.3g}", x));
  return words;
}

std::string in_words(const Errors& e) {
  return fmt::format("{}; {} {}: {}; {} {:.3g}, band {} ({}): {}", e.quantity, fmt::join(e.refinements, ", "), e.refined,
                     fmt::join(short_numbers(e.errors), ", "), word(e.figure), e.value(), band_in_words(e), e.why,
                     e.holds() ? "holds" : "MISSED");
}

nlohmann::json as_json(const Errors& e) {
  return {{"quantity", e.quantity}, {"refined", e.refined},     {"refinements", e.refinements},
          {"errors", e.errors},     {"figure", word(e.figure)}, {"value", e.value()},
          {"low", e.low},           {"high", e.high},           {"why", e.why},
          {"holds", e.holds()}};
}

}  // namespace bake::studies
