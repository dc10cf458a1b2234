// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshing/tets/delaunay.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>

namespace bake {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_3<std::int32_t, Kernel>;
using Structure = CGAL::Triangulation_data_structure_3<Vertex, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, Structure>;

/// The same tetrahedron with its smallest vertex first: an even permutation.
Tet smallest_first(const Tet& t) {
  switch (std::min_element(t.begin(), t.end()) - t.begin()) {
    case 1:
      return {t[1], t[0], t[3], t[2]};
    case 2:
      return {t[2], t[3], t[0], t[1]};
    case 3:
      return {t[3], t[2], t[1], t[0]};
    default:
      return t;
  }
}

}  // namespace

std::vector<Tet> delaunay_tets(const std::vector<Point>& points) {
  std::vector<std::pair<Kernel::Point_3, std::int32_t>> numbered;
  numbered.reserve(points.size());
  for (const Point& x : points) numbered.emplace_back(Kernel::Point_3(x[0], x[1], x[2]), static_cast<std::int32_t>(numbered.size()));
  const Delaunay delaunay(numbered.begin(), numbered.end());
  std::vector<Tet> tets;
  if (delaunay.dimension() < 3) return tets;
  tets.reserve(delaunay.number_of_finite_cells());
  for (const auto& cell : delaunay.finite_cell_handles()) {
    Tet tet;
    for (int k = 0; k < 4; ++k) tet[k] = cell->vertex(k)->info();
    tets.push_back(smallest_first(tet));
  }
  std::sort(tets.begin(), tets.end());
  return tets;
}

}  // namespace bake
