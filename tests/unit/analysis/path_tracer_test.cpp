// SPDX-License-Identifier: MIT
// The path tracer against light that is known on paper.
#include "analysis/pictures/path_tracer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <set>

namespace bake {
namespace {

SphereObject sphere(float radius, float albedo, const Gloss& gloss = {}) {
  return {{Eigen::Vector4f(0, 0, 0, radius)}, {Colour::Constant(albedo)}, gloss};
}

Camera camera_at(float distance, float half_height) { return {{0, -distance, 0}, {0, 0, 0}, {0, 0, 1}, half_height}; }

Sky furnace() { return {Colour::Ones(), Colour::Ones(), Colour::Ones()}; }

/// Mean radiance (first channel) of all pixels.
double mean(const Radiance& picture) {
  double sum = 0;
  for (const Colour& pixel : picture.pixels) sum += pixel[0];
  return sum / static_cast<double>(picture.pixels.size());
}

/// A square [-half, half]^2 at z = 0.
TriangleObject square(float half, float albedo) {
  TriangleObject object;
  object.vertices = {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
  object.triangles = {{0, 1, 2}, {0, 2, 3}};
  object.albedos.assign(4, Colour::Constant(albedo));
  return object;
}

/// A small patch around the origin, seen from above.
Camera looking_down() { return {{0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.001f}; }

TEST(PathTracer, WhiteSphereInAWhiteFurnaceCannotBeSeen) {
  PathTracer tracer;
  tracer.sky = furnace();
  tracer.add(sphere(1, 1));
  for (const Colour& pixel : tracer.expose(camera_at(4, 0.4f), {16, 16, 4, 1}).pixels) EXPECT_NEAR(pixel[0], 1, 1e-5);
}

/// ... and is done after the first batch, but for its silhouette, which is no noise either.
TEST(PathTracer, FurnaceNeedsFewPaths) {
  PathTracer tracer;
  tracer.sky = furnace();
  tracer.add(sphere(1, 1));
  Exposure exposure{32, 32, 64, 1};
  exposure.noise = 0.001f;
  const Radiance picture = tracer.expose(camera_at(4, 0.4f), exposure);
  EXPECT_EQ(std::set(picture.paths.begin(), picture.paths.end()), std::set{16});
}

TEST(PathTracer, ConvexBodyInAFurnaceShowsItsAlbedo) {
  PathTracer tracer;
  tracer.sky = furnace();
  tracer.add(sphere(1, 0.3f));
  EXPECT_NEAR(mean(tracer.expose(camera_at(4, 0.05f), {8, 8, 16, 1})), 0.3, 1e-5);
}

/// A coat moves light between the lobes; it must not make any. It loses what facets would pass on to other facets: little.
TEST(PathTracer, CoatNeitherMakesNorLosesMuchLight) {
  for (const float roughness : {0.1f, 0.3f, 0.6f, 1.0f}) {
    PathTracer tracer;
    tracer.sky = furnace();
    tracer.add(sphere(1, 1, {1, roughness}));
    const double seen = mean(tracer.expose(camera_at(4, 0.18f), {32, 32, 256, 1}));
    EXPECT_LT(seen, 1.005) << roughness;
    EXPECT_GT(seen, 0.96) << roughness;
  }
}

/// What is large beside its light's free paths shows the albedo that was asked for.
TEST(PathTracer, TranslucentBodyShowsItsAlbedo) {
  for (const float albedo : {0.2f, 0.5f, 0.8f}) {
    PathTracer tracer;
    tracer.sky = furnace();
    tracer.add(sphere(1, albedo, {0, 0.5f, 0.01f}));
    EXPECT_NEAR(mean(tracer.expose(camera_at(4, 0.05f), {16, 16, 64, 1})), albedo, 0.03) << albedo;
  }
}

/// An octahedron. Of each scattering the fit lets a thousandth be absorbed inside a white body, and light is scattered a few times.
TEST(PathTracer, WhiteTranslucentBodyLosesNoLight) {
  TriangleObject body;
  body.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (const std::uint32_t x : {0u, 1u})
    for (const std::uint32_t y : {2u, 3u})
      for (const std::uint32_t z : {4u, 5u}) body.triangles.push_back({x, y, z});
  body.albedos.assign(6, Colour::Ones());
  body.gloss.depth = 0.2f;
  PathTracer tracer;
  tracer.sky = furnace();
  tracer.add(std::move(body));
  EXPECT_NEAR(mean(tracer.expose(camera_at(4, 0.05f), {16, 16, 64, 1})), 1, 0.004);
}

/// A ball with a lamp behind it: the side that is seen of an opaque one is dark.
TEST(PathTracer, LightPassesThroughATranslucentBody) {
  const auto seen_through = [](float depth) {
    PathTracer tracer;
    tracer.add(sphere(0.5f, 0.9f, {0, 0.5f, depth}));
    tracer.lamp = {{0, 3, 0}, {0, -1, 0}, 0.1f, Colour::Constant(100)};
    return mean(tracer.expose(camera_at(4, 0.03f), {8, 8, 64, 1}));
  };
  EXPECT_EQ(seen_through(0), 0);
  EXPECT_GT(seen_through(0.2f), 3 * seen_through(0.02f));
}

/// No light is lost however often it goes to and fro between body and floor.
TEST(PathTracer, WhiteBodyOnAWhiteFloorInAFurnaceCannotBeSeen) {
  PathTracer tracer;
  tracer.sky = furnace();
  tracer.add(square(50, 1));
  SphereObject ball = sphere(1, 1);
  ball.spheres[0].z() = 1;
  tracer.add(std::move(ball));
  Exposure exposure{16, 16, 64, 1};
  exposure.most_bounces = 200;
  const Camera camera{{0, -6, 3}, {0, 0, 0.5f}, {0, 0, 1}, 0.3f};
  EXPECT_NEAR(mean(tracer.expose(camera, exposure)), 1, 0.01);
}

/// A parallel square lamp of half width b at height h above the point: E = 4 L * 2 x / (2 sqrt(1 + x^2)) atan(x / sqrt(1 + x^2)), x = b / h
/// (view factor of a rectangle's corner, e.g. Howell's catalogue B-3, four times). A floor of albedo a shows a E / pi.
TEST(PathTracer, LampLightsTheFloorBelowItAsTheViewFactorSays) {
  const double half = 1.2, height = 2, albedo = 0.6, x = half / height, root = std::sqrt(1 + x * x);
  const double factor = 4 / (2 * std::numbers::pi) * 2 * (x / root) * std::atan(x / root);
  PathTracer tracer;
  tracer.add(square(50, static_cast<float>(albedo)));
  tracer.lamp = {{0, 0, static_cast<float>(height)}, {0, 0, -1}, static_cast<float>(half), Colour::Constant(3)};
  const double seen = mean(tracer.expose(looking_down(), {16, 16, 256, 1}));
  EXPECT_NEAR(seen, albedo * 3 * factor, 0.003 * albedo * 3 * factor);
}

TEST(PathTracer, BodyBetweenLampAndFloorCastsAShadow) {
  PathTracer tracer;
  tracer.add(square(50, 1));
  SphereObject ball = sphere(0.5f, 0);
  ball.spheres[0].z() = 1;
  tracer.add(std::move(ball));
  tracer.lamp = {{0, 0, 2}, {0, 0, -1}, 0.1f, Colour::Constant(3)};
  const Camera from_below{{0.3f, 0, 0.2f}, {0, 0, 0}, {0, 1, 0}, 0.01f};
  EXPECT_EQ(mean(tracer.expose(from_below, {4, 4, 16, 1})), 0);
}

/// A sphere of radius r at distance d is seen under the angle asin(r/d): a disc of radius r / sqrt(d^2 - r^2) in the image plane.
TEST(PathTracer, SphereCoversItsSilhouette) {
  PathTracer tracer;
  tracer.sky = {Colour::Zero(), Colour::Zero(), Colour::Ones()};
  tracer.add(sphere(1, 0));
  const double half = 0.4, radius = 1 / std::sqrt(16.0 - 1);
  const double covered = 1 - mean(tracer.expose(camera_at(4, static_cast<float>(half)), {64, 64, 16, 1}));
  EXPECT_NEAR(covered, std::numbers::pi * radius * radius / (4 * half * half), 2e-3);
}

TEST(PathTracer, SameBitsForAnyNumberOfThreads) {
  const auto picture = [](int threads) {
    PathTracer tracer;
    tracer.sky = {Colour::Constant(0.5f), Colour::Zero(), Colour::Ones()};
    tracer.lamp = {{-2, -2, 4}, Vec3f(2, 2, -4).normalized(), 1, Colour::Constant(8)};
    tracer.add(square(50, 0.7f));
    for (int i = 0; i < 40; ++i) {
      SphereObject ball = sphere(0.3f, 0.6f, {0.5f, 0.4f});
      ball.spheres[0].head<3>() = Vec3f(0.21f * static_cast<float>(i % 7) - 0.6f, 0.17f * static_cast<float>(i % 5) - 0.3f, 0.3f);
      tracer.add(std::move(ball));
    }
    Exposure exposure{96, 72, 48, threads};
    exposure.noise = 0.012f;
    return tracer.expose({{0, -4, 2}, {0, 0, 0.2f}, {0, 0, 1}, 0.25f}, exposure);
  };
  const Radiance one = picture(1);
  EXPECT_GT(std::set(one.paths.begin(), one.paths.end()).size(), 1u);
  for (const int threads : {2, 5}) {
    const Radiance other = picture(threads);
    EXPECT_EQ(std::memcmp(one.pixels.data(), other.pixels.data(), one.pixels.size() * sizeof one.pixels[0]), 0);
  }
}

/// Smooth normals must not depend on how triangles are wound.
TEST(PathTracer, InsideOutTrianglesLookTheSame) {
  const auto seen = [](bool inside_out) {
    PathTracer tracer;
    tracer.lamp = {{0, 0, 2}, {0, 0, -1}, 0.5f, Colour::Ones()};
    TriangleObject floor = square(50, 0.5f);
    floor.normals.assign(2, {Vec3f(0, 0, 1), Vec3f(0, 0, 1), Vec3f(0, 0, 1)});
    if (inside_out)
      for (auto& t : floor.triangles) std::swap(t[1], t[2]);
    tracer.add(std::move(floor));
    return mean(tracer.expose(looking_down(), {4, 4, 16, 1}));
  };
  EXPECT_GT(seen(false), 0.01);
  EXPECT_NEAR(seen(true), seen(false), 0.01 * seen(false));
}

TEST(PathTracer, RefusesListsOfOtherLengths) {
  PathTracer tracer;
  TriangleObject object = square(1, 1);
  object.albedos.pop_back();
  EXPECT_THROW(tracer.add(object), std::invalid_argument);
  object = square(1, 1);
  object.triangles[1][2] = 4;
  EXPECT_THROW(tracer.add(object), std::invalid_argument);
  SphereObject spheres = sphere(1, 1);
  spheres.albedos.clear();
  EXPECT_THROW(tracer.add(spheres), std::invalid_argument);
}

}  // namespace
}  // namespace bake
