// SPDX-License-Identifier: MIT
#include "analysis/surface/splat.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkWindowedSincPolyDataFilter.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <limits>

#include "analysis/surface/mesh_tools.h"
#include "analysis/surface/point_grid.h"
#include "solver/core/errors.h"

namespace bake {
namespace {

constexpr float k_reach = 1.8f;   ///< of a particle's weight, in spacings
constexpr float k_far_reach = 4;  ///< where the nearest particle still counts, in spacings
constexpr float k_cell = 0.5f;    ///< of the sampling grid, in spacings
constexpr float k_radius = 0.5f;  ///< of a lone particle, in spacings
constexpr int k_smoothing = 20;   ///< degree of the windowed sinc
constexpr double k_pass_band = 0.1;
constexpr std::size_t k_slab = 8;  ///< layers of the grid that a thread takes at a time

/// The weight at a squared distance, in units of the squared reach: (1 - r^2)^3 [Zhu and Bridson 2005, Eq. 6].
float weight(float share2) {
  const float w = 1 - share2;
  return w * w * w;
}

/// Nodes of the sampling grid.
struct SampleGrid {
  Eigen::Array3f low;
  float cell;
  Eigen::Array3i nodes;
  std::size_t layer() const { return static_cast<std::size_t>(nodes.x()) * static_cast<std::size_t>(nodes.y()); }
  std::size_t count() const { return layer() * static_cast<std::size_t>(nodes.z()); }
};

SampleGrid grid_around(const Particles& particles, float spacing) {
  const auto box = box_around<float>(particles.positions);
  const float margin = (k_reach + 1) * spacing, cell = k_cell * spacing;
  const Eigen::Array3d nodes = ((box.diagonal().array() + 2 * margin) / cell).ceil().cast<double>() + 1;
  constexpr double k_most_nodes = 5e8;
  if (!(nodes.prod() < k_most_nodes))
    throw InputError(fmt::format("the particles are strewn over {:.3g} nodes of {:.3g} m, allowed: up to {:.3g}; give a larger --spacing",
                                 nodes.prod(), cell, k_most_nodes));
  return {box.min().array() - margin, cell, nodes.cast<int>()};
}

/// phi at every node, positive inside: half a spacing minus the distance to the weighted mean of the particles around.
std::vector<float> level_set(const Particles& particles, const SampleGrid& grid, float spacing, int threads) {
  const float reach = k_reach * spacing;
  const std::size_t layers = static_cast<std::size_t>(grid.nodes.z()), slabs = (layers + k_slab - 1) / k_slab;
  // each slab gets the particles that reach it, in their own order, so that sums do not depend on threads
  std::vector<std::vector<std::uint32_t>> of_slab(slabs);
  for (std::size_t i = 0; i < particles.count(); ++i) {
    const float z = particles.positions[3 * i + 2] - grid.low.z();
    const auto slab_of = [&](float height) { return static_cast<std::size_t>(std::max(0.0f, height / grid.cell)) / k_slab; };
    for (std::size_t s = slab_of(z - reach); s <= std::min(slabs - 1, slab_of(z + reach)); ++s)
      of_slab[s].push_back(static_cast<std::uint32_t>(i));
  }
  std::vector<float> phi(grid.count());
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
  for (std::size_t slab = 0; slab < slabs; ++slab) {
    const std::size_t first = slab * k_slab, last = std::min(layers, first + k_slab);
    std::vector<Eigen::Array4f> sums((last - first) * grid.layer(),
                                     Eigen::Array4f::Zero());  // of w, and w times the offset from the particle
    for (const std::uint32_t i : of_slab[slab]) {
      const Eigen::Array3f p = Eigen::Map<const Eigen::Array3f>(&particles.positions[3 * i]) - grid.low;
      const Eigen::Array3i from = ((p - reach) / grid.cell).ceil().cast<int>().max(0);
      const Eigen::Array3i to = ((p + reach) / grid.cell).floor().cast<int>().min(grid.nodes - 1);
      for (int z = std::max(from.z(), static_cast<int>(first)); z <= std::min(to.z(), static_cast<int>(last) - 1); ++z)
        for (int y = from.y(); y <= to.y(); ++y) {
          Eigen::Array4f* row = &sums[(static_cast<std::size_t>(z) - first) * grid.layer() + static_cast<std::size_t>(y * grid.nodes.x())];
          const float dz = grid.cell * static_cast<float>(z) - p.z(), dy = grid.cell * static_cast<float>(y) - p.y();
          for (int x = from.x(); x <= to.x(); ++x) {
            const float dx = grid.cell * static_cast<float>(x) - p.x();
            const float share2 = (dx * dx + dy * dy + dz * dz) / (reach * reach);
            if (share2 < 1) row[x] += weight(share2) * Eigen::Array4f(dx, dy, dz, 1);
          }
        }
    }
    for (std::size_t k = 0; k < sums.size(); ++k) {
      const Eigen::Array4f& s = sums[k];
      const float outside = -reach;
      phi[first * grid.layer() + k] = s[3] > 0 ? k_radius * spacing - (s.head<3>() / s[3]).matrix().norm() : outside;
    }
  }
  return phi;
}

/// Zero surface of phi, smoothed.
Mesh contour(std::vector<float>& phi, const SampleGrid& grid) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(grid.nodes.x(), grid.nodes.y(), grid.nodes.z());
  image->SetSpacing(grid.cell, grid.cell, grid.cell);
  image->SetOrigin(grid.low.x(), grid.low.y(), grid.low.z());
  vtkNew<vtkFloatArray> values;
  values->SetArray(phi.data(), static_cast<vtkIdType>(phi.size()), 1);  // not owned
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkFlyingEdges3D> edges;
  edges->SetInputData(image);
  edges->SetValue(0, 0);
  edges->ComputeNormalsOff();
  edges->ComputeScalarsOff();
  vtkNew<vtkWindowedSincPolyDataFilter> smooth;
  smooth->SetInputConnection(edges->GetOutputPort());
  smooth->SetNumberOfIterations(k_smoothing);
  smooth->SetPassBand(k_pass_band);
  smooth->NonManifoldSmoothingOn();
  smooth->NormalizeCoordinatesOn();
  smooth->Update();
  vtkPolyData* surface = smooth->GetOutput();
  Mesh mesh;
  mesh.points.resize(3 * static_cast<std::size_t>(surface->GetNumberOfPoints()));
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) surface->GetPoint(static_cast<vtkIdType>(i), &mesh.points[3 * i]);
  vtkNew<vtkIdList> corners;
  for (vtkIdType c = 0; c < surface->GetPolys()->GetNumberOfCells(); ++c) {
    surface->GetPolys()->GetCellAtId(c, corners);
    mesh.cells.insert(mesh.cells.end(), corners->begin(), corners->end());
  }
  return mesh;
}

