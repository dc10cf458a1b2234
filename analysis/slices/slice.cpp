// SPDX-License-Identifier: MIT
#include "analysis/slices/slice.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "analysis/image/colour_bar.h"
#include "analysis/pictures/shown.h"
#include "analysis/slices/draw.h"
#include "analysis/surface/mesh_tools.h"
#include "solver/core/errors.h"
#include "solver/scene/entry.h"

namespace bake {
namespace {

Eigen::Vector3d as_eigen(const Vector3& v) { return {v[0], v[1], v[2]}; }

/// Directions of the drawing: right, up, towards the eye.
struct Axes {
  Eigen::Vector3d right, up, towards_eye;
};

Axes axes_of(const SliceSettings& slice) {
  const Eigen::Vector3d n = as_eigen(slice.normal).normalized();
  const Eigen::Vector3d up = slice.up ? as_eigen(*slice.up) : std::abs(n.z()) > 0.999 ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d right = up.cross(n).normalized();
  return {right, n.cross(right), n};
}

/// The parts of one file that are drawn: the face of the cut and the body behind it; without a cut the whole body is the `face`.
struct Body {
  std::string title;
  Mesh face, behind;
  Eigen::AlignedBox2d extent;  ///< of the body in the drawing plane [m]
};

Body body_of(const View& view, const ObjectSettings& object, const Shown& shown, const Axes& axes) {
  const Mesh whole = shown.surface(object.spacing_m.value_or(0));
  Body body{object.title.empty() ? fmt::format("t = {:.4g} s", shown.time_s()) : object.title, {}, {}, {}};
  if (view.slice.cut) {
    const Eigen::Vector3d point = view.slice.point_m ? as_eigen(*view.slice.point_m) : box_around<double>(whole.points).center();
    CutMesh pieces = cut(whole, point, axes.towards_eye, diameter(whole.points) / 250);
    if (pieces.face.cells.empty())
      throw InputError(fmt::format("{}: slice.point_m: the plane does not meet {}", quotable_path(view.file), shown.file().string()));
    body.face = std::move(pieces.face);
    body.behind = std::move(pieces.kept);
  } else {
    body.face = whole;
  }
  for (const PanelSettings& panel : view.panels) shown.provide(body.face, panel.field);
  for (const Mesh* mesh : {&body.face, &body.behind})
    for (std::size_t i = 0; i < mesh->vertex_count(); ++i) {
      const Eigen::Map<const Eigen::Vector3d> p(&mesh->points[3 * i]);
      body.extent.extend(Eigen::Vector2d(axes.right.dot(p), axes.up.dot(p)));
    }
  return body;
}

struct Span {
  double low, high;
};

Span span_of(const PanelSettings& panel, const std::vector<Body>& bodies) {
  Span span{k_infinity, -k_infinity};
  for (const Body& body : bodies)
    for (const double value : body.face.find(panel.field)->values) span = {std::min(span.low, value), std::max(span.high, value)};
  return {panel.range_low.value_or(span.low), panel.range_high.value_or(span.high)};
}

std::string label_of(const PanelSettings& panel, const MeshField& field) {
  if (!panel.label.empty()) return panel.label;
  return label_of_field(panel.field, field.unit);
}

/// A round number of 1, 2 or 5 times a power of ten, at most `most`.
double round_below(double most) {
  const double power = std::pow(10, std::floor(std::log10(most)));
  return (most >= 5 * power ? 5 : most >= 2 * power ? 2 : 1) * power;
}

/// The layout of the picture [pixels].
struct Layout {
  int text, cell_width, cell_height, foot;
  Layout(const PictureSettings& picture, int columns, int rows) {
    text = std::clamp(std::min(picture.height_px / 24, picture.width_px / columns / 14), 10, 64);
    foot = 4 * text;
    cell_width = picture.width_px / columns;
    cell_height = (picture.height_px - foot) / rows;
    if (cell_height < 4 * text || cell_width < 8 * text)
      throw InputError(fmt::format("{} x {} panels do not fit into {} x {} pixels, allowed: a larger --size", columns, rows,
                                   picture.width_px, picture.height_px));
  }
};

const Colour k_ink = Colour::Constant(0.1f);

void draw_scale_bar(Image& image, double metres_per_pixel, int x, int y, int most_pixels, int text) {
  const double length_m = round_below(most_pixels * metres_per_pixel);
  const int length = static_cast<int>(std::lround(length_m / metres_per_pixel)), thick = std::max(2, text / 6);
  paste(image, Image(length, thick, k_ink), x, y);
  const std::string words = length_m >= 0.1    ? fmt::format("{:g} m", length_m)
                            : length_m >= 0.01 ? fmt::format("{:g} cm", 100 * length_m)
                                               : fmt::format("{:g} mm", 1000 * length_m);
  draw_text(image, words, x, y - text * 2 / 3, text, Anchor::left, k_ink);
}

Image draw_body(const View& view, const Body& body, const PanelSettings& panel, const Span& span, const Axes& axes, double metres_per_pixel,
                int width, int height) {
  DrawnMesh face{&body.face, {}, !view.slice.cut, view.slice.edges};
  for (const double value : body.face.find(panel.field)->values)
    face.colours.push_back(
        map_colour(panel.map, span.high > span.low ? static_cast<float>((value - span.low) / (span.high - span.low)) : 0.5f));
  std::vector<DrawnMesh> meshes{std::move(face)};
  if (!body.behind.cells.empty()) meshes.push_back({&body.behind, {}, true, view.slice.edges});
  const Eigen::Array2d middle = body.extent.center();
  const Eigen::Vector3d flat = middle.x() * axes.right + middle.y() * axes.up;
  const Eigen::Vector3d centre = view.slice.centre_m ? as_eigen(*view.slice.centre_m) : flat;
  return draw(meshes, {centre, axes.towards_eye, axes.up, height * metres_per_pixel / 2}, width, height);
}

}  // namespace

Image take_slices(const View& view, const std::vector<std::filesystem::path>& files, const std::vector<std::filesystem::path>& results,
                  int threads) {
  if (view.panels.empty())
    throw InputError(fmt::format("{}: found no [[panel]], allowed: one for each field to show", quotable_path(view.file)));
  if (view.objects.size() > 1 && view.objects.size() != files.size())
    throw InputError(fmt::format("{}: found {} [[object]] for {} files, allowed: one for all or one for each", quotable_path(view.file),
                                 view.objects.size(), files.size()));
  const Axes axes = axes_of(view.slice);
  std::vector<Body> bodies;
  for (std::size_t i = 0; i < files.size(); ++i)
    bodies.push_back(body_of(view, view.objects[view.objects.size() > 1 ? i : 0], Shown(files[i], results[i], threads), axes));

  const int panels = static_cast<int>(view.panels.size()), count = static_cast<int>(files.size());
  const bool by_file = panels == 1;
  const Layout at(view.picture, by_file ? count : panels, by_file ? 1 : count);
  const int inner_width = at.cell_width - at.text, inner_height = at.cell_height - at.text * 2;
  double metres_per_pixel = 0;
  for (const Body& body : bodies) {
    const Eigen::Array2d size = body.extent.diagonal();
    metres_per_pixel = std::max({metres_per_pixel, size.x() / inner_width, size.y() / inner_height});
  }
  if (view.slice.width_m) metres_per_pixel = *view.slice.width_m / inner_width;

  Image image(view.picture.width_px, view.picture.height_px, Colour::Ones());
  for (int p = 0; p < panels; ++p) {
    const PanelSettings& panel = view.panels[static_cast<std::size_t>(p)];
    const Span span = span_of(panel, bodies);
    for (int b = 0; b < count; ++b) {
      const Body& body = bodies[static_cast<std::size_t>(b)];
      const int left = (by_file ? b : p) * at.cell_width, top = (by_file ? 0 : b) * at.cell_height;
      const Image drawn = draw_body(view, body, panel, span, axes, metres_per_pixel, inner_width, inner_height);
      paste(image, drawn, left + at.text / 2, top + at.text * 3 / 2);
      if (by_file || p == 0) draw_text(image, body.title, left + at.text / 2, top + at.text, at.text, Anchor::left, k_ink);
    }
    const int centre = by_file ? image.width / 2 : p * at.cell_width + at.cell_width / 2;
    draw_colour_bar(image, {panel.map, span.low, span.high, label_of(panel, *bodies[0].face.find(panel.field))}, centre,
                    image.height - at.foot + at.text / 2, std::min(at.cell_width - 4 * at.text, 20 * at.text), at.text, k_ink);
  }
  draw_scale_bar(image, metres_per_pixel, at.text / 2, image.height - at.foot, at.cell_width / 5, at.text);
  return image;
}

}  // namespace bake
