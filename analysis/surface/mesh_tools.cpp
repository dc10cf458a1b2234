// SPDX-License-Identifier: MIT
#include "analysis/surface/mesh_tools.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkClipClosedSurface.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace bake {
namespace {

using Triangle = std::array<std::int64_t, 3>;

Eigen::Map<const Eigen::Vector3d> point_of(const Mesh& mesh, std::int64_t vertex) {
  return Eigen::Map<const Eigen::Vector3d>(&mesh.points[3 * static_cast<std::size_t>(vertex)]);
}

/// A mesh of the given triangles and of those vertices only that they use.
Mesh with_used_vertices(const Mesh& source, std::vector<std::int64_t> cells) {
  std::vector<std::int64_t> number(source.vertex_count(), -1);
  Mesh mesh;
  mesh.time_s = source.time_s;
  for (const MeshField& field : source.fields) mesh.fields.push_back({field.name, field.unit, field.components, {}});
  for (std::int64_t& vertex : cells) {
    const auto old = static_cast<std::size_t>(vertex);
    if (number[old] < 0) {
      number[old] = static_cast<std::int64_t>(mesh.vertex_count());
      mesh.points.insert(mesh.points.end(), &source.points[3 * old], &source.points[3 * old] + 3);
      for (std::size_t f = 0; f < mesh.fields.size(); ++f) {
        const std::size_t n = mesh.fields[f].components;
        const double* values = &source.fields[f].values[n * old];
        mesh.fields[f].values.insert(mesh.fields[f].values.end(), values, values + n);
      }
    }
    vertex = number[old];
  }
  mesh.cells = std::move(cells);
  return mesh;
}

vtkNew<vtkPolyData> poly_data(const Mesh& mesh) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.vertex_count()));
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) points->SetPoint(static_cast<vtkIdType>(i), &mesh.points[3 * i]);
  vtkNew<vtkCellArray> cells;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    const vtkIdType corners[] = {mesh.cells[3 * c], mesh.cells[3 * c + 1], mesh.cells[3 * c + 2]};
    cells->InsertNextCell(3, corners);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  for (const MeshField& field : mesh.fields) {
    vtkNew<vtkDoubleArray> values;
    values->SetName(field.name.c_str());
    values->SetNumberOfComponents(static_cast<int>(field.components));
    values->SetNumberOfTuples(static_cast<vtkIdType>(mesh.vertex_count()));
    std::copy(field.values.begin(), field.values.end(), values->GetPointer(0));
    data->GetPointData()->AddArray(values);
  }
  return data;
}

/// Splits triangles at the middle of their longest edge until none is longer.
std::vector<std::array<Eigen::Vector3d, 3>> split(std::vector<std::array<Eigen::Vector3d, 3>> to_do, double longest) {
  std::vector<std::array<Eigen::Vector3d, 3>> done;
  while (!to_do.empty()) {
    const auto t = to_do.back();
    to_do.pop_back();
    std::size_t k = 0;
    for (std::size_t i = 1; i < 3; ++i)
      if ((t[(i + 1) % 3] - t[i]).squaredNorm() > (t[(k + 1) % 3] - t[k]).squaredNorm()) k = i;
    const Eigen::Vector3d &a = t[k], &b = t[(k + 1) % 3], &c = t[(k + 2) % 3];
    if ((b - a).norm() <= longest) {
      done.push_back(t);
      continue;
    }
    const Eigen::Vector3d middle = (a + b) / 2;
    to_do.push_back({a, middle, c});
    to_do.push_back({middle, b, c});
  }
  return done;
}

}  // namespace

