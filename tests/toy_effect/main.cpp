// SPDX-License-Identifier: MIT
// What the toy effect must do once it is compiled in: its keys are read, its column, limit and booking are there and right.
#include <cmath>
#include <cstdio>

#include "solver/effects/all_effects.h"
#include "solver/io/frames.h"
#include "solver/run/ledger.h"
#include "solver/run/simulation.h"
#include "solver/scene/reader.h"

namespace {

int g_failures = 0;

void expect(bool holds, const char* what) {
  if (holds) return;
  ++g_failures;
  std::printf("FAILED: %s\n", what);
}

constexpr const char* k_scene = R"(
effects = ["heat", "browning"]
[run]
end_s = 0.5
frame_rate_per_s = 2
precision = "double"
[grid]
dx_m = 0.05
[domain]
min_m = [-0.2, -0.2, -0.2]
max_m = [0.2, 0.2, 0.2]
[[material]]
name = "dough"
density_kg_per_m3 = 500
initial_temperature_C = 200
specific_heat_J_per_kgK = 2000
conductivity_W_per_mK = 1e-3
browning_per_s = 2
browning_heat_J_per_kg = 1000
[[body]]
material = "dough"
shape = { sphere = { radius_m = 0.1 } }
)";

}  // namespace

int main(int, char** words) {
  using namespace bake;
  const Scene scene = parse_scene(k_scene, "crust.toml", {});
  const auto s = Simulation::begin(scene);
  const double heat = s->total(total::heat_content), mass = s->total(total::solid_mass);
  expect(s->dt() == 0.25, "the step is what the effect allows: safety / rate");
  s->advance(0.5, 1);
  const double taken = s->booked(booked::browning_heat);
  expect(std::abs(taken / (1000 * mass * 0.75) - 1) < 1e-7, "half browns in each of two steps");
  expect(std::abs(s->total(total::heat_content) + taken - heat) < 1e-12 * heat, "the heat that it takes is booked, to round-off");
  expect(is_of_scene(scene, "browning_heat_J"), "the ledger has its booking");
  expect(!explain_column("brownness").empty() && !explain_column("browning_heat_J").empty(), "its columns are explained");
  expect(notation_page().find("B_p") != std::string::npos, "its symbol is in the notation");
  const std::string frame = std::string(words[1]) + "/frame.hdf";
  s->write_frame_file(frame);
  const FrameReader reader(frame);
  const auto brown = reader.column("brownness");
  expect(!brown.empty() && std::abs(brown.front() - taken / (1000 * mass)) < 1e-6, "frames have its column");
  if (g_failures == 0) std::printf("the toy effect works\n");
  return g_failures > 0;
}
