// SPDX-License-Identifier: MIT
// Views, and pictures taken by them.
#include "analysis/pictures/picture.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "analysis/surface/splat.h"
#include "solver/core/errors.h"
#include "solver/io/atomic_file.h"
#include "tests/unit/analysis/runs.h"

namespace bake {
namespace {

std::string refusal(const std::string& text) {
  return message_of<InputError>([&] { parse_view(text, "loaf.toml"); });
}

TEST(View, SaysWhatIsWrongInOneLine) {
  EXPECT_TRUE(has(refusal("[camera]\nmargn = 0.1"), "loaf.toml:2: camera: unknown key 'margn', did you mean 'margin'?"));
  EXPECT_TRUE(has(refusal("[lights]"), "unknown key 'lights', did you mean 'light'?"));
  EXPECT_TRUE(has(refusal("[camera]\nmargin = 0.9"), "camera.margin: found 0.9, allowed: a number from 0 to 0.45"));
  EXPECT_TRUE(has(refusal("[[object]]\nmap = \"jet\""), "object.0.map: unknown name 'jet'"));
  EXPECT_TRUE(has(refusal("[[object]]\ncut_normal = [1, 0, 0]"), "a cut needs both cut_point_m and cut_normal"));
  EXPECT_TRUE(has(refusal("[[object]]\ncut_point_m = [1, 0, 0]\ncut_normal = [0, 0, 0]"), "cut_normal: found no direction"));
  EXPECT_TRUE(has(refusal("[[object]]\nrange_low = 3\nrange_high = 3"), "allowed: a rising range"));
  EXPECT_TRUE(has(refusal("[[object]]\nmirrored = \"w\""), "object.0.mirrored: found 'w', allowed: letters x, y and z"));
  EXPECT_TRUE(has(refusal("[camera]\nfit = false"), "fit = false needs eye_m and target_m"));
  EXPECT_TRUE(has(refusal("[camera]\neye_m = [0, 0, 1]"), "need fit = false"));
  EXPECT_TRUE(has(refusal("[camera]\ndirection = [0, 0, 0]"), "camera.direction: found no direction"));
  EXPECT_TRUE(has(refusal("[crust]\nskin = []"), "crust.skin: found no rising degrees"));
  EXPECT_TRUE(has(refusal("[camera"), "no valid TOML"));
  EXPECT_TRUE(has(message_of<InputError>([] { read_view("missing.toml"); }), "missing.toml: no such file"));
}

TEST(View, TakesOverridesAndDefaults) {
  const View view = parse_view("", "loaf.toml", {"camera.margin=0.2"});
  EXPECT_EQ(view.camera.margin, 0.2);
  EXPECT_EQ(view.objects.size(), 1u);
  EXPECT_EQ(view.objects[0].paint, Paint::browning);
}

TEST(View, ExplainsEveryKey) {
  const std::string text = explain_view();
  for (const char* key : {"angle_of_view_deg", "reference_time_s", "crumb_mottle", "cut_normal", "size", "backdrop", "height_m"})
    EXPECT_NE(text.find(key), std::string::npos) << key;
}

/// What of the picture `points` fill, from 0 to 1 from the left and from the top.
struct Filled {
  double left = 1, right = 0, top = 1, bottom = 0;
};
Filled filled(const std::vector<Vec3f>& points, const Camera& camera, double aspect) {
  const Vec3f back = (camera.eye - camera.target).normalized(), right = camera.up.cross(back).normalized(), up = back.cross(right);
  Filled f;
  for (const Vec3f& p : points) {
    const double depth = back.dot(camera.eye - p);
    const double x = 0.5 + right.dot(p - camera.eye) / (2 * depth * camera.half_height * aspect);
    const double y = 0.5 - up.dot(p - camera.eye) / (2 * depth * camera.half_height);
    f = {std::min(f.left, x), std::max(f.right, x), std::min(f.top, y), std::max(f.bottom, y)};
  }
  return f;
}

TEST(FittedCamera, TouchesTheMargins) {
  const std::vector<Vec3f> wide = {{-3, 0, 0}, {2, 0.5f, 0.2f}, {0, 1, 0.1f}, {1, -1, 0.3f}},
                           high = {{0, 0, -3}, {0.1f, 0.2f, 2}, {0, 0.1f, 0}};
  const Filled w = filled(wide, fitted_camera(wide, {0.3f, -1, 0.5f}, 30, 4.0 / 3, 0.1, 0.05), 4.0 / 3);
  EXPECT_NEAR(w.left, 0.1, 1e-4);
  EXPECT_NEAR(w.right, 0.9, 1e-4);
  EXPECT_GE(w.top, 0.1);
  EXPECT_LE(w.bottom, 0.85);
  const Filled h = filled(high, fitted_camera(high, {0.3f, -1, 0.5f}, 30, 4.0 / 3, 0.1, 0.05), 4.0 / 3);
  EXPECT_NEAR(h.top, 0.1, 1e-4);
  EXPECT_NEAR(h.bottom, 0.85, 1e-4);
  EXPECT_NEAR((h.left + h.right) / 2, 0.5, 1e-4);
  EXPECT_NEAR(w.top - 0.1, 0.85 - w.bottom, 1e-4);
  const Filled below_bars = filled(high, fitted_camera(high, {0.3f, -1, 0.5f}, 30, 4.0 / 3, 0.1, 0.05, 0.2), 4.0 / 3);
  EXPECT_NEAR(below_bars.top, 0.3, 1e-4);
  EXPECT_NEAR(below_bars.bottom, 0.85, 1e-4);
}

/// A ball whose upper half has been hot and dry.
class Pictures : public testing::Test {
 protected:
  Pictures() {
    write_run(folder / "run", ball, 3, [](const float* p, double t) {
      return p[2] > 0.1f ? State{150, t < 0.5 ? 1.0f : 0.2f} : State{60, 1.0f};
    });
    view = parse_view("[picture]\nwidth_px = 64\nheight_px = 48\nsamples = 8\n[browning]\nreference_time_s = 1\n[crust]\ngrain = 0\n",
                      "ball.toml");
  }
  Image take(const std::filesystem::path& file, const std::filesystem::path& results = {}, int threads = 1) const {
    Histories histories;
    return take_picture(view, {file}, {results}, histories, threads);
  }
  std::string refusal(const std::filesystem::path& file, const std::filesystem::path& results = {}) const {
    return message_of<InputError>([&] { take(file, results); });
  }
  static double brightness(const Image& image, int x, int y) {
    const auto& p = image.at(x, y);
    return p[0] + p[1] + p[2];
  }
  TemporaryFolder folder;
  const Ball ball{0.1f, 0.02f, 0.1f};
  View view;
};

TEST_F(Pictures, ShowBrownWhereItWasHotAndDry) {
  view.camera.direction = {0, -1, 0};
  view.light.direction = {0, -1, 0};
  for (const ParticleShape shape : {ParticleShape::surface, ParticleShape::spheres}) {
    view.objects[0].particles = shape;
    const Image image = take(folder / "run/frames/0002.hdf");
    EXPECT_LT(brightness(image, 32, 12), 0.75 * brightness(image, 32, 36));
    const Image raw = take(folder / "run/frames/0000.hdf");
    EXPECT_GT(brightness(raw, 32, 12), 0.9 * brightness(raw, 32, 36));
  }
}

TEST_F(Pictures, AreTheSameForAnyNumberOfThreadsAndAsFiles) {
  write_png(folder / "one.png", take(folder / "run/frames/0002.hdf", {}, 1));
  write_png(folder / "two.png", take(folder / "run/frames/0002.hdf", {}, 2));
  EXPECT_EQ(contents(folder / "one.png"), contents(folder / "two.png"));
  const Image back = read_png(folder / "one.png");
  EXPECT_EQ(back.width, 64);
  EXPECT_EQ(back.pixels, take(folder / "run/frames/0002.hdf").pixels);
}

TEST_F(Pictures, OfSurfacesGetBrowningFromTheRun) {
  write_mesh(folder / "surface.hdf", splat_surface(read_particles_of_frame(folder / "run/frames/0002.hdf")));
  EXPECT_EQ(take(folder / "surface.hdf", folder / "run").pixels, take(folder / "run/frames/0002.hdf").pixels);
  EXPECT_TRUE(has(refusal(folder / "surface.hdf"), "give --results"));
}

TEST_F(Pictures, OfACutBallShowCrumbInside) {
  view.objects[0].cut_point_m = Vector3{0, 0, 0.1};
  view.objects[0].cut_normal = Vector3{0, -1, 0};
  view.camera.direction = {0, -1, 0.01};
  view.objects[0].paint = Paint::field;
  for (const ParticleShape shape : {ParticleShape::surface, ParticleShape::spheres}) {
    view.objects[0].particles = shape;
    EXPECT_NO_THROW(take(folder / "run/frames/0002.hdf"));
  }
  view.objects[0].cut_point_m = Vector3{0, 5, 0};
  EXPECT_TRUE(has(refusal(folder / "run/frames/0002.hdf"), "the cut leaves nothing"));
}

TEST_F(Pictures, ShowOneMaterialOfAFrame) {
  write_run(folder / "two", ball, 1, [](const float* p, double) { return State{20, 1, p[0] > 0.03f ? 1 : 0}; });
  const std::filesystem::path frame = folder / "two/frames/0000.hdf";
  Histories histories;
  const auto extent = [&](std::optional<int> material) {
    view.objects[0].material = material;
    const PictureObject object = load_object(frame, {}, view, view.objects[0], histories, 1);
    float low = 1, high = -1;
    for (const Vec3f& p : object.meshes[0].vertices) {
      low = std::min(low, p.x());
      high = std::max(high, p.x());
    }
    return std::array{low, high};
  };
  const float half_a_spacing = 0.01f;
  EXPECT_LT(extent({})[0], -0.09f);
  EXPECT_GT(extent({})[1], 0.09f);
  EXPECT_NEAR(extent(0)[1], 0.03f, half_a_spacing + 0.01f);
  EXPECT_NEAR(extent(1)[0], 0.03f, half_a_spacing + 0.01f);
  EXPECT_GT(extent(1)[1], 0.09f);
  view.objects[0].material = 2;
  EXPECT_TRUE(has(refusal(frame), "material: found no particle of number 2"));
  write_mesh(folder / "surface.hdf", splat_surface(read_particles_of_frame(frame)));
  EXPECT_TRUE(has(refusal(folder / "surface.hdf", folder / "two"), "material: has no particles of materials"));
}

TEST_F(Pictures, PaintedByAFieldSayWhatTheirColoursStandFor) {
  view.picture.width_px = 320, view.picture.height_px = 240, view.picture.samples = 1;
  view.objects[0].paint = Paint::field;
  for (const ParticleShape shape : {ParticleShape::surface, ParticleShape::spheres}) {
    view.objects[0].particles = shape;
    Histories histories;
    const PictureObject object = load_object(folder / "run/frames/0002.hdf", {}, view, view.objects[0], histories, 1);
    ASSERT_TRUE(object.bar);
    EXPECT_EQ(object.bar->map, ColourMap::viridis);
    EXPECT_NEAR(object.bar->low, 60, 1e-9);
    EXPECT_NEAR(object.bar->high, 150, 1e-9);
    EXPECT_EQ(object.bar->label, "temperature [C]");
    EXPECT_EQ(object.time_s, 2);
  }
  view.objects[0].range_high = 200;
  const Image with = take(folder / "run/frames/0002.hdf");
  // the bar's ends, in the upper left corner
  EXPECT_EQ(with.at(16, 10), pixel(map_colour(ColourMap::viridis, 0.5f / 128)));
  EXPECT_EQ(with.at(143, 10), pixel(map_colour(ColourMap::viridis, 127.5f / 128)));
  view.picture.colour_bar = false;
  const Image without = take(folder / "run/frames/0002.hdf");
  EXPECT_NE(without.at(16, 10), with.at(16, 10));
  view.picture.colour_bar = true;
  view.objects[0].paint = Paint::constant;
  EXPECT_NE(take(folder / "run/frames/0002.hdf").at(16, 10), with.at(16, 10));
}

TEST_F(Pictures, LeaveRoomForOneBarOfAllObjectsWithTheSameColours) {
  view.picture.width_px = 320, view.picture.height_px = 240, view.picture.samples = 1;
  view.objects[0].paint = Paint::field;
  view.objects[0].range_low = 0, view.objects[0].range_high = 200;
  view.objects.push_back(view.objects[0]);
  const auto top_and_image = [&] {
    Histories histories;
    Composition composition = compose(view, {folder / "run/frames/0000.hdf", folder / "run/frames/0002.hdf"}, {{}, {}}, histories, 1);
    const std::vector<Vec3f> points = points_of(composition);
    const Stage stage = set_stage(view, points);
    return std::pair(filled(points, stage.camera, 4.0 / 3).top, take_picture(view, std::move(composition), stage, 1));
  };
  const auto blue = pixel(map_colour(ColourMap::viridis, 0.5f / 128));
  constexpr int k_first = 10, k_second = 40;  // rows of the bars
  const auto [top, one_bar] = top_and_image();
  EXPECT_GT(240 * top, 8 + 26) << "below the bar";
  EXPECT_EQ(one_bar.at(16, k_first), blue);
  EXPECT_NE(one_bar.at(16, k_second), blue);
  view.objects[1].range_high = 150;
  const auto [lower, two_bars] = top_and_image();
  EXPECT_GT(240 * lower, 8 + 26 + 30);
  EXPECT_EQ(two_bars.at(16, k_second), blue);
}

TEST_F(Pictures, OfARunWithoutHeatSayHowToPaintThem) {
  std::filesystem::create_directories(folder / "cold/frames");
  write_frame(folder / "cold/frames/0000.hdf", 0, {ball.positions, {{"id", "", ball.ids, 1}, {"volume", "m^3", ball.volumes, 1}}});
  write_series(folder / "cold/frames.hdf.series", {{"frames/0000.hdf", 0}});
  EXPECT_TRUE(has(refusal(folder / "cold/frames/0000.hdf"), "a run without heat does not brown: set paint = \"constant\" or \"field\""));
}

TEST_F(Pictures, CompleteWhatWasRunBetweenMirrors) {
  Ball quarter = ball;
  quarter.positions.clear();
  for (std::size_t i = 0; i < ball.positions.size(); i += 3)
    if (ball.positions[i] >= 0 && ball.positions[i + 1] >= 0)
      quarter.positions.insert(quarter.positions.end(), &ball.positions[i], &ball.positions[i] + 3);
  quarter.volumes.resize(quarter.positions.size() / 3);
  quarter.ids.resize(quarter.volumes.size());
  write_run(folder / "quarter", quarter, 1, [](const float*, double) { return State{20, 1}; });
  const std::filesystem::path frame = folder / "quarter/frames/0000.hdf";
  Histories histories;
  const auto lowest = [&](const char* mirrored) {
    view.objects[0].mirrored = mirrored;
    Vec3f low = Vec3f::Ones();
    const PictureObject object = load_object(frame, {}, view, view.objects[0], histories, 1);
    for (const Vec3f& p : object.meshes[0].vertices) low = low.cwiseMin(p);
    return low;
  };
  EXPECT_GT(lowest("").head(2).minCoeff(), -0.02f);
  EXPECT_LT(lowest("x").x(), -0.09f);
  EXPECT_GT(lowest("x").y(), -0.02f);
  EXPECT_LT(lowest("xy").head(2).maxCoeff(), -0.09f);
}

TEST_F(Pictures, OfWrongFilesAreRefusedInOneLine) {
  const std::filesystem::path frame = folder / "run/frames/0002.hdf";
  EXPECT_TRUE(has(refusal(folder / "missing.hdf"), "missing.hdf"));
  put(folder / "text.hdf", "no hdf");
  EXPECT_TRUE(has(refusal(folder / "text.hdf"), "text.hdf"));
  std::filesystem::copy(frame, folder / "alone.hdf");
  EXPECT_TRUE(has(refusal(folder / "alone.hdf"), "give --results"));
  EXPECT_TRUE(has(refusal(frame, folder / "nowhere"), "no run is here"));
  // frames of another run
  write_run(folder / "other", Ball(0.1f, 0.02f, 3), 3, [](const float*, double) { return State{20, 1}; });
  write_mesh(folder / "surface.hdf", splat_surface(read_particles_of_frame(frame)));
  EXPECT_TRUE(has(refusal(folder / "surface.hdf", folder / "other"), "it shows another run, or another time"));
  view.objects[0].paint = Paint::field;
  view.objects[0].field = "temperatur";
  EXPECT_TRUE(has(refusal(frame), "has no field 'temperatur'; did you mean 'temperature'?"));
  view.objects.emplace_back();
  EXPECT_TRUE(has(refusal(frame), "found 2 [[object]] for 1 files"));
}

TEST(Images, AreWrittenWholeOrRefused) {
  const Image image(8, 4, Colour(1, 0, 0));
  EXPECT_THROW(write_png("/nonexistent/x.png", image), OutputError);
  EXPECT_THROW(read_png("/nonexistent/x.png"), InputError);
}

TEST(Images, TextIsDrawnAroundItsMiddle) {
  for (const Anchor anchor : {Anchor::left, Anchor::centre, Anchor::right}) {
    Image image(200, 60, Colour::Ones());
    draw_text(image, "HHH", 100, 30, 30, anchor, Colour::Zero());
    double sum = 0, x_sum = 0, y_sum = 0;
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 200; ++x) {
        const double ink = 255.0 - image.at(x, y)[0];
        sum += ink;
        x_sum += ink * x;
        y_sum += ink * y;
      }
    ASSERT_GT(sum, 255 * 50);
    EXPECT_NEAR(y_sum / sum, 30, 1.5);
    const double shift = x_sum / sum - 100;
    if (anchor == Anchor::left) {
      EXPECT_GT(shift, 10);
    }
    if (anchor == Anchor::right) {
      EXPECT_LT(shift, -10);
    }
    if (anchor == Anchor::centre) {
      EXPECT_NEAR(shift, 0, 2);
    }
  }
}

/// A label that is wider than its bar, in a corner of a narrow picture, once lost its first letter.
TEST(Images, TextNearABorderIsWhole) {
  const auto ink = [](Anchor anchor, int x) {
    Image image(200, 60, Colour::Ones());
    draw_text(image, "temperature", x, 30, 20, anchor, Colour::Zero());
    double sum = 0;
    for (const auto& p : image.pixels) sum += 255.0 - p[0];
    return sum;
  };
  const double whole = ink(Anchor::centre, 100);
  EXPECT_EQ(ink(Anchor::centre, 20), whole);
  EXPECT_EQ(ink(Anchor::centre, 190), whole);
  EXPECT_EQ(ink(Anchor::right, 10), whole);
  EXPECT_EQ(ink(Anchor::left, 150), whole);
}

/// Letters that hang below the line, or start left of their place, must not move it.
TEST(Images, TextKeepsItsLine) {
  const auto lowest_of_h = [](const std::string& text) {
    Image image(300, 80, Colour::Ones());
    draw_text(image, text, 10, 40, 32, Anchor::left, Colour::Zero());
    int lowest = 0;
    for (int y = 0; y < 80; ++y)
      for (int x = 0; x < 20; ++x)
        if (image.at(x, y)[0] < 128) lowest = y;
    return lowest;
  };
  for (const char* text : {"Hg", "H, j", "H [x]", "HAy"}) EXPECT_EQ(lowest_of_h(text), lowest_of_h("H")) << text;
  Image image(300, 80, Colour::Ones());
  for (const char* text : {"81.6", "j", "A", "y = x", "Tj,;"})
    EXPECT_NO_THROW(draw_text(image, text, 150, 40, 12, Anchor::centre, Colour::Zero()));
}

}  // namespace
}  // namespace bake
