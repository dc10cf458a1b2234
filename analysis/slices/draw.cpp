// SPDX-License-Identifier: MIT
#include "analysis/slices/draw.h"

#include "analysis/slices/headless_window.h"
// after GLEW
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace bake {
namespace {

constexpr int k_finer = 2;  ///< drawn so many times as large, for smooth edges

vtkNew<vtkActor> actor_of(const DrawnMesh& drawn) {
  const Mesh& mesh = *drawn.mesh;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.vertex_count()));
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) points->SetPoint(static_cast<vtkIdType>(i), &mesh.points[3 * i]);
  vtkNew<vtkCellArray> cells;
  for (std::size_t c = 0; c < mesh.cells.size(); c += 3) {
    const vtkIdType corners[] = {mesh.cells[c], mesh.cells[c + 1], mesh.cells[c + 2]};
    cells->InsertNextCell(3, corners);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  if (!drawn.colours.empty()) {
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetNumberOfComponents(3);
    for (const Colour& c : drawn.colours) colours->InsertNextTypedTuple(pixel(c).data());
    data->GetPointData()->SetScalars(colours);
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty* look = actor->GetProperty();
  look->SetColor(0.86, 0.86, 0.86);
  look->SetLighting(drawn.lit);
  look->SetAmbient(0.3);
  look->SetDiffuse(0.7);
  look->SetEdgeVisibility(drawn.edges);
  look->SetEdgeColor(0.15, 0.15, 0.15);
  look->SetLineWidth(k_finer);
  return actor;
}

}  // namespace

Image draw(const std::vector<DrawnMesh>& meshes, const Projection& projection, int width, int height) {
  vtkNew<HeadlessWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(k_finer * width, k_finer * height);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  window->AddRenderer(renderer);
  for (const DrawnMesh& mesh : meshes) renderer->AddActor(actor_of(mesh));
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(projection.half_height_m);
  const Eigen::Vector3d& at = projection.centre;
  const Eigen::Vector3d eye = at + projection.towards_eye;
  camera->SetFocalPoint(at.x(), at.y(), at.z());
  camera->SetPosition(eye.x(), eye.y(), eye.z());
  camera->SetViewUp(projection.up.x(), projection.up.y(), projection.up.z());
  renderer->ResetCameraClippingRange();
  window->Render();
  vtkNew<vtkUnsignedCharArray> bytes;
  window->GetPixelData(0, 0, k_finer * width - 1, k_finer * height - 1, 0, bytes.Get(), 0);
  Image fine(k_finer * width, k_finer * height, Colour::Ones());
  for (int y = 0; y < fine.height; ++y)
    std::copy_n(bytes->GetPointer(3L * fine.width * (fine.height - 1 - y)), 3 * fine.width, fine.at(0, y).data());
  return scaled(fine, width, height);
}

}  // namespace bake
