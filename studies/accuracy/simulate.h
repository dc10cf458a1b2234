// SPDX-License-Identifier: MIT
// A scene run for its exact solution: stepped, timed, looked at, compared.
#pragma once

#include "solver/baker/simulation.h"
#include "studies/accuracy/case.h"

namespace bake::studies::accuracy {

/// Snapshots at the times that were asked for -> the relative error.
using Compare = std::function<double(const std::vector<Snapshot>&)>;

/// Runs the scene with one thread through `times` (rising; 0 is the start). A run that fails, or an error that is no number, is a Found
/// with its failure. Throws InputError.
Found simulate(const Scene& scene, const std::vector<double>& times, const Compare& compare, const NodalForce& force = {});

/// Processor time of this program [s].
double processor_seconds();

/// Steps to `time` and adds what that took; throws RunError.
void advance_timed(Simulation& simulation, double time, Found& found);
/// Numbers of particles and steps.
void count(const Simulation& simulation, Found& found);

}  // namespace bake::studies::accuracy
