// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "analysis/claims/finite.h"
#include "experiments/fig14_return_map/stress_state.h"
#include "experiments/fig15_bread/dough.h"
#include "experiments/make/computed.h"
#include "solver/effects/plasticity.h"

namespace bake {
namespace {

constexpr double k_any_dt = 1e-3;            // any: without viscosity the image does not depend on it
constexpr double k_nearly_none = 1.0001e-6;  // at 1e-6 itself, the least porosity, the solver lets nothing compact

/// A yield surface in the plane of p and q, in units of tau_y.
struct Surface {
  double n;
  std::vector<double> p, q;
};

/// The images of stresses half as far out again, from pure tension over pure shear to pure pressure.
Surface surface_at(const Scene& scene, double n) {
  const FlowStep step(scene, n, k_any_dt);
  const double tip = 1 / std::sqrt(published_cap(n));  // only to aim; wherever the trial lies, its image lies on the surface
  constexpr int k_trials = 720;
  Surface surface{n, {}, {}};
  for (int i = 0; i <= k_trials; ++i) {
    const double angle = M_PI * (static_cast<double>(i) / k_trials - 0.5), far = 1.5 * step.tau_y();
    const Stress image = step.image(uniaxial(far * tip * std::sin(angle), far * std::cos(angle)));
    surface.p.push_back(pressure_of(image) / step.tau_y());
    surface.q.push_back(effective_of(image) / step.tau_y());
  }
  return surface;
}

/// Largest |sqrt(a p^2 + q^2) - 1|, with a of Eq. 12 as printed.
double distance_from_ellipse(const Surface& s) {
  double largest = 0;
  for (std::size_t i = 0; i < s.p.size(); ++i)
    largest = larger(largest, std::abs(std::sqrt(published_cap(s.n) * s.p[i] * s.p[i] + s.q[i] * s.q[i]) - 1));
  return largest;
}

/// Largest |1 - q| where |p| < 1.
double distance_from_von_mises(const Surface& s) {
  double largest = 0;
  for (std::size_t i = 0; i < s.p.size(); ++i)
    if (std::abs(s.p[i]) < 1) largest = larger(largest, std::abs(1 - s.q[i]));
  return largest;
}

/// Tip of the ellipse, in units of tau_y: the image of pure pressure.
double tip_of(const Surface& s) { return s.p.back(); }

std::string porosity_name(double n) { return n < 1e-3 ? "$n^p$ = 10$^{−6}$" : fmt::format("$n^p$ = {}", n); }

charts::Chart chart_of(const std::vector<Surface>& surfaces, const std::vector<Surface>& tips) {
  charts::Panel plane{"(a)", {"pressure $p$/$τ_y$", ""}, {"effective stress $q$/$τ_y$", ""}};
  plane.x.range = {{-3.4, 3.4}};
  plane.y.range = {{0, 1.2}};
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    charts::Series curve{porosity_name(surfaces[i].n), charts::Kind::line, surfaces[i].p, surfaces[i].q};
    curve.colour = charts::ramp(static_cast<double>(i) / static_cast<double>(surfaces.size() - 1));
    plane.series.push_back(curve);
  }
  charts::Series limit{"von Mises, $n^p$ → 0", charts::Kind::line, {-3.4, 3.4}, {1, 1}};
  limit.colour = "#808080";
  limit.dash = charts::Dash::dashed;
  limit.width = 1;
  plane.series.push_back(limit);
  plane.legend = charts::Legend::right;

  charts::Panel cap{
      "(b)", {"porosity $n^p$", "", charts::Scale::logarithmic}, {"tip of the ellipse $p$/$τ_y$", "", charts::Scale::logarithmic}};
  charts::Series found{"return mapping", charts::Kind::points}, printed{"Eq. 12"};
  for (const Surface& s : tips) {
    found.x.push_back(s.n);
    found.y.push_back(tip_of(s));
  }
  for (double n = 1e-6; n < 0.97; n *= 1.05) {
    printed.x.push_back(n);
    printed.y.push_back(1 / std::sqrt(published_cap(n)));
  }
  cap.series = {printed, found};
  cap.legend = charts::Legend::bottom_left;

  return {"yield_surface",
          "Yield surfaces in the plane of pressure and effective stress: ellipses that shrink as porosity grows",
          {plane, cap},
          1,
          5,
          2.3};
}

}  // namespace

Computed fig07_yield_surface() {
  const Scene scene = bread_scene({"material.dough.viscosity_Pa_s=0"});
  std::vector<Surface> surfaces, tips;
  for (const double n : {k_nearly_none, 0.01, 0.1, 0.3, 0.5, 0.9}) surfaces.push_back(surface_at(scene, n));
  for (const double n : {k_nearly_none, 1e-5, 1e-4, 1e-3, 0.01, 0.03, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 0.95})
    tips.push_back(surface_at(scene, n));

  double off_ellipse = 0, largest_ratio = 0;
  for (const Surface& s : surfaces) off_ellipse = larger(off_ellipse, distance_from_ellipse(s));
  for (std::size_t i = 1; i < tips.size(); ++i) largest_ratio = larger(largest_ratio, tip_of(tips[i]) / tip_of(tips[i - 1]));
  const double a = Plasticity::cap(lanes<double>(1e-30))[0];
  Computed computed;
  computed.charts = {chart_of(surfaces, tips)};
  computed.numbers = {
      {"distance_from_ellipse", "1", "largest distance of the images from the ellipse of Eq. 12, in tau_y", off_ellipse},
      {"distance_from_von_mises", "1", "largest distance from q = tau_y where |p| < tau_y, at n = 1e-6, in tau_y",
       distance_from_von_mises(surfaces.front())},
      {"distance_from_von_mises_in_the_limit", "1", "the same of the solver's a(n) at n = 1e-30", 1 - std::sqrt(1 - a)},
      {"tip_ratio", "1", "largest ratio of the ellipse's tip to that at the next smaller of thirteen porosities", largest_ratio},
      {"tip_at_tenth", "1", "tip of the ellipse at n = 0.1, in tau_y", tip_of(surfaces[2])},
  };
  return computed;
}

}  // namespace bake
