// SPDX-License-Identifier: MIT
// Photo-like pictures: a small path tracer on Embree's ray queries. Needs no display.
//
// Surfaces are diffuse under a rough dielectric coat, or translucent: the light that the camera sees has wandered about inside. Light
// comes from one square lamp (sampled directly, not seen by rays) and from the sky (met by rays that leave the scene). The picture is an
// unbiased estimate but for the bound on bounces, and the same for any number of threads: every path has its own random numbers, and the
// tree over the scene is built by one thread.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "analysis/image/colour.h"
#include "analysis/pictures/exposure.h"

namespace bake {

using Vec3f = Eigen::Vector3f;  ///< a point or direction of a picture [m]

/// Fine structure that no mesh resolves, as noise in the object's texture coordinates. It serves the look and is no data.
struct Grain {
  float size = 0;      ///< of the largest bumps [m]; 0: none
  float bump = 0;      ///< how much normals are tilted, about the slope of the bumps
  float mottle = 0;    ///< how much the albedo varies, relative
  bool pores = false;  ///< pits in a plane, dark at their bottoms, instead of bumps
};

/// How an object reflects light.
struct Gloss {
  float coat = 0;         ///< share of the surface that is coated, 0 to 1
  float roughness = 0.5;  ///< of the coat, 0 (mirror; at least 0.05 is used) to 1
  float depth = 0;        ///< mean free path of light inside, where the camera sees the surface [m]; 0: opaque. Surfaces must be closed
};

struct TriangleObject {
  std::vector<Vec3f> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::array<Vec3f, 3>> normals;  ///< at the corners of each triangle; empty: flat
  std::vector<Colour> albedos;                ///< linear, one per vertex
  std::vector<Vec3f> texture;                 ///< texture coordinates, one per vertex; empty: the vertices themselves
  Gloss gloss;
  Grain grain;
};

struct SphereObject {
  std::vector<Eigen::Vector4f> spheres;  ///< x, y, z, radius
  std::vector<Colour> albedos;           ///< linear, one per sphere
  Gloss gloss;
};

/// A square lamp that shines to one side.
struct Lamp {
  Vec3f centre = {0, 0, 1};
  Vec3f direction = {0, 0, -1};  ///< in which it shines, of length 1
  float half_width = 0;          ///< [m]; 0: there is no lamp
  Colour radiance = {0, 0, 0};
};

struct Sky {
  Colour above = {0, 0, 0};     ///< radiance from straight above
  Colour below = {0, 0, 0};     ///< from straight below; linear in the height of the direction between them
  Colour backdrop = {0, 0, 0};  ///< what the camera sees where nothing is
};

struct Camera {
  Vec3f eye = {0, -1, 0};
  Vec3f target = {0, 0, 0};
  Vec3f up = {0, 0, 1};
  float half_height = 0.25f;  ///< tangent of half the vertical field of view
};

class PathTracer {
 public:
  PathTracer();
  ~PathTracer();
  PathTracer(const PathTracer&) = delete;
  PathTracer& operator=(const PathTracer&) = delete;

  /// Throws std::invalid_argument if the lengths of an object's lists do not fit.
  void add(TriangleObject object);
  void add(SphereObject object);
  Lamp lamp;
  Sky sky;

  /// Renders the picture. The first thread calls `progress(share done)` now and then.
  Radiance expose(const Camera& camera, const Exposure& exposure, const std::function<void(double share)>& progress = {});

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace bake
