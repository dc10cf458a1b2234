// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "experiments/common/study_scene.h"
#include "experiments/stability/stability.h"
#include "solver/core/errors.h"

namespace bake::studies {

namespace {

constexpr int k_steps = 300;

/// A cube of six cells in two halves that differ by a jump of whatever the map is about.
struct Cube {
  std::string effects, material, motion, tables, kernel = "quadratic";
  std::string left, right;  ///< keys of the two halves
  double dx = 0.1;
  int particles_per_cell = 8;

  std::unique_ptr<Simulation> begin(double safety) const {
    StudyScene setting(effects);
    setting.frame_s = 1e6;
    setting.dx = dx;
    setting.low = {-10 * dx, -10 * dx, -10 * dx};
    setting.high = {10 * dx, 10 * dx, 10 * dx};
    setting.kernel = kernel;
    setting.time = fmt::format("safety = {}\ncfl = 0.999\nsmallest_step_s = 1e-12", safety);  // no frame tells how small is too small
    setting.motion = motion;
    setting.material += material;
    setting.tables = tables;
    for (const auto& [side, keys] : {std::pair(-1, left), std::pair(1, right)})
      setting.tables += fmt::format(
          "[[body]]\nmaterial = \"dough\"\nparticles_per_cell = {}\n{}\n"
          "shape = {{ box = {{ centre_m = [{:.17g}, 0, 0], half_extents_m = [{:.17g}, {:.17g}, {:.17g}] }} }}\n",
          particles_per_cell, keys, side * 1.5 * dx, 1.5 * dx, 3 * dx, 3 * dx);
    return setting.begin();
  }
};

/// Takes k_steps steps. False if one cannot be taken, or `bounded` says so on the way.
bool endures(const Cube& cube, double safety, const std::function<bool(const Simulation&)>& bounded) {
  try {
    const auto simulation = cube.begin(safety);
    if (!bounded(*simulation)) return false;
    for (int i = 0; i < k_steps; i += 10) {
      for (int j = 0; j < 9; ++j) simulation->advance(1e6, 2e6, [] { return false; });  // one step each
      const double next = simulation->time() + simulation->dt();
      simulation->advance(next, 1e6);  // one step that samples
      if (!bounded(*simulation)) return false;
    }
    return true;
  } catch (const RunError&) {
    return false;
  }
}

/// Of energies none that is more than twice the first.
template <class Energy>
bool keeps(const Cube& cube, double safety, Energy energy) {
  double start = -1;
  return endures(cube, safety, [&](const Simulation& s) {
    if (start < 0) start = energy(s);
    return energy(s) <= 2 * start;
  });
}

/// Mechanics: no energy from nowhere. A jump of velocities excites every mode of the grid.
bool keeps_energy(const Cube& cube, double safety) {
  return keeps(cube, safety, [](const Simulation& s) { return s.total(total::kinetic) + s.total(total::elastic); });
}

/// Diffusion: no value outside those at the start, by more than a tenth of the jump (FLIP and the kernels overshoot a little).
bool keeps_range(const Cube& cube, double safety) {
  return endures(cube, safety,
                 [](const Simulation& s) { return s.highest(highest::coldness) < 10 && s.highest(highest::temperature) < 110; });
}

bool keeps_saturations(const Cube& cube, double safety) {
  return endures(cube, safety, [](const Simulation& s) {
    const Snapshot now = s.snapshot();
    const auto &m = now["water_mass"], &V = now["initial_volume"];
    for (std::size_t i = 0; i < m.size(); ++i)
      if (const double saturation = m[i] / V[i]; !(saturation > 0.378 && saturation < 0.402)) return false;  // water of density 1
    return s.booked(booked::water_limited) == 0;
  });
}

Cube elastic_cube(double E) {
  Cube cube;
  cube.effects = "motion, elasticity";
  cube.material = fmt::format("young_modulus_Pa = {}\npoisson_ratio = 0.3\n", E);
  const double speed = 1e-3 * std::sqrt(E);  // far below the wave's
  cube.left = fmt::format("velocity_m_per_s = [{0}, {0}, 0]", speed);
  cube.right = fmt::format("velocity_m_per_s = [-{0}, -{0}, 0]", speed);
  return cube;
}

Cube conducting(double kappa, const char* integrator) {
  Cube cube;
  cube.effects = "heat";
  cube.material = fmt::format("specific_heat_J_per_kgK = 1\nconductivity_W_per_mK = {}\n", kappa);
  cube.tables = fmt::format("[heat]\nintegrator = \"{}\"\nimplicit_step_factor = 1\n", integrator);
  cube.left = "temperature_C = 0";
  cube.right = "temperature_C = 100";
  return cube;
}

Cube diffusing(double K) {
  Cube cube;
  cube.effects = "water";
  cube.material = fmt::format("diffusivity_m2_per_sK = {}\nwater_density_kg_per_m3 = 1\ninitial_saturation = 0.2\n", K);
  cube.left = "saturation = 0.38";  // a small jump: the diffusivity, K theta s, is nearly the same everywhere
  cube.right = "saturation = 0.4";
  return cube;
}

/// Soft solid, stiff pores: the gas alone sets the step.
Cube leavened(double p_ref) {
  Cube cube = elastic_cube(1e-3 * p_ref);
  cube.effects = "motion, heat, elasticity, plasticity, leavening";
  cube.material += "initial_porosity = 0.3\nyield_stress_Pa = 1e9\nspecific_heat_J_per_kgK = 1\nconductivity_W_per_mK = 0\n";
  cube.tables = fmt::format("[leavening]\nreference_pressure_Pa = {}\n", p_ref);
  return cube;
}

/// Gas works on the solid and takes it back: the elastic energy alone says nothing, but kinetic energy may not grow.
bool keeps_kinetic_energy(const Cube& cube, double safety) {
  return keeps(cube, safety, [](const Simulation& s) { return s.total(total::kinetic); });
}

}  // namespace

std::vector<Probe> all_probes(bool quick) {
  std::vector<Probe> probes;
  using Holds = bool (*)(const Cube&, double);
  for (const std::string kernel : {"quadratic", "cubic"}) {
    const auto add = [&](std::string map, const char* knob, double value, Cube cube, Holds holds, bool has_limit = true) {
      cube.kernel = kernel;
      probes.push_back({std::move(map), knob, value, has_limit, [=](double safety) { return holds(cube, safety); },
                        [=](double safety) { return cube.begin(safety)->dt(); }});
    };
    /// Every knob that all cubes have.
    const auto sweep = [&](const std::string& map, const Cube& cube, Holds holds, bool has_limit = true) {
      for (const double dx : quick ? std::vector{0.01} : std::vector{0.01, 1.0}) {
        Cube other = cube;
        other.dx = dx;
        add(map, "dx_m", dx, other, holds, has_limit);
      }
      for (const int n : quick ? std::vector{1, 8} : std::vector{1, 2, 4, 8, 27, 64}) {
        Cube other = cube;
        other.particles_per_cell = n;
        add(map, "particles_per_cell", n, other, holds, has_limit);
      }
    };
    for (const char* transfer : {"apic", "pic", "flip"}) {
      const std::string map = fmt::format("elastic waves, {}, {}", kernel, transfer);
      const auto of = [&](double E) {
        Cube cube = elastic_cube(E);
        cube.motion = fmt::format("transfer = \"{}\"", transfer);
        return cube;
      };
      for (const double E : quick ? std::vector{1e2} : std::vector{1e2, 1e4, 1e6}) add(map, "young_modulus_Pa", E, of(E), keeps_energy);
      sweep(map, of(1e4), keeps_energy);
    }
    const std::string gas = fmt::format("pore gas, {}, apic", kernel);
    for (const double p : quick ? std::vector{4000.} : std::vector{400., 4000., 101325.})
      add(gas, "reference_pressure_Pa", p, leavened(p), keeps_kinetic_energy);
    sweep(gas, leavened(4000), keeps_kinetic_energy);
    for (const char* integrator : {"forward_euler", "backward_euler"}) {
      const std::string map = fmt::format("heat, {}, {}", kernel, integrator);
      const bool has_limit = std::string_view(integrator) == "forward_euler";
      for (const double kappa : quick ? std::vector{1.} : std::vector{1e-3, 1., 1e3})
        add(map, "conductivity_W_per_mK", kappa, conducting(kappa, integrator), keeps_range, has_limit);
      sweep(map, conducting(1, integrator), keeps_range, has_limit);
    }
    const std::string water = fmt::format("water, {}", kernel);
    for (const double K : quick ? std::vector{1e-2} : std::vector{1e-4, 1e-2, 1.})
      add(water, "diffusivity_m2_per_sK", K, diffusing(K), keeps_saturations);
    sweep(water, diffusing(1e-2), keeps_saturations);
  }
  return probes;
}

}  // namespace bake::studies
