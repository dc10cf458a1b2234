// SPDX-License-Identifier: MIT
#include "tests/oracle/scenes.h"

#include <fmt/format.h>

#include <random>

namespace bake {

namespace {

class Dice {
 public:
  explicit Dice(int seed) : bits_(static_cast<std::uint32_t>(seed)) {}
  double between(double low, double high) { return low + (high - low) * (bits_() / 4294967296.0); }
  std::string vector(double low, double high) {
    const double x = between(low, high), y = between(low, high), z = between(low, high);
    return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", x, y, z);
  }

 private:
  std::mt19937 bits_;
};

/// Table 2's bread with faster water, so that all effects show within a hundred steps.
std::string material(Dice& dice, const std::string& more) {
  return fmt::format(R"(density_kg_per_m3 = {:.17g}
young_modulus_Pa = {:.17g}
poisson_ratio = {:.17g}
initial_saturation = 0.2
initial_porosity = {:.17g}
initial_temperature_C = 20
specific_heat_J_per_kgK = 20
conductivity_W_per_mK = {:.17g}
expansion_per_K = 1e-4
temperatures_C = [4, 20, 60, 85]
pressure_Pa = 300
diffusivity_m2_per_sK = 2e-4
evaporation_kg_per_m2sK = 0.5
production_mol_per_kgs = 0.3
{}
)",
                     dice.between(400, 600), dice.between(1e4, 3e4), dice.between(0.1, 0.4), dice.between(0.1, 0.3), dice.between(50, 150),
                     more);
}

std::string blob(const std::string& material, const std::string& shape, const std::string& state, Dice& dice) {
  const std::string angular_velocity = dice.vector(-4, 4), velocity = dice.vector(-1.5, 1.5);
  return fmt::format(R"(
[[body]]
material = "{}"
shape = {{ {} }}
particles_per_cell = {:.17g}
jitter = 1
velocity_m_per_s = {}
angular_velocity_rad_per_s = {}
{}
)",
                     material, shape, dice.between(5, 9), velocity, angular_velocity, state);
}

}  // namespace

Scene RandomScene::scene() const {
  Dice dice(seed);
  const std::string drawn = dice.vector(-10, 10);
  const bool own_strength = material.find("yield_stress") != std::string::npos;
  const std::string strength = own_strength ? "" : "yield_stress_Pa = [200, 200, 150, 400]\nviscosity_Pa_s = [50, 50, 40, 40]\n";
  SceneBuilder builder;
  builder.effects = effects;
  builder.precision = precision;
  builder.frame_s = 1000;
  builder.run = fmt::format("seed = {}", seed);
  builder.kernel = kernel;
  builder.low = {-0.6, -0.6, -0.6};
  builder.high = far_corner;
  builder.faces = "friction = 0.2\n" + faces;
  builder.gravity = gravity.empty() ? drawn : gravity;
  builder.motion = motion;
  builder.heat = "water_specific_heat_J_per_kgK = 40\n" + heat;
  builder.leavening = leavening;
  builder.surface = surface;
  builder.material = bake::material(dice, strength + material);
  std::string& text = builder.tables;
  text = fmt::format(
      "[oven]\ntemperature_C = [[0, 120], [1, 200]]\nheat_transfer_coefficient_W_per_m2K = 300\nequilibrium_saturation = 0.05\n"
      "[water]\n{}\n[plasticity]\n{}\n[[material]]\nname = \"crust\"\n{}",
      water, plasticity, bake::material(dice, strength + material));
  text += blob("dough", fmt::format("sphere = {{ centre_m = {}, radius_m = 0.2 }}", dice.vector(-0.1, 0.1)), "", dice);
  text += blob("crust", "box = { centre_m = [0.36, -0.1, 0.1], half_extents_m = [0.12, 0.15, 0.1] }",
               "temperature_C = 70\nsaturation = 0.3\nleavener = 0.6", dice);
  text += blob("dough", "sphere = { centre_m = [-0.3, -0.45, -0.1], radius_m = 0.13 }", "temperature_C = 95\nsaturation = 0", dice);
  // nowhere on the grid's planes: a node must not lie at a threshold of a distance
  const std::string solids = fmt::format(
      R"(
[[collider]]
shape = {{ half_space = {{ point_m = [0, 0, -0.21], normal = {} }} }}
friction = 0.3
temperature_C = 180
heat_transfer_coefficient_W_per_m2K = 200
[[collider]]
shape = {{ sphere = {{ centre_m = {}, radius_m = 0.2 }} }}
contact = "sticky"
motion = [{{ time_s = 0 }}, {{ time_s = 1, position_m = [0, -0.4, 0], rotation_deg = {} }}]
pivot_m = [0.1, 0.45, 0.1]
)",
      "[0.1, 0.2, 1]", fmt::format("[{:.17g}, {:.17g}, 0.1]", dice.between(0.05, 0.15), dice.between(0.4, 0.5)), dice.vector(-90, 90));
  text += (colliders ? solids : "") + tables;
  builder.overrides = overrides;
  return builder.scene();
}

}  // namespace bake
