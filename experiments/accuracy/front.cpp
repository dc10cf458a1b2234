// SPDX-License-Identifier: MIT
#include "experiments/accuracy/front.h"

#include <algorithm>
#include <cmath>

#include "experiments/common/order.h"

namespace bake::studies::accuracy {

namespace {

std::optional<double> slope(const Curve& curve, const std::function<double(const Point&)>& against) {
  std::vector<double> x, errors;
  for (const Point& p : curve.points)
    if (!p.failed() && p.error > 0 && against(p) > 0) {
      x.push_back(against(p));
      errors.push_back(p.error);
    }
  if (x.size() < 2) return std::nullopt;
  return fitted_order(x, errors);
}

}  // namespace

void settle(Curve& curve) {
  double worst = 0;
  for (auto p = curve.points.rbegin(); p != curve.points.rend(); ++p) {
    worst = std::max(worst, p->failed() ? std::numeric_limits<double>::infinity() : p->error);
    p->settled = worst;
  }
}

std::vector<const Point*> front(const std::vector<Curve>& curves, Cost cost) {
  std::vector<const Point*> all;
  for (const Curve& c : curves)
    for (const Point& p : c.points)
      if (std::isfinite(p.settled) && p.variant.by == By::solver) all.push_back(&p);
  std::sort(all.begin(), all.end(), [&](const Point* a, const Point* b) {
    return std::pair{cost(*a), a->settled} < std::pair{cost(*b), b->settled};
  });
  std::vector<const Point*> best;
  for (const Point* p : all)
    if (best.empty() || p->settled < best.back()->settled) best.push_back(p);
  return best;
}

const Point* cheapest(const std::vector<Curve>& curves, double error, Cost cost) {
  for (const Point* p : front(curves, cost))
    if (p->settled <= error) return p;
  return nullptr;
}

double excess(const std::vector<Curve>& curves, const Point& point, Cost cost) {
  const Point* best = cheapest(curves, point.settled, cost);
  return best ? cost(point) / cost(*best) : std::numeric_limits<double>::quiet_NaN();
}

std::optional<double> order(const Curve& curve) {
  return slope(curve, [](const Point& p) { return static_cast<double>(p.variant.cells); });
}
std::optional<double> exponent(const Curve& curve, Cost cost) { return slope(curve, cost); }

double cost_of_halving(double exponent) { return std::pow(2, 1 / exponent); }

}  // namespace bake::studies::accuracy
