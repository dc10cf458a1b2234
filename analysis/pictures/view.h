// SPDX-License-Identifier: MIT
// A view: it tells how a picture is made, in a TOML file beside the experiment (experiments/<experiment>/views/<name>.toml).
//
// As for scenes, every key is declared once; the reader, the checks and `bake-render explain` use the declaration. Colours are sRGB.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "analysis/browning/browning.h"
#include "analysis/image/colour.h"
#include "solver/core/parameter.h"

namespace bake {

inline constexpr Range pixels{16, 16384, false, false, "a whole number from 16 to 16384"};
inline constexpr Range whole_positive{1, 1e6, false, false, "a whole number from 1 to 1000000"};
inline constexpr Range angle_of_view{1, 120, false, false, "a number from 1 to 120"};
inline constexpr Range share_of_picture{0, 0.45, false, false, "a number from 0 to 0.45"};

/// [picture]
struct PictureSettings {
  int width_px = 1280;
  int height_px = 960;
  int samples = 64;
  double noise = 0.02;
  double exposure = 1;
  bool colour_bar = true;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"width_px", &PictureSettings::width_px, "", pixels, "width of the picture"},
        Parameter{"height_px", &PictureSettings::height_px, "", pixels, "height of the picture"},
        Parameter{"samples", &PictureSettings::samples, "", whole_positive,
                  "most paths of light per pixel: 16 to look, 64 to review, 256 to print"},
        Parameter{"noise", &PictureSettings::noise, "1", fraction,
                  "share of white: where the picture's noise is less no further paths are taken; 0: all samples everywhere"},
        Parameter{"exposure", &PictureSettings::exposure, "1", positive, "brightness of the whole picture"},
        Parameter{"colour_bar", &PictureSettings::colour_bar, "", any_number,
                  "show what the colours of an object with paint = \"field\" stand for, with its range and time"},
    };
  }
};

/// [camera]
struct CameraSettings {
  Vector3 direction = {0.45, -1, 0.55};
  double angle_of_view_deg = 24;
  bool fit = true;
  double margin = 0.06;
  std::optional<Vector3> eye_m;
  std::optional<Vector3> target_m;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"direction", &CameraSettings::direction, "", any_number, "from the objects to the camera, of any length"},
        Parameter{"angle_of_view_deg", &CameraSettings::angle_of_view_deg, "degrees", angle_of_view, "vertical angle of view"},
        Parameter{"fit", &CameraSettings::fit, "", any_number, "stand as near as the objects fit into the picture, which then fill it"},
        Parameter{"margin", &CameraSettings::margin, "1", share_of_picture, "with fit: share of the picture to leave free on every side"},
        Parameter{"eye_m", &CameraSettings::eye_m, "m", any_number, "without fit: where the camera stands"},
        Parameter{"target_m", &CameraSettings::target_m, "m", any_number, "without fit: where it looks"},
    };
  }
};

/// [light] - a square lamp
struct LightSettings {
  Vector3 direction = {-0.35, -0.7, 1};
  double distance = 5;
  double size = 1.3;
  Vector3 colour = {1, 0.95, 0.88};
  double strength = 1.35;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"direction", &LightSettings::direction, "", any_number, "from the objects to the lamp, of any length"},
        Parameter{"distance", &LightSettings::distance, "1", positive, "of the lamp, in radii of the sphere around all objects"},
        Parameter{"size", &LightSettings::size, "1", positive, "half the width of the lamp in the same radii: larger makes softer shadows"},
        Parameter{"colour", &LightSettings::colour, "", fraction, "of the lamp"},
        Parameter{"strength", &LightSettings::strength, "1", non_negative,
                  "radiance of a white surface amid the objects that faces the lamp"},
    };
  }
};

/// [sky] - light from all around
struct SkySettings {
  Vector3 colour = {1, 0.97, 0.93};
  double strength = 0.7;
  Vector3 backdrop = {1, 1, 1};
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"colour", &SkySettings::colour, "", fraction, "of the light from above"},
        Parameter{"strength", &SkySettings::strength, "1", non_negative,
                  "radiance of the sky straight above; a third of it comes from below"},
        Parameter{"backdrop", &SkySettings::backdrop, "", fraction, "what is seen where nothing is"},
    };
  }
};

/// [ground] - a table that rises to a wall far behind the objects
struct GroundSettings {
  bool show = true;
  Vector3 colour = {0.91, 0.90, 0.88};
  std::optional<double> height_m;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"show", &GroundSettings::show, "", any_number, "whether there is a table"},
        Parameter{"colour", &GroundSettings::colour, "", fraction, "of the table"},
        Parameter{"height_m", &GroundSettings::height_m, "m", any_number, "of the table; default: the lowest point of all objects"},
    };
  }
};

