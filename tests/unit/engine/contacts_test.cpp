// SPDX-License-Identifier: MIT
#include "solver/engine/contacts.h"

#include <gtest/gtest.h>

#include "solver/scene/scene.h"

namespace bake {

namespace {

/// Whether the block that holds the last nodes of an axis knows of the face that goes through them.
TEST(DomainFaces, AreKnownToTheirNodesBlockWhateverTheRounding) {
  for (int cells = 12; cells < 16; ++cells)
    for (int i = 1; i <= 300; ++i) {
      const double dx = 0.0007 * i;
      Scene scene;
      scene.domain.min_m = {-0.3, -0.3, -0.3};
      scene.domain.max_m = {-0.3 + cells * dx, 1e3, 1e3};
      scene.domain.x_min = scene.domain.y_min = scene.domain.z_min = scene.domain.y_max = scene.domain.z_max = Face::open;
      const GridGeometry geometry(scene.domain.min_m, scene.domain.max_m, dx);
      Contacts contacts(scene, geometry);
      contacts.prepare(0);
      const int face = static_cast<int>(geometry.high_face(0));
      const BlockIndex block{face / 4, 4, 4};
      const Point node = geometry.origin(block) + Vector3{face % 4 * dx, 0, 0};
      EXPECT_TRUE(contacts.near(block, 0)) << cells << " cells of " << dx;
      EXPECT_EQ(contacts.velocity_after(node, {1, 0, 0})[0], 0) << cells << " cells of " << dx;
    }
}

}  // namespace

}  // namespace bake
