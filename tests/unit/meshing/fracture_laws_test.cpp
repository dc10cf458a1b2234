// SPDX-License-Identifier: MIT
// What holds for every set of broken edges of every mesh.
#include <algorithm>
#include <numeric>
#include <queue>
#include <set>

#include "meshing/fracture/breaking.h"
#include "meshing/fracture/census.h"
#include "meshing/fracture/depth.h"
#include "meshing/fracture/positions.h"
#include "meshing/tets/lattice_mesher.h"
#include "solver/core/vector3.h"
#include "tests/unit/laws/law.h"
#include "tests/unit/meshing/solids.h"

namespace bake {
namespace {

using Broken = std::vector<std::int32_t>;

/// Some 60 random points: a mesh with tetrahedra of all forms.
Topology random_mesh() {
  std::vector<Point> points;
  const int count = *rc::gen::inRange(8, 60).as("points");
  for (int i = 0; i < count; ++i) points.push_back({between(0, 1, "x"), between(0, 1, "y"), between(0, 1, "z")});
  TetMesh mesh = delaunay_mesh(std::move(points));
  RC_PRE(!mesh.tets.empty());
  return make_topology(std::move(mesh));
}

/// Each edge broken or whole with some probability, or all that a plane crosses, or those of a half plane.
Broken random_break(const Topology& topology) {
  const int kind = *rc::gen::inRange(0, 3).as("kind of break");
  const double share = between(0, 1, "share broken");
  Broken broken(topology.edges.size(), -1);
  for (std::size_t e = 0; e < broken.size(); ++e) {
    const Point a = topology.mesh.points[topology.edges[e][0]], b = topology.mesh.points[topology.edges[e][1]];
    const bool crossed = (a[0] - share) * (b[0] - share) < 0;
    const bool is_broken = kind == 0 ? between(0, 1, "of edge") < share : kind == 1 ? crossed : crossed && a[1] + b[1] < 1;
    if (is_broken) broken[e] = 0;
  }
  return broken;
}

/// Number of pieces by walking along whole edges: no union-find.
std::size_t count_pieces(const Topology& topology, const Broken& broken) {
  std::vector<std::vector<std::int32_t>> next(topology.mesh.points.size());
  for (std::size_t e = 0; e < broken.size(); ++e) {
    if (broken[e] >= 0) continue;
    next[topology.edges[e][0]].push_back(topology.edges[e][1]);
    next[topology.edges[e][1]].push_back(topology.edges[e][0]);
  }
  std::vector<char> seen(next.size(), 0);
  std::size_t count = 0;
  for (std::size_t v = 0; v < next.size(); ++v) {
    if (seen[v]) continue;
    ++count;
    std::queue<std::size_t> todo({v});
    for (seen[v] = 1; !todo.empty(); todo.pop())
      for (const std::int32_t w : next[todo.front()])
        if (!seen[w]) seen[w] = 1, todo.push(w);
  }
  return count;
}

double total_volume(const std::vector<Piece>& pieces) {
  return std::accumulate(pieces.begin(), pieces.end(), 0.0, [](double sum, const Piece& piece) { return sum + piece.volume_m3; });
}

TEST(FractureLaw, EveryPieceIsClosedAndTheVolumeIsKept) {
  const bool holds = rc::check([] {
    const Topology topology = random_mesh();
    const Broken broken = random_break(topology);
    const CutSurface surface = cut(topology, broken);
    const int passes = *rc::gen::inRange(0, 10).as("passes of smoothing");
    const MaterialShape shape = material_shape(topology, surface, passes);
    const std::vector<Piece> found = take_census(surface, pieces(topology, broken), shape.points);
    RC_ASSERT(std::all_of(found.begin(), found.end(), [](const Piece& piece) { return piece.closed; }));
    expect_near(total_volume(found), volume(topology.mesh), 1e-12);
    if (passes == 0) {  // each piece has the volumes of its vertices
      const std::vector<double> volumes = vertex_volumes(topology.mesh);
      std::vector<double> expected(found.size(), 0);
      const auto piece_of = pieces(topology, broken);
      for (std::size_t v = 0; v < volumes.size(); ++v) expected[piece_of[v]] += volumes[v];
      for (std::size_t p = 0; p < found.size(); ++p) expect_near(found[p].volume_m3, expected[p], 1e-12);
    }
  });
  EXPECT_TRUE(holds);
}

TEST(FractureLaw, NodesStayInsideTheRimOfWhatTheyBelongTo) {
  const bool holds = rc::check([] {
    const Topology topology = random_mesh();
    const CutSurface surface = cut(topology, random_break(topology));
    const MaterialShape shape = material_shape(topology, surface, 10);
    for (std::size_t n = 0; n < surface.nodes.size(); ++n) {
      const int size = surface.nodes[n].size();
      const double least = size == 1 ? 1 : size == 2 ? 0.2 : 0.1;
      for (int i = 0; i < size; ++i) RC_ASSERT(shape.shares[n][i] >= least - 1e-9);
      expect_near(std::accumulate(shape.shares[n].begin(), shape.shares[n].end(), 0.0), 1, 1e-12);
    }
  });
  EXPECT_TRUE(holds);
}

TEST(FractureLaw, PiecesAreCountedRightAndSorted) {
  const bool holds = rc::check([] {
    const Topology topology = random_mesh();
    const Broken broken = random_break(topology);
    const std::vector<Piece> found = take_census(cut(topology, broken), pieces(topology, broken), topology.mesh.points);
    RC_ASSERT(found.size() == count_pieces(topology, broken));
    RC_ASSERT(std::is_sorted(found.begin(), found.end(), [](const Piece& a, const Piece& b) { return a.vertices > b.vertices; }));
  });
  EXPECT_TRUE(holds);
}

TEST(FractureLaw, ARigidMotionMovesTheSurfaceRigidly) {
  const bool holds = rc::check([] {
    const Topology topology = random_mesh();
    const Broken broken = random_break(topology);
    const CutSurface surface = cut(topology, broken);
    const MaterialShape shape = material_shape(topology, surface, 3);
    const auto move = [](const Point& x) { return Point{3 - x[1], x[0] + 1, x[2] - 2}; };  // a quarter turn
    std::vector<Point> moved;
    for (const Point& x : topology.mesh.points) moved.push_back(move(x));
    const std::vector<Point> nodes = node_positions(topology, surface, shape, broken, 100, moved);
    // A particle with one whole edge, or none, does not know how it is turned.
    std::vector<int> whole(topology.mesh.points.size(), 0);
    for (std::size_t e = 0; e < broken.size(); ++e)
      for (const std::int32_t v : topology.edges[e]) whole[v] += broken[e] < 0;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      const CutNode& node = surface.nodes[n];
      bool known = true;
      for (int i = 0; i < node.size(); ++i) known = known && (!node.owns(i) || whole[node.vertices[i]] >= 3 || node.owns_all());
      if (known) RC_ASSERT(length(nodes[n] - move(shape.points[n])) < 1e-3);
    }
  });
  EXPECT_TRUE(holds);
}

TEST(FractureLaw, WhatBreaksLaterOnlyAddsNodes) {
  const bool holds = rc::check([] {
    const Topology topology = random_mesh();
    Broken broken = random_break(topology);
    const auto before = pieces(topology, broken);
    for (std::int32_t& at : broken)
      if (at < 0 && between(0, 1, "of edge") < 0.2) at = 1;
    const auto after = pieces(topology, broken);
    std::set<std::pair<std::int32_t, std::int32_t>> pairs;  // (later piece, earlier piece): pieces only part
    for (std::size_t v = 0; v < before.size(); ++v) pairs.insert({after[v], before[v]});
    RC_ASSERT(pairs.size() == 1u + static_cast<std::size_t>(*std::max_element(after.begin(), after.end())));
  });
  EXPECT_TRUE(holds);
}

TEST(FractureLaw, WithoutAnyCrackAllIsWhole) {
  const bool holds = rc::check([] {
    const Topology topology = random_mesh();
    const Broken broken = random_break(topology);
    const CutSurface surface = cut(topology, broken);
    const auto found = cracks(surface, material_shape(topology, surface, 2).points);
    const CutSurface whole = cut(topology, without_specks(topology, broken, found, k_infinity));
    RC_ASSERT(whole.triangles.size() == whole.skin_triangles);
  });
  EXPECT_TRUE(holds);
}

TEST(Fracture, OfNothingBrokenIsTheBoundaryWithoutCracks) {
  const Topology topology = make_topology(filled(*brick(), 500));
  const Broken whole(topology.edges.size(), -1);
  const CutSurface surface = cut(topology, whole);
  EXPECT_EQ(surface.triangles.size(), topology.boundary.size());
  EXPECT_EQ(surface.skin_triangles, surface.triangles.size());
  EXPECT_TRUE(cracks(surface, material_shape(topology, surface, 8).points).empty());
}

TEST(Fracture, AlongAPlaneMakesOneFlatCrackOfItsArea) {
  const Topology topology = make_topology(filled(*brick({0.5, 0.5, 0.5}), 1500));
  Broken broken(topology.edges.size(), -1);
  for (std::size_t e = 0; e < broken.size(); ++e) {
    const auto& [a, b] = topology.edges[e];
    if (topology.mesh.points[a][0] * topology.mesh.points[b][0] < 0) broken[e] = 0;
  }
  const CutSurface surface = cut(topology, broken);
  const auto smooth = cracks(surface, material_shape(topology, surface, 8).points),
             raw = cracks(surface, material_shape(topology, surface, 0).points);
  ASSERT_EQ(smooth.size(), 1u);
  EXPECT_GT(smooth[0].area_m2, 0.95);  // the cube's cross section,
  EXPECT_LT(smooth[0].area_m2, 1.2);   // a little wavy, since nodes stay within the middle three fifths of their edges
  EXPECT_LT(smooth[0].area_m2, raw[0].area_m2);
  EXPECT_NEAR(smooth[0].centre_m[0], 0, 0.03);
  EXPECT_GT(smooth[0].length_m, 0.95);
  EXPECT_LT(smooth[0].length_m, 1.6);
  EXPECT_LT(smooth[0].high_m[0] - smooth[0].low_m[0], 0.15);
  const auto parts = take_census(surface, pieces(topology, broken), material_shape(topology, surface, 8).points);
  EXPECT_EQ(parts.size(), 2u);
}

TEST(Cracks, AreSortedAndMeasuredAlikeEverywhere) {
  const TetMesh mesh = filled(*brick({0.5, 0.2, 0.1}), 1500);
  const Vector3 away{5, 3, -2};
  TetMesh moved = mesh;
  for (Point& x : moved.points) x = x + away;
  for (const double side : {-0.25, 0.25}) {  // a crack all through on one side, and one of half its size on the other
    const Topology topology = make_topology(mesh);
    Broken broken(topology.edges.size(), -1);
    for (std::size_t e = 0; e < broken.size(); ++e) {
      const Point &a = topology.mesh.points[topology.edges[e][0]], &b = topology.mesh.points[topology.edges[e][1]];
      const bool through = (a[0] - side) * (b[0] - side) < 0, half = (a[0] + side) * (b[0] + side) < 0 && a[1] + b[1] < 0;
      if (through || half) broken[e] = 0;
    }
    const CutSurface surface = cut(topology, broken);
    const auto here = cracks(surface, material_shape(topology, surface, 8).points),
               there = cracks(surface, material_shape(make_topology(moved), surface, 8).points);
    ASSERT_EQ(here.size(), 2u);
    ASSERT_EQ(there.size(), 2u);
    EXPECT_GT(here[0].area_m2, 1.5 * here[1].area_m2);
    EXPECT_NEAR(here[0].centre_m[0], side, 0.03);
    EXPECT_GT(here[0].length_m, 0.38);
    for (int i = 0; i < 2; ++i) {
      EXPECT_NEAR(there[i].area_m2, here[i].area_m2, 1e-9);
      EXPECT_NEAR(there[i].length_m, here[i].length_m, 1e-6);
      EXPECT_LT(length(there[i].centre_m - away - here[i].centre_m), 1e-9);
      EXPECT_LT(length(there[i].low_m - away - here[i].low_m), 1e-9);
      EXPECT_LT(length(there[i].high_m - away - here[i].high_m), 1e-9);
    }
    const Broken resolved = without_specks(topology, broken, here, 0.5 * (here[0].area_m2 + here[1].area_m2));
    const CutSurface less = cut(topology, resolved);
    const auto left = cracks(less, material_shape(topology, less, 8).points);
    ASSERT_EQ(left.size(), 1u) << "the smaller one is closed";
    EXPECT_NEAR(left[0].area_m2, here[0].area_m2, 1e-12) << "and the other as it was";
    EXPECT_EQ(without_specks(topology, broken, here, here[1].area_m2), broken);
  }
}

Topology one_tet() { return make_topology(TetMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}}}); }

