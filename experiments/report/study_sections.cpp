// SPDX-License-Identifier: MIT
// Tables of the results that the studies have stored in paper/*.json.
#include <fmt/format.h>

#include <map>

#include "experiments/report/sections.h"
#include "solver/core/errors.h"
#include "solver/io/json_fault.h"
#include "solver/scene/entry.h"

namespace bake::report {
namespace {

using nlohmann::json;

std::string word(const json& object, const char* key) { return object.at(key); }

Html made_by(const json& study) {
  const json& made = study.at("provenance");
  return element("p",
                 text(fmt::format("Measured {} with commit {} on {}.", word(made, "date").substr(0, 10),
                                  word(made.at("program"), "commit").substr(0, 10), word(made.at("machine"), "cpu"))),
                 "class=\"soft\"");
}

/// A study, folded: its title and what it is about are seen.
Html study_section(const char* id, const char* title, const char* words, const json& study, const Html& table) {
  const Html summary = element("summary", join({element("h2", join({text(title), link_to(id, title)})), element("p", text(words))}));
  return element("section", element("details", join({summary, table, made_by(study)})), fmt::format("id=\"{}\"", id));
}

/// The largest stable step divided by that of the time-step rule, over the points of one map.
struct Edges {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  int count = 0;
  bool holds = true, has_limit = true;
};

}  // namespace

std::optional<json> read_json(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return std::nullopt;
  try {
    return json::parse(read_text_file(file));
  } catch (const json::exception& error) {
    throw InputError(fmt::format("{}: damaged: {}", file.string(), json_fault(error)));
  }
}

Html orders_section(const std::filesystem::path& root) {
  const auto study = read_json(root / "paper/orders.json");
  if (!study) return {};
  std::vector<std::vector<Html>> rows;
  for (const json& order : study->at("orders"))
    rows.push_back({text(word(order, "exact_solution")), text(word(order, "quantity")), text(number(order.at("value"))),
                    text(fmt::format("{} to {}", number(order.at("low")), number(order.at("high")))),
                    badge(order.at("holds").get<bool>())});
  return study_section("orders", "Orders of convergence", "Errors against exact solutions fall with these powers of the resolution.",
                       *study, table({"exact solution", "error of", "order", "promised", "verdict"}, rows));
}

Html departures_section(const std::filesystem::path& root) {
  const auto study = read_json(root / "paper/departures.json");
  if (!study) return {};
  std::vector<std::vector<Html>> rows;
  for (const json& one : study->at("consequences"))
    rows.push_back({text(word(one, "equation")), text_with_code(word(one, "printed")), text_with_code(word(one, "instead")),
                    text(with_signs(word(one, "measured"))), text(with_signs(word(one, "expected"))), text(number(one.at("published"))),
                    text(number(one.at("standard")))});
  return study_section("departures", "Departures from the printed equations",
                       "Where the printed form can be run, this is what it does to a small case.", *study,
                       table({"equation", "printed", "instead", "measured", "right is", "as printed", "here"}, rows));
}

Html stability_section(const std::filesystem::path& root) {
  const auto study = read_json(root / "paper/stability.json");
  if (!study) return {};
  std::map<std::string, Edges> maps;
  for (const json& edge : study->at("edges")) {
    Edges& map = maps[word(edge, "map")];
    ++map.count;
    map.has_limit = edge.at("has_limit");
    map.holds = map.holds && edge.at("safe").get<bool>() && edge.at("sharp").get<bool>();
    if (!edge.at("factor").is_number()) continue;
    map.least = std::min(map.least, edge.at("factor").get<double>());
    map.most = std::max(map.most, edge.at("factor").get<double>());
  }
  std::vector<std::vector<Html>> rows;
  rows.reserve(maps.size());
  for (const auto& [name, map] : maps)
    rows.push_back({text(name), text(std::to_string(map.count)),
                    text(map.has_limit ? fmt::format("{:.2f} to {:.2f}", map.least, map.most) : "no edge to be found"), badge(map.holds)});
  return study_section("stability", "Where the method breaks",
                       "The largest step with which nothing grows, over the step that the rule takes, for hard and soft, fine and coarse, "
                       "few and many particles.",
                       *study, table({"map", "points", "largest stable step over the rule's", "verdict"}, rows));
}

Html effects_section(const std::filesystem::path& root) {
  const auto study = read_json(root / "paper/effects.json");
  if (!study) return {};
  std::vector<std::vector<Html>> rows;
  for (const json& point : study->at("points"))
    rows.push_back({text(word(point, "scene")), text(word(point, "effects")),
                    text(fmt::format("{:.1f}", point.at("added_cpu_ns").get<double>())),
                    text(fmt::format("{:.0f} %", 100 * point.at("run_cpu_share").get<double>())),
                    text(fmt::format("{:.2g}", point.at("largest_change_over_error").get<double>())), text(word(point, "of"))});
  return study_section(
      "effects", "What each effect costs, and what it changes",
      "Each effect left out of a scene in turn: the processor time that it adds to a particle-step and to the run, and the largest "
      "change of what the scene is run for, in units of the difference between two grids.",
      *study, table({"scene", "without", "ns per particle-step", "of the run", "change over error", "of"}, rows));
}

Html accuracy_section(const std::filesystem::path& root) {
  const auto study = read_json(root / "paper/accuracy.json");
  if (!study) return {};
  std::vector<std::vector<Html>> rows;
  std::vector<Html> charts, parts;
  for (const json& one : study->at("cases")) {
    const auto cell = [](const json& at) {
      return text(at.is_null() ? "not reached" : fmt::format("{}, {} cells", word(at, "setting"), at.at("cells").get<int>()));
    };
    const std::string name = word(one, "case");
    rows.push_back({text(name)});
    for (const json& goal : one.at("goals")) rows.back().push_back(cell(goal.at("by_particle_steps")));
    std::vector<Html> sentences{element("strong", text(name)), element("div", text(word(one, "measured")), "class=\"soft\"")};
    for (const json& sentence : one.at("conclusions")) sentences.push_back(element("p", text(sentence.get<std::string>())));
    const auto chart = root / "paper/accuracy" / (name + ".svg");
    if (std::filesystem::exists(chart))
      charts.push_back(
          element("figure", join({picture(chart, "Error against cost: " + word(one, "measured")), element("figcaption", text(name))})));
    parts.push_back(element("li", join(sentences)));
  }
  const Html cases = element("details", join({element("summary", text("What each case tells")), element("ul", join(parts))}));
  const Html small = element("div", join(charts), "class=\"plots\"");
  return study_section("accuracy", "What accuracy costs",
                       "Relative errors against exact solutions or fine runs, beside the particle-steps and the time that they cost.",
                       *study, join({small, table({"cheapest for", "10 %", "3 %", "1 %", "0.3 %"}, rows), cases}));
}

}  // namespace bake::report
