// SPDX-License-Identifier: MIT
// A bar in which everything depends on x alone: the setting of most exact solutions.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "experiments/common/study_scene.h"

namespace bake::studies {

/// The bar is 1 m long, from x = 0 to 1, and fills its domain along y and z, whose faces are slip and pass neither heat nor water.
/// Particles stand in rows along each axis: weights then are products of one factor per axis, so that fields that
/// depend on x alone stay so to round-off, however few cells the bar is thick.
struct Bar {
  int cells = 16;                                   ///< along the metre
  int rows = 2;                                     ///< of particles in a cell, along each axis
  int across = 1;                                   ///< cells along y and z
  int before = 0, after = 0;                        ///< cells that the body reaches beyond x = 0 and x = 1, into what holds it there
  int air = 0;                                      ///< cells between the body and the domain's faces along x; 0: it touches them
  double shift = 0;                                 ///< of the body against the nodes along x [node distances]
  double end_s = 1;                                 ///< the first sample
  std::string effects = "heat";                     ///< "motion, heat"
  std::string material;                             ///< keys of the material besides density 1 kg/m^3
  std::string tables;                               ///< further tables
  std::string time = "safety = 1";                  ///< keys of [time]
  std::string faces = "\"slip\"";                   ///< rule of the domain's faces along x
  std::function<std::string(double x)> state = {};  ///< keys of the layer of particles at x; without it all are alike
  std::vector<std::string> overrides = {};          ///< `key=value`, as for parse_scene

  double dx() const { return 1.0 / cells; }
  StudyScene setting() const;
  std::unique_ptr<Simulation> begin() const { return setting().begin(); }
  std::unique_ptr<Simulation> end() const { return setting().after(end_s); }
};

/// A grip that holds all behind a plane at a temperature [C]. `point` and `normal`, which looks out of what is held: "[0, 0, 0]".
std::string held(const char* point, const char* normal, int temperature_C);

/// Part of the bar.
struct Span {
  double from, to;
};
inline constexpr Span k_all{0, 1}, k_interior{0.2, 0.8};  ///< the interior keeps away from surface layers, whatever dx

using Field = std::function<double(std::size_t particle)>;
using Profile = std::function<double(double x)>;

/// Differences found - exact of the particles in `span`.
std::vector<double> differences(const Snapshot& now, const Field& found, const Profile& exact, const Span& span);
/// Differences of temperature at the end, found - exact, of the bar with so many cells.
std::vector<double> temperature_differences(Bar bar, double cells, const Profile& exact, const Span& span);
double root_mean_square(const std::vector<double>& values);
double largest(const std::vector<double>& values);  ///< of the absolute values
double mean(const std::vector<double>& values);

}  // namespace bake::studies
