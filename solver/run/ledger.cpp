// SPDX-License-Identifier: MIT
#include "solver/run/ledger.h"

#include <fmt/format.h>

#include <algorithm>

#include "solver/effects/all_effects.h"
#include "solver/effects/common.h"
#include "solver/engine/sheets.h"
#include "solver/run/simulation.h"
#include "solver/scene/scene.h"

namespace bake {
namespace {

constexpr const char* k_skin = "[[skin]]";  ///< no effect, but has columns
constexpr const char* k_at_frame = "state at the frame";
constexpr const char* k_summed = "summed over the particles at the frame";
constexpr const char* k_booked = "booked in every step, summed since the start";
constexpr const char* k_left = "summed over the particles that left through open faces, when they left";
constexpr const char* k_poured = "summed over the particles that emitters poured, when they were poured";

/// "kg m^2/s" as a name's end: "_kg_m2_per_s".
std::string as_suffix(std::string_view unit) {
  std::string text = "_";
  for (const char c : unit) text += c == ' ' ? "_" : c == '/' ? "_per_" : c == '^' ? "" : std::string(1, c);
  return text == "_" || text == "_1" ? "" : text;
}

/// Takes down the columns of one effect.
class Columns {
 public:
  Columns(std::vector<LedgerColumn>& all, const char* effect) : all_(all), effect_(effect) {}

  /// One column for each of the numbers of a quantity; none if it has no name.
  template <class Q, class Value>
  void add(Q, const std::string& prefix, const char* how, Value value) {
    if (std::string_view(Q::name).empty()) return;
    for (int i = 0; i < Q::width; ++i) {
      const std::string axis = Q::width == 3 ? fmt::format("_{}", "xyz"[i]) : "";
      all_.push_back({fmt::format("{}{}{}{}", prefix, Q::name, axis, as_suffix(Q::unit)), Q::unit, Q::meaning, how, effect_,
                      [value, i](const Simulation& now, const Box3&) { return value(now, i); }});
    }
  }
  /// A column that is made of others.
  template <class Value>
  void made(const char* name, const char* unit, const char* meaning, Value value) {
    all_.push_back(
        {name + as_suffix(unit), unit, meaning, k_at_frame, effect_, [value](const Simulation& now, const Box3&) { return value(now); }});
  }

 private:
  std::vector<LedgerColumn>& all_;
  std::string effect_;
};

template <class E>
void add_columns(std::vector<LedgerColumn>& all, const char* effect) {
  Columns columns(all, effect);
  E::Totals::for_each([&](auto q) { columns.add(q, "", k_summed, [q](const Simulation& now, int i) { return now.total(q, i); }); });
  E::Booked::for_each([&](auto q) { columns.add(q, "", k_booked, [q](const Simulation& now, int i) { return now.booked(q, i); }); });
  BAKE_CALL(E, ledger, columns);
}

template <class E>
void add_passing(std::vector<LedgerColumn>& all, const char* effect) {
  Columns columns(all, effect);
  E::Totals::for_each([&](auto q) {
    columns.add(q, "retired_", k_left, [q](const Simulation& now, int i) { return now.retired(q, i); });
    columns.add(q, "emitted_", k_poured, [q](const Simulation& now, int i) { return now.emitted(q, i); });
  });
}

std::vector<LedgerColumn> make_ledger() {
  std::vector<LedgerColumn> all;
  Columns run(all, "");
  const auto add_extent = [&](const char* name, const char* meaning, std::size_t axis) {
    all.push_back({name, "m", meaning, k_at_frame, "",
                   [axis](const Simulation& now, const Box3& box) { return now.particles() == 0 ? 0 : box.high[axis] - box.low[axis]; }});
  };
  run.made("time", "s", "simulated time", [](const Simulation& now) { return now.time(); });
  run.made("steps", "1", "time steps so far", [](const Simulation& now) { return double(now.counters().steps); });
  run.made("dt", "s", "length of the step that comes next", [](const Simulation& now) { return now.dt(); });
  run.made("particles", "1", "particles in the domain", [](const Simulation& now) { return double(now.particles()); });
  run.made("retired_particles", "1", "particles that left through open faces",
           [](const Simulation& now) { return double(now.counters().retired); });
  run.made("clamped_particles", "1", "times that a particle was held at a closed face",
           [](const Simulation& now) { return double(now.counters().clamped); });
  add_extent("height_m", "extent of the particles along z", 2);
  add_extent("extent_x_m", "extent of the particles along x", 0);
  add_extent("extent_y_m", "extent of the particles along y", 1);
  add_columns<Common>(all, "");
  for_each_effect([&]<class E>() { add_columns<E>(all, E::name); });
  Columns skin(all, k_skin);
  skin.made("skin_membrane", "J", "energy of stretched skin", [](const Simulation& now) { return now.skin_sums().membrane; });
  skin.made("skin_bending", "J", "energy of bent skin", [](const Simulation& now) { return now.skin_sums().bending; });
  skin.made("skin_area", "m^2", "area of the skin's triangles", [](const Simulation& now) { return now.skin_sums().area; });
  add_passing<Common>(all, "");
  for_each_effect([&]<class E>() { add_passing<E>(all, E::name); });
  return all;
}

}  // namespace

const std::vector<LedgerColumn>& ledger() {
  static const std::vector<LedgerColumn> all = make_ledger();
  return all;
}

std::vector<std::string> ledger_columns() {
  std::vector<std::string> names;
  for (const LedgerColumn& column : ledger()) names.push_back(column.name);
  return names;
}

const std::vector<GiverColumn>& giver_columns() {
  static const std::vector<GiverColumn> all = [] {
    std::vector<GiverColumn> columns;
    for (std::size_t d = 0; d < 3; ++d)
      columns.push_back({fmt::format("_impulse_{}_kg_m_per_s", "xyz"[d]), "kg m/s",
                         "impulse that it gave to the dough; its change from row to row over the time between them is the force", false,
                         [d](const Given& given) { return given.impulse[d]; }});
    columns.push_back(
        {"_heat_J", "J", "heat that it gave to the dough; grips have no such column", true, [](const Given& given) { return given.heat; }});
    return columns;
  }();
  return all;
}

std::vector<std::string> ledger_columns(const Scene& scene) {
  std::vector<std::string> names = ledger_columns();
  for (const Giver& giver : givers_of(scene))
    for (const GiverColumn& column : giver_columns())
      if (giver.gives_heat || !column.is_heat) names.push_back(giver.name + column.end);
  return names;
}

std::vector<double> ledger_row(const Simulation& simulation) {
  std::vector<double> row;
  const Box3 extent = simulation.extent();
  for (const LedgerColumn& column : ledger()) row.push_back(column.value(simulation, extent));
  for (std::size_t g = 0; g < simulation.givers().size(); ++g)
    for (const GiverColumn& column : giver_columns())
      if (simulation.givers()[g].gives_heat || !column.is_heat) row.push_back(column.value(simulation.given()[g]));
  return row;
}

bool is_of_scene(const Scene& scene, std::string_view name) {
  const auto found = std::find_if(ledger().begin(), ledger().end(), [&](const LedgerColumn& column) { return column.name == name; });
  if (found == ledger().end()) return false;
  return found->effect.empty() || (found->effect == k_skin ? !scene.skins.empty() : scene.lists(found->effect));
}

}  // namespace bake
