// SPDX-License-Identifier: MIT
#include "analysis/machines/scenes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "solver/scene/describe.h"
#include "solver/scene/scene_builder.h"

namespace bake::bench {

// The dough of fig. 15 under the gravity of experiments/fig15_bread, baked from 30 C on the same grid whatever its size, with a
// fifth of that dough's yield stress: after the few steps before the clock starts most particles flow, as in most of a bake. With all
// of Earth's gravity a loaf without gas is pressed flat, and strains so large that they leave the series are timed instead.
Scene loaf(const Combination& combination, Precision precision, double particles) {
  constexpr double k_pi = 3.14159265358979323846, per_cell = 7, dx = 0.01;
  constexpr double length = 5, width = 3, height = 3;  // half an ellipsoid, times `scale`
  const double scale = std::cbrt(particles / per_cell * dx * dx * dx / (2 * k_pi / 3 * length * width * height));
  const double size = 1.3 * length * scale;
  SceneBuilder builder;
  builder.dx = dx;
  builder.effects = fmt::format("{}", fmt::join(combination.effects, ", "));
  builder.precision = word_of(precision);
  builder.low = {-size, -size, 0};
  builder.high = {size, size, size};
  builder.gravity = "[0, 0, -1]";
  builder.motion = combination.flip ? "transfer = \"flip\"" : "";
  builder.leavening = "reference_pressure_Pa = 4000";
  builder.material = R"(density_kg_per_m3 = 500
young_modulus_Pa = 2e3
poisson_ratio = 0.3
initial_temperature_C = 30
initial_porosity = 0.1
initial_saturation = 0.2
specific_heat_J_per_kgK = 20
conductivity_W_per_mK = 100
expansion_per_K = 1e-4
temperatures_C = [4, 20, 60, 85]
yield_stress_Pa = [4, 4, 3, 80]
viscosity_Pa_s = [500, 500, 400, 400]
diffusivity_m2_per_sK = 5e-7
evaporation_kg_per_m2sK = 4e-3
pressure_Pa = 300
production_mol_per_kgs = 0.03
peak_temperature_C = 40
temperature_width_K = 20
)";
  builder.tables = R"([water]
latent_heat_J_per_kg = 1.7e4
[oven]
temperature_C = 200
heat_transfer_coefficient_W_per_m2K = 100
[[collider]]
name = "tray"
shape = { half_space = { point_m = [0, 0, 0], normal = [0, 0, 1] } }
contact = "sticky"
temperature_C = 200
heat_transfer_coefficient_W_per_m2K = 150
)";
  builder.particles_per_cell = per_cell;
  builder.shape = fmt::format(R"(intersection = [
    {{ superellipsoid = {{ centre_m = [0, 0, 0], half_axes_m = [{}, {}, {}], plan_exponent = 2, profile_exponent = 2 }} }},
    {{ half_space = {{ point_m = [0, 0, 0], normal = [0, 0, -1] }} }},
])",
                              length * scale, width * scale, height * scale);
  return builder.scene();
}

Scene elastic_block(Precision precision, int cells) {
  const double side = 0.01 * cells;
  SceneBuilder builder;
  builder.effects = "motion, elasticity";
  builder.precision = word_of(precision);
  builder.dx = 0.01;
  builder.low = {-0.08, -0.08, -0.08};
  builder.high = {side + 0.08, side + 0.08, side + 0.08};
  builder.material = "density_kg_per_m3 = 1000\nyoung_modulus_Pa = 1e5\npoisson_ratio = 0.3\n";
  builder.shape = fmt::format("box = {{ centre_m = [{0}, {0}, {0}], half_extents_m = [{0}, {0}, {0}] }}", side / 2);
  builder.body = "jitter = 0";
  return builder.scene();
}

// The flesh and skin of experiments/fig09_grapes, at the grid of `standard`.
Scene grape(Precision precision, bool in_skin) {
  SceneBuilder builder;
  builder.effects = "motion, water, elasticity, plasticity";
  builder.precision = word_of(precision);
  builder.dx = 0.0008;
  builder.low = {-0.0128, -0.0128, -0.0128};
  builder.high = {0.0128, 0.0128, 0.0128};
  builder.motion = "inertia_scale = 1500";
  builder.material = R"(density_kg_per_m3 = 1000
young_modulus_Pa = 2e3
poisson_ratio = 0.3
initial_temperature_C = 60
initial_porosity = 1e-6
initial_saturation = 0.8
yield_stress_Pa = 200
pressure_Pa = 8330
diffusivity_m2_per_sK = 1.33e-7
evaporation_kg_per_m2sK = 0.0133
)";
  builder.shape = "ellipsoid = { half_axes_m = [0.009, 0.008, 0.008] }";
  builder.body = "jitter = 1";
  if (in_skin) builder.tables = "[[skin]]\nyoung_modulus_Pa = 1e5\npoisson_ratio = 0.3\nthickness_m = 3.5e-4\ndensity_kg_per_m3 = 1000\n";
  return builder.scene();
}

}  // namespace bake::bench
