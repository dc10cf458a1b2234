// SPDX-License-Identifier: MIT
#include "solver/engine/survey.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "solver/boundary/shapes.h"
#include "solver/engine/contacts.h"
#include "solver/scene/scene.h"

namespace bake {
namespace {

constexpr double k_fine_dx = 0.01;

ShapePtr box(const Vector3& half) {
  auto made = std::make_shared<Box>();
  made->centre_m = {0.08, 0.08, 0.04};
  made->half_extents_m = half;
  return made;
}

ShapePtr ball() {
  auto made = std::make_shared<Sphere>();
  made->centre_m = {0.083, 0.079, 0.091};
  made->radius_m = 0.033;
  return made;
}

/// A ball in the slot of a tilted slab.
std::vector<Collider> ball_and_slab(Contact contact) {
  std::vector<Collider> both(2);
  both[0].shape = ball();
  both[1].shape =
      make_transformed(make_difference(box({0.07, 0.06, 0.03}), {box({0.02, 0.09, 0.05})}), 1, {10, 20, 5}, {0.004, -0.01, 0.02});
  for (Collider& c : both) c.contact = contact, c.friction = 0.4;
  return both;
}

struct Surveyed {
  Scene scene;
  GridGeometry geometry{{0, 0, 0}, {16 * k_fine_dx, 16 * k_fine_dx, 16 * k_fine_dx}, k_fine_dx};
  ActiveBlocks active;
  explicit Surveyed(std::vector<Collider> colliders) {
    scene.domain.min_m = {0, 0, 0};
    scene.domain.max_m = {16 * k_fine_dx, 16 * k_fine_dx, 16 * k_fine_dx};
    scene.colliders = std::move(colliders);
    for (int x = 2; x < 6; ++x)
      for (int y = 2; y < 6; ++y)
        for (int z = 2; z < 6; ++z) active.at.push_back({x, y, z});
  }
  /// Calls visit(node, velocity) for all nodes.
  template <class Visit>
  void for_each_node(Visit visit) const {
    for (const BlockIndex& block : active.at)
      for (int n = 0; n < k_block_nodes; ++n) {
        const Place at(geometry, block, n);
        visit(at, velocity(at.x));
      }
  }
  static Vector3 velocity(const Point& x) { return {std::sin(90 * x[0]), std::cos(70 * x[1]), std::sin(110 * x[2] + 1)}; }
};

/// Nodes that are half full, so that some columns are.
struct HalfFull final : NodesAround {
  NodeState at(int axis, int steps) const override { return {steps > 0 ? 1.0 : 0.5 + 0.1 * steps, {0.1 * axis, -0.2, 0.05 * steps}}; }
};

class ContactOfSolidsThatStand : public testing::TestWithParam<Contact> {};

TEST_P(ContactOfSolidsThatStand, IsThatOfSolidsThatAreAskedAnew) {
  const Surveyed nodes(ball_and_slab(GetParam()));
  Contacts fresh(nodes.scene, nodes.geometry), kept(nodes.scene, nodes.geometry);
  fresh.prepare(0);
  for (int step = 0; step < 2; ++step) kept.prepare(0), kept.survey(nodes.active);
  EXPECT_EQ(fresh.bytes(), 0u);
  EXPECT_GT(kept.bytes(), 0u);
  const HalfFull around;
  int touched = 0, covered = 0, on_line = 0;
  nodes.for_each_node([&](const Place& at, const Vector3& v) {
    const Vector3 expected = fresh.velocity_after(at.x, v, &around);
    EXPECT_EQ(kept.velocity_after(at, v, &around), expected);
    EXPECT_EQ(kept.velocity_after(at, v), fresh.velocity_after(at.x, v));
    EXPECT_EQ(kept.room(at), fresh.room(at.x));
    const Vector3 n = (1 / length(v)) * v;
    const Covers of_kept = kept.covering(at, n, 2.5 * k_fine_dx), of_fresh = fresh.covering(at.x, n, 2.5 * k_fine_dx);
    ASSERT_EQ(of_kept.count, of_fresh.count);
    for (int s = 0; s < of_kept.count; ++s)
      EXPECT_EQ(of_kept.solids[static_cast<std::size_t>(s)].share, of_fresh.solids[static_cast<std::size_t>(s)].share);
    touched += expected != v;
    on_line += expected != fresh.velocity_after(at.x, v);
    covered += fresh.room(at.x) < 1;
  });
  EXPECT_GT(touched, 300);
  EXPECT_GT(on_line, 30);
  EXPECT_GT(covered, 1000);
}

TEST_P(ContactOfSolidsThatStand, ChangesNoNodesButThoseNamed) {
  const Surveyed nodes(ball_and_slab(GetParam()));
  Contacts fresh(nodes.scene, nodes.geometry), kept(nodes.scene, nodes.geometry);
  fresh.prepare(0);
  for (int step = 0; step < 2; ++step) kept.prepare(0), kept.survey(nodes.active);
  const HalfFull around;
  int left_out = 0;
  for (const BlockIndex& block : nodes.active.at) {
    const NodeBits named = kept.nodes_touched(block), of_fresh = fresh.nodes_touched(block);
    left_out += std::popcount(of_fresh & ~named);
    EXPECT_EQ(named & ~of_fresh, 0u);
    for (int n = 0; n < k_block_nodes; ++n) {
      const Point x = Place(nodes.geometry, block, n).x;
      const Vector3 v = Surveyed::velocity(x);
      const bool changes = fresh.velocity_after(x, v, &around) != v || fresh.velocity_after(x, v) != v;
      EXPECT_LE(changes, named >> n & 1) << "node " << n;
    }
  }
  EXPECT_GT(left_out, 500);
}

INSTANTIATE_TEST_SUITE_P(Rules, ContactOfSolidsThatStand, testing::Values(Contact::sticky, Contact::slip, Contact::separating));

TEST(Survey, IsOfThePresentPose) {
  Surveyed nodes(ball_and_slab(Contact::sticky));
  for (Collider& c : nodes.scene.colliders) c.motion = {{.time_s = 1}, {.time_s = 2, .position_m = {0.5 * k_fine_dx, 0, 0}}};
  Contacts kept(nodes.scene, nodes.geometry);
  std::vector<std::size_t> bytes;
  const HalfFull around;
  for (const double time : {0.0, 0.5, 1.5, 1.8, 2.5, 3.0}) {
    kept.prepare(time);
    kept.survey(nodes.active);
    bytes.push_back(kept.bytes());
    Contacts fresh(nodes.scene, nodes.geometry);
    fresh.prepare(time);
    nodes.for_each_node([&](const Place& at, const Vector3& v) {
      EXPECT_EQ(kept.velocity_after(at, v, &around), fresh.velocity_after(at.x, v, &around)) << "at " << time << " s";
    });
  }
  EXPECT_EQ(bytes[0], 0u);
  EXPECT_GT(bytes[1], 0u) << "it has not moved yet";
  EXPECT_LT(bytes[3], bytes[1]) << "it moves";
  EXPECT_GT(bytes[5], bytes[3]) << "it stands again";
}

}  // namespace
}  // namespace bake
