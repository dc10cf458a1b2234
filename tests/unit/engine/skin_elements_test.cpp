// SPDX-License-Identifier: MIT
// The elements of a skin: forces are gradients of energies, and energies are those of theory.
#include "solver/effects/skin_elements.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "solver/boundary/surface_mesh.h"
#include "solver/core/vector3.h"

namespace bake {
namespace {

using V = Lanes<double>;

void fill_lanes(const Vector3& x, V (&out)[3]) {
  for (std::size_t d = 0; d < 3; ++d) out[d] = lanes<double>(x[d]);
}

/// A pack of W equal elements; the results of its last lane.
struct Result {
  double energy;
  std::vector<Vector3> forces;  ///< on all corners
};

struct MembraneConstants {
  double inverse[4] = {1, -0.3, 0, 1.2};
  double mu = 2, lambda = 3;
};

Result pull(const std::vector<Vector3>& x, const MembraneConstants& k = {}) {
  V a[3], b[3], inverse[4], force_1[3], force_2[3];
  fill_lanes(x[1] - x[0], a);
  fill_lanes(x[2] - x[0], b);
  for (int i = 0; i < 4; ++i) inverse[i] = lanes<double>(k.inverse[i]);
  const V energy = membrane(a, b, inverse, lanes<double>(k.mu), lanes<double>(k.lambda), force_1, force_2);
  constexpr int l = k_width<double> - 1;
  const Vector3 f1{force_1[0][l], force_1[1][l], force_1[2][l]}, f2{force_2[0][l], force_2[1][l], force_2[2][l]};
  return {energy[l], {-(f1 + f2), f1, f2}};
}

/// x: both ends of the edge, then both tips.
Result bend(const std::vector<Vector3>& x, double stiffness = 1.7, double rest = 0.2, double edge_2 = 1) {
  V e[3], a[3], b[3], f[3][3];
  fill_lanes(x[1] - x[0], e);
  fill_lanes(x[2] - x[0], a);
  fill_lanes(x[3] - x[0], b);
  const V energy = hinge(e, a, b, lanes<double>(stiffness), lanes<double>(rest), lanes<double>(edge_2), f[0], f[1], f[2]);
  constexpr int l = k_width<double> - 1;
  Result result{energy[l], {{0, 0, 0}}};
  for (auto& force : f) {
    result.forces.push_back({force[0][l], force[1][l], force[2][l]});
    result.forces[0] = result.forces[0] - result.forces.back();
  }
  return result;
}

/// The largest difference between forces and differences of the energy, relative to the largest force.
double error_of_forces(const std::function<Result(const std::vector<Vector3>&)>& element, std::vector<Vector3> x) {
  const Result at = element(x);
  double worst = 0, largest = 0;
  for (std::size_t v = 0; v < x.size(); ++v)
    for (std::size_t d = 0; d < 3; ++d) {
      constexpr double h = 3e-4;
      const auto energy = [&](double step) {
        std::vector<Vector3> moved = x;
        moved[v][d] += step;
        return element(moved).energy;
      };
      const double slope = (8 * (energy(h) - energy(-h)) - (energy(2 * h) - energy(-2 * h))) / (12 * h);
      worst = std::max(worst, std::abs(slope + at.forces[v][d]));
      largest = std::max(largest, std::abs(at.forces[v][d]));
    }
  return worst / largest;
}

std::vector<Vector3> shaken(std::vector<Vector3> x, unsigned seed, double by) {
  std::mt19937 bits(seed);
  std::uniform_real_distribution<double> draw(-by, by);
  for (Vector3& p : x)
    for (double& c : p) c += draw(bits);
  return x;
}

const std::vector<Vector3> k_triangle{{0, 0, 0}, {1, 0, 0}, {0.3, 0.8, 0}};
const std::vector<Vector3> k_hinge{{0, 0, 0}, {1, 0, 0}, {0.4, 0.9, 0.1}, {0.5, -0.8, -0.1}};

TEST(MembraneOfASkin, HasForcesThatAreTheGradientsOfItsEnergy) {
  for (unsigned seed = 1; seed < 20; ++seed)
    EXPECT_LE(error_of_forces([](const auto& x) { return pull(x); }, shaken(k_triangle, seed, 0.2)), 1e-9) << seed;
}

TEST(HingeOfASkin, HasForcesThatAreTheGradientsOfItsEnergy) {
  for (unsigned seed = 1; seed < 20; ++seed)
    EXPECT_LE(error_of_forces([](const auto& x) { return bend(x); }, shaken(k_hinge, seed, 0.25)), 1e-9) << seed;
}

/// Far beyond a right angle, where a tangent or a sine of the angle would not do.
TEST(HingeOfASkin, KnowsAnglesUpToAFold) {
  for (const double theta : {-3.0, -1.6, -0.4, 0.0, 1e-5, 0.7, 2.0, 3.1}) {
    const std::vector<Vector3> x{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -std::cos(theta), std::sin(theta)}};
    const double bent = std::sqrt(2 * bend(x, 1, 0).energy);
    EXPECT_NEAR(bent, std::abs(theta), 1e-12 * std::max(1., std::abs(theta)));
  }
}

TEST(ElementsOfASkin, FeelNoRigidMotion) {
  const double c = std::cos(1.1), s = std::sin(1.1);
  const auto moved = [&](std::vector<Vector3> x) {
    for (Vector3& p : x) p = Vector3{c * p[0] - s * p[2], p[1], s * p[0] + c * p[2]} + Vector3{3, -2, 5};
    return x;
  };
  MembraneConstants rest;  // D_m = [1 0.3; 0 0.8]
  rest.inverse[1] = -0.3 / 0.8, rest.inverse[3] = 1 / 0.8;
  const Result membrane_at_rest = pull(moved(k_triangle), rest);
  EXPECT_NEAR(membrane_at_rest.energy, 0, 1e-14);
  for (const Vector3& f : membrane_at_rest.forces) EXPECT_LE(length(f), 1e-14);

  const double theta = std::sqrt(2 * bend(k_hinge, 1, 0).energy);
  const bool same_sign = bend(k_hinge, 1, theta).energy < 1e-20;
  const Result hinge_at_rest = bend(moved(k_hinge), 1, same_sign ? theta : -theta);
  EXPECT_NEAR(hinge_at_rest.energy, 0, 1e-14);
  for (const Vector3& f : hinge_at_rest.forces) EXPECT_LE(length(f), 1e-14);
}

/// C is diag(a^2, b^2) wherever the triangle lies.
TEST(MembraneOfASkin, HasTheEnergyOfEvenAndUnevenStretch) {
  const double c = std::cos(0.6), s = std::sin(0.6);
  MembraneConstants k;
  k.inverse[0] = 1, k.inverse[1] = -0.3 / 0.8, k.inverse[2] = 0, k.inverse[3] = 1 / 0.8;
  for (const auto& [a, b] : {std::pair(1.3, 1.3), std::pair(1.2, 0.7), std::pair(0.5, 0.5), std::pair(2.0, 1.0)}) {
    std::vector<Vector3> x = k_triangle;
    for (Vector3& p : x) p = {c * a * p[0], b * p[1], s * a * p[0]};
    const double ln = 2 * std::log(a * b);
    EXPECT_NEAR(pull(x, k).energy, k.mu / 2 * (a * a + b * b - 2 - ln) + k.lambda / 8 * ln * ln, 1e-13);
  }
  // small strains: Hooke's law, E h / (2 (1 - nu^2)) (e^2 + g^2 + 2 nu e g) with 2 mu + lambda = E h / (1 - nu^2), lambda = nu E h / (1 -
  // nu^2)
  const double e = 2e-5, g = -1e-5, stiff = 2 * k.mu + k.lambda, nu = k.lambda / stiff;
  std::vector<Vector3> x = k_triangle;
  for (Vector3& p : x) p = {(1 + e) * p[0], (1 + g) * p[1], 0};
  EXPECT_NEAR(pull(x, k).energy / (stiff / 2 * (e * e + g * g + 2 * nu * e * g)), 1, 1e-4);
}

/// A sheet of n x n edges, right-angled or equilateral, with rows along the direction that is bent or across it.
SurfaceMesh sheet(int n, bool equilateral, bool across) {
  const double edge = 1. / n, row = equilateral ? edge * std::sqrt(0.75) : edge;
  SurfaceMesh mesh;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double along = (i + (equilateral ? (j & 1) * 0.5 : 0)) * edge;
      mesh.points.push_back(across ? Point{j * row, along, 0} : Point{along, j * row, 0});
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      std::int32_t a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      std::vector<SurfaceTriangle> two =
          equilateral && (j & 1) ? std::vector<SurfaceTriangle>{{a, b, d}, {a, d, c}} : std::vector<SurfaceTriangle>{{a, b, c}, {b, d, c}};
      for (SurfaceTriangle t : two) {
        if (across) std::swap(t[1], t[2]);
        mesh.triangles.push_back(t);
      }
    }
  return mesh;
}

