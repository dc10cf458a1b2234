// SPDX-License-Identifier: MIT
#include "analysis/pictures/picture.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>

#include "solver/core/errors.h"
#include "solver/scene/entry.h"

namespace bake {
namespace {

constexpr double k_title_height = 0.045;  ///< of the picture's height

Vec3f as_vec3f(const Vector3& v) { return Vec3f(static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])); }
Colour linear(const Vector3& srgb) { return linear_from_srgb(as_vec3f(srgb)); }

/// All points of an object that can be outermost.
std::vector<Vec3f> outline(const PictureObject& object) {
  std::vector<Vec3f> points;
  for (const TriangleObject& mesh : object.meshes)
    for (const auto& triangle : mesh.triangles)
      for (const std::uint32_t v : triangle) points.push_back(mesh.vertices[v]);
  for (const SphereObject& set : object.spheres)
    for (const Eigen::Vector4f& s : set.spheres)
      for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) points.push_back(s.head<3>() + side * s[3] * Vec3f::Unit(axis));
  return points;
}

/// Right, up and backward of a camera that looks along -direction.
std::array<Vec3f, 3> axes_of(const Vec3f& direction, const Vec3f& up) {
  const Vec3f back = direction.normalized(), right = up.cross(back).normalized();
  return {right, back.cross(right), back};
}

Vec3f up_for(const Vec3f& direction) {  // a camera straight above has the y axis up
  return std::abs(direction.normalized().z()) > 0.999f ? Vec3f(0, 1, 0) : Vec3f(0, 0, 1);
}

/// A table that bends up into a wall behind the objects, as photographers have it. Many columns, so that their boxes are small: that of a
/// strip across the whole table would hold the objects, and every ray near them would be tested against every strip (twice the time).
TriangleObject cove(const Stage& stage, const Colour& albedo) {
  const Vec3f view_direction = stage.camera.eye - stage.camera.target;
  Vec3f away(-view_direction.x(), -view_direction.y(), 0);
  away = away.norm() > 1e-3f ? away.normalized() : Vec3f(0, 1, 0);
  const Vec3f side(-away.y(), away.x(), 0);
  const float r = stage.radius, reach = 4 * r, bend = 6 * r, wide = 60 * r;
  TriangleObject object;
  std::vector<Vec3f> normals;
  constexpr std::uint32_t k_columns = 32;
  const auto add = [&](float forward, float up, const Vec3f& normal) {
    Vec3f centre = stage.centre + forward * away;
    centre.z() = stage.table + up;
    for (std::uint32_t column = 0; column <= k_columns; ++column) {
      object.vertices.push_back(centre + (2 * static_cast<float>(column) / k_columns - 1) * wide * side);
      normals.push_back(normal);
    }
  };
  add(-60 * r, 0, Vec3f(0, 0, 1));
  constexpr int k_steps = 48;
  for (int i = 0; i <= k_steps; ++i) {
    const float angle = static_cast<float>(i) / k_steps * std::numbers::pi_v<float> / 2;
    add(reach + bend * std::sin(angle), bend * (1 - std::cos(angle)), std::cos(angle) * Vec3f(0, 0, 1) - std::sin(angle) * away);
  }
  add(reach + bend, 40 * r, -away);
  const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    object.triangles.push_back({a, b, c});
    object.normals.push_back({normals[a], normals[b], normals[c]});
  };
  for (std::uint32_t row = 0; row + k_columns + 1 < normals.size(); row += k_columns + 1)
    for (std::uint32_t i = row; i < row + k_columns; ++i) {
      const std::uint32_t next = i + k_columns + 1;
      triangle(i, i + 1, next);
      triangle(i + 1, next + 1, next);
    }
  object.albedos.assign(object.vertices.size(), albedo);
  return object;
}

void light_up(PathTracer& tracer, const View& view, const Stage& stage) {
  const Vec3f towards = as_vec3f(view.light.direction).normalized();
  const float distance = static_cast<float>(view.light.distance) * stage.radius;
  Lamp& lamp = tracer.lamp;
  lamp.centre = stage.centre + distance * towards;
  lamp.direction = -towards;
  lamp.half_width = static_cast<float>(view.light.size) * stage.radius;
  const float area = 4 * lamp.half_width * lamp.half_width;  // strength: albedo 1 reflects irradiance / pi
  lamp.radiance =
      linear(view.light.colour) * (static_cast<float>(view.light.strength) * std::numbers::pi_v<float> * distance * distance / area);
  const Colour above = linear(view.sky.colour) * static_cast<float>(view.sky.strength);
  tracer.sky = {above, above / 3, linear(view.sky.backdrop)};
}

/// Where an object appears in the picture [pixels].
struct Extent {
  double left = 1e9, right = -1e9, bottom = -1e9;
};

