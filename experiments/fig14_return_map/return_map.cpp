// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "analysis/claims/finite.h"
#include "experiments/fig14_return_map/stress_state.h"
#include "experiments/fig15_bread/dough.h"
#include "experiments/make/computed.h"

namespace bake {
namespace {

constexpr double k_porosity = 0.3;  // of the case with pores
constexpr double k_dt = 0.01;       // with the viscosity below about half of the way is left

/// A material whose yield stress is bread's; viscosity in Pa s, or Pa^3 s with the quadratic norm.
Scene dough(double viscosity, const char* norm = "distance") {
  return bread_scene({fmt::format("material.dough.viscosity_Pa_s={}", viscosity), fmt::format("plasticity.norm=\"{}\"", norm)});
}

/// Viscosity that is to `share` of the shear stiffness over the step, 3 mu dt.
double viscosity_of(double share) { return share * 3 * FlowStep(dough(0), 0, k_dt).mu() * k_dt; }

/// Trials around the ellipse, pressure positive or either sign, in units of tau_y: p and q.
struct Trial {
  double p, q;
};
const std::vector<Trial> k_trials{{0.5, 2}, {1.2, 1.5}, {2, 2}, {2.5, 1}, {-0.6, 1.7}, {-1.8, 1.4}, {-2.4, 0.6}};

/// Random stresses with all six components, p >= 0, up to three times the yield stress.
std::vector<Stress> random_trials(double tau_y, int count) {
  std::mt19937_64 random(14);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Stress> all;
  while (static_cast<int>(all.size()) < count) {
    Stress tau;
    for (double& component : tau.at) component = 2 * tau_y * uniform(random);
    if (pressure_of(tau) < 0)
      for (double& component : tau.at) component = -component;
    if (effective_of(tau) > 1.05 * tau_y) all.push_back(tau);
  }
  return all;
}

/// r of the yield condition, sqrt(a p^2 + q^2), with a of Eq. 12 as printed.
double r_of(double p, double q, double n) { return std::sqrt(published_cap(n) * p * p + q * q); }

/// Largest distance of inviscid images from the surface, in units of tau_y.
double distance_from_surface(const FlowStep& step, double n, const std::vector<Stress>& trials) {
  double largest = 0;
  for (const Stress& trial : trials) {
    const Stress image = step.image(trial);
    largest = larger(largest, std::abs(r_of(pressure_of(image), effective_of(image), n) / step.tau_y() - 1));
  }
  return largest;
}

Stress difference(const Stress& a, const Stress& b) {
  Stress result;
  for (int i = 0; i < 6; ++i) result.at[i] = a.at[i] - b.at[i];
  return result;
}

/// Of the ways of viscous images against those of inviscid ones: the largest sine of the angle between them, and the shares.
struct Ways {
  double sine = 0, least_share = 1, largest_share = 0;
};
Ways compare_ways(const FlowStep& viscous, const FlowStep& inviscid, const std::vector<Stress>& trials) {
  Ways ways;
  for (const Stress& trial : trials) {
    const Stress part = difference(viscous.image(trial), trial), whole = difference(inviscid.image(trial), trial);
    const double share = std::sqrt(norm_squared(part) / norm_squared(whole));
    Stress aside;
    for (int i = 0; i < 6; ++i) aside.at[i] = part.at[i] - share * whole.at[i];
    ways.sine = larger(ways.sine, std::sqrt(norm_squared(aside) / norm_squared(part)));
    ways.least_share = smaller(ways.least_share, share);
    ways.largest_share = larger(ways.largest_share, share);
  }
  return ways;
}

/// 1/2 (tau_tr - tau) : C^-1 : (tau_tr - tau) + (dt/eta) g(f(tau)), g = f^2/2 beyond yield, of stresses with the trial's
/// direction of shear: no other can be lower, since f does not see the direction.   [Ding19 Sec. 6.5]
class Functional {
 public:
  Functional(const FlowStep& step, double n, bool quadratic, double p_tr, double q_tr)
      : a_(published_cap(n)),
        bulk_(step.bulk()),
        mu3_(3 * step.mu()),
        tau_y_(step.tau_y()),
        eta_dt_(step.eta_dt()),
        quadratic_(quadratic),
        p_tr_(p_tr),
        q_tr_(q_tr) {}
  long double operator()(long double p, long double q) const {
    const long double r2 = a_ * p * p + q * q;
    const long double f = std::max(0.0L, quadratic_ ? r2 - tau_y_ * tau_y_ : std::sqrt(r2) - tau_y_);
    return (p - p_tr_) * (p - p_tr_) / (2 * bulk_) + (q - q_tr_) * (q - q_tr_) / (2 * mu3_) + f * f / (2 * eta_dt_);
  }
  /// By brute force: of a 41 x 41 grid the best place, then a grid of half the size about it, and so on.
  Trial lowest() const {
    long double p = p_tr_ / 2, q = q_tr_ / 2, half = std::max({std::abs(p_tr_), q_tr_, 1.0L});
    for (int zoom = 0; zoom < 40; ++zoom, half /= 2) {
      long double best = (*this)(p, q), best_p = p, best_q = q;
      for (int i = -20; i <= 20; ++i)
        for (int j = -20; j <= 20; ++j) {
          const long double at_p = p + half * i / 20, at_q = std::max(0.0L, q + half * j / 20), value = (*this)(at_p, at_q);
          if (value < best) best = value, best_p = at_p, best_q = at_q;
        }
      p = best_p, q = best_q;
    }
    return {static_cast<double>(p), static_cast<double>(q)};
  }