/// Energy over B / (2 R^2) times the area of a sheet that is rolled to a cylinder. Hinges are missing at its rim.
double rolled(int n, bool equilateral, bool across) {
  SurfaceMesh mesh = sheet(n, equilateral, across);
  constexpr double R = 2;
  double area = 0, energy = 0;
  for (const SurfaceTriangle& t : mesh.triangles) area += area_of(mesh, t);
  const auto flat = mesh.points;
  for (Point& x : mesh.points) x = {R * std::sin(x[0] / R), x[1], R * std::cos(x[0] / R)};
  for (const SurfaceHinge& h : hinges_of(mesh.triangles)) {
    const auto at = [&](const std::vector<Point>& points, std::int32_t v) { return points[static_cast<std::size_t>(v)]; };
    const Vector3 e = at(flat, h.edge[1]) - at(flat, h.edge[0]);
    const double edge_2 = dot(e, e), areas = (length(cross(e, at(flat, h.tips[0]) - at(flat, h.edge[0]))) +
                                              length(cross(e, at(flat, h.tips[1]) - at(flat, h.edge[0])))) /
                                             2;
    energy += bend({at(mesh.points, h.edge[0]), at(mesh.points, h.edge[1]), at(mesh.points, h.tips[0]), at(mesh.points, h.tips[1])},
                   edge_2 / areas, 0, edge_2)
                  .energy;
  }
  return energy / (area / (2 * R * R));
}