Extent extent_of(const std::vector<Vec3f>& points, const Camera& camera, const PictureSettings& picture) {
  const auto [right, up, back] = axes_of(camera.eye - camera.target, camera.up);
  const double half_width = camera.half_height * picture.width_px / picture.height_px;
  Extent extent;
  for (const Vec3f& p : points) {
    const Vec3f q = p - camera.eye;
    const double depth = -back.dot(q);
    if (depth <= 0) continue;
    const double x = (right.dot(q) / (depth * half_width) + 1) / 2 * picture.width_px;
    extent.left = std::min(extent.left, x);
    extent.right = std::max(extent.right, x);
    extent.bottom = std::max(extent.bottom, (1 - up.dot(q) / (depth * camera.half_height)) / 2 * picture.height_px);
  }
  return extent;
}

}  // namespace

Camera fitted_camera(const std::vector<Vec3f>& points, const Vec3f& direction, double angle_of_view_deg, double aspect, double margin,
                     double below, double above) {
  Camera camera;
  camera.up = up_for(direction);
  camera.half_height = static_cast<float>(std::tan(angle_of_view_deg / 2 * std::numbers::pi / 180));
  const auto [right, up, back] = axes_of(direction, camera.up);
  // A point at (x, y, z) along right, up, back is inside the left plane of a camera at (cx, cy, d) if cx - x <= t (d - z). So the
  // planes ask for the largest t z - x and t z + x, and the camera touches them where both are equal.
  const double tx = camera.half_height * aspect * (1 - 2 * margin);
  const double top = camera.half_height * (1 - 2 * margin - 2 * above), bottom = camera.half_height * (1 - 2 * margin - 2 * below);
  double left_most = -k_infinity, right_most = -k_infinity, lowest = -k_infinity, highest = -k_infinity;
  for (const Vec3f& p : points) {
    const double x = right.dot(p), y = up.dot(p), z = back.dot(p);
    left_most = std::max(left_most, tx * z - x);
    right_most = std::max(right_most, tx * z + x);
    lowest = std::max(lowest, bottom * z - y);
    highest = std::max(highest, top * z + y);
  }
  const double d = std::max((left_most + right_most) / (2 * tx), (lowest + highest) / (bottom + top));
  // Along the axis with room to spare: where the picture leaves as much free on either side. Seen from further up, all moves down.
  const auto centred = [&, &back = back](double low, double high, const Vec3f& axis, double middle) {
    for (int i = 0; i < 40; ++i) {
      const double c = (low + high) / 2;
      double first = k_infinity, last = -k_infinity;
      for (const Vec3f& p : points) {
        const double place = (axis.dot(p) - c) / (d - back.dot(p));
        first = std::min(first, place);
        last = std::max(last, place);
      }
      ((first + last) / 2 > middle ? low : high) = c;
    }
    return (low + high) / 2;
  };
  const double cx = centred(right_most - tx * d, tx * d - left_most, right, 0);
  const double cy = centred(highest - top * d, bottom * d - lowest, up, (top - bottom) / 2);
  camera.eye = (cx * right.cast<double>() + cy * up.cast<double>() + d * back.cast<double>()).cast<float>();
  camera.target = camera.eye - back;
  return camera;
}

Colour developed(const Colour& light, double exposure) {
  const auto film = [](float x) { return x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f); };
  constexpr float k_middle = 0.6f;  // the fit is meant for light reduced by this
  const Colour reduced = light * (k_middle * static_cast<float>(exposure));
  return srgb_from_linear(reduced.unaryExpr(film));
}

Image developed(const Radiance& radiance, double exposure) {
  Image image(radiance.width, radiance.height, Colour::Zero());
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = pixel(developed(radiance.pixels[i], exposure));
  return image;
}

Composition compose(const View& view, const std::vector<std::filesystem::path>& files, const std::vector<std::filesystem::path>& results,
                    Histories& histories, int threads) {
  if (files.size() != view.objects.size())
    throw InputError(fmt::format("{}: found {} [[object]] for {} files, allowed: one for each", quotable_path(view.file),
                                 view.objects.size(), files.size()));
  Composition composition;
  for (std::size_t i = 0; i < files.size(); ++i) {
    composition.objects.push_back(load_object(files[i], results[i], view, view.objects[i], histories, threads));
    composition.outlines.push_back(outline(composition.objects.back()));
  }
  return composition;
}

std::vector<Vec3f> points_of(const Composition& composition) {
  std::vector<Vec3f> points;
  for (const auto& outline : composition.outlines) points.insert(points.end(), outline.begin(), outline.end());
  return points;
}

namespace {

/// Height of letters beside colour bars [pixels].
int letters_of_bars(int height_px) { return std::clamp(height_px / 36, 8, 48); }

/// Share of the picture that the bars of the view's objects take, as far as its ranges tell which are alike.
double height_of_bars(const View& view) {
  if (!view.picture.colour_bar) return 0;
  std::vector<const ObjectSettings*> different;
  const auto is_like = [](const ObjectSettings& a, const ObjectSettings& b) {
    return a.range_low && a.range_high && a.field == b.field && a.map == b.map && a.backwards == b.backwards &&
           a.range_low == b.range_low && a.range_high == b.range_high;
  };
  for (const ObjectSettings& object : view.objects)
    if (object.paint == Paint::field &&
        std::none_of(different.begin(), different.end(), [&](const ObjectSettings* other) { return is_like(*other, object); }))
      different.push_back(&object);
  const int text = letters_of_bars(view.picture.height_px), count = static_cast<int>(different.size());
  constexpr double k_most = 0.3;  // beyond, bars lie over the picture
  return std::min(k_most, static_cast<double>(count * (colour_bar_height(text) + text / 2)) / view.picture.height_px);
}

}  // namespace