TEST(Fracture, CutsATetrahedronBetweenCornersThatNoWholeEdgesConnect) {
  const Topology topology = one_tet();
  for (int mask = 0; mask < 64; ++mask) {
    Broken broken(topology.edges.size());
    for (std::size_t e = 0; e < broken.size(); ++e) broken[e] = (mask >> e & 1) != 0 ? 0 : -1;
    const std::vector<std::int32_t> piece = pieces(topology, broken);
    std::size_t apart = 0;
    for (const auto& [a, b] : topology.edges) apart += piece[a] != piece[b];
    const CutSurface surface = cut(topology, broken);
    EXPECT_EQ(surface.triangles.size() - surface.skin_triangles, 4 * apart) << "broken edges as bits: " << mask;  // two sides of two
  }
}

TEST(Depth, IsTheDistanceFromTheBoundary) {
  const auto depth = depth_in(one_tet());
  EXPECT_NEAR(depth({0.1, 0.2, 0.25}), 0.1, 1e-12);
  EXPECT_NEAR(depth({0.25, 0.25, 0.25}), 0.25 / std::sqrt(3), 1e-12);
}

/// Vertex 3 has parted from the others: its edges to the vertices 0, 1, 2 broke in these frames.
Broken parted(const Topology& topology, const std::array<std::int32_t, 3>& frames) {
  Broken broken(topology.edges.size(), -1);
  for (std::size_t e = 0; e < broken.size(); ++e)
    if (topology.edges[e][1] == 3) broken[e] = frames[topology.edges[e][0]];
  return broken;
}