/// A stop of a colour ramp for browning.
struct BrowningStop {
  double degree = 0;
  Vector3 colour = {0, 0, 0};
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"degree", &BrowningStop::degree, "1", fraction, "of browning, 0 raw to 1", Presence::required},
        Parameter{"colour", &BrowningStop::colour, "", fraction, "at that degree", Presence::required},
    };
  }
};

/// [crust] - how browned dough looks
struct CrustSettings {
  std::vector<BrowningStop> skin = {{0, {0.93, 0.85, 0.68}},   {0.15, {0.92, 0.76, 0.49}}, {0.35, {0.84, 0.58, 0.26}},
                                    {0.6, {0.66, 0.37, 0.13}}, {0.8, {0.44, 0.22, 0.09}},  {1, {0.18, 0.09, 0.05}}};
  std::vector<BrowningStop> crumb = {{0, {0.96, 0.91, 0.78}},   {0.15, {0.93, 0.82, 0.61}}, {0.35, {0.84, 0.62, 0.33}},
                                     {0.6, {0.66, 0.37, 0.13}}, {0.8, {0.44, 0.22, 0.09}},  {1, {0.18, 0.09, 0.05}}};
  double grain = 0.022;
  double bump = 0.05;
  double mottle = 0.12;
  double crumb_grain = 0.006;
  double crumb_bump = 0.6;
  double crumb_mottle = 0.12;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"skin", &CrustSettings::skin, "", any_number, "colours of the skin by degree of browning, rising"},
        Parameter{"crumb", &CrustSettings::crumb, "", any_number, "colours of cut and crack faces by degree of browning, rising"},
        Parameter{"grain", &CrustSettings::grain, "1", non_negative,
                  "size of the skin's bumps in diameters of the object (a look, not data)"},
        Parameter{"bump", &CrustSettings::bump, "1", non_negative, "slope of the skin's bumps"},
        Parameter{"mottle", &CrustSettings::mottle, "1", fraction, "how much the skin's colour varies"},
        Parameter{"crumb_grain", &CrustSettings::crumb_grain, "1", non_negative, "size of the crumb's pores in diameters of the object"},
        Parameter{"crumb_bump", &CrustSettings::crumb_bump, "1", non_negative, "slope of the crumb's pores"},
        Parameter{"crumb_mottle", &CrustSettings::crumb_mottle, "1", fraction, "how much the crumb's colour varies"},
    };
  }
};

/// What gives an object its colours.
enum class Paint { browning, field, constant };
constexpr auto choice_names(Paint) { return std::array{"browning", "field", "constant"}; }
/// How particles without a mesh are shown.
enum class ParticleShape { surface, spheres };
constexpr auto choice_names(ParticleShape) { return std::array{"surface", "spheres"}; }

/// [[object]] - one for each file, in order
struct ObjectSettings {
  std::string title;
  Vector3 offset_m = {0, 0, 0};
  Vector3 rotate_deg = {0, 0, 0};
  Paint paint = Paint::browning;
  Vector3 colour = {0.80, 0.80, 0.80};
  std::string field = "temperature";
  ColourMap map = ColourMap::viridis;
  std::optional<double> range_low;
  std::optional<double> range_high;
  bool backwards = false;
  ParticleShape particles = ParticleShape::surface;
  std::optional<int> material;
  std::string mirrored;
  std::optional<double> spacing_m;
  double outwards_m = 0;
  double sphere_scale = 1;
  std::optional<Vector3> cut_point_m;
  std::optional<Vector3> cut_normal;
  double coat = 0.5;
  double roughness = 0.5;
  double translucent_m = 0;
  double crease_deg = 60;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"title", &ObjectSettings::title, "", any_number, "written below the object"},
        Parameter{"offset_m", &ObjectSettings::offset_m, "m", any_number, "shift, after the turn"},
        Parameter{"rotate_deg", &ObjectSettings::rotate_deg, "degrees", any_number, "turn about the origin: axis times angle"},
        Parameter{"paint", &ObjectSettings::paint, "", any_number, "where the colours come from: browning history, a field, or one colour"},
        Parameter{"colour", &ObjectSettings::colour, "", fraction, "with paint = \"constant\""},
        Parameter{"field", &ObjectSettings::field, "", any_number, "with paint = \"field\": name of a scalar in the file"},
        Parameter{"map", &ObjectSettings::map, "", any_number, "with paint = \"field\": its colours"},
        Parameter{"range_low", &ObjectSettings::range_low, "", any_number, "value at the map's start; default: the smallest"},
        Parameter{"range_high", &ObjectSettings::range_high, "", any_number, "value at the map's end; default: the largest"},
        Parameter{"backwards", &ObjectSettings::backwards, "", any_number, "the map's end stands for range_low, its start for range_high"},
        Parameter{"particles", &ObjectSettings::particles, "", any_number,
                  "show a frame's particles as a smooth surface around them, or as spheres"},
        Parameter{"material", &ObjectSettings::material, "", Range{0, 1e6, false, false, "a whole number of at least 0"},
                  "only the frame's particles of that [[material]] of the scene, counted from 0; default: all"},
        Parameter{
            "mirrored", &ObjectSettings::mirrored, "", any_number,
            "completes a half or a quarter that was run between mirrors: axes whose planes through 0 they were, such as \"y\" or \"xy\""},
        Parameter{"spacing_m", &ObjectSettings::spacing_m, "m", positive, "of particles, for their surface; default: measured"},
        Parameter{"outwards_m", &ObjectSettings::outwards_m, "m", non_negative,
                  "moves a mesh along its normals: skins lie inside the flesh (depth_dx), whose surface would hide them"},
        Parameter{"sphere_scale", &ObjectSettings::sphere_scale, "1", positive, "radius of spheres over that of the particle's volume"},
        Parameter{"cut_point_m", &ObjectSettings::cut_point_m, "m", any_number, "a point of the cutting plane, before turn and shift"},
        Parameter{"cut_normal", &ObjectSettings::cut_normal, "", any_number, "the side of the plane that is taken away"},
        Parameter{"coat", &ObjectSettings::coat, "1", fraction, "share of the surface that shines"},
        Parameter{"roughness", &ObjectSettings::roughness, "1", fraction, "of the shine, 0 a mirror"},
        Parameter{"translucent_m", &ObjectSettings::translucent_m, "m", non_negative,
                  "how far light goes inside the body between two scatterings; 0: it is opaque. The surface must be closed"},
        Parameter{"crease_deg", &ObjectSettings::crease_deg, "degrees", Range{0, 180, false, false, "a number from 0 to 180"},
                  "edges sharper than this are shown sharp"},
    };
  }
};

