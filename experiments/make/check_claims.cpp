// SPDX-License-Identifier: MIT

#include <map>
#include <set>

#include "analysis/image/layout.h"
#include "experiments/make/pipeline.h"
#include "solver/io/atomic_file.h"
#include "solver/io/provenance.h"

namespace bake {
namespace {

/// The runs and surfaces that the claims measure; each is read once.
class Measured {
 public:
  Measured(const FigurePaths& paths, const Computed& computed) : place_(paths), computed_(computed) {}

  Measurement operator()(const Claim& claim, const std::string& of) {
    if (of.empty()) return find_named(computed_.numbers, claim.metric)->value;
    const Metric& metric = find_metric(claim.metric);
    if (!claim.measured.empty()) {
      const FigureMeasured& measured = *find_named(place_.figure.measured, claim.measured);
      return distance(metric, run(of), claim.place, measured.times_s, measured.values);
    }
    return metric.is_of_run() ? measure(metric, run(of), claim.place) : measure(metric, surface(of), claim.place);
  }

 private:
  const Results& run(const std::string& name) { return runs_.try_emplace(name, place_.run(name)).first->second; }
  const Fracture& surface(const std::string& name) {
    const auto found = surfaces_.find(name);
    return found != surfaces_.end() ? found->second
                                    : surfaces_.emplace(name, read_fracture(place_.surface(name) / "fracture.json")).first->second;
  }

  const FigurePaths& place_;
  const Computed& computed_;
  std::map<std::string, Results> runs_;
  std::map<std::string, Fracture> surfaces_;
};

MetricWords words_of(const Claim& claim, const Computed& computed) {
  if (!claim.of.empty()) {
    const Metric& metric = find_metric(claim.metric);
    if (claim.measured.empty()) return {metric.unit, metric.meaning};
    return {metric.unit, fmt::format("distance from the points measured as {}, root mean square: {}", claim.measured, metric.meaning)};
  }
  const ComputedNumber& number = *find_named(computed.numbers, claim.metric);
  return {number.unit, number.meaning};
}

nlohmann::json json_of(const std::optional<double>& number) { return number ? nlohmann::json(*number) : nlohmann::json(); }

nlohmann::json json_of(const ClaimVerdict& v) {
  return {{"metric", v.metric},       {"meaning", v.meaning},    {"of", v.of},          {"measured", v.measured}, {"unit", v.unit},
          {"condition", v.condition}, {"kind", word_of(v.kind)}, {"why", v.why},        {"says", v.says},         {"low", json_of(v.low)},
          {"high", json_of(v.high)},  {"holds", v.holds},        {"problem", v.problem}};
}

nlohmann::json json_of(const FigurePaths& paths, const FigureRun& run) {
  const nlohmann::json description = Results(paths.run(run.name)).description();
  const nlohmann::json& summary = description["summary"];
  return {{"name", run.name},
          {"scene", run.scene},
          {"set", run.set},
          {"particles", summary["particles"]},
          {"steps", summary["steps"]},
          {"simulated_s", summary["time_s"]},
          {"seconds", summary["wall_s"]},
          {"provenance", description["provenance"]}};
}

nlohmann::json json_of(const FigurePicture& picture) {
  return {{"file", picture.name + ".png"}, {"shows", picture.shows}, {"kind", word_of(picture.kind)}};
}

nlohmann::json json_of(const FigureMontage& montage) {
  return {{"file", montage.name + ".png"}, {"shows", montage.shows}, {"kind", "montage"}};
}

/// Montages, and the pictures that stand in none.
nlohmann::json pictures_of(const Figure& figure) {
  nlohmann::json pictures = nlohmann::json::array();
  std::set<std::string> tiles;
  for (const FigureMontage& montage : figure.montages) {
    pictures.push_back(json_of(montage));
    for (const Place& place : layout_of(montage.rows).places) tiles.insert(place.name);
  }
  for (const FigurePicture& picture : figure.pictures)
    if (!tiles.contains(picture.name)) pictures.push_back(json_of(picture));
  return pictures;
}

nlohmann::json json_of(const FigureChart& chart) { return {{"file", chart.name + ".svg"}, {"shows", chart.shows}}; }

nlohmann::json json_of(const FigureObject& object) {
  return {{"name", object.name}, {"shows", object.shows}, {"picture", object.picture}, {"of", object.of}, {"particles", object.particles}};
}

nlohmann::json json_of(const ComputedNumber& n) { return {{"name", n.name}, {"value", n.value}, {"unit", n.unit}, {"meaning", n.meaning}}; }

nlohmann::json json_of(const ComputedTable& t) { return {{"name", t.name}, {"title", t.title}, {"header", t.header}, {"rows", t.rows}}; }

/// Of the verdicts those of what is shown.
struct Held {
  int hold = 0, all = 0;
  bool every_run = true;  ///< whether something is claimed of each that is shown