/// Calls it with each node of a crack on the side of the vertices 0, 1 and 2 and the last frame in which an edge of theirs broke.
void for_nodes_of_the_triangle(const CutSurface& surface, const Broken& broken, const Topology& topology,
                               const std::function<void(std::size_t, int)>& visit) {
  for (std::size_t n = 0; n < surface.nodes.size(); ++n) {
    const CutNode& node = surface.nodes[n];
    int last = -1;
    bool is_on_side = !node.owns_all();
    for (int i = 0; i < node.size(); ++i) {
      if (!node.owns(i)) continue;
      is_on_side = is_on_side && node.vertices[i] != 3;
      for (std::size_t e = 0; e < broken.size(); ++e)
        if (topology.edges[e] == std::array<std::int32_t, 2>{node.vertices[i], 3}) last = std::max(last, broken[e]);
    }
    if (is_on_side) visit(n, last);
  }
}

TEST(NodePositions, AreTurnedByEdgesOfOnePlaneAlready) {
  const Topology topology = one_tet();
  const Broken broken = parted(topology, {0, 0, 0});
  const CutSurface surface = cut(topology, broken);
  const MaterialShape shape = material_shape(topology, surface, 0);
  const auto turned = [](const Point& x) { return Point{x[0], -x[1], -x[2]}; };  // half a turn, no mirror image
  std::vector<Point> positions;
  for (const Point& x : topology.mesh.points) positions.push_back(turned(x));
  const std::vector<Point> nodes = node_positions(topology, surface, shape, broken, 100, positions);
  int count = 0;
  for_nodes_of_the_triangle(surface, broken, topology, [&](std::size_t n, int) {
    ++count;
    EXPECT_LT(length(nodes[n] - turned(shape.points[n])), 1e-4);
  });
  EXPECT_EQ(count, 7);  // of three edges, three faces and the tetrahedron
}