Mesh boundary_of_tetrahedra(const Mesh& tetrahedra) {
  struct Face {
    Triangle sorted, outward;
  };
  std::vector<Face> faces;
  faces.reserve(4 * tetrahedra.cell_count());
  constexpr std::size_t k_faces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};  // outwards if the volume is positive
  for (std::size_t c = 0; c < tetrahedra.cell_count(); ++c)
    for (const auto& f : k_faces) {
      const Triangle outward{tetrahedra.cells[4 * c + f[0]], tetrahedra.cells[4 * c + f[1]], tetrahedra.cells[4 * c + f[2]]};
      Triangle sorted = outward;
      std::sort(sorted.begin(), sorted.end());
      faces.push_back({sorted, outward});
    }
  std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) { return a.sorted < b.sorted; });
  std::vector<std::int64_t> cells;
  for (std::size_t i = 0; i < faces.size();) {
    std::size_t next = i + 1;
    while (next < faces.size() && faces[next].sorted == faces[i].sorted) ++next;
    if (next == i + 1) cells.insert(cells.end(), faces[i].outward.begin(), faces[i].outward.end());
    i = next;
  }
  return with_used_vertices(tetrahedra, std::move(cells));
}

std::vector<std::array<Eigen::Vector3f, 3>> corner_normals(const Mesh& triangles, double crease_deg) {
  const double least_cosine = std::cos(crease_deg * std::numbers::pi / 180);
  std::vector<Eigen::Vector3d> areas(triangles.cell_count());  // normals of twice the area's length
  std::vector<std::uint32_t> starts(triangles.vertex_count() + 1);
  for (std::size_t c = 0; c < areas.size(); ++c) {
    const std::int64_t* v = &triangles.cells[3 * c];
    areas[c] = (point_of(triangles, v[1]) - point_of(triangles, v[0])).cross(point_of(triangles, v[2]) - point_of(triangles, v[0]));
    for (int k = 0; k < 3; ++k) ++starts[static_cast<std::size_t>(v[k]) + 1];
  }
  for (std::size_t v = 1; v < starts.size(); ++v) starts[v] += starts[v - 1];
  std::vector<std::uint32_t> around(triangles.cells.size()), next(starts.begin(), starts.end() - 1);
  for (std::size_t i = 0; i < triangles.cells.size(); ++i)
    around[next[static_cast<std::size_t>(triangles.cells[i])]++] = static_cast<std::uint32_t>(i / 3);

  std::vector<std::array<Eigen::Vector3f, 3>> normals(triangles.cell_count());
  for (std::size_t i = 0; i < triangles.cells.size(); ++i) {
    const Eigen::Vector3d& own = areas[i / 3];
    const auto v = static_cast<std::size_t>(triangles.cells[i]);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::uint32_t k = starts[v]; k < starts[v + 1]; ++k) {
      const Eigen::Vector3d& other = areas[around[k]];
      if (other.dot(own) >= least_cosine * other.norm() * own.norm()) sum += other;
    }
    const double length = sum.norm();
    normals[i / 3][i % 3] = (length > 0 ? Eigen::Vector3d(sum / length) : Eigen::Vector3d::UnitZ().eval()).cast<float>();
  }
  return normals;
}

void move_outwards(Mesh& triangles, double distance_m) {
  const auto normals = corner_normals(triangles, 180);
  std::vector<bool> moved(triangles.vertex_count());
  for (std::size_t i = 0; i < triangles.cells.size(); ++i) {
    const auto v = static_cast<std::size_t>(triangles.cells[i]);
    if (moved[v]) continue;
    moved[v] = true;
    for (std::size_t d = 0; d < 3; ++d)
      triangles.points[3 * v + d] += distance_m * static_cast<double>(normals[i / 3][i % 3][static_cast<Eigen::Index>(d)]);
  }
}

