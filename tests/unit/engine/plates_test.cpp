// SPDX-License-Identifier: MIT
// Plates that press and pull between the nodes of the grid.
#include <gtest/gtest.h>

#include <cmath>

#include "solver/effects/elasticity.h"
#include "tests/conservation/dough.h"

namespace bake {
namespace {

constexpr double k_height = 0.5, k_wide = 0.25;  // [m]

/// A block in a shaft of five colliders that slip, all turned by an angle about x.
struct Shaft : Dough {
  Shaft(double cells, double angle_deg, const std::string& contact, double travel) {
    dx = k_height / cells;
    motion = k_pic;
    material = "density_kg_per_m3 = 500\nyoung_modulus_Pa = 2e4\npoisson_ratio = 0.3\n";
    place_ = fmt::format("rotate_deg = [{}, 0, 0], move_m = [0.013, -0.021, 0.017]", angle_deg);
    shape = fmt::format("box = {{ centre_m = [0, 0, {0}], half_extents_m = [{1}, {1}, {0}] }}, {2}", k_height / 2, k_wide / 2, place_);
    body = "jitter = 0";
    for (const Vector3& n : {Vector3{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}})
      add(fmt::format("point_m = [{}, {}, 0], normal = [{}, {}, 0]", -n[0] * k_wide / 2, -n[1] * k_wide / 2, n[0], n[1]), "slip", "");
    add("point_m = [0, 0, 0], normal = [0, 0, 1]", "slip", "");
    const double angle = angle_deg * M_PI / 180;
    add(fmt::format("point_m = [0, 0, {}], normal = [0, 0, -1]", k_height), contact,
        fmt::format("motion = [{{ time_s = 0 }}, {{ time_s = 1, position_m = [0, {:.17g}, {:.17g}] }}]", -travel * std::sin(angle),
                    travel * std::cos(angle)));
  }
  /// Energy when the plate has come to rest, relative to that of the strain.
  double energy(double travel) const {
    const Scene scene = Dough::scene();
    const auto& elastic = of<Elasticity>(scene.materials[0]);
    const double nu = elastic.poisson_ratio, modulus = elastic.young_modulus_Pa * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
    const auto s = Simulation::begin(scene);
    EXPECT_TRUE(s->advance(1.3, 1.4));
    const double strain = std::log(1 + travel / k_height);
    return s->total(total::elastic) / (k_height * k_wide * k_wide * modulus / 2 * strain * strain);
  }

 private:
  std::string place_;
  void add(const std::string& half_space, const std::string& contact, const std::string& keys) {
    tables +=
        fmt::format("[[collider]]\nshape = {{ half_space = {{ {} }}, {} }}\ncontact = \"{}\"\n{}\n", half_space, place_, contact, keys);
  }
};

double energy(double cells, double angle_deg, const std::string& contact, double travel) {
  return Shaft(cells, angle_deg, contact, travel).energy(travel);
}

// Nodes inside of plates alone, with the plates' velocity: 10 to 30 % are missing, whatever dx.
TEST(APlateThatPresses, StoresTheEnergyOfTheStrain) {
  for (const char* contact : {"slip", "separating"}) {
    EXPECT_NEAR(energy(8, 0, contact, -0.026), 1, 0.03) << contact;
    EXPECT_NEAR(energy(16, 0, contact, -0.026), 1, 0.02) << contact;
  }
}

TEST(APlateThatPresses, StoresTheEnergyOfTheStrainIfItIsNotAlongTheGrid) {
  for (const double angle : {20., 45.}) EXPECT_NEAR(energy(16, angle, "separating", -0.026), 1, 0.1) << angle;
}

TEST(APlateThatIsPulledAway, TakesDoughAlongUnlessItSeparates) {
  for (const char* contact : {"slip", "sticky"}) EXPECT_NEAR(energy(8, 0, contact, 0.1), 1, 0.1) << contact;
  EXPECT_LT(energy(8, 0, "separating", 0.1), 0.01);
}

}  // namespace
}  // namespace bake
