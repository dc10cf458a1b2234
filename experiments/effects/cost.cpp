// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "analysis/machines/scenes.h"
#include "analysis/machines/stopwatch.h"
#include "experiments/effects/effects.h"
#include "solver/core/tell.h"
#include "solver/engine/engine.h"
#include "solver/run/simulation.h"
#include "solver/scene/scene.h"

namespace bake::studies {
namespace {

struct Running {
  std::unique_ptr<Scene> scene;  // the simulation refers to it
  std::unique_ptr<Simulation> simulation;
};

Running begin(const bench::Combination& combination, const CostOptions& options) {
  Running running;
  running.scene = std::make_unique<Scene>(bench::loaf(combination, Precision::single_precision, options.particles));
  running.simulation = Simulation::begin(*running.scene);
  bench::take_steps(*running.simulation, options.warm_up);
  return running;
}

Cost describe(const bench::Combination& combination, const Running& running) {
  const auto physics = make_physics<float>(*running.scene);
  const auto kernel = make_block_kernel<float>(running.scene->grid.kernel, *physics);
  return {combination.name,
          combination.effects,
          physics->column_count,
          physics->scatter_channels,
          physics->gather_channels,
          static_cast<double>(sizeof(float)) * physics->column_count,
          static_cast<double>(sizeof(float)) * (kernel->scattered_row() + kernel->gathered_row()),
          running.simulation->dt(),
          {},
          {}};
}

void time_once(Simulation& simulation, int steps, Cost& cost) {
  const auto before = simulation.counters().particle_steps;
  const bench::Stopwatch watch;
  bench::take_steps(simulation, steps);
  const auto done = static_cast<double>(simulation.counters().particle_steps - before);
  cost.cpu_ns.push_back(1e9 * watch.cpu_s() / done);
  cost.wall_ns.push_back(1e9 * watch.wall_s() / done);
}

const Cost& cost_of(const std::vector<Cost>& costs, const std::string& name) {
  const auto found = std::find_if(costs.begin(), costs.end(), [&](const Cost& c) { return c.name == name; });
  if (found == costs.end()) throw std::logic_error("no combination " + name);
  return *found;
}

}  // namespace

std::vector<Cost> measure_costs(const CostOptions& options) {
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  std::vector<Cost> costs;
  std::vector<Running> all;
  for (const bench::Combination& combination : bench::k_combinations) {
    if (combination.flip) continue;
    all.push_back(begin(combination, options));
    costs.push_back(describe(combination, all.back()));
    tell_user("{} is warm", combination.name);
  }
  for (int repeat = 0; repeat < options.repeats; ++repeat)
    for (std::size_t i = 0; i < all.size(); ++i) time_once(*all[i].simulation, options.steps, costs[i]);
  omp_set_num_threads(threads);
  return costs;
}

const std::vector<Margin>& all_margins() {
  static const std::vector<Margin> margins{
      {"motion, elasticity", "heat, water", "elastic+heat+water", "heat+water", "last"},
      {"heat", "motion, elasticity", "elastic+heat", "elastic", "alone"},
      {"heat", "motion, elasticity, plasticity, water", "plastic+heat+water", "plastic+water", "last"},
      {"water", "motion, elasticity", "elastic+water", "elastic", "alone"},
      {"water", "all but water", "all", "plastic+heat+leavening", "last"},
      {"plasticity", "motion, elasticity", "plastic", "elastic", "alone"},
      {"plasticity", "motion, elasticity, heat, water", "plastic+heat+water", "elastic+heat+water", "last"},
      {"leavening", "motion, elasticity, plasticity, heat", "plastic+heat+leavening", "plastic+heat", "alone"},
      {"leavening", "all but leavening", "all", "plastic+heat+water", "last"},
  };
  return margins;
}

std::vector<double> added_ns(const std::vector<Cost>& costs, const std::string& with, const std::string& without) {
  std::vector<double> added = cost_of(costs, with).cpu_ns;
  const std::vector<double>& base = cost_of(costs, without).cpu_ns;
  for (std::size_t i = 0; i < added.size(); ++i) added[i] -= base[i];
  return added;
}

}  // namespace bake::studies
