// SPDX-License-Identifier: MIT
#include "analysis/claims/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "analysis/claims/table.h"
#include "solver/core/errors.h"
#include "solver/io/atomic_file.h"
#include "solver/scene/describe.h"
#include "solver/scene/nearest.h"

namespace bake {

namespace {

/// One table of the file, for messages with its place.
class Entry {
 public:
  Entry(const std::filesystem::path& file, std::string place, const nlohmann::json& json)
      : file_(file), place_(std::move(place)), json_(json) {
    if (!json.is_object()) complain("", "found no table, allowed: { ... }");
  }

  [[noreturn]] void complain(std::string_view key, const std::string& problem) const {
    throw InputError(fmt::format("{}: {}{}{}: {}", file_.string(), place_, place_.empty() || key.empty() ? "" : ".", key, problem));
  }
  void expect_keys(const std::vector<std::string>& known) const {
    for (const auto& [key, value] : json_.items())
      if (std::find(known.begin(), known.end(), key) == known.end()) complain(key, "unknown key, " + suggestion(key, known));
  }
  std::string text(const char* key) const {
    if (!json_.contains(key)) complain(key, "missing, allowed: a text");
    if (!json_[key].is_string() || json_[key].get<std::string>().empty()) complain(key, "found " + json_[key].dump() + ", allowed: a text");
    return json_[key];
  }
  template <class Choice>
  Choice choice(const char* key) const {
    const std::string word = text(key);
    constexpr auto names = choice_names(Choice{});
    const auto at = std::find(names.begin(), names.end(), word);
    if (at == names.end()) complain(key, fmt::format("found '{}', {}", word, suggestion(word, {names.begin(), names.end()})));
    return static_cast<Choice>(at - names.begin());
  }
  std::optional<double> number(const char* key) const {
    if (!json_.contains(key)) return std::nullopt;
    if (!json_[key].is_number()) complain(key, "found " + json_[key].dump() + ", allowed: a number");
    return json_[key].get<double>();
  }

 private:
  const std::filesystem::path& file_;
  std::string place_;
  const nlohmann::json& json_;
};

Expectation read_expectation(const Entry& entry) {
  entry.expect_keys({"name", "kind", "expected", "tolerance", "at_least", "at_most", "why"});
  Expectation e{entry.text("name"),       entry.choice<Evidence>("kind"), entry.number("expected"), entry.number("tolerance"),
                entry.number("at_least"), entry.number("at_most"),        entry.text("why")};
  try {
    const Metric& metric = find_metric(e.name);
    if (!metric.of_run || !metric.needs.empty()) throw InputError(fmt::format("'{}' cannot be measured of a run alone", e.name));
  } catch (const InputError& error) {
    entry.complain("name", error.what());
  }
  if (e.expected.has_value() != e.tolerance.has_value())
    entry.complain("expected", "needs a tolerance beside it, and a tolerance needs it");
  if (e.expected.has_value() == (e.at_least || e.at_most))
    entry.complain("", "allowed: either expected with tolerance, or at_least, at_most or both");
  if (e.kind == Evidence::regression && !e.expected) entry.complain("kind", "found a regression without an expected value");
  return e;
}

nlohmann::ordered_json json_of(const Expectation& e) {
  nlohmann::ordered_json json{{"name", e.name}, {"kind", word_of(e.kind)}};
  const auto put = [&](const char* key, const std::optional<double>& value) {
    if (value) json[key] = *value;
  };
  put("expected", e.expected);
  put("tolerance", e.tolerance);
  put("at_least", e.at_least);
  put("at_most", e.at_most);
  json["why"] = e.why;
  return json;
}

}  // namespace

bool Expectation::holds(double measured) const {
  if (!std::isfinite(measured)) return false;
  if (expected) return std::abs(measured - *expected) <= *tolerance;
  return (!at_least || measured >= *at_least) && (!at_most || measured <= *at_most);
}

std::string Expectation::words() const {
  if (expected) return fmt::format("{:.6g} +- {:.2g}", *expected, *tolerance);
  if (at_least && at_most) return fmt::format("{:.6g} to {:.6g}", *at_least, *at_most);
  return at_least ? fmt::format(">= {:.6g}", *at_least) : fmt::format("<= {:.6g}", *at_most);
}

Reference read_reference(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw InputError(fmt::format("{}: cannot open", file.string()));
  nlohmann::json json;
  try {
    json = nlohmann::json::parse(in);
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
  const Entry top(file, "", json);
  top.expect_keys({"item", "scene", "quality", "metrics", "blessed"});
  Reference reference{
      file, top.text("item"), top.text("scene"), top.choice<Quality>("quality"), {}, json.value("blessed", nlohmann::json())};
  if (!json.contains("metrics") || !json["metrics"].is_array() || json["metrics"].empty())
    top.complain("metrics", "missing, allowed: a list of metrics");
  for (std::size_t i = 0; i < json["metrics"].size(); ++i)
    reference.metrics.push_back(read_expectation(Entry(file, fmt::format("metrics.{}", i), json["metrics"][i])));
  return reference;
}

void write_reference(const Reference& reference) {
  nlohmann::ordered_json json{{"item", reference.item}, {"scene", reference.scene}, {"quality", word_of(reference.quality)}};
  for (const Expectation& e : reference.metrics) json["metrics"].push_back(json_of(e));
  json["blessed"] = reference.blessed;
  write_text_atomically(reference.file, json.dump(2) + "\n");
}

std::vector<Verdict> check(const Reference& reference, const Results& results) {
  std::vector<Verdict> verdicts;
  for (const Expectation& e : reference.metrics) verdicts.push_back({e, find_metric(e.name).of_run(results, {})});
  return verdicts;
}

std::string table(const std::vector<Verdict>& verdicts) {
  std::vector<TableRow> rows;
  rows.reserve(verdicts.size());
  for (const Verdict& v : verdicts)
    rows.push_back({v.expectation.name, v.measured, find_metric(v.expectation.name).unit, v.expectation.words(), v.expectation.kind,
                    v.holds(), v.expectation.why});
  return table(rows);
}

}  // namespace bake
