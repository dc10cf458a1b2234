// SPDX-License-Identifier: MIT
#include "tests/bench/steps.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <functional>
#include <memory>

#include "analysis/machines/scenes.h"
#include "analysis/machines/stopwatch.h"
#include "solver/engine/engine.h"
#include "solver/run/simulation.h"
#include "solver/scene/describe.h"
#include "tests/bench/counters.h"
#include "tests/bench/flops.h"
#include "tests/bench/flowing.h"

namespace bake::bench {

namespace {

/// What is timed: benchmarks of one subject follow each other and share a simulation, which goes on.
struct Subject {
  std::string name;  ///< <scene>/<precision>/<size>
  Precision precision;
  std::function<Scene()> scene;
  int warm_up, steps;
};

/// A warmed-up simulation and what is known of it before it is timed.
struct Running {
  std::string name;
  Scene scene;
  std::unique_ptr<Simulation> simulation;
  double flops, bytes_per_particle, bytes_per_node, bytes_moved_per_node, bytes_moved, flowing;
};

template <class Real>
void describe(Running& running) {
  const auto physics = make_physics<Real>(running.scene);
  running.flops = flops_per_particle_step(*physics, running.scene);
  running.bytes_per_particle = static_cast<double>(sizeof(Real)) * physics->column_count;
  const auto kernel = make_block_kernel<Real>(running.scene.grid.kernel, *physics);
  running.bytes_per_node = static_cast<double>(sizeof(Real)) * (kernel->scattered_row() + kernel->gathered_row());
  running.bytes_moved_per_node = bytes_moved_per_node(*kernel);
}

double nodes_per_particle(const Simulation& simulation) {
  return static_cast<double>(simulation.active_nodes()) / static_cast<double>(simulation.particles());
}

Running& running(const Subject& subject) {
  static Running now;
  if (now.name == subject.name) return now;
  now.simulation.reset();  // before the next one takes memory
  now.name = subject.name;
  now.scene = subject.scene();
  if (subject.precision == Precision::single_precision)
    describe<float>(now);
  else
    describe<double>(now);
  now.simulation = Simulation::begin(now.scene);
  take_steps(*now.simulation, subject.warm_up);
  now.bytes_moved = 2 * now.bytes_per_particle + now.bytes_moved_per_node * nodes_per_particle(*now.simulation);
  now.flowing = flowing_share(*now.simulation, now.scene);
  return now;
}

void time_steps(benchmark::State& state, const Subject& subject, int threads, double peak_GFLOPs, double triad_GB_per_s) {
  const int all = omp_get_max_threads();
  const Running& run = running(subject);
  omp_set_num_threads(threads);
  take_steps(*run.simulation, 1);  // the other threads fall asleep, or wake
  const Counters before = run.simulation->counters();
  const Stopwatch watch;
  for ([[maybe_unused]] auto step : state) take_steps(*run.simulation, 1);
  const double wall = watch.wall_s(), cpu = watch.cpu_s();
  omp_set_num_threads(all);
  const Counters& after = run.simulation->counters();
  const auto done = static_cast<double>(after.particle_steps - before.particle_steps);
  set_counter(state.counters, "M/s", 1e-6 * done / wall);
  set_counter(state.counters, "ns*core", 1e9 * wall * threads / done);
  set_counter(state.counters, "cpu_ns", 1e9 * cpu / done);
  set_counter(state.counters, "peak", 1e-9 * run.flops * done / wall / peak_GFLOPs);
  set_counter(state.counters, "triad", 1e-9 * run.bytes_moved * done / wall / triad_GB_per_s);
  set_counter(state.counters, "flops", run.flops);
  set_counter(state.counters, "bytes", run.bytes_moved);
  set_counter(state.counters, "B/particle", run.bytes_per_particle);
  set_counter(state.counters, "B/node", run.bytes_per_node);
  set_counter(state.counters, "MiB", static_cast<double>(run.simulation->bytes()) / (1 << 20));
  set_counter(state.counters, "nodes/particle", nodes_per_particle(*run.simulation));
  set_counter(state.counters, "flowing", run.flowing);
  set_counter(state.counters, "orderings", static_cast<double>(after.orderings - before.orderings));
}

void add(const Subject& subject, const Limits& limits, const std::vector<int>& threads) {
  const Rate& peak = subject.precision == Precision::single_precision ? limits.single_GFLOPs : limits.double_GFLOPs;
  for (const int n : threads)
    benchmark::RegisterBenchmark(fmt::format("Step/{}/threads:{}", subject.name, n).c_str(), time_steps, subject, n,
                                 n == 1 ? peak.one : peak.all, n == 1 ? limits.triad_GB_per_s.one : limits.triad_GB_per_s.all)
        ->Iterations(subject.steps)
        ->Unit(benchmark::kMillisecond)
        ->UseRealTime();
}

std::string size_word(int thousands) { return thousands < 1000 ? fmt::format("{}K", thousands) : fmt::format("{}M", thousands / 1000); }

Subject loaf_subject(const Combination& combination, Precision precision, int thousands) {
  return {fmt::format("{}/{}/{}", combination.name, word_of(precision), size_word(thousands)), precision,
          [=] { return loaf(combination, precision, 1e3 * thousands); }, 40, std::clamp(10'000 / thousands, 5, 50)};
}

/// In the steps after the start particles of a cell still stand together as they were filled in. Later they stand as in most of a bake,
/// which takes two sortings, a hundred steps apart, where it is not to take too long; the steps that are timed hold every time since the
/// last.
Subject mixed_loaf_subject(const Combination& combination, Precision precision, int thousands) {
  Subject subject = loaf_subject(combination, precision, thousands);
  subject.name += "_mixed";
  subject.warm_up = thousands <= 500 ? 1000 : 200;
  subject.steps = thousands <= 500 ? 200 : 100;
  return subject;
}

Subject block_subject(Precision precision, int cells) {
  return {fmt::format("block/{}/{}^3", word_of(precision), cells), precision, [=] { return elastic_block(precision, cells); }, 2,
          cells < 50 ? 50 : 4};
}

/// The ratio of the two times a step is what a skin costs.
Subject grape_subject(Precision precision, bool in_skin) {
  return {fmt::format("{}/{}/28K", in_skin ? "grape_in_skin" : "grape", word_of(precision)), precision,
          [=] { return grape(precision, in_skin); }, 200, 200};
}

}  // namespace

void register_steps(const Limits& limits) {
  std::vector<int> one_and_all{1};
  if (limits.threads > 1) one_and_all.push_back(limits.threads);
  const std::vector<int> all{limits.threads};
  constexpr Precision precisions[] = {Precision::single_precision, Precision::double_precision};
  for (const Combination& c : k_combinations)
    for (const Precision precision : precisions)
      add(loaf_subject(c, precision, 500), limits, c.name == "all" ? limits.thread_counts() : one_and_all);
  for (const Combination& c : k_combinations)
    if (c.name == "plastic" || c.name == "all")
      for (const int thousands : {100, 200, 1000, 2000, 4000, 8000})
        add(loaf_subject(c, Precision::single_precision, thousands), limits, all);
  for (const Combination& c : k_combinations)
    if (c.name == "all")
      for (const int thousands : {10, 30, 100, 500, 4000})
        add(mixed_loaf_subject(c, Precision::single_precision, thousands), limits, thousands <= 500 ? one_and_all : all);
  for (const int cells : {25, 100})
    for (const Precision precision : precisions) add(block_subject(precision, cells), limits, one_and_all);
  for (const bool in_skin : {false, true}) add(grape_subject(Precision::single_precision, in_skin), limits, one_and_all);
}

}  // namespace bake::bench
