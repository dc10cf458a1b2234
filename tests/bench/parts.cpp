// SPDX-License-Identifier: MIT
// Parts of a step by themselves; the laws on inputs that stay in the first-level cache.
#include <benchmark/benchmark.h>
#include <omp.h>

#include <random>

#include "analysis/machines/scenes.h"
#include "analysis/machines/stopwatch.h"
#include "solver/core/symmetric.h"
#include "solver/effects/plasticity.h"
#include "solver/engine/engine.h"
#include "solver/grid/sort_particles.h"
#include "solver/run/fill_scene.h"
#include "tests/bench/counters.h"
#include "tests/bench/flops.h"
#include "tests/bench/steps.h"

namespace bake::bench {

namespace {

/// Returns the rate, in millions per second.
double count_particles(benchmark::State& state, const Stopwatch& watch, double per_iteration) {
  const double done = per_iteration * static_cast<double>(state.iterations()), wall = watch.wall_s(), rate = 1e-6 * done / wall;
  set_counter(state.counters, "M/s", rate);
  set_counter(state.counters, "ns", 1e9 * wall / done);
  return rate;
}

template <class Real>
void order_500K(benchmark::State& state, int threads, double triad_GB_per_s) {
  const int all = omp_get_max_threads();
  const Precision precision = sizeof(Real) == 4 ? Precision::single_precision : Precision::double_precision;
  const Scene scene = loaf(k_combinations[12], precision, 5e5);
  Engine<Real> engine(scene);
  engine.add(fill_bodies(scene));
  engine.start(1);
  for (int step = 0; step < 20; ++step) engine.step(1, 1);
  ParticleStore<Real> store(engine.store());
  omp_set_num_threads(threads);
  sort_particles<Real>(store, nullptr, engine.geometry(), nullptr);  // takes the memory
  const Stopwatch watch;
  for ([[maybe_unused]] auto once : state) sort_particles<Real>(store, nullptr, engine.geometry(), nullptr);
  const double rate = count_particles(state, watch, static_cast<double>(engine.particles()));
  const double bytes = 2. * sizeof(Real) * store.columns;  // columns are read and written
  set_counter(state.counters, "bytes", bytes);
  set_counter(state.counters, "triad", 1e-3 * bytes * rate / triad_GB_per_s);
  omp_set_num_threads(all);
}

constexpr int k_tiles = 32;

template <class Real>
Lanes<Real> random_lanes(std::mt19937& random, double low, double high) {
  std::uniform_real_distribution<double> between(low, high);
  Lanes<Real> result;
  for (int l = 0; l < k_width<Real>; ++l) result[l] = static_cast<Real>(between(random));
  return result;
}

/// Strains of up to two per cent, as in dough; all within the series.
template <class Real>
std::vector<Symmetric<Lanes<Real>>> strains() {
  std::mt19937 random(1);
  std::vector<Symmetric<Lanes<Real>>> result(k_tiles);
  for (auto& strain : result)
    for (auto& component : strain.at) component = random_lanes<Real>(random, -0.02, 0.02);
  return result;
}

template <class Real, class Function>
void time_function(benchmark::State& state, Function f, double flops, double peak_GFLOPs) {
  auto in = strains<Real>();
  const Stopwatch watch;
  for ([[maybe_unused]] auto once : state) {
    for (auto& strain : in) {
      auto result = f(strain);
      benchmark::DoNotOptimize(result);
    }
    benchmark::ClobberMemory();
  }
  const double rate = count_particles(state, watch, k_tiles * k_width<Real>);
  set_counter(state.counters, "flops", flops);
  set_counter(state.counters, "peak", 1e-3 * flops * rate / peak_GFLOPs);
}

template <class Real>
void half_log(benchmark::State& state, double peak_GFLOPs) {
  constexpr double flops = polynomial_flops(std::size(detail::Series<Real>::half_log));
  time_function<Real>(
      state, [](const auto& b) { return half_log1p<Real>(b); }, flops, peak_GFLOPs);
}
template <class Real>
void expm1_of_twice(benchmark::State& state, double peak_GFLOPs) {
  constexpr double flops = polynomial_flops(std::size(detail::Series<Real>::expm1));
  time_function<Real>(
      state, [](const auto& h) { return expm1_twice<Real>(h); }, flops, peak_GFLOPs);
}

/// Newton's iteration for the dough of fig. 15 with trial stresses from nothing to one and a half times the yield stress, of
/// which most flow; dt = 1 ms.
template <class Real>
void return_map(benchmark::State& state, bool quadratic) {
  using V = Lanes<Real>;
  constexpr Real tau_y = 20, eta_dt = Real(500 / 1e-3), mu3 = 3 * 769, bulk = 1667, a = Real(0.3);
  struct Trial {
    V ap2, q2;
  };
  std::mt19937 random(1);
  std::vector<Trial> trials(k_tiles);
  double flowing = 0;
  for (Trial& t : trials) {
    const V p = random_lanes<Real>(random, 0, 40), q = random_lanes<Real>(random, 0, 30);
    t = {a * p * p, q * q};
    const auto flows = t.ap2 + t.q2 > lanes<Real>(tau_y * tau_y);
    for (int l = 0; l < k_width<Real>; ++l) flowing += flows[l] ? 1. / (k_tiles * k_width<Real>) : 0.;
  }
  const Stopwatch watch;
  for ([[maybe_unused]] auto once : state) {
    for (const Trial& t : trials) {
      const auto flows = t.ap2 + t.q2 > lanes<Real>(tau_y * tau_y);
      V z = Plasticity::solve<V>(t.ap2, t.q2, lanes<Real>(a * bulk), mu3, lanes<Real>(tau_y), lanes<Real>(eta_dt), flows, quadratic);
      benchmark::DoNotOptimize(z);
    }
    benchmark::ClobberMemory();
  }
  count_particles(state, watch, k_tiles * k_width<Real>);
  set_counter(state.counters, "flowing", flowing);
}

template <class Real>
void register_in(const std::string& precision, const Limits& limits, double peak_GFLOPs) {
  const auto add = [&](const std::string& name, auto f, auto... arguments) {
    return benchmark::RegisterBenchmark(("Part/" + name + "/" + precision).c_str(), f, arguments...);
  };
  for (const int threads : limits.thread_counts())
    benchmark::RegisterBenchmark(("Part/ordering/" + precision + "/500K/threads:" + std::to_string(threads)).c_str(), order_500K<Real>,
                                 threads, threads == 1 ? limits.triad_GB_per_s.one : limits.triad_GB_per_s.all)
        ->Unit(benchmark::kMillisecond)
        ->Iterations(20)
        ->UseRealTime();
  add("return_map_distance", return_map<Real>, false);  // how often it iterates is up to the data: no flops are counted
  add("return_map_quadratic", return_map<Real>, true);
  add("half_log1p", half_log<Real>, peak_GFLOPs);
  add("expm1_twice", expm1_of_twice<Real>, peak_GFLOPs);
}

}  // namespace

void register_parts(const Limits& limits) {
  register_in<float>("single", limits, limits.single_GFLOPs.one);
  register_in<double>("double", limits, limits.double_GFLOPs.one);
}

}  // namespace bake::bench
