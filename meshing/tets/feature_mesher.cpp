// SPDX-License-Identifier: GPL-3.0-or-later
// Only this file includes Mesh_3, which takes minutes to compile.
#include "meshing/tets/feature_mesher.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_3/Worksharing_data_structures.h>  // exude_mesh_3.h forgets it
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/Random.h>
#include <CGAL/exude_mesh_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/perturb_mesh_3.h>
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

#include "meshing/solid/cgal_surface.h"
#include "solver/core/errors.h"

namespace bake {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polyhedron = CGAL::Mesh_polyhedron_3<Kernel>::type;
using Domain = CGAL::Polyhedral_mesh_domain_with_features_3<Kernel>;
// The data structure for several threads is three times as fast as the sequential one even with one thread.
using Triangulation = CGAL::Mesh_triangulation_3<Domain, CGAL::Default, CGAL::Parallel_tag>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Domain::Corner_index, Domain::Curve_index>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

Complex refine(const Polyhedron& surface, double size) {
  namespace parameters = CGAL::parameters;
  CGAL::get_default_random() = CGAL::Random(0);
  CGAL::Random random(0);
  Domain domain(surface, &random);
  domain.detect_features(k_sharp_deg);
  const Criteria criteria(parameters::edge_size = size, parameters::facet_angle = 25, parameters::facet_size = size,
                          parameters::facet_distance = 0.1 * size, parameters::cell_radius_edge_ratio = 3, parameters::cell_size = size);
  Complex complex = CGAL::make_mesh_3<Complex>(domain, criteria, parameters::no_perturb(), parameters::no_exude());
  constexpr double k_sliver_deg = 10;
  CGAL::perturb_mesh_3(complex, domain, parameters::sliver_bound = k_sliver_deg);
  CGAL::exude_mesh_3(complex, parameters::sliver_bound = k_sliver_deg);
  return complex;
}

/// The tetrahedra of the complex and their vertices, in the order of their coordinates; some vertices of the triangulation are in none.
TetMesh to_tet_mesh(const Complex& complex) {
  std::vector<std::array<Point, 4>> corners;
  TetMesh mesh;
  for (auto cell = complex.cells_in_complex_begin(); cell != complex.cells_in_complex_end(); ++cell) {
    std::array<Point, 4> tet;
    for (int k = 0; k < 4; ++k) {
      const auto& x = cell->vertex(k)->point();
      tet[k] = {x.x(), x.y(), x.z()};
      mesh.points.push_back(tet[k]);
    }
    corners.push_back(tet);
  }
  std::sort(mesh.points.begin(), mesh.points.end());
  mesh.points.erase(std::unique(mesh.points.begin(), mesh.points.end()), mesh.points.end());
  for (const auto& tet : corners) {
    Tet numbers;
    for (int k = 0; k < 4; ++k)
      numbers[k] = static_cast<std::int32_t>(std::lower_bound(mesh.points.begin(), mesh.points.end(), tet[k]) - mesh.points.begin());
    mesh.tets.push_back(numbers);
  }
  std::sort(mesh.tets.begin(), mesh.tets.end());
  return mesh;
}

/// Size of elements for a number of vertices, N = a V / s^3 + b A / s^2 (fitted to meshes of 10 000 to 600 000 vertices with the
/// criteria above), by halving an interval.
double size_for(double vertices, double volume, double area) {
  const auto count = [&](double s) { return 0.732 * volume / (s * s * s) + 0.42 * area / (s * s); };
  double low = 0, high = std::cbrt(volume) + std::sqrt(area);
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (count(middle) > vertices ? low : high) = middle;
  }
  return high;
}

}  // namespace

TetMesh feature_tets(const TriangleMesh& surface, std::size_t target, const Tell& tell) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const auto closed = cgal_surface<Polyhedron, Kernel>(surface);
  const double volume = enclosed_volume(surface), whole_area = area(surface);
  const auto miss = [&](const TetMesh& mesh) {
    return std::abs(static_cast<double>(mesh.points.size()) / static_cast<double>(target) - 1);
  };
  constexpr double k_hopeless = 0.1;
  auto wanted = static_cast<double>(target);
  TetMesh best;
  for (int round = 0; round < 6 && (round == 0 || miss(best) > 0.015); ++round) {
    if (wanted < k_hopeless * static_cast<double>(target)) break;  // the sharp edges alone need more
    tell(fmt::format("refining to about {:.0f} vertices", wanted));
    TetMesh mesh = to_tet_mesh(refine(closed, size_for(wanted, volume, whole_area)));
    if (mesh.points.empty()) break;
    wanted *= static_cast<double>(target) / static_cast<double>(mesh.points.size());
    if (round == 0 || miss(mesh) < miss(best)) best = std::move(mesh);
  }
  if (best.points.empty()) throw InputError(fmt::format("{} vertices are too few to fill the surface with tetrahedra", target));
  return best;
}

}  // namespace bake