  /// No number where nothing is claimed: what nobody measured holds nothing.
  double share() const { return every_run && all > 0 ? static_cast<double>(hold) / all : std::nan(""); }
};

Held held_of(const std::vector<std::string>& runs, const Figure& part, const std::vector<ClaimVerdict>& verdicts) {
  Held held;
  for (const std::string& run : runs) {
    const int before = held.all;
    for (const ClaimVerdict& v : verdicts)
      if (belongs_to(part, v.of, run)) {
        ++held.all;
        held.hold += v.holds;
      }
    if (held.all == before) held.every_run = false;
  }
  return held;
}

template <class T>
nlohmann::json json_list(const std::vector<T>& list) {
  nlohmann::json array = nlohmann::json::array();
  for (const T& one : list) array.push_back(json_of(one));
  return array;
}

}  // namespace

void add_parts(const FigurePaths& paths, Computed& computed) {
  ComputedTable table{"tiles", "Where the tiles come from", {"tile", "figure", "runs", "their claims that hold"}, {}};
  for (const FigurePicture& picture : paths.figure.pictures) {
    if (!picture.part) continue;
    const std::vector<std::string> runs = runs_shown(picture, *picture.part);
    const Held held = held_of(runs, *picture.part, check_claims(shown_by(picture, paths), {}));
    computed.numbers.push_back({claims_number(picture), "1",
                                fmt::format("share of the claims of {} that hold of what is shown", picture.figure), held.share(),
                                fraction});
    table.rows.push_back(
        {picture.name, picture.figure, fmt::format("{}", fmt::join(runs, ", ")), fmt::format("{} of {}", held.hold, held.all)});
  }
  if (!table.rows.empty()) computed.tables.push_back(std::move(table));
}

std::vector<ClaimVerdict> check_claims(const FigurePaths& paths, const Computed& computed) {
  Measured measured(paths, computed);
  std::vector<ClaimVerdict> verdicts;
  for (const Claim& claim : paths.figure.claims) {
    if (!claim.is_judged_at(paths.quality())) continue;
    for (ClaimVerdict& v : judge(claim, words_of(claim, computed), std::ref(measured))) verdicts.push_back(std::move(v));
  }
  return verdicts;
}

void write_claims(const FigurePaths& paths, const Computed& computed, const std::vector<ClaimVerdict>& verdicts) {
  nlohmann::json runs = nlohmann::json::array();
  std::set<std::string> listed;
  for (const FigurePaths& part : with_parts(paths))
    for (const FigureRun& run : part.figure.runs)
      if (listed.insert(run.name).second) runs.push_back(json_of(part, run));
  const nlohmann::json all{{"number", paths.item.number},
                           {"name", paths.item.name},
                           {"quality", paths.quality()},
                           {"title", paths.figure.title},
                           {"shows", paths.figure.shows},
                           {"claims", json_list(verdicts)},
                           {"runs", runs},
                           {"numbers", json_list(computed.numbers)},
                           {"tables", json_list(computed.tables)},
                           {"pictures", paths.options.pictures ? pictures_of(paths.figure) : nlohmann::json::array()},
                           {"objects", paths.options.pictures ? json_list(paths.figure.objects) : nlohmann::json::array()},
                           {"charts", json_list(paths.figure.charts)},
                           {"provenance", provenance()}};
  std::filesystem::create_directories(paths.item_folder());
  write_text_atomically(paths.item_folder() / "claims.json", all.dump(2) + "\n");
}

}  // namespace bake