Stage set_stage(const View& view, const std::vector<Vec3f>& points) {
  Eigen::AlignedBox3f box;
  for (const Vec3f& p : points) box.extend(p);
  Stage stage{{}, box.center(), 0, view.ground.height_m ? static_cast<float>(*view.ground.height_m) : box.min().z()};
  for (const Vec3f& p : points) stage.radius = std::max(stage.radius, (p - stage.centre).norm());
  const double aspect = static_cast<double>(view.picture.width_px) / view.picture.height_px;
  const bool titled = std::any_of(view.objects.begin(), view.objects.end(), [](const ObjectSettings& o) { return !o.title.empty(); });
  const CameraSettings& camera = view.camera;
  stage.camera = fitted_camera(points, as_vec3f(camera.direction), camera.angle_of_view_deg, aspect, camera.margin,
                               titled ? 1.6 * k_title_height : 0, height_of_bars(view));
  if (!camera.fit) {
    stage.camera.eye = as_vec3f(*camera.eye_m);
    stage.camera.target = as_vec3f(*camera.target_m);
    stage.camera.up = up_for(stage.camera.eye - stage.camera.target);
  }
  return stage;
}

namespace {

/// What colours stand for, and at which times.
struct TimedBar {
  ColourBar bar;
  std::set<double> times_s;
};

/// Objects with the same bar share it.
std::vector<TimedBar> bars_of(const std::vector<PictureObject>& objects) {
  std::vector<TimedBar> bars;
  for (const PictureObject& object : objects) {
    if (!object.bar) continue;
    auto same = std::find_if(bars.begin(), bars.end(), [&](const TimedBar& timed) { return timed.bar == *object.bar; });
    if (same == bars.end()) same = bars.insert(bars.end(), {*object.bar, {}});
    same->times_s.insert(object.time_s);
  }
  return bars;
}

/// "2 s", "2 and 5 s", "0, 2 and 5 s".
std::string in_words(const std::set<double>& times_s) {
  std::string words;
  for (auto time = times_s.begin(); time != times_s.end(); ++time)
    words += fmt::format("{}{:.4g}", time == times_s.begin() ? "" : std::next(time) == times_s.end() ? " and " : ", ", *time);
  return words + " s";
}

/// One below the other in the upper left corner.
void draw_colour_bars(Image& image, const std::vector<TimedBar>& bars) {
  const int text = letters_of_bars(image.height), width = std::min(image.width * 2 / 5, 16 * text), left = 2 * text;
  int top = text;
  for (const auto& [bar, times_s] : bars) {
    ColourBar timed = bar;
    timed.label += ", " + in_words(times_s);
    if (top + colour_bar_height(text) > image.height) return;
    draw_colour_bar(image, timed, left + width / 2, top, width, text, Colour::Constant(0.15f));
    top += colour_bar_height(text) + text / 2;
  }
}

}  // namespace

Image take_picture(const View& view, Composition composition, const Stage& stage, int threads,
                   const std::function<void(double share)>& progress) {
  const std::vector<TimedBar> bars = view.picture.colour_bar ? bars_of(composition.objects) : std::vector<TimedBar>();
  PathTracer tracer;
  for (PictureObject& object : composition.objects) {
    for (TriangleObject& mesh : object.meshes) tracer.add(std::move(mesh));
    for (SphereObject& spheres : object.spheres) tracer.add(std::move(spheres));
  }
  if (view.ground.show) tracer.add(cove(stage, linear(view.ground.colour)));
  light_up(tracer, view, stage);
  Exposure exposure{view.picture.width_px, view.picture.height_px, view.picture.samples, threads};
  exposure.noise = static_cast<float>(view.picture.noise);
  exposure.shown = [&](const Colour& light) { return developed(light, view.picture.exposure); };
  Image image = developed(tracer.expose(stage.camera, exposure, progress), view.picture.exposure);
  draw_colour_bars(image, bars);
  const int size = static_cast<int>(std::lround(k_title_height * image.height));
  for (std::size_t i = 0; i < view.objects.size(); ++i) {
    const Extent extent = extent_of(composition.outlines[i], stage.camera, view.picture);
    const double y = std::min(extent.bottom + 0.9 * size, image.height - 0.6 * size);
    draw_text(image, view.objects[i].title, static_cast<int>((extent.left + extent.right) / 2), static_cast<int>(y), size, Anchor::centre,
              Colour::Constant(0.15f));
  }
  return image;
}

Image take_picture(const View& view, const std::vector<std::filesystem::path>& files, const std::vector<std::filesystem::path>& results,
                   Histories& histories, int threads, const std::function<void(double share)>& progress) {
  Composition composition = compose(view, files, results, histories, threads);
  const Stage stage = set_stage(view, points_of(composition));
  return take_picture(view, std::move(composition), stage, threads, progress);
}

}  // namespace bake
