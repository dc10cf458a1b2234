// SPDX-License-Identifier: MIT
#include "experiments/accuracy/result.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/scene/reader.h"
#include "solver/scene/resolved.h"

namespace bake::studies::accuracy {

namespace {

using nlohmann::json;

Spread spread(const std::vector<json>& lines, const char* group, const char* key) {
  std::vector<double> values;
  values.reserve(lines.size());
  for (const json& line : lines) values.push_back(line.at(group).at(key));
  return spread_of(values);
}

Point point_of(const Variant& v, const std::vector<json>& lines) {
  const json& first = lines.front().at("found");
  Point p;
  p.variant = v;
  p.repeats = static_cast<int>(lines.size());
  p.failure = first.at("failure");
  p.error = first.at("error").is_null() ? std::nan("") : first.at("error").get<double>();
  if (p.failure.empty() && p.error > 1) p.failure = "the error is above 100 %";
  p.parts = first.at("parts").get<std::map<std::string, double>>();
  p.particles = first.at("particles");
  p.steps = first.at("steps");
  p.particle_steps = first.at("particle_steps");
  p.wall_s = spread(lines, "found", "wall_s");
  p.cpu_s = spread(lines, "found", "cpu_s");
  p.load_average = spread(lines, "when", "load_average");
  for (const json& line : lines)
    if (const json& when = line.at("when"); when.contains("speed")) {
      const json& s = when.at("speed");
      p.speeds.push_back({s.at("triad_GB_per_s"), s.at("single_GFLOPs"), s.at("double_GFLOPs")});
    }
  p.same_error =
      std::all_of(lines.begin(), lines.end(), [&](const json& line) { return line.at("found").at("error") == first.at("error"); });
  return p;
}

json as_json(const Spread& s) { return {{"median", s.median}, {"low", s.low}, {"high", s.high}}; }

json place(const Point* p) { return p ? json{{"setting", p->variant.label}, {"cells", p->variant.cells}} : json(nullptr); }

}  // namespace

CaseResult::CaseResult(const Case& c, const RawData& raw) : case_(&c) {
  for (const Variant& v : variants_of(c, Effort::full)) {
    const auto& lines = raw.of(identity_of(c, v, c.scene_of(v)));
    if (lines.empty()) continue;
    if (curves_.empty() || curves_.back().label != v.label) curves_.push_back({v.label, {}});
    curves_.back().points.push_back(point_of(v, lines));
  }
  for (Curve& curve : curves_) settle(curve);
}

const Curve* CaseResult::default_curve() const { return !empty() && curves_.front().label == "default" ? &curves_.front() : nullptr; }

std::vector<QualityResult> CaseResult::qualities() const {
  constexpr std::array names{"draft", "standard", "paper"};
  std::vector<QualityResult> all;
  const Curve* curve = default_curve();
  if (!curve) return all;
  for (std::size_t q = 0; q < std::min(names.size(), case_->quality.size()); ++q)
    for (const Point& p : curve->points)
      if (p.variant.cells == case_->quality[q] && std::isfinite(p.settled))
        all.push_back({names[q], &p, excess(curves_, p, particle_steps), excess(curves_, p, cpu_seconds),
                       cheapest(curves_, p.settled, particle_steps)});
  return all;
}

const Curve* CaseResult::curve_of(const std::string& label) const {
  const auto at = std::find_if(curves_.begin(), curves_.end(), [&](const Curve& c) { return c.label == label; });
  return at == curves_.end() ? nullptr : &*at;
}

std::pair<const Point*, const Point*> finest_common(const Curve* a, const Curve* b) {
  std::pair<const Point*, const Point*> found{nullptr, nullptr};
  if (!a || !b) return found;
  for (const Point& p : a->points)
    for (const Point& q : b->points)
      if (p.variant.cells == q.variant.cells && !p.failed() && !q.failed()) found = {&p, &q};
  return found;
}

bool CaseResult::same_errors() const {
  for (const Curve& curve : curves_)
    for (const Point& p : curve.points)
      if (!p.same_error) return false;
  return true;
}

bool CaseResult::falls() const {
  const Curve* curve = default_curve();
  if (!curve || curve->points.size() < 2) return true;
  return curve->points.back().error < curve->points.front().error;
}

MachineSpeed speed_of(const std::vector<CaseResult>& results) {
  std::vector<double> triad, in_single, in_double;
  for (const CaseResult& r : results)
    for (const Curve& curve : r.curves())
      for (const Point& p : curve.points)
        for (const bench::Speed& s : p.speeds) {
          triad.push_back(s.triad_GB_per_s);
          in_single.push_back(s.single_GFLOPs);
          in_double.push_back(s.double_GFLOPs);
        }
  if (triad.empty()) return {};
  return {static_cast<int>(triad.size()), spread_of(triad), spread_of(in_single), spread_of(in_double)};
}

json as_json(const MachineSpeed& speed) {
  if (speed.known == 0) return nullptr;
  return {{"threads", 1},
          {"measurements", speed.known},
          {"triad_GB_per_s", as_json(speed.triad_GB_per_s)},
          {"single_GFLOPs", as_json(speed.single_GFLOPs)},
          {"double_GFLOPs", as_json(speed.double_GFLOPs)}};
}

std::string words_of(const Point& point) {
  const int cells = point.variant.cells;
  return fmt::format("{}, {} {}", point.variant.label, cells, cells == 1 ? "cell" : "cells");
}

std::string brief(double number) { return number < 99.5 ? fmt::format("{:.2g}", number) : fmt::format("{:.0f}", number); }

std::string percent(double share) { return brief(100 * share) + " %"; }

json as_json(const CaseResult& result) {
  json goals = json::array(), qualities = json::array();
  for (const double goal : k_goals)
    goals.push_back({{"error", goal},
                     {"by_particle_steps", place(cheapest(result.curves(), goal, particle_steps))},
                     {"by_cpu_s", place(cheapest(result.curves(), goal, cpu_seconds))}});
  for (const QualityResult& q : result.qualities())
    qualities.push_back({{"quality", q.quality},
                         {"cells", q.point->variant.cells},
                         {"error", q.point->error},
                         {"particle_steps", q.point->particle_steps},
                         {"wall_s", q.point->wall_s.median},
                         {"cpu_s", q.point->cpu_s.median},
                         {"repeats", q.point->repeats},
                         {"load_average", q.point->load_average.median},
                         {"excess_particle_steps", q.excess_particle_steps},
                         {"excess_cpu", q.excess_cpu},
                         {"better", place(q.better)}});
  const Case& c = result.of();
  const json fingerprint = c.scene.empty() ? json(nullptr) : json(scene_fingerprint(read_scene(scene_path(c.scene))));
  return {{"case", c.name},         {"scene_fingerprint", fingerprint},
          {"measured", c.measured}, {"scene", c.scene},
          {"cells_of", c.cells_of}, {"goals", goals},
          {"qualities", qualities}, {"conclusions", conclusions(result)}};
}

}  // namespace bake::studies::accuracy
