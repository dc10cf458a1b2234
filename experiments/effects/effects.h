// SPDX-License-Identifier: MIT
// What every effect costs, and what it changes.
#pragma once

#include <string>
#include <vector>

namespace bake::studies {

// ---------------------------------------------------------------- what it costs

/// One combination of effects that is compiled, on the loaf of analysis/machines/scenes.h in single precision.
struct Cost {
  std::string name;  ///< of bench::k_combinations
  std::vector<std::string> effects;
  int columns, scattered, gathered;  ///< numbers per particle, per node before and after the grid update
  double bytes_per_particle, bytes_per_node;
  double step_limit_s;          ///< the step that the rule takes after the warm-up
  std::vector<double> cpu_ns;   ///< processor time per particle-step, one number a repeat; one thread
  std::vector<double> wall_ns;  ///< the same by the clock
};

struct CostOptions {
  double particles;
  int warm_up, steps, repeats;
};
/// All combinations without FLIP. Variants are interleaved: every repeat times every combination once, the first first.
std::vector<Cost> measure_costs(const CostOptions& options);

/// What an effect adds: the difference of two combinations, repeat by repeat.
struct Margin {
  std::string effect;         ///< "water"
  std::string beside;         ///< what is there without it: "motion, elasticity"
  std::string with, without;  ///< names of the combinations
  const char* kind;           ///< "alone": with the least that it needs; "last": with all others that do not need it
};
const std::vector<Margin>& all_margins();
/// cpu_ns of one combination less that of another, repeat by repeat.
std::vector<double> added_ns(const std::vector<Cost>& costs, const std::string& with, const std::string& without);

// ---------------------------------------------------------------- what it changes

/// A number that a scene is run for, at the end of the run.
struct Quantity {
  std::string name, unit;
  double value;
};

/// A scene, whole or with some effects left out, run to its end.
struct Outcome {
  std::string scene;                  ///< name of the file: "bread"
  std::vector<std::string> left_out;  ///< an effect and those that need it, or a setting; none: the whole scene
  std::string combination;            ///< name of what is left, of bench::k_combinations
  double dx_m;
  std::vector<Quantity> quantities;
  double particle_steps, cpu_s;
};

/// The effect and all effects of the scene that need it, directly or not.
std::vector<std::string> with_dependents(const std::string& effect, const std::vector<std::string>& effects);

struct Influence {
  Outcome whole, other;                         ///< the scene as it is, and on a grid of another node distance
  std::vector<Outcome> without;                 ///< each effect left out in turn, and subgrid diffusion
  double error_of(std::size_t quantity) const;  ///< difference between the resolutions: the yardstick
  double change_of(std::size_t quantity, const Outcome& without) const;
  /// Largest change over its yardstick, of all quantities, and which it is.
  std::pair<double, std::string> largest(const Outcome& without) const;
};

struct InfluenceOptions {
  double coarsening;  ///< of the node distance of draft quality
  double other;       ///< node distance of the grid that gives the yardstick, over that of draft quality
  double end_share;   ///< of the scene's time
};
/// Bread, cookie and drying cube. A line of progress for every run on standard error. Throws RunError.
std::vector<Influence> measure_influence(const InfluenceOptions& options);

}  // namespace bake::studies
