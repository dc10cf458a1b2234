// SPDX-License-Identifier: MIT
// Errors against costs: which settings are worth their price.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/machines/limits.h"
#include "analysis/machines/statistics.h"
#include "experiments/accuracy/case.h"

namespace bake::studies::accuracy {

/// A variant, measured.
struct Point {
  Variant variant;
  int repeats = 0;
  std::string failure;
  double error = 0;
  double settled = 0;  ///< the largest error of this and all finer grids of the curve: what can be relied on
  std::map<std::string, double> parts;
  double particles = 0, steps = 0, particle_steps = 0;
  Spread wall_s, cpu_s, load_average;
  std::vector<bench::Speed> speeds;  ///< of the machine, before each repeat; empty in data of old
  bool same_error = true;            ///< in every repeat, bit for bit

  bool failed() const { return !failure.empty(); }
};

/// Points of one setting, cells rising.
struct Curve {
  std::string label;
  std::vector<Point> points;
};

/// What is paid.
using Cost = double (*)(const Point&);
inline double particle_steps(const Point& p) { return p.particle_steps; }
inline double cpu_seconds(const Point& p) { return p.cpu_s.median; }

/// Fills `settled` of every point. A curve that failed on a finer grid settles nothing.
void settle(Curve& curve);

/// Points of the solver than which none is both cheaper and has a settled error as small, by rising cost: errors fall along it.
std::vector<const Point*> front(const std::vector<Curve>& curves, Cost cost);

/// The cheapest point whose settled error is at most `error`; nullptr if there is none.
const Point* cheapest(const std::vector<Curve>& curves, double error, Cost cost);

/// The cost of `point` over that of the cheapest one that is as good: 1 on the front.
double excess(const std::vector<Curve>& curves, const Point& point, Cost cost);

/// Least-squares slope of -ln(error) against ln(cells), and against ln(cost). Nothing with fewer than two points or without any error.
std::optional<double> order(const Curve& curve);
std::optional<double> exponent(const Curve& curve, Cost cost);

/// How much the cost grows when the error is to be halved.
double cost_of_halving(double exponent);

}  // namespace bake::studies::accuracy