TEST(HingesOfASkin, HaveTheEnergyOfARolledPlate) {
  for (const bool equilateral : {false, true})
    for (const bool across : {false, true}) {
      const double coarse = rolled(32, equilateral, across), fine = rolled(64, equilateral, across);
      EXPECT_NEAR(fine, 1, 0.02) << equilateral << across;
      EXPECT_NEAR(2 * fine - coarse, 1, 0.002) << "what is missing is the rim's, and goes with 1/n";
    }
}

template <class Real>
void expect_finite(const std::vector<Vector3>& x, const char* what) {
  using L = Lanes<Real>;
  L d[3][3], f[3][3], inverse[4] = {lanes<Real>(1), lanes<Real>(-0.3), lanes<Real>(0), lanes<Real>(1.2)};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i) d[k][i] = lanes<Real>(static_cast<Real>(x[std::min(k + 1, x.size() - 1)][i] - x[0][i]));
  const L energy = x.size() == 3 ? membrane(d[0], d[1], inverse, lanes<Real>(2), lanes<Real>(3), f[0], f[1])
                                 : hinge(d[0], d[1], d[2], lanes<Real>(2), lanes<Real>(0.1), lanes<Real>(1), f[0], f[1], f[2]);
  EXPECT_TRUE(std::isfinite(energy[0])) << what;
  for (std::size_t k = 0; k + 1 < x.size(); ++k)
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(std::isfinite(f[k][i][0])) << what << " corner " << k + 1;
}

TEST(ElementsOfASkin, StayFiniteWhenCollapsed) {
  for (const auto& [what, x] : std::vector<std::pair<const char*, std::vector<Vector3>>>{
           {"a point", {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}},
           {"a line", {{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}}},
           {"nearly a line", {{0, 0, 0}, {1, 0, 0}, {0.5, 1e-9, 0}}},
           {"a hinge that is a point", {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}},
           {"a hinge that is a line", {{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}, {0.2, 0, 0}}},
           {"a hinge without an edge", {{0, 0, 0}, {0, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}}},
           {"a fold", {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 1, 0}}},
       }) {
    expect_finite<float>(x, what);
    expect_finite<double>(x, what);
  }
}

TEST(Atan, IsExactToAFewUnitsInTheLastPlace) {
  const auto check = [](auto real, double units) {
    using Real = decltype(real);
    for (double x = 1e-12; x < 1e12; x *= 1.37)
      for (const double sign : {-1., 1.}) {
        const auto a = static_cast<Real>(sign * x);
        const auto angle = static_cast<double>(atan(lanes<Real>(a))[0]), exact = std::atan(static_cast<double>(a));
        EXPECT_LE(std::abs(angle - exact), units * static_cast<double>(std::numeric_limits<Real>::epsilon()) * std::abs(exact)) << x;
      }
    EXPECT_EQ(atan(lanes<Real>(0))[0], Real(0));
    EXPECT_NEAR(static_cast<double>(atan(lanes<Real>(std::numeric_limits<Real>::infinity()))[0]), std::acos(0.), 1e-6);
  };
  check(float(), 4);
  check(double(), 4);
}

}  // namespace
}  // namespace bake
