// SPDX-License-Identifier: MIT
// A scene in motion, by the solver or by the textbook baker: what the study looks at and what it pays.
#pragma once

#include "experiments/accuracy/case.h"
#include "solver/run/simulation.h"

namespace bake::studies::accuracy {

class Running {
 public:
  virtual ~Running() = default;

  /// Steps to `time` and adds to `found` what that took: for the textbook, its own steps alone, without the choice of their length.
  /// Throws RunError.
  virtual void advance(double time, Found& found) = 0;
  /// Numbers of particles and steps.
  virtual void count(Found& found) const = 0;
  /// Of the textbook: positions, velocities, temperature, water_mass and initial_volume.
  virtual Snapshot snapshot() const = 0;

  /// What metrics are taken from. The textbook has fewer columns than the solver.
  virtual std::vector<std::string> ledger_names() const = 0;
  virtual std::vector<double> ledger_row() const = 0;
  virtual void write_frame_file(const std::filesystem::path& path) const = 0;
};

/// Goes through a run that has begun and finds its error.
using Work = std::function<void(Running&, Found&)>;

/// Begins a scene that is to go to `end_s`, with one thread, and gives it to `work`. A run that fails, or an error that is no number, is
/// a Found with its failure; so is a run that comes apart: stability asks for steps of which 300 thousand would not bring it there.
/// The textbook takes the steps that the solver chooses; it knows no emitters and no `force`. Throws InputError.
Found run(const Scene& scene, By by, double end_s, const Work& work, const NodalForce& force = {});

/// Snapshots at the times that were asked for -> the relative error.
using Compare = std::function<double(const std::vector<Snapshot>&)>;

/// The same through `times` (rising; 0 is the start), for an exact solution.
Found simulate(const Scene& scene, By by, const std::vector<double>& times, const Compare& compare, const NodalForce& force = {});

}  // namespace bake::studies::accuracy