 private:
  long double a_, bulk_, mu3_, tau_y_, eta_dt_;
  bool quadratic_;
  long double p_tr_, q_tr_;
};

/// Largest distance of images from the minimiser that brute force finds, in units of tau_y.
double distance_from_minimiser(const FlowStep& step, double n, bool quadratic) {
  double largest = 0;
  for (const Trial& trial : k_trials) {
    if (n == 0 && trial.p < 0) continue;
    const double p = trial.p * step.tau_y(), q = trial.q * step.tau_y();
    const Trial lowest = Functional(step, n, quadratic, p, q).lowest();
    const Stress image = step.image(uniaxial(p, q));
    largest = larger(largest, std::hypot(pressure_of(image) - lowest.p, effective_of(image) - lowest.q) / step.tau_y());
  }
  return largest;
}

charts::Panel panel(const char* title, const FlowStep& step, double n) {
  charts::Panel panel{title, {"pressure $p$/$τ_y$", ""}, {"effective stress $q$/$τ_y$", ""}};
  panel.x.range = {{-2.8, 2.8}};
  panel.y.range = {{0, 2.3}};
  charts::Series surface{"yield surface"}, trials{"trial", charts::Kind::points}, images{"image", charts::Kind::points};
  charts::Series ways{"", charts::Kind::arrows};
  for (int i = 0; i <= 400; ++i) {
    const double tip = n == 0 ? 2.8 : 1 / std::sqrt(published_cap(n)), p = tip * std::sin(M_PI * (i / 400. - 0.5));
    surface.x.push_back(p);
    surface.y.push_back(std::sqrt(std::max(0., 1 - published_cap(n) * p * p)));
  }
  for (const Trial& trial : k_trials) {
    const Stress image = step.image(uniaxial(trial.p * step.tau_y(), trial.q * step.tau_y()));
    const double p = pressure_of(image) / step.tau_y(), q = effective_of(image) / step.tau_y();
    if (std::hypot(p - trial.p, q - trial.q) < 1e-9) continue;  // elastic
    for (auto* series : {&trials, &ways}) series->x.push_back(trial.p), series->y.push_back(trial.q);
    images.x.push_back(p), images.y.push_back(q);
    ways.x_end.push_back(p), ways.y_end.push_back(q);
  }
  surface.colour = "#808080";
  trials.colour = charts::palette(0);
  trials.marker = charts::Marker::circle;
  images.colour = charts::palette(1);
  ways.name = "way";
  ways.in_legend = false;
  ways.colour = "#a0a0a0";
  ways.width = 0.75;
  panel.series = {surface, ways, trials, images};
  panel.equal_aspect = true;
  return panel;
}

}  // namespace

Computed fig14_return_map() {
  const double eta = viscosity_of(1);
  const FlowStep inviscid(dough(0), 0, k_dt), viscous(dough(eta), 0, k_dt);
  const FlowStep porous(dough(0), k_porosity, k_dt), porous_viscous(dough(eta), k_porosity, k_dt);
  const double tau_y = inviscid.tau_y(), eta_quadratic = eta * tau_y * tau_y;
  const FlowStep printed(dough(eta_quadratic, "quadratic"), 0, k_dt), printed_porous(dough(eta_quadratic, "quadratic"), k_porosity, k_dt);

  const std::vector<Stress> trials = random_trials(tau_y, 200);
  const Ways ways = compare_ways(viscous, inviscid, trials);
  Computed computed;
  computed.numbers = {
      {"distance_from_surface", "1", "without pores and viscosity: largest distance of 200 images from the yield surface, in tau_y",
       distance_from_surface(inviscid, 0, trials)},
      {"distance_from_surface_with_pores", "1", "the same at a porosity of 0.3", distance_from_surface(porous, k_porosity, trials)},
      {"sine_between_ways", "1", "without pores: largest sine of the angle between the ways of the images with and without viscosity",
       ways.sine},
      {"least_share_of_way", "1", "without pores: smallest share of the inviscid way that is gone with viscosity 3 mu dt",
       ways.least_share},
      {"largest_share_of_way", "1", "largest share", ways.largest_share},
      {"distance_from_minimiser", "1", "largest distance of viscous images from the functional's minimum by brute force, in tau_y",
       larger(distance_from_minimiser(viscous, 0, false), distance_from_minimiser(porous_viscous, k_porosity, false))},
      {"distance_from_printed_minimiser", "1", "the same with the functional as printed (norm \"quadratic\")",
       larger(distance_from_minimiser(printed, 0, true), distance_from_minimiser(printed_porous, k_porosity, true))},
  };
  computed.charts = {
      {"return_map",
       "Trial stresses and their images under the return mapping: on the yield surface without viscosity, part of the way with it",
       {panel("(a) $n^p$ = 0, $η$ = 0", inviscid, 0), panel("(b) $n^p$ = 0, $η$ = 3$μ$Δ$t$", viscous, 0),
        panel("(c) $n^p$ = 0.3, $η$ = 0", porous, k_porosity), panel("(d) $n^p$ = 0.3, $η$ = 3$μ$Δ$t$", porous_viscous, k_porosity)}}};
  charts::Chart& chart = computed.charts[0];
  chart.panels[0].marks = {{0.5, 2, "trial", charts::Side::right, false, charts::palette(0)},
                           {0.5, 1, "image", charts::Side::below, false, charts::palette(1)},
                           {-1.2, 1, "yield surface", charts::Side::below, false, "#808080"}};
  chart.panel_height_in = 2.0;
  return computed;
}

}  // namespace bake
