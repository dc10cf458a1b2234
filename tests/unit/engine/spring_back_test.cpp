// SPDX-License-Identifier: MIT
#include "solver/engine/spring_back.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <vector>

#include "solver/engine/engine.h"
#include "solver/scene/scene_builder.h"
#include "tests/unit/engine/kernel_cases.h"

namespace bake {
namespace {

constexpr double k_spring_dx = 0.1, k_K = 2e4 / (3 * (1 - 2 * 0.4)), k_rho = 500;
using Places = std::vector<Point>;

/// Particles of 1/8 cell at any places [dx], the origin in the middle of the domain; as the engine finds them and as a matrix has them. All
/// frequencies are over those of K / (rho dx^2).
template <class C>
class SpringingBack : public testing::Test {
 public:
  using Real = typename C::Real;
  static constexpr double k_alone = 3 * Kernel<C::order>::inverse_d, k_V = 1. / 8;

  double found(const Places& places) const {
    SceneBuilder builder;
    builder.effects = "motion, elasticity";
    builder.dx = k_spring_dx;
    builder.precision = sizeof(Real) == 4 ? "single" : "double";
    builder.kernel = C::order == KernelOrder::quadratic ? "quadratic" : "cubic";
    builder.shape = "sphere = { radius_m = 0.1 }";
    builder.material = "density_kg_per_m3 = 500\nyoung_modulus_Pa = 2e4\npoisson_ratio = 0.4\n";
    const Scene scene = builder.scene();
    Engine<Real> engine(scene);
    std::vector<NewParticle> particles;
    for (const Point& x : places)
      particles.push_back({k_spring_dx * x, k_V * k_spring_dx * k_spring_dx * k_spring_dx, 0, {}, {}, &scene.bodies[0]});
    engine.add(particles);
    std::vector<BlockColumns> one_by_one;
    for (std::int32_t b = 0; b < static_cast<std::int32_t>(engine.store().blocks.size()); ++b) one_by_one.push_back({{b, b + 1}});
    return spring_back(C::order, engine.store(), engine.physics(), k_spring_dx, one_by_one, engine.active_nodes() / k_block_nodes) /
           (k_K / (k_rho * k_spring_dx * k_spring_dx));
  }

  /// The largest eigenvalue of sum_p V_0 K (D^-1 w r)(D^-1 w r)^T on nodes of mass sum w m, by power iteration on the particles.
  static double eigenvalue(const Places& places) {
    struct Entry {
      int node;
      double w;
      Vector3 r;
    };
    std::map<std::array<int, 3>, int> numbers;
    std::vector<std::vector<Entry>> nodes_of;
    std::vector<double> phi;
    for (const Point& place : places) {
      Lanes<double> x[3];
      int corner[3];
      for (std::size_t d = 0; d < 3; ++d) {
        corner[d] = static_cast<int>(std::floor(place[d]));
        x[d] = lanes<double>(place[d] - corner[d]);
      }
      const Stencil<double, C::order> s(x);
      constexpr int N = Kernel<C::order>::support;
      auto& nodes = nodes_of.emplace_back();
      for (int j = 0; j < N * N * N; ++j) {
        const int o[3] = {j / (N * N), j / N % N, j % N};
        std::array<int, 3> at;
        double w = 1;
        Vector3 r;
        for (std::size_t d = 0; d < 3; ++d) {
          at[d] = corner[d] + static_cast<int>(s.base[d][0]) + o[d];
          w *= s.weight[d][o[d]][0];
          r[d] = at[d] - place[d];
        }
        const auto [entry, is_new] = numbers.try_emplace(at, static_cast<int>(numbers.size()));
        if (is_new) phi.push_back(0);
        phi[static_cast<std::size_t>(entry->second)] += k_V * w;
        nodes.push_back({entry->second, w, r});
      }
    }
    std::mt19937 random(3);
    std::vector<double> strain(places.size());
    for (double& e : strain) e = std::uniform_real_distribution<double>(0.5, 1)(random);
    double largest = 0;
    for (int i = 0; i < 300; ++i) {
      std::vector<Vector3> a(phi.size(), Vector3{0, 0, 0});
      for (std::size_t p = 0; p < places.size(); ++p)
        for (const Entry& n : nodes_of[p])
          a[static_cast<std::size_t>(n.node)] =
              a[static_cast<std::size_t>(n.node)] + (k_V * strain[p] * Kernel<C::order>::inverse_d * n.w) * n.r;
      double before = 0, after = 0;
      for (std::size_t p = 0; p < places.size(); ++p) {
        before += strain[p] * strain[p];
        strain[p] = 0;
        for (const Entry& n : nodes_of[p])
          strain[p] +=
              Kernel<C::order>::inverse_d * n.w / phi[static_cast<std::size_t>(n.node)] * dot(n.r, a[static_cast<std::size_t>(n.node)]);
        after += strain[p] * strain[p];
      }
      largest = std::sqrt(after / before);
      for (double& e : strain) e /= std::sqrt(after);
    }
    return largest;
  }