TEST(NodePositions, PartOverFourFramesAfterTheLastEdgeBroke) {
  const Topology topology = one_tet();
  const Broken broken = parted(topology, {10, 12, 11});
  const CutSurface surface = cut(topology, broken);
  const MaterialShape shape = material_shape(topology, surface, 0);
  std::vector<Point> positions = topology.mesh.points;
  positions[3][2] += 4;
  for (const int frame : {10, 11, 12, 13, 15, 16, 30}) {
    const std::vector<Point> nodes = node_positions(topology, surface, shape, broken, frame, positions);
    for_nodes_of_the_triangle(surface, broken, topology, [&](std::size_t n, int last) {
      const double share_of_3 = shape.shares[n][surface.nodes[n].size() - 1], open = std::clamp((frame - last) / 4.0, 0.0, 1.0);
      const Point expected = shape.points[n] + Point{0, 0, (1 - open) * 4 * share_of_3};
      EXPECT_LT(length(nodes[n] - expected), 1e-4) << "frame " << frame << ", broken at " << last;
    });
  }
}

TEST(Breaking, NeedsBothBoundsInTwoFramesAndNeverHeals) {
  const Topology topology = one_tet();
  const auto moved = [&](double x) {
    std::vector<Point> points = topology.mesh.points;
    points[1][0] = x;
    return points;
  };
  const auto broken = [&](const BreakingRule& rule, std::initializer_list<double> history) {
    Breaking breaking(topology, topology.mesh.points, rule);
    int frame = 0;
    for (const double x : history) breaking.advance(frame++, moved(x));
    return breaking.broken_at()[0];
  };
  EXPECT_EQ(broken({2, 0}, {1, 2.1, 2.2, 2.3}), 2);
  EXPECT_EQ(broken({2, 0}, {1, 2.1, 1.9, 2.1}), -1) << "one frame is not enough";
  EXPECT_EQ(broken({2, 0}, {2.1, 2.1, 1, 1}), 1) << "closed again is still broken";
  EXPECT_EQ(broken({2, 3}, {1, 2.5, 2.5}), -1) << "the gap is too small";
  EXPECT_EQ(broken({2, 3}, {1, 3.5, 3.5}), 2);
  EXPECT_EQ(broken({4, 3}, {1, 3.5, 3.5}), -1) << "the stretch is too small";
}

TEST(Breaking, WantsAVoidThatDoughHasNotFilledIfAskedTo) {
  const Topology topology = one_tet();
  const auto broken = [&](const Vector3& stretch, double shear, double growth) {
    std::vector<Point> points = topology.mesh.points;
    for (Point& x : points) x = {stretch[0] * x[0] + shear * x[1], stretch[1] * x[1], stretch[2] * x[2]};
    Breaking breaking(topology, topology.mesh.points, {2, 0, 1.5});
    for (int frame = 0; frame < 2; ++frame) breaking.advance(frame, points, std::vector<double>(4, growth));
    return std::count_if(breaking.broken_at().begin(), breaking.broken_at().end(), [](std::int32_t at) { return at >= 0; });
  };
  EXPECT_EQ(broken({3, 1, 1}, 0, 1), 3) << "all edges of the corner that went away";
  EXPECT_EQ(broken({3, 1, 1}, 0, 3), 0) << "rose along one axis only";
  EXPECT_EQ(broken({3, 1, 1}, 0, 2.1), 0);
  EXPECT_EQ(broken({3, 1, 1}, 0, 1.9), 3);
  EXPECT_EQ(broken({1, 1, 1}, 4, 1), 0) << "sheared";
}

}  // namespace
}  // namespace bake
