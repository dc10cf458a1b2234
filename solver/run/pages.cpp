// SPDX-License-Identifier: MIT
// What columns and symbols mean, for people: made from the effects' own declarations.
#include <fmt/format.h>

#include <set>

#include "solver/effects/all_effects.h"
#include "solver/effects/composed_effects.h"
#include "solver/run/ledger.h"

namespace bake {
namespace {

/// Takes down what an effect shows of its particles.
struct ShownWords {
  std::vector<FrameColumnWords>& all;
  const char* effect;
  template <class F>
  void sampled(F f) {
    stored(f);
  }
  template <class F>
  void stored(F) {
    all.push_back({F::name, F::unit, F::meaning, effect});
  }
  template <class Maker>
  void made(const char* name, const char* unit, const char* meaning, Maker) {
    all.push_back({name, unit, meaning, effect});
  }
};

constexpr const char* k_booked_of_giver = "booked in every step, summed since the start";

std::string whose(const std::string& effect) { return effect.empty() ? "every run" : effect; }

/// "theta_p: temperature [Ding19 Eq. 9]" in its three parts; the first and the last may be missing.
struct Meaning {
  std::string symbol, words, equation;

  explicit Meaning(std::string text) {
    if (const auto colon = text.find(": "); colon != std::string::npos) symbol = text.substr(0, colon), text = text.substr(colon + 2);
    if (const auto bracket = text.find(" [Ding19 "); bracket != std::string::npos) {
      equation = text.substr(bracket + 9, text.find(']', bracket) - bracket - 9);
      text = text.substr(0, bracket);
    }
    words = text;
  }
};

/// Rows of the table of a kind of fields, each field once.
class NotationTable {
 public:
  explicit NotationTable(const char* kind) : kind_(kind) {}
  template <class List>
  void add(const char* effect) {
    List::for_each([&](auto f) {
      if (!seen_.insert(f.symbol).second) return;
      const Meaning meaning(f.meaning);
      text_ += fmt::format("| {} | `{}::{}` | {} | {} | {} | {} | {} |\n", meaning.symbol.empty() ? f.symbol : meaning.symbol, kind_,
                           f.symbol, f.width, f.unit, meaning.words, meaning.equation, effect);
    });
  }
  std::string text() const {
    return "| symbol | in the code | numbers | unit | meaning | equation | effect |\n|---|---|---|---|---|---|---|\n" + text_;
  }

