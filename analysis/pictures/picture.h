// SPDX-License-Identifier: MIT
// Makes a picture from a view and files.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "analysis/image/image.h"
#include "analysis/pictures/object.h"
#include "analysis/pictures/view.h"

namespace bake {

/// The nearest camera that looks along -direction and sees all `points`. The share `margin` of the picture stays free on each side, and
/// `below` more at the bottom and `above` at the top. The fit is exact: the outermost points touch the margins in width, in height or in
/// both.
Camera fitted_camera(const std::vector<Vec3f>& points, const Vec3f& direction, double angle_of_view_deg, double aspect, double margin,
                     double below, double above = 0);

/// Light to sRGB: exposure, then a curve that rolls off highlights (Narkowicz 2015, fit of the ACES film curve).
Colour developed(const Colour& light, double exposure);
Image developed(const Radiance& radiance, double exposure);

/// The contents of a picture, before the camera is set up.
struct Composition {
  std::vector<PictureObject> objects;
  std::vector<std::vector<Vec3f>> outlines;  ///< points of each that can be outermost
};

/// Loads `files`, one for each object of the view; `results`: folder of the run of each, empty where not given.
/// Throws InputError: a number of files that is not that of objects, and as load_object does.
Composition compose(const View& view, const std::vector<std::filesystem::path>& files, const std::vector<std::filesystem::path>& results,
                    Histories& histories, int threads);

/// Camera, lamp and table for everything within `points`.
struct Stage {
  Camera camera;
  Vec3f centre;
  float radius;  ///< of the sphere around all points [m]
  float table;   ///< height of the table [m]
};
Stage set_stage(const View& view, const std::vector<Vec3f>& points);

/// Renders the picture.
Image take_picture(const View& view, Composition composition, const Stage& stage, int threads,
                   const std::function<void(double share)>& progress = {});

/// Does all three steps.
Image take_picture(const View& view, const std::vector<std::filesystem::path>& files, const std::vector<std::filesystem::path>& results,
                   Histories& histories, int threads, const std::function<void(double share)>& progress = {});

/// All points of the composition's outlines.
std::vector<Vec3f> points_of(const Composition& composition);

}  // namespace bake
