// SPDX-License-Identifier: MIT
#include "experiments/make/figure_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

#include "analysis/image/layout.h"
#include "solver/scene/nearest.h"
#include "solver/scene/read_value.h"

namespace bake {
namespace {

namespace fs = std::filesystem;

template <class T>
std::vector<std::string> names_in(const std::vector<T>& list) {
  std::vector<std::string> names;
  names.reserve(list.size());
  for (const T& one : list) names.push_back(one.name);
  return names;
}

std::vector<std::string> runs_and_surfaces(const Figure& figure) {
  auto names = names_in(figure.runs);
  for (const auto& name : names_in(figure.surfaces)) names.push_back(name);
  return names;
}

bool is_one_of(const std::vector<std::string>& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

/// Complains about an unknown name.
void check_known(const SceneEntry& entry, std::string_view key, const std::string& name, const char* what,
                 const std::vector<std::string>& known) {
  if (!is_one_of(known, name))
    entry.complain_at(key,
                      fmt::format("unknown {} '{}'; {}", what, quotable(name), known.empty() ? "there is none" : suggestion(name, known)));
}

/// Checks a name, which becomes part of a file's name.
void check_name(const SceneEntry& entry, const std::string& name, const std::vector<std::string>& taken) {
  if (name.empty() || name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") != std::string::npos)
    entry.complain_at("name", fmt::format("found '{}', allowed: a-z, 0-9 and _", quotable(name)));
  if (std::find(taken.begin(), taken.end(), name) != taken.end()) entry.complain_at("name", fmt::format("found '{}' again", name));
}

void check(const SceneEntry& entry, const FigureRun& run, const Figure& figure, const ComputedNames&) {
  check_name(entry, run.name, runs_and_surfaces(figure));
  if (!fs::is_regular_file(scene_file(figure, run)))
    entry.complain_at("scene",
                      fmt::format("found '{}', allowed: a scene ({} is not there)", quotable(run.scene), scene_file(figure, run).string()));
}

void check(const SceneEntry& entry, const FigureSurface& surface, const Figure& figure, const ComputedNames&) {
  check_name(entry, surface.name, runs_and_surfaces(figure));
  check_known(entry, "run", surface.run, "run", names_in(figure.runs));
  if (!find_named(figure.runs, surface.run)->mesh)
    entry.complain_at("run", fmt::format("found '{}', allowed: a run with mesh = true", surface.run));
}

void check_view(const SceneEntry& entry, const std::string& view, const Figure& figure) {
  const fs::path file = view_file(figure, view);
  if (!fs::is_regular_file(file))
    entry.complain_at("view", fmt::format("found '{}', allowed: a view ({} is not there)", quotable(view), file.string()));
}

/// Of a figure what a picture shows, with its claims, and what these compare it with.
Figure part_of(const Figure& figure, const FigurePicture& picture) {
  Figure part;
  part.file = figure.file;
  part.title = figure.title;
  part.measured = figure.measured;  // which claims may be compared with
  const std::vector<std::string> shown = runs_shown(picture, figure);
  const auto is_shown = [&](const std::string& name) {
    return std::any_of(shown.begin(), shown.end(), [&](const std::string& run) { return belongs_to(figure, name, run); });
  };
  std::set<std::string> needed(shown.begin(), shown.end());
  needed.insert(picture.of.begin(), picture.of.end());
  for (Claim claim : figure.claims) {
    if (std::none_of(claim.of.begin(), claim.of.end(), is_shown)) continue;
    if (!claim.order) std::erase_if(claim.of, [&](const std::string& name) { return !is_shown(name); });  // each is judged by itself
    needed.insert(claim.of.begin(), claim.of.end());
    if (!claim.greater_than.empty()) needed.insert(claim.greater_than);
    part.claims.push_back(std::move(claim));
  }
  for (const FigureSurface& surface : figure.surfaces)
    if (needed.contains(surface.name)) {
      part.surfaces.push_back(surface);
      needed.insert(surface.run);
    }
  for (const FigureRun& run : figure.runs)
    if (needed.contains(run.name)) part.runs.push_back(run);
  return part;
}

Figure read_other(const SceneEntry& entry, const std::string& item, const ComputedNames& names) {
  try {
    if (names.other) return names.other(item);
  } catch (const InputError& error) {
    entry.complain_at("figure", error.what());
  }
  entry.complain_at("figure", "allowed: in the figure.toml of an item of the paper");
}

void check(const SceneEntry& entry, FigurePicture& picture, const Figure& own, const ComputedNames& names) {
  check_name(entry, picture.name, names_in(own.pictures));
  check_view(entry, picture.view, own);
  const Figure other = picture.figure.empty() ? Figure{} : read_other(entry, picture.figure, names);
  const Figure& figure = picture.figure.empty() ? own : other;
  auto known = runs_and_surfaces(figure);
  for (const FigureRun& run : figure.runs) known.push_back(run.name + std::string(k_skin_of));
  for (const std::string& name : picture.of) check_known(entry, "of", name, "run, surface or skin", known);
  if (!picture.figure.empty()) picture.part = std::make_shared<const Figure>(part_of(other, picture));
}

void check(const SceneEntry& entry, const FigureMontage& montage, const Figure& figure, const ComputedNames&) {
  auto taken = names_in(figure.pictures);
  for (const std::string& name : names_in(figure.montages)) taken.push_back(name);
  check_name(entry, montage.name, taken);
  const Layout layout = layout_of(montage.rows);
  if (!layout.problem.empty()) entry.complain_at("rows", layout.problem);
  for (const Place& place : layout.places) check_known(entry, "rows", place.name, "picture", names_in(figure.pictures));
}

void check(const SceneEntry& entry, const FigureMeasured& measured, const Figure& figure, const ComputedNames&) {
  check_name(entry, measured.name, names_in(figure.measured));
  for (const auto& [key, text] : {std::pair{"source", &measured.source}, {"reading", &measured.reading}})
    if (text->empty()) entry.complain_at(key, "found \"\", allowed: words");
  const std::vector<double>& times = measured.times_s;
  if (times.empty()) entry.complain_at("times_s", "found [], allowed: one time or more");
  if (std::adjacent_find(times.begin(), times.end(), std::greater_equal<>()) != times.end())
    entry.complain_at("times_s", "allowed: rising times");
  if (measured.values.size() != times.size())
    entry.complain_at("values", fmt::format("found {}, allowed: as many as times_s, {}", measured.values.size(), times.size()));
}

void check(const SceneEntry& entry, const FigureObject& object, const Figure& figure, const ComputedNames&) {
  check_name(entry, object.name, names_in(figure.objects));
  check_view(entry, object.view, figure);
  check_known(entry, "picture", object.picture, "picture", names_in(figure.pictures));
  if (object.of.empty()) entry.complain_at("of", "found [], allowed: a run, or a list of them");
  for (const std::string& name : object.of) check_known(entry, "of", name, "run", names_in(figure.runs));
}

/// Checks that the metric is one of a run, and over time one that has a time, which the chart sets.
void check_metrics(const SceneEntry& entry, const FigureChart& chart) {
  std::vector<std::string> known;
  const bool over_time = chart.against.empty();
  for (const Metric& metric : all_metrics())
    if (metric.is_of_run() && (!over_time || std::find(metric.knows.begin(), metric.knows.end(), "time_s") != metric.knows.end()))
      known.emplace_back(metric.name);
  check_known(entry, "metric", chart.metric, over_time ? "metric of a run that has a time" : "metric of a run", known);
  if (chart.place.time_s) entry.complain_at("time_s", over_time ? "the chart is drawn over all times" : "the chart shows the end");
  check_place(entry, find_metric(chart.metric), chart.place);
  if (over_time) return;
  check_known(entry, "against", chart.against, "metric of a run", known);
  check_place(entry, find_metric(chart.against), chart.place);
}

void check(const SceneEntry& entry, const FigureChart& chart, const Figure& figure, const ComputedNames& computed) {
  check_name(entry, chart.name, names_in(figure.charts));
  const int sources = !chart.column.empty() + !chart.metric.empty();
  if (sources > 1 || (sources == 0) != chart.of.empty())
    entry.complain_at("column", "allowed: column or metric, with `of`, or a name alone");
  if (sources == 0) check_known(entry, "name", chart.name, "chart", computed.charts);
  if (!chart.metric.empty()) check_metrics(entry, chart);
  if (!chart.against.empty() && chart.metric.empty()) entry.complain_at("against", "needs a metric beside it");
  for (const std::string& name : chart.of) check_known(entry, "of", name, "run", names_in(figure.runs));
  for (const std::string& name : chart.measured) check_known(entry, "measured", name, "[[measured]]", names_in(figure.measured));
  if (!chart.measured.empty() && (chart.metric.empty() || !chart.against.empty() || chart.measured.size() > chart.of.size()))
    entry.complain_at("measured", "allowed: beside a metric over time, at most as many as runs");
}

/// Checks that the surface has the time, and that something can have broken by then.
void check_time(const SceneEntry& entry, const Claim& claim, const FigureSurface& surface) {
  const std::vector<double>& times = surface.times_s;
  if (!claim.place.time_s && times.empty()) return;  // at the end
  const double time = claim.place.time_s.value_or(times.empty() ? 0 : times.back());
  if (claim.place.time_s && std::find(times.begin(), times.end(), time) == times.end())
    entry.complain_at("time_s", fmt::format("found {}, allowed: a time of surface '{}': {}", time, surface.name,
                                            times.empty() ? "none, for the end" : fmt::format("{}", fmt::join(times, ", "))));
  if (time <= surface.reference_time_s)
    entry.complain_at(claim.place.time_s ? "time_s" : "of",
                      fmt::format("found surface '{}' at {} s, allowed: after its reference time, {} s, at which nothing is broken",
                                  surface.name, time, surface.reference_time_s));
}

/// Checks that the metric can be measured of the run or surface that the claim names.
void check(const SceneEntry& entry, const Claim& claim, const Figure& figure) {
  if (!claim.measured.empty()) check_known(entry, "measured", claim.measured, "[[measured]]", names_in(figure.measured));
  auto names = claim.of;
  if (!claim.greater_than.empty()) names.push_back(claim.greater_than);
  for (const std::string& name : names) {
    const char* key = name == claim.greater_than ? "greater_than" : "of";
    check_known(entry, key, name, "run or surface", runs_and_surfaces(figure));
    const bool is_run = find_named(figure.runs, name);
    if (is_run == find_metric(claim.metric).is_of_run()) {
      if (!is_run) check_time(entry, claim, *find_named(figure.surfaces, name));
      continue;
    }
    entry.complain_at(key, fmt::format("found '{}', a {}, allowed: a {}, of which {} is measured", name, is_run ? "run" : "surface",
                                       is_run ? "surface" : "run", claim.metric));
  }
}

template <class T>
T read_one(const SceneEntry& entry) {
  return read_table<T>(entry);
}

template <>
FigureChart read_one(const SceneEntry& entry) {
  entry.expect_table();
  entry.refuse_unknown(keys_of<FigureChart, MetricPlace>());
  FigureChart chart;
  read_members(entry, chart, Demand::required_keys);
  read_members(entry, chart.place, Demand::nothing);
  return chart;
}

template <class T>
void read_tables(const SceneEntry& root, const char* key, std::vector<T> Figure::*member, Figure& figure, const ComputedNames& computed) {
  for (const SceneEntry& entry : root.tables(key)) {
    T one = read_one<T>(entry);
    check(entry, one, figure, computed);
    (figure.*member).push_back(std::move(one));
  }
}

std::string required_text(const SceneEntry& root, const char* key) {
  const auto entry = root.find(key);
  if (!entry) root.refuse_missing(key, allowed<std::string>({}));
  return read_text(*entry);
}

}  // namespace

Figure read_figure(const fs::path& file, const ComputedNames& computed) {
  const Document document{file.string(), file.parent_path()};
  const toml::table table = parse_toml(read_text_file(file), document.name);
  const SceneEntry root(document, table);
  root.refuse_unknown(
      {"title", "shows", "timed", "run", "surface", "picture", "montage", "object", "measured", "chart", "claim", "blessed"});
  Figure figure;
  figure.file = file;
  figure.title = required_text(root, "title");
  figure.shows = required_text(root, "shows");
  if (const auto timed = root.find("timed")) figure.timed = read_truth(*timed);
  read_tables(root, "run", &Figure::runs, figure, computed);
  read_tables(root, "surface", &Figure::surfaces, figure, computed);
  read_tables(root, "picture", &Figure::pictures, figure, computed);
  read_tables(root, "montage", &Figure::montages, figure, computed);
  read_tables(root, "object", &Figure::objects, figure, computed);
  read_tables(root, "measured", &Figure::measured, figure, computed);
  read_tables(root, "chart", &Figure::charts, figure, computed);
  std::vector<KnownNumber> numbers = computed.numbers;
  for (const FigurePicture& picture : figure.pictures)
    if (picture.part) numbers.push_back({claims_number(picture), fraction});
  for (const SceneEntry& entry : root.tables("claim")) {
    figure.claims.push_back(read_claim(entry, numbers));
    check(entry, figure.claims.back(), figure);
  }
  if (figure.claims.empty()) root.refuse_missing("claim", "at least one: what is shown must be measured");
  return figure;
}

std::vector<std::string> runs_shown(const FigurePicture& picture, const Figure& figure) {
  std::vector<std::string> runs;
  for (const std::string& name : picture.of) {
    const FigureSurface* surface = find_named(figure.surfaces, name);
    const std::string run = surface ? surface->run : name.substr(0, name.find(k_skin_of));
    if (!is_one_of(runs, run)) runs.push_back(run);
  }
  return runs;
}

std::vector<std::string> runs_of(const Figure& figure) {
  std::vector<std::string> runs = names_in(figure.runs);
  for (const FigurePicture& picture : figure.pictures)
    if (picture.part)
      for (const std::string& run : names_in(picture.part->runs))
        if (!is_one_of(runs, run)) runs.push_back(run);
  return runs;
}

bool belongs_to(const Figure& figure, const std::string& name, const std::string& run) {
  const FigureSurface* surface = find_named(figure.surfaces, name);
  return name == run || (surface && surface->run == run);
}

fs::path scene_file(const Figure& figure, const FigureRun& run) {
  const fs::path folder = figure.file.parent_path();
  return (run.scene.find('/') == std::string::npos ? folder : folder.parent_path()) / (run.scene + ".toml");
}

fs::path view_file(const Figure& figure, const std::string& view) { return figure.file.parent_path() / "views" / (view + ".toml"); }

}  // namespace bake
