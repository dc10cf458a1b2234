// SPDX-License-Identifier: MIT
// States of rest that a warm body settles to, and the pressure of pores that are held shut.
#include <fmt/format.h>

#include <cmath>

#include "experiments/convergence/bar.h"
#include "experiments/convergence/cases.h"

namespace bake::studies {

namespace {

constexpr double k_cold = 20, k_hot = 80, k_kelvin = 273.15;
constexpr double k_pores = 0.3, k_pressure = 1;                  // n_0, and the atmosphere [Pa]
constexpr double k_leavener = 10;                                // [mol/m^3]
constexpr double k_gas_constant = 8.314, k_atmosphere = 101325;  // moles are given for the real one and scaled

/// A cube that starts at k_hot and swings until PIC has damped it.
Snapshot settled_cube(double cells, const char* effects, const std::string& material, const std::string& tables, double end_s) {
  StudyScene setting(effects);
  setting.dx = 1 / cells;
  setting.frame_s = end_s;
  setting.time = "safety = 0.5";
  setting.motion = "transfer = \"pic\"";
  setting.material +=
      fmt::format("initial_temperature_C = {}\nspecific_heat_J_per_kgK = 1000\nconductivity_W_per_mK = 0\n", k_cold) + material;
  setting.tables = tables;
  setting.shape = "box = { half_extents_m = [0.5, 0.5, 0.5] }";
  setting.body = fmt::format("temperature_C = {}", k_hot);
  return setting.after(end_s)->snapshot();
}

Errors at_rest(const char* quantity, double bound, const char* why, bool quick) {
  Errors e;
  e.quantity = quantity;
  e.refined = "cells in the edge";
  e.figure = Errors::Figure::largest_error;
  e.high = bound;
  e.why = why;
  e.refinements = quick ? std::vector<double>{4, 6} : std::vector<double>{4, 6, 8, 12};
  return e;
}

}  // namespace

std::vector<Errors> thermal_strain(bool quick) {
  constexpr double alpha = 1e-4;
  Errors middle =
      at_rest("ln J against 3 alpha (theta - theta_0), mean", 1e-5, "the discrete solution: without stress no node is pushed", quick);
  Errors noise = at_rest("ln J against 3 alpha (theta - theta_0), rms", 5e-3,
                         "particle noise: what of the first swing the particles keep where the nodes see none of it", quick);
  for (const double n : middle.refinements) {
    const Snapshot now =
        settled_cube(n, "motion, heat, elasticity", fmt::format("young_modulus_Pa = 1\nexpansion_per_K = {}\n", alpha), "", 100);
    const auto &J = now["volume_ratio"], &theta = now["temperature"];
    std::vector<double> error;
    for (std::size_t i = 0; i < J.size(); ++i) error.push_back(std::log(J[i]) / (3 * alpha * (theta[i] - k_cold)) - 1);
    middle.errors.push_back(std::abs(mean(error)));
    noise.errors.push_back(root_mean_square(error));
  }
  return {middle, noise};
}

std::vector<Errors> open_pores(bool quick) {
  std::vector<Errors> all;
  for (const double leavener : {0.0, k_leavener}) {
    Errors e =
        at_rest(leavener > 0 ? "volume of pores heated and leavened, mean" : "volume of heated pores, mean", 1e-3,
                "the discrete solution, but for the elastic stress that the yield stress of 1e-5 of the atmosphere lets stand", quick);
    for (const double n : e.refinements) {
      const Snapshot now =
          settled_cube(n, "motion, heat, elasticity, plasticity, leavening",
                       fmt::format("young_modulus_Pa = 1\ninitial_porosity = {}\nyield_stress_Pa = 1e-5\nproduction_mol_per_kgs = {}\n"
                                   "peak_temperature_C = {}\nleavener_mol_per_m3 = {}\n",
                                   k_pores, leavener, k_hot, k_leavener),
                       fmt::format("[leavening]\nreference_pressure_Pa = {}\n", k_pressure), 100);
      const auto& J = now["volume_ratio"];
      std::vector<double> error;
      error.reserve(J.size());
      // J - (1 - n_0) = n_0 theta_K / theta_0K + nu R theta_K / p
      const double theta_K = k_hot + k_kelvin;
      const double pores = k_pores * theta_K / (k_cold + k_kelvin) + leavener * k_gas_constant * theta_K / k_atmosphere;
      for (const double j : J) error.push_back((j - (1 - k_pores)) / pores - 1);
      e.errors.push_back(std::abs(mean(error)));
    }
    all.push_back(e);
  }
  return all;
}

std::vector<Errors> closed_pores(bool quick) {
  constexpr double t = 0.2;
  Errors e = at_rest(
      "momentum of half a bar against p_ref (theta_K / theta_0K - 1) A t", 1e-6,
      "exact until the waves from the free ends meet: the middle still pushes with the pressure of heated pores of their first volume; "
      "on the grid, waves have forerunners",
      quick);
  e.refined = "cells";
  e.refinements = quick ? std::vector<double>{32, 64} : std::vector<double>{32, 64, 128};
  for (const double n : e.refinements) {
    Bar bar;
    bar.effects = "motion, heat, elasticity, plasticity, leavening";
    bar.cells = static_cast<int>(n);
    bar.air = bar.cells / 4;
    bar.end_s = t;
    bar.time = "safety = 0.5";
    bar.material = fmt::format(
        "young_modulus_Pa = 1\ninitial_porosity = {}\nyield_stress_Pa = 1e3\ninitial_temperature_C = {}\nspecific_heat_J_per_kgK = 1000\n"
        "conductivity_W_per_mK = 0\n",
        k_pores, k_cold);
    bar.tables = fmt::format("[leavening]\nreference_pressure_Pa = {}\n", k_pressure / 10);
    bar.state = [](double) { return fmt::format("temperature_C = {}", k_hot); };
    const Snapshot now = bar.end()->snapshot();
    const auto& mass = now["solid_mass"];
    double momentum = 0;
    for (std::size_t i = 0; i < mass.size(); ++i)
      if (now.position[i][0] > 0.5) momentum += mass[i] * now.velocity[i][0];
    const double pressure = k_pressure / 10 * ((k_hot + k_kelvin) / (k_cold + k_kelvin) - 1), section = bar.dx() * bar.dx();
    e.errors.push_back(std::abs(momentum / (pressure * section * t) - 1));
  }
  return {e};
}

}  // namespace bake::studies
