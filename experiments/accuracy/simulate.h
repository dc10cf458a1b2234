// SPDX-License-Identifier: MIT
// A scene run for its exact solution: stepped, timed, looked at, compared.
#pragma once

#include "experiments/accuracy/running.h"

namespace bake::studies::accuracy {

/// Snapshots at the times that were asked for -> the relative error.
using Compare = std::function<double(const std::vector<Snapshot>&)>;

/// Runs the scene with one thread through `times` (rising; 0 is the start). A run that fails, or an error that is no number, is a Found
/// with its failure. Throws InputError.
Found simulate(const Scene& scene, By by, const std::vector<double>& times, const Compare& compare, const NodalForce& force = {});

}  // namespace bake::studies::accuracy