/// [slice] - for technical pictures: the cut and how it is drawn
struct SliceSettings {
  Vector3 normal = {0, -1, 0};
  std::optional<Vector3> up;
  std::optional<Vector3> point_m;
  bool cut = true;
  bool edges = false;
  std::optional<Vector3> centre_m;
  std::optional<double> width_m;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"normal", &SliceSettings::normal, "", any_number, "the side of the plane that is taken away, from which it is seen"},
        Parameter{"up", &SliceSettings::up, "", any_number,
                  "what is drawn upwards, not along the normal; default: z, or y if it is seen along z"},
        Parameter{"point_m", &SliceSettings::point_m, "m", any_number, "a point of the plane; default: the middle of each body"},
        Parameter{"cut", &SliceSettings::cut, "", any_number, "cut the bodies, or show their surfaces painted by the field"},
        Parameter{"edges", &SliceSettings::edges, "", any_number, "draw the edges of the triangles"},
        Parameter{"centre_m", &SliceSettings::centre_m, "m", any_number, "middle of a close-up; default: that of each body"},
        Parameter{"width_m", &SliceSettings::width_m, "m", positive, "width of a close-up; default: all bodies are seen whole"},
    };
  }
};

/// [[panel]] - one for each field of a technical picture
struct PanelSettings {
  std::string field;
  std::string label;
  ColourMap map = ColourMap::viridis;
  std::optional<double> range_low;
  std::optional<double> range_high;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"field", &PanelSettings::field, "", any_number, "name of a scalar", Presence::required},
        Parameter{"label", &PanelSettings::label, "", any_number, "below the colour bar; default: the field's name and unit"},
        Parameter{"map", &PanelSettings::map, "", any_number, "its colours"},
        Parameter{"range_low", &PanelSettings::range_low, "", any_number, "value at the map's start; default: the smallest"},
        Parameter{"range_high", &PanelSettings::range_high, "", any_number, "value at the map's end; default: the largest"},
    };
  }
};

struct View {
  std::filesystem::path file;
  PictureSettings picture;
  CameraSettings camera;
  LightSettings light;
  SkySettings sky;
  GroundSettings ground;
  BrowningLaw browning;
  CrustSettings crust;
  SliceSettings slice;
  std::vector<PanelSettings> panels;    ///< of technical pictures
  std::vector<ObjectSettings> objects;  ///< at least one
};

/// Reads and checks a view; `overrides` are `key=value` as for scenes. Throws InputError, one line with file, line and key.
View read_view(const std::filesystem::path& file, const std::vector<std::string>& overrides = {});

/// Reads a view from text in memory; messages call it `name`.
View parse_view(std::string_view text, const std::filesystem::path& name, const std::vector<std::string>& overrides = {});

/// Describes all keys of a view with unit, default and meaning.
std::string explain_view();

}  // namespace bake