/// Six times the volume that the triangles enclose.
double signed_volume6(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) {
    const auto p = [&](std::size_t k) {
      return Eigen::Map<const Eigen::Vector3d>(&mesh.points[3 * static_cast<std::size_t>(mesh.cells[3 * c + k])]);
    };
    sum += p(0).dot(p(1).cross(p(2)));
  }
  return sum;
}

void orient_outwards(Mesh& mesh) {
  if (signed_volume6(mesh) >= 0) return;
  for (std::size_t c = 0; c < mesh.cell_count(); ++c) std::swap(mesh.cells[3 * c + 1], mesh.cells[3 * c + 2]);
}

}  // namespace

std::vector<MeshField> fields_at(const std::vector<double>& points, const Particles& particles, const std::vector<MeshField>& fields,
                                 int threads, const std::string& what, float spacing) {
  const float distance = std::max(spacing, particles.spacing()), reach = k_reach * distance, far = k_far_reach * distance;
  const PointGrid near(particles.positions, reach);
  const std::size_t count = points.size() / 3;
  std::vector<MeshField> result;
  result.reserve(fields.size());
  for (const MeshField& field : fields)
    result.push_back({field.name, field.unit, field.components, std::vector<double>(count * field.components)});
  std::atomic<std::size_t> strays{0};
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3f place = Eigen::Map<const Eigen::Vector3d>(&points[3 * i]).cast<float>();
    std::vector<std::pair<std::size_t, double>> shares;
    double sum = 0;
    near.within(place, reach, [&](std::size_t p, float distance2) {
      const double w = std::max(1e-9f, weight(distance2 / (reach * reach)));
      shares.emplace_back(p, w);
      sum += w;
    });
    if (shares.empty()) {
      std::int64_t p = near.nearest(place, far);
      if (p < 0 && 100 * ++strays <= count) p = near.nearest(place, std::numeric_limits<float>::infinity());
      if (p < 0) continue;
      shares.emplace_back(static_cast<std::size_t>(p), 1.0);
      sum = 1;
    }
    for (std::size_t f = 0; f < fields.size(); ++f) {
      const std::size_t components = fields[f].components;
      for (const auto& [p, w] : shares)
        for (std::size_t c = 0; c < components; ++c) result[f].values[components * i + c] += w / sum * fields[f].values[components * p + c];
    }
  }
  if (100 * strays > count)
    throw InputError(fmt::format("{}: found {} of {} vertices with no particle within {:.3g} m: it shows another run, or another time",
                                 what, strays.load(), count, far));
  return result;
}

Mesh splat_surface(const Particles& particles, const SplatSettings& settings) {
  const float spacing = settings.spacing_m > 0 ? static_cast<float>(settings.spacing_m) : particles.spacing();
  const SampleGrid grid = grid_around(particles, spacing);
  std::vector<float> phi = level_set(particles, grid, spacing, settings.threads);
  Mesh mesh = contour(phi, grid);
  if (mesh.cells.empty())
    throw InputError(
        fmt::format("the particles make no surface at a spacing of {:.3g} m: they are strewn; give a larger --spacing", spacing));
  orient_outwards(mesh);
  mesh.time_s = particles.time_s;
  mesh.fields = fields_at(mesh.points, particles, particles.fields, settings.threads, "the surface", spacing);
  return mesh;
}

}  // namespace bake
