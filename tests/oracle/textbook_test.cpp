// SPDX-License-Identifier: MIT
// What only the textbook has: gradients as the derivative of the weights, as in the paper.
#include <gtest/gtest.h>

#include "reference/compare/recipe_of.h"
#include "reference/textbook/baker.h"
#include "solver/effects/all_effects.h"
#include "tests/support/temporary_folder.h"

namespace bake::textbook {

namespace {

TEST(RecipeOf, AnEffectThatTheTextbookDoesNotKnowIsRefused) {
  Scene scene;
  scene.file = "dough.toml";
  scene.grid.dx_m = 0.1;
  scene.effects = effect_names();
  EXPECT_NO_THROW(recipe_of(scene));
  scene.effects.push_back("yeast");
  EXPECT_EQ(message_of<InputError>([&] { recipe_of(scene); }),
            "dough.toml: effects: found yeast, allowed: what the textbook knows: motion, heat, water, elasticity, plasticity, leavening");
}

TEST(RecipeOf, AFractureEnergyIsRefused) {
  Scene scene;
  scene.file = "dough.toml";
  scene.grid.dx_m = 0.1;
  scene.effects = effect_names();
  scene.materials.emplace_back();
  scene.materials[0].name = "crust";
  scene.materials[0].effects.get<Plasticity::Material>().fracture_energy_J_per_m2 = 6;
  EXPECT_EQ(message_of<InputError>([&] { recipe_of(scene); }),
            "dough.toml: material.crust.fracture_energy_J_per_m2: found 6, allowed: inf, which the textbook knows");
}

TEST(RecipeOf, SettlingIsRefused) {
  Scene scene;
  scene.file = "dough.toml";
  scene.grid.dx_m = 0.1;
  scene.effects = effect_names();
  scene.settings.get<Motion::Settings>().settle_damping_per_s = 20;
  EXPECT_EQ(message_of<InputError>([&] { recipe_of(scene); }),
            "dough.toml: motion.settle_damping_per_s: found 20, allowed: 0, since the textbook does not settle");
}

constexpr Kernel k_kernels[] = {Kernel::quadratic, Kernel::cubic};
constexpr Gradient k_gradients[] = {Gradient::moments, Gradient::spline};

/// Elastic dough that moves freely in a large box.
Recipe free_flight(Kernel kernel, Gradient gradient) {
  Recipe recipe;
  recipe.motion = recipe.elasticity = true;
  recipe.dx = 0.1;
  for (int& cells : recipe.cells) cells = 16;
  recipe.kernel = kernel;
  recipe.gradient = gradient;
  Material dough;
  dough.density = 500;
  dough.young_modulus = 1e4;
  dough.poisson_ratio = 0.3;
  recipe.materials = {dough};
  return recipe;
}

TEST(TextbookKernel, GradientsOfLinearFieldsAreExact) {
  for (const Kernel kernel : k_kernels)
    for (const Gradient gradient : k_gradients) {
      const Recipe recipe = free_flight(kernel, gradient);
      const Grid grid(recipe);
      const Vector slope{{3, -1, 2}}, x{{0.83, 0.511, 0.768}};
      double sum = 0, value = 0;
      Vector seen;
      for_each_node(grid, x, kernel, [&](const Index& i, const Overlap& o) {
        sum += o.w;
        value += o.w * dot(slope, grid.position(i));
        seen += dot(slope, grid.position(i)) * o.grad_w;
      });
      EXPECT_NEAR(sum, 1, 1e-14);
      EXPECT_NEAR(value, dot(slope, x), 1e-13);
      EXPECT_LT(length(seen - slope), 1e-12);
    }
}

TEST(TextbookKernel, SplineSlopeIsTheDerivativeOfTheSpline) {
  for (const Kernel kernel : k_kernels)
    for (double u = -2.05; u < 2.1; u += 0.1) {
      const double h = 1e-6;
      EXPECT_NEAR(spline_slope(kernel, u), (spline(kernel, u + h) - spline(kernel, u - h)) / (2 * h), 1e-9) << u;
    }
}

TEST(TextbookBaker, FreeFlightKeepsMomentumWithEitherGradient) {
  for (const Kernel kernel : k_kernels)
    for (const Gradient gradient : k_gradients) {
      Baker baker(free_flight(kernel, gradient));
      for (int i = 0; i < 64; ++i) {
        const Vector offset{{0.05 * (i / 16) - 0.075, 0.05 * (i / 4 % 4) - 0.075, 0.05 * (i % 4) - 0.075}};
        Beginning b;
        b.id = i;
        b.x = Vector{{0.8, 0.8, 0.8}} + offset;
        b.v = {{0.3 + 5 * offset[1], -0.2, 0.1 - 3 * offset[2]}};
        b.volume = 1.25e-4;
        baker.add(b);
      }
      const auto momentum = [&] {
        Vector sum;
        for (const Particle& p : baker.particles()) sum += p.mass() * p.v;
        return sum;
      };
      const Vector before = momentum();
      double strain = 0;
      for (int n = 0; n < 50; ++n) baker.step(2e-3, {});
      for (const Particle& p : baker.particles()) strain = std::max(strain, frobenius_squared(p.b_E - identity()));
      EXPECT_GT(strain, 1e-4);  // stresses were at work
      EXPECT_LT(length(momentum() - before), 1e-12 * length(before));
    }
}

}  // namespace

}  // namespace bake::textbook
