// SPDX-License-Identifier: MIT
// Cases without an exact solution: their quantities of interest, against those of a fine run in double precision that are stored in
// reference/accuracy/<case>.json.
#pragma once

#include "analysis/claims/metric.h"
#include "experiments/accuracy/case.h"

namespace bake::studies::accuracy {

/// A metric of the finished run. Its error is relative to how far the reference has come from `start`.
struct Quantity {
  std::string name;    ///< in tables
  std::string metric;  ///< a metric of analysis/claims
  MetricPlace at = {};
  double start = 0;  ///< what it is before anything happens
};

/// A scene of experiments/ and its reference.
struct ReferencedScene {
  std::string name;   ///< of the case
  std::string scene;  ///< "teaching/rising_ball"
  double length = 0;  ///< that cells divide [m]
  int fine = 0;       ///< cells of the reference
  std::vector<Quantity> quantities;
  std::vector<std::string> fine_settings = {};  ///< `key=value` of the reference alone: where the scene itself saves time
};

/// The parts of a case that follow from it: name, scene, scene_of, measure, missing, make_reference. The reference is run with all cores.
void refer(Case& c, const ReferencedScene& scene);

}  // namespace bake::studies::accuracy