  /// Points of a lattice of eight a cell, a little beside their places, in a box about the origin [dx].
  static Places box(const Vector3& sides) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> beside(-0.2, 0.2);
    Places places;
    for (double x = -sides[0] / 2 + 0.25; x < sides[0] / 2; x += 0.5)
      for (double y = -sides[1] / 2 + 0.25; y < sides[1] / 2; y += 0.5)
        for (double z = -sides[2] / 2 + 0.25; z < sides[2] / 2; z += 0.5)
          places.push_back({x + 0.13 + beside(random), y + 0.31 + beside(random), z - 0.22 + beside(random)});
    return places;
  }
};

TYPED_TEST_SUITE(SpringingBack, KernelCases);

TYPED_TEST(SpringingBack, IsThatOfAParticleAloneWhereverItIs) {
  const double bound = 256 * static_cast<double>(std::numeric_limits<typename TestFixture::Real>::epsilon());
  for (const Point& x : Places{{0, 0, 0}, {0.5, 0.5, 0.5}, {-1.3, 2.24, 0.49}, {3.9, -4.1, 1.7}}) {
    EXPECT_NEAR(this->found({x}), TestFixture::k_alone, bound * TestFixture::k_alone);
    EXPECT_NEAR(this->found({x, x, x}), TestFixture::k_alone, bound * TestFixture::k_alone) << "as are those in the same place";
    EXPECT_NEAR(this->found({x, {x[0] + 5, x[1], x[2]}}), TestFixture::k_alone, bound * TestFixture::k_alone) << "or out of reach";
  }
}

TYPED_TEST(SpringingBack, IsSlowerInsideOfDough) {
  EXPECT_LT(this->found(this->box({6, 6, 6})), 0.7 * TestFixture::k_alone);
  EXPECT_LT(this->found(this->box({8, 8, 2})), 0.75 * TestFixture::k_alone);
}

/// Where crumbs or threads make it larger than inside of dough, as the step's limit takes it: 1.05 times, of which 0.9^2 is used.
TYPED_TEST(SpringingBack, BoundsTheLargestEigenvalue) {
  std::vector<std::pair<const char*, Places>> cases{{"cube", this->box({5, 5, 5})},
                                                    {"small cube", this->box({1.5, 1.5, 1.5})},
                                                    {"thread", this->box({6, 1, 1})},
                                                    {"sheet", this->box({5, 5, 1})}};
  for (const double gap : {0.5, 1., 1.5, 2., 2.4}) {
    Places beside = this->box({4, 4, 4});
    beside.push_back({2.13 + gap, 0.31, -0.22});
    cases.push_back({"one particle beside a cube", beside});
    for (const Point& x : Places{{0.2, 0.3, 0}, {-0.1, 0.1, 0.2}, {0.1, -0.3, 0.1}, {0, 0, -0.2}})
      beside.push_back({2.13 + gap + x[0], 0.31 + x[1], -0.22 + x[2]});
    cases.push_back({"a crumb of five beside a cube", beside});
  }
  const double inside = TestFixture::k_alone * (5.9 + 3.4 / 8) / 12;  // as Motion::bounds has it
  for (const auto& [name, places] : cases) {
    const double largest = this->eigenvalue(places), found = this->found(places);
    EXPECT_LT(0.81 * largest, std::max(1.05 * found, inside)) << name << ": " << found << " of " << largest;
    EXPECT_LT(found, std::max(1.4 * largest, inside)) << name << ": " << found << " of " << largest;
  }
}

}  // namespace
}  // namespace bake