 private:
  const char* kind_;
  std::set<std::string> seen_;
  std::string text_;
};

/// Calls visit for all effects and for the parts that they imply.
template <class Visit>
void for_each_effect_and_part(Visit visit) {
  for_each_effect(visit);
  const auto implied = [&]<class E>(E*) {
    if constexpr (Implied<E>) visit.template operator()<E>();
  };
  [&]<class... E>(std::tuple<E...>*) { (implied(static_cast<E*>(nullptr)), ...); }(static_cast<ComposedEffects*>(nullptr));
}

/// The same, and what every model has.
template <class Visit>
void for_each_part(Visit visit) {
  visit.template operator()<Common>();
  for_each_effect_and_part(visit);
}

}  // namespace

std::vector<FrameColumnWords> frame_columns() {
  std::vector<FrameColumnWords> all{{"id", "1", "number that the particle keeps for life", ""},
                                    {"material", "1", "number of its [[material]] in the scene, from 0", ""}};
  ShownWords common{all, ""};
  Common::show(common);
  for_each_effect_and_part([&]<class E>() {
    ShownWords words{all, E::name};
    BAKE_CALL(E, show, words);
  });
  return all;
}

std::vector<FrameColumnWords> skin_columns() {
  return {{"velocity", "m/s", "velocity", ""},
          {"area_ratio", "1", "area of the triangles around it over their area at the start", ""},
          {"curvature", "1/m",
           "sqrt(2 e / B) with the bending energy e per area of the hinges around it: 1/R of a sheet rolled to a cylinder", ""},
          {"skin", "1", "number of its [[skin]] in the scene, from 0", ""},
          {"saturation", "1", "saturation of the flesh around it", ""},
          {"temperature", "C", "temperature of the flesh around it", ""}};
}

std::string explain_column(std::string_view name) {
  std::string text;
  const auto add = [&](const std::string& what, const std::string& meaning, const std::string& unit, const std::string& how,
                       const std::string& effect) {
    text += fmt::format("{}{}\n  {}\n  unit     {}\n  how      {}\n  effect   {}\n", text.empty() ? "" : "\n", what, meaning, unit, how,
                        whose(effect));
  };
  for (const LedgerColumn& c : ledger())
    if (c.name == name) add(fmt::format("{}, a column of ledger.csv", c.name), c.meaning, c.unit, c.how, c.effect);
  for (const char* kind : {"collider_", "grip_", "face_"})
    for (const GiverColumn& c : giver_columns())
      if (name.starts_with(kind) && name.ends_with(c.end))
        add(fmt::format("{}, a column of ledger.csv where `ledger = true`", name), c.meaning, c.unit, k_booked_of_giver, "");
  for (const FrameColumnWords& c : frame_columns())
    if (c.name == name) add(fmt::format("{}, a column of frames", c.name), c.meaning, c.unit, "of each particle at the frame", c.effect);
  for (const FrameColumnWords& c : skin_columns())
    if (c.name == name)
      add(fmt::format("{}, a column of meshes of skins", c.name), c.meaning, c.unit, "of each vertex at the frame", "[[skin]]");
  return text;
}

std::string columns_page() {
  std::string page =
      R"(<!-- SPDX-License-Identifier: MIT. Generated: BAKE_WRITE_DOCS=1 run_tests --gtest_filter='Pages.*' writes it anew. -->
# Columns

What the numbers in a run's files are. `bake explain <column>` says the same in the terminal. Columns of effects that a scene does not list
are zero in its ledger and missing in its frames.

## ledger.csv

One row a frame.

| column | unit | meaning | how it comes about | effect |
|---|---|---|---|---|
)";
  for (const LedgerColumn& c : ledger())
    page += fmt::format("| `{}` | {} | {} | {} | {} |\n", c.name, c.unit, c.meaning, c.how, whose(c.effect));
  page += R"(
What is booked closes the balance of what is summed, to round-off: mass of water + evaporated, momentum - impulse - water_remap_momentum,
angular momentum - angular_impulse, and heat content - heat_exchanged + latent + vapour + expansion - water_remap stay as they were at the
start, but for what was emitted and retired.

A collider, a grip or a `[[face]]` of the domain with `ledger = true` has columns of its own behind these, called by what it is and its
name, as in `collider_plate_impulse_z_kg_m_per_s`. They do not change the run.

| column | unit | meaning | how it comes about |
|---|---|---|---|
)";
  for (const GiverColumn& c : giver_columns())
    page += fmt::format("| `..{}` | {} | {} | {} |\n", c.end, c.unit, c.meaning, k_booked_of_giver);
  page += R"(
Impulses of all colliders, grips and faces, of gravity and of vapour together are `impulse`; heats of all colliders, faces and grips and of
the air are `heat_exchanged`.

## frames/*.hdf

One number, or one vector, for each particle, in the order of their `id`.

| column | unit | meaning | effect |
|---|---|---|---|
)";
  for (const FrameColumnWords& c : frame_columns())
    page += fmt::format("| `{}` | {} | {} | {} |\n", c.name, c.unit, c.meaning, whose(c.effect));
  page += R"(
## skins/*.hdf

The triangles of the skins at the same times, for scenes with `[[skin]]`; `skins.hdf.series` opens them all. One number, or one vector, for each
vertex.

| column | unit | meaning |
|---|---|---|
)";
  for (const FrameColumnWords& c : skin_columns()) page += fmt::format("| `{}` | {} | {} |\n", c.name, c.unit, c.meaning);
  return page;
}

std::string notation_page() {
  NotationTable particles("field"), nodes("channel");
  for_each_part([&]<class E>() {
    particles.add<typename E::Stored>(E::name);
    particles.add<typename E::Transient>(E::name);
    nodes.add<typename E::Moments>(E::name);
    nodes.add<typename E::Values>(E::name);
    nodes.add<typename E::Gathered>(E::name);
  });
  return R"(<!-- SPDX-License-Identifier: MIT. Generated: BAKE_WRITE_DOCS=1 run_tests --gtest_filter='Pages.*' writes it anew. -->
# Notation

The paper's symbols, what they are called in the code, their units and equations (of Ding et al. 2019). Constants of materials and settings
stand in [scene.md](scene.md), sums and bookings in [columns.md](columns.md).

| index | meaning |
|---|---|
| p | particle |
| i | node of the grid |
| n, n+1 | before and after the step |
| s, w | solid, water |
| E, P | elastic, plastic |

w is the B-spline weight of a node at a particle, r = x_i - x_p, D^-1 = 4/dx^2 (quadratic) or 3/dx^2 (cubic).

## Particles

)" + particles.text() +
         R"(
## Nodes

The first of these are sums over particles (P2G); `node velocity` and what follows it is what the grid update hands back (G2P).

)" + nodes.text();
}

}  // namespace bake