Mesh without_specks(const Mesh& triangles, double share) {
  std::vector<std::size_t> parent(triangles.vertex_count());  // a forest; the root of a vertex names its part
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::int64_t vertex) {
    auto at = static_cast<std::size_t>(vertex);
    while (parent[at] != at) at = parent[at] = parent[parent[at]];
    return at;
  };
  for (std::size_t c = 0; c < triangles.cells.size(); c += 3)
    for (const std::size_t k : {c + 1, c + 2}) parent[root(triangles.cells[k])] = root(triangles.cells[c]);
  std::vector<double> volume(triangles.vertex_count());  // six times that of the part, at its root
  for (std::size_t c = 0; c < triangles.cells.size(); c += 3)
    volume[root(triangles.cells[c])] +=
        point_of(triangles, triangles.cells[c])
            .dot(point_of(triangles, triangles.cells[c + 1]).cross(point_of(triangles, triangles.cells[c + 2])));
  double largest = 0;
  for (const double v : volume) largest = std::max(largest, std::abs(v));
  std::vector<std::int64_t> kept;
  for (std::size_t c = 0; c < triangles.cells.size(); c += 3)
    if (std::abs(volume[root(triangles.cells[c])]) >= share * largest)
      kept.insert(kept.end(), &triangles.cells[c], &triangles.cells[c] + 3);
  return with_used_vertices(triangles, std::move(kept));
}

CutMesh cut(const Mesh& triangles, const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double longest_edge_m) {
  if (normal.norm() == 0) throw std::invalid_argument("a cut needs a normal that is not zero");
  vtkNew<vtkPlane> plane;
  const Eigen::Vector3d inwards = -normal.normalized();
  plane->SetOrigin(point.x(), point.y(), point.z());
  plane->SetNormal(inwards.x(), inwards.y(), inwards.z());
  vtkNew<vtkPlaneCollection> planes;
  planes->AddItem(plane);
  const vtkNew<vtkPolyData> whole = poly_data(triangles);
  vtkNew<vtkClipClosedSurface> clip;
  clip->SetInputData(whole);
  clip->SetClippingPlanes(planes);
  clip->SetScalarModeToLabels();
  clip->PassPointDataOn();
  clip->TriangulationErrorDisplayOff();
  clip->Update();
  vtkPolyData* clipped = clip->GetOutput();
  vtkDataArray* labels = clipped->GetCellData()->GetArray("Labels");

  Mesh all;
  all.time_s = triangles.time_s;
  all.points.resize(3 * static_cast<std::size_t>(clipped->GetNumberOfPoints()));
  for (std::size_t i = 0; i < all.vertex_count(); ++i) clipped->GetPoint(static_cast<vtkIdType>(i), &all.points[3 * i]);
  for (const MeshField& field : triangles.fields) {
    vtkDataArray* values = clipped->GetPointData()->GetArray(field.name.c_str());
    MeshField copy{field.name, field.unit, field.components, std::vector<double>(all.vertex_count() * field.components)};
    for (std::size_t i = 0; i < all.vertex_count(); ++i) values->GetTuple(static_cast<vtkIdType>(i), &copy.values[i * field.components]);
    all.fields.push_back(std::move(copy));
  }
  std::vector<std::int64_t> kept;
  std::vector<std::array<Eigen::Vector3d, 3>> face;
  vtkNew<vtkIdList> corners;
  for (vtkIdType c = 0; c < clipped->GetPolys()->GetNumberOfCells(); ++c) {
    clipped->GetPolys()->GetCellAtId(c, corners);
    const bool on_plane = labels->GetComponent(c, 0) != 0;
    for (vtkIdType k = 2; k < corners->GetNumberOfIds(); ++k) {  // convex where there are more than three
      const Triangle t{corners->GetId(0), corners->GetId(k - 1), corners->GetId(k)};
      if (!on_plane) kept.insert(kept.end(), t.begin(), t.end());
      if (on_plane) face.push_back({point_of(all, t[0]), point_of(all, t[1]), point_of(all, t[2])});
    }
  }
  CutMesh result{with_used_vertices(all, std::move(kept)), {}};
  result.face.time_s = triangles.time_s;
  for (const auto& triangle : split(std::move(face), longest_edge_m))
    for (const Eigen::Vector3d& p : triangle) {
      result.face.cells.push_back(static_cast<std::int64_t>(result.face.vertex_count()));
      result.face.points.insert(result.face.points.end(), p.begin(), p.end());
    }
  return result;
}

}  // namespace bake
