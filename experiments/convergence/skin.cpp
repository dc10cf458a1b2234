// SPDX-License-Identifier: MIT
// A skin on deep soft ground, in plane strain, both compressed along x by the logarithmic strain e; see film.cpp. A skin has no thickness
// but stiffnesses, N = E_f h / (1 - nu_f^2) against stretching and B against bending, and holds the ground, of which G = 4 mu (1 - nu) / (3
// - 4 nu) is left to it. So the stiffness S = B k^4 + G k - N k^2 e against a load f cos(k x) vanishes at
//     e_c(k) = (B k^2 + G / k) / N,
// which is least, 3 B k^2 / N, at the wavelength 2 pi (2 B / G)^(1/3).
//
// Of the solver S is asked as there: the load is put on the nodes at the surface, all motion is damped, and w read off the vertices when it
// is at rest. How large the load is does not matter: where S would be zero follows from the ratio of two. Both are of pressed ground:
// S falls 3 % faster near the onset than without strain.
#include "experiments/convergence/cases.h"
#include "experiments/convergence/film.h"
#include "solver/io/mesh_file.h"
#include "solver/io/scratch_folder.h"

namespace bake::studies {

namespace film {

namespace {

using std::numbers::pi;

constexpr double k_wavelength = 14, k_onset = 0.02;  // of theory
constexpr double k_piece = 189;                      // compressed; so long that its ends matter little
// In its length; the onset has 27. Odd waves alone: what is compressed rises a little in its middle, to which even ones belong.
constexpr Waves k_halves{23, 27, 31};
constexpr double k_ground_nu = 0.4, k_skin_nu = 0.3;
constexpr double k_mu = 1 / (2 * (1 + k_ground_nu)), k_G = 4 * k_mu * (1 - k_ground_nu) / (3 - 4 * k_ground_nu);

Waves numbers() {
  Waves k;
  for (std::size_t i = 0; i < k.size(); ++i) k[i] = pi * k_halves[i] / k_piece;
  return k;
}

constexpr int k_flap = 2, k_across = 2;  // edges

/// A strip of triangles in the ground, with edges of half a cell. At its ends it is bent down along the walls: these keep a flap upright,
/// and so the strip level, as if it went on behind them as in a mirror.
void write_strip(const std::filesystem::path& path, double length, double width, double dx) {
  constexpr double k_depth = 0.4;
  const int n = static_cast<int>(std::lround(2 * length / dx)), m = k_across;
  Mesh mesh;
  const auto add_row = [&](double x, double down) {
    for (int j = 0; j <= m; ++j) mesh.points.insert(mesh.points.end(), {x, width * j / m, -(k_depth + down) * dx});
  };
  for (int i = k_flap; i > 0; --i) add_row(0, i / 2.);
  for (int i = 0; i <= n; ++i) add_row(length * i / n, 0);
  for (int i = 1; i <= k_flap; ++i) add_row(length, i / 2.);
  for (std::int64_t i = 0; i < n + 2 * k_flap; ++i)
    for (std::int64_t j = 0; j < m; ++j) {
      const std::int64_t a = i * (m + 1) + j, b = a + m + 1;
      if ((i + j) % 2 == 0)
        mesh.cells.insert(mesh.cells.end(), {a, b, b + 1, a, b + 1, a + 1});
      else
        mesh.cells.insert(mesh.cells.end(), {a, b, a + 1, b, b + 1, a + 1});
    }
  write_mesh(path, mesh);
}

/// How far the skin yields to waves of load of one sign or the other; `cells` in a wavelength.
Waves yields(double cells, double e, double sign) {
  const double dx = k_wavelength / cells, length = k_piece * std::exp(e), depth = std::ceil(12 / dx) * dx;
  const double k = 2 * pi / k_wavelength, B = k_G / (2 * k * k * k), N = 3 * B * k * k / k_onset;
  const double h = std::sqrt(12 * B / N), E_f = N * (1 - k_skin_nu * k_skin_nu) / h;
  const ScratchFolder folder;
  write_strip(folder / "strip.hdf", length, dx, dx);
  StudyScene setting("motion, elasticity");
  setting.frame_s = k_pressed;
  setting.dx = dx;
  setting.low = {-3 * dx, 0, -depth - 3 * dx};
  setting.high = {length + 4 * dx, dx, 4 * dx};
  setting.faces = "y_min = \"slip\"\ny_max = \"slip\"\n";
  setting.time = "safety = 0.9";
  setting.material += fmt::format("young_modulus_Pa = 1\npoisson_ratio = {}\n", k_ground_nu);
  setting.tables = wall("slip", 0, 0, 1, 0) + wall("slip", k_piece, 0, -1, 0) + wall("sticky", 0, dx - depth, 0, 1) +
                   fmt::format(
                       "[[skin]]\nyoung_modulus_Pa = {:.17g}\nthickness_m = {:.17g}\npoisson_ratio = {}\ndensity_kg_per_m3 = 0.01\n"
                       "depth_dx = 0\nmesh_file = \"{}\"\n",
                       E_f, h, k_skin_nu, (folder / "strip.hdf").string());
  setting.shape = fmt::format("box = {{ centre_m = [{:.17g}, {:.17g}, {:.17g}], half_extents_m = [{:.17g}, {:.17g}, {:.17g}] }}",
                              length / 2, dx / 2, -depth / 2, length / 2, dx / 2, depth / 2);
  setting.body = "jitter = 0";
  const auto s = setting.begin();
  press(*s, e, k_ground_nu);
  const Mesh pressed = *s->skin_mesh(s->frame());

  const Waves waves = numbers();
  double slowest = 1e9;
  for (const double each : waves)
    slowest = std::min(slowest, std::sqrt((B * each * each * each * each + k_G * each - N * each * each * e) / (dx / 2 + 1 / each)));
  const auto push = [=](const Point& x) {
    double sum = 0;
    if (x[2] > -0.6 * dx)
      for (const double each : waves) sum += sign * 1e-3 * std::cos(each * x[0]);
    return sum;
  };
  return load(*s, 1.4 * slowest, push, [&] {
    const Mesh now = *s->skin_mesh(s->frame());
    Waves w{};
    constexpr std::size_t k_row = k_across + 1;  // of vertices; those at the strip's ends stand for half as much of it
    const std::size_t first = k_flap * k_row, end = now.vertex_count() - first;
    for (std::size_t v = first; v < end; ++v)
      for (std::size_t i = 0; i < w.size(); ++i)
        w[i] += (v < first + k_row || v + k_row >= end ? 0.5 : 1) * sign * (now.points[3 * v + 2] - pressed.points[3 * v + 2]) *
                std::cos(waves[i] * pressed.points[3 * v]);
    // What is pressed has more mass in each length. Of the loaded mass 0.63 is ground, which becomes higher; the rest is the skin's
    // inertia.
    for (double& each : w) each /= static_cast<double>(end - first - k_row) * std::exp(e * (1 - 0.63 * k_ground_nu / (1 - k_ground_nu)));
    return w;
  });
}

/// Where S, found at a third and two thirds of the onset, would be zero. The compression takes whole columns of particles: a gap at the end
/// would be pressed out first. The mean of both signs of the load is free of what moves by itself.
Waves critical_strains_of_skin(double cells) {
  const auto strain = [&](double share) {
    const double column = k_wavelength / cells / 2;
    return std::log(1 + std::round(share * k_onset * k_piece / column) * column / k_piece);
  };
  const auto both = [&](double e) { return mean(yields(cells, e, 1), yields(cells, e, -1)); };
  const double lower = strain(0.35), upper = strain(0.7);
  return critical_strains(both(lower), lower, both(upper), upper);
}

}  // namespace

}  // namespace film

std::vector<Errors> wrinkles_of_skin(bool quick) {
  using namespace film;
  Errors wavelength, onset;
  wavelength.quantity = "wavelength against 2 pi (2 B / G)^(1/3)";
  onset.quantity = "onset against 3 B k^2 / N";
  wavelength.high = onset.high = 0.05;
  wavelength.why = "no order: theory is that of small strains";
  onset.why =
      "the same: at 6 cells the flesh above the skin, 0.4 dx, puts it up by 3 %, a strain of 2 % that theory takes for small puts it down";
  for (Errors* e : {&wavelength, &onset}) {
    e->figure = Errors::Figure::largest_error;
    e->refined = "cells in a wavelength";
    e->refinements = quick ? std::vector<double>{6, 8} : std::vector<double>{6, 8, 10, 12, 16};
  }
  for (const double n : onset.refinements) {
    const Wrinkle found = least_of_fit(numbers(), critical_strains_of_skin(n));
    wavelength.errors.push_back(std::abs(found.wavelength / k_wavelength - 1));
    onset.errors.push_back(std::abs(found.onset / k_onset - 1));
  }
  return {wavelength, onset};
}

}  // namespace bake::studies
