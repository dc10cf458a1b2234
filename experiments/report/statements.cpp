// SPDX-License-Identifier: MIT
#include "experiments/report/statements.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "experiments/report/sections.h"
#include "experiments/report/time_chart.h"

namespace bake::report {
namespace {

using nlohmann::json;

std::optional<double> number_in(const json& claim, const char* key) {
  const auto found = claim.find(key);
  return found != claim.end() && found->is_number() ? std::optional(found->get<double>()) : std::nullopt;
}

std::string words_in(const json& claim, const char* key) { return claim.at(key).get<std::string>(); }

/// A bar from zero to the number, with what is allowed behind it; nothing without a number or a bound.
Html bar(const json& claim) {
  const auto measured = number_in(claim, "measured"), low = number_in(claim, "low"), high = number_in(claim, "high");
  if (!measured || (!low && !high)) return element("span", {});
  double left = 0, right = 0;
  for (const auto& value : {measured, low, high})
    if (value) left = std::min(left, *value), right = std::max(right, *value);
  if (right == left) right = left + 1;
  const double margin = 0.12 * (right - left);
  right += right > 0 ? margin : 0;
  left -= left < 0 ? margin : 0;
  constexpr double k_width = 200;
  const auto at = [&](double value) { return k_width * (value - left) / (right - left); };
  const double from = low ? at(*low) : 0, to = high ? at(*high) : k_width, zero = at(0), tip = at(*measured);
  constexpr double k_thinnest = 2.5;
  std::string code =
      fmt::format("<rect class=\"allowed\" x=\"{:.1f}\" y=\"4\" width=\"{:.1f}\" height=\"10\"/>", from, std::max(to - from, 1.0));
  code += fmt::format("<rect class=\"{}\" x=\"{:.1f}\" y=\"7\" width=\"{:.1f}\" height=\"4\"/>",
                      claim.at("holds").get<bool>() ? "met" : "unmet", std::clamp(std::min(zero, tip), 0.0, k_width - k_thinnest),
                      std::max(k_thinnest, std::abs(tip - zero)));
  for (const auto& bound : {low, high})
    if (bound) code += fmt::format("<line class=\"bound\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"1\" y2=\"17\"/>", at(*bound));
  return element("svg", {code}, "viewBox=\"0 0 200 18\" preserveAspectRatio=\"none\" aria-hidden=\"true\"");
}

/// "needs ≥ 1.2"; of a claim against another run the number alone, whose name stands in the title.
std::string need(const json& claim) {
  const auto low = number_in(claim, "low"), high = number_in(claim, "high");
  const std::string condition = words_in(claim, "condition");
  if (condition == "first of the list") return "first";
  if (condition.starts_with("> ") && low) return "> " + number(*low);
  if (condition.starts_with("< ") && high) return "< " + number(*high);
  return with_signs(condition);
}

std::string unit_of(const json& claim) {
  const std::string unit = words_in(claim, "unit");
  return unit == "1" || unit.empty() ? "" : "\u00a0" + unit;
}

/// A line of a card: of what, the bar, the number, what it must be.
Html line(const json& claim, const std::string& common, bool names_metric) {
  std::string metric = words_in(claim, "metric");
  std::replace(metric.begin(), metric.end(), '_', ' ');
  const std::string of = words_in(claim, "of");
  const std::string label = of.empty() ? metric : names_metric ? short_name(of, common) + ": " + metric : short_name(of, common);
  const auto measured = number_in(claim, "measured");
  const std::string title = fmt::format("{}{}: {}; {}", metric, of.empty() ? "" : " of " + of, words_in(claim, "meaning"),
                                        with_signs(words_in(claim, "condition")));
  const bool holds = claim.at("holds").get<bool>();
  std::vector<Html> parts{
      element("span", text(label), "class=\"of\""), bar(claim),
      element("span", text(number(measured.value_or(std::nan(""))) + unit_of(claim)), holds ? "class=\"value\"" : "class=\"value miss\""),
      element("span", text(need(claim)), "class=\"soft need\"")};
  if (const std::string problem = claim.value("problem", ""); !problem.empty())
    parts.push_back(element("span", text(problem), "class=\"soft problem\""));
  return element("div", join(parts), fmt::format("class=\"claim\" title=\"{}\"", text(title).code));
}

/// "bread volume gain": for a card's anchor.
std::string anchor_of(const Statement& statement, const std::string& place, std::size_t number) {
  std::string metric = statement.claims.front().at("metric");
  std::replace(metric.begin(), metric.end(), '_', '-');
  return fmt::format("{}-{}-{}", place, number + 1, metric);
}

/// `of_all`: how the names of all runs begin; those of a single run are not told apart otherwise.
Html card(const Statement& statement, const std::string& anchor, const std::string& of_all) {
  std::vector<std::string> metrics, runs;
  for (const json& claim : statement.claims) {
    metrics.push_back(claim.at("metric"));
    const std::string of = claim.at("of");
    if (!of.empty() && std::find(runs.begin(), runs.end(), of) == runs.end()) runs.push_back(of);
  }
  const std::string common = runs.size() > 1 ? common_start(runs) : of_all;
  const bool several = std::any_of(metrics.begin(), metrics.end(), [&](const std::string& m) { return m != metrics.front(); });
  const Html words = statement.is_quoted ? join({text("“"), text(statement.words), text("”")}) : text(statement.words);
  std::vector<Html> parts{element("h4", join({words, text(" "), badge(statement.holds()), link_to(anchor, "this statement")}))};
  std::vector<std::string> reasons;
  for (const json& claim : statement.claims) {
    std::string why = claim.at("why");
    if (!statement.is_quoted || std::find(reasons.begin(), reasons.end(), why) != reasons.end()) continue;
    reasons.push_back(why);
    parts.push_back(element("p", text(why), "class=\"soft\""));
  }
  std::string kind = statement.claims.front().at("kind");
  for (const json& claim : statement.claims) parts.push_back(line(claim, common, several));
  if (kind != "published") parts.push_back(element("p", text("Evidence: " + kind + "."), "class=\"soft\""));
  return element("article", join(parts), fmt::format("class=\"say {}\" id=\"{}\"", statement.holds() ? "good" : "bad", anchor));
}

}  // namespace

bool Statement::holds() const {
  return std::all_of(claims.begin(), claims.end(), [](const json& claim) { return claim.at("holds").get<bool>(); });
}

std::vector<Statement> statements_of(const json& claims) {
  std::vector<Statement> statements;
  for (const json& claim : claims) {
    const std::string says = claim.value("says", ""), words = says.empty() ? claim.at("why").get<std::string>() : says;
    const auto same = std::find_if(statements.begin(), statements.end(), [&](const Statement& s) { return s.words == words; });
    if (same != statements.end())
      same->claims.push_back(claim);
    else
      statements.push_back({words, !says.empty(), {claim}});
  }
  return statements;
}

Html cards(const std::vector<Statement>& statements, const std::string& place) {
  std::vector<std::string> runs;
  for (const Statement& statement : statements)
    for (const json& claim : statement.claims)
      if (const std::string of = claim.at("of"); !of.empty()) runs.push_back(of);
  std::vector<Html> parts;
  for (std::size_t i = 0; i < statements.size(); ++i)
    parts.push_back(card(statements[i], anchor_of(statements[i], place, i), common_start(runs)));
  return join(parts);
}

}  // namespace bake::report
