// SPDX-License-Identifier: MIT
#include "analysis/pictures/path_tracer.h"

#if BAKE_EMBREE_VERSION >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <stdexcept>
#include <variant>

#include "analysis/pictures/noise.h"
#include "analysis/pictures/samples.h"

namespace bake {
namespace {

constexpr float k_pi = std::numbers::pi_v<float>;
constexpr float k_far = 1e30f;

#if BAKE_EMBREE_VERSION < 4
// Embree 4 has these without the context, which older versions ask for.

void rtcIntersect1(RTCScene scene, RTCRayHit* query) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  ::rtcIntersect1(scene, &context, query);
}

void rtcOccluded1(RTCScene scene, RTCRay* ray) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  ::rtcOccluded1(scene, &context, ray);
}
#endif

/// Two directions that are at right angles to `n` (Duff et al. 2017).
std::array<Vec3f, 2> tangents(const Vec3f& n) {
  const float sign = std::copysign(1.0f, n.z()), a = -1 / (sign + n.z()), b = n.x() * n.y() * a;
  return {Vec3f(1 + sign * n.x() * n.x() * a, sign * b, -sign * n.x()), Vec3f(b, sign + n.y() * n.y() * a, -n.y())};
}

/// Direction about `n` with density cosine / pi.
Vec3f cosine_direction(const Vec3f& n, Sample2 s) {
  const auto [t, b] = tangents(n);
  const float r = std::sqrt(s.u), angle = 2 * k_pi * s.v;
  return (r * std::cos(angle) * t + r * std::sin(angle) * b + std::sqrt(std::max(0.0f, 1 - s.u)) * n).normalized();
}

/// A rough dielectric coat over a diffuse ground. `coat` scales the coat's reflectance.
class Reflection {
 public:
  Reflection(const Colour& albedo, const Gloss& gloss) : albedo_(albedo), coat_(gloss.coat) {
    const float alpha = std::pow(std::max(gloss.roughness, 0.05f), 2.0f);
    alpha2_ = alpha * alpha;
  }

  /// The reflection function times the cosine of `out`, for directions on the side of n. cos_*: cosines to the normal.
  Colour towards(const Vec3f& n, const Vec3f& in, const Vec3f& out) const {
    const float cos_in = std::max(n.dot(in), 1e-4f), cos_out = n.dot(out);
    if (cos_out <= 0) return Colour::Zero();
    const Colour diffuse = albedo_ * (below_coat(cos_in) * below_coat(cos_out) / (k_pi * (1 - coat_ * k_mean_fresnel)));
    if (coat_ == 0) return diffuse * cos_out;
    const Vec3f h = (in + out).normalized();
    const float cos_h = n.dot(h), k = cos_h * cos_h * (alpha2_ - 1) + 1;
    const float density = alpha2_ / (k_pi * k * k);
    const float specular = coat_ * fresnel(in.dot(h)) * density * joint_masking(cos_in, cos_out) / (4 * cos_in * cos_out);
    return (diffuse + Colour::Constant(specular)) * cos_out;
  }

  /// A direction to go on, and the share of the light that comes from there: towards() over the density of the choice.
  struct Bounce {
    Vec3f out;
    Colour weight;
  };
  Bounce bounce(const Vec3f& n, const Vec3f& in, Sample2 s, float choice) const {
    const float chance = chance_of_mirror(n, in);
    if (choice < chance) return mirror(n, in, s, 1 / chance);
    const Vec3f out = cosine_direction(n, s);
    const float below = share_below(n, in) * below_coat(n.dot(out)) / (1 - coat_ * k_mean_fresnel);
    return {out, albedo_ * (below / (1 - chance))};
  }
  /// How often a bounce is one of the coat.
  float chance_of_mirror(const Vec3f& n, const Vec3f& in) const {
    return coat_ > 0 ? std::clamp(2 * coat_ * fresnel(n.dot(in)), 0.1f, 0.7f) : 0;
  }
  /// What the coat lets through.
  float share_below(const Vec3f& n, const Vec3f& in) const { return below_coat(std::max(n.dot(in), 1e-4f)); }

 private:
  static constexpr float k_normal_fresnel = 0.04f;                                         ///< refractive index 1.5
  static constexpr float k_mean_fresnel = k_normal_fresnel + (1 - k_normal_fresnel) / 21;  ///< over the cosine-weighted hemisphere

  static float fresnel(float cosine) {  // Schlick's approximation
    const float m = 1 - std::clamp(cosine, 0.0f, 1.0f), m2 = m * m;
    return k_normal_fresnel + (1 - k_normal_fresnel) * m2 * m2 * m;
  }
  float below_coat(float cosine) const { return 1 - coat_ * fresnel(cosine); }
  float lambda(float cosine) const { return (std::sqrt(1 + alpha2_ * (1 / (cosine * cosine) - 1)) - 1) / 2; }
  float joint_masking(float a, float b) const { return 1 / (1 + lambda(a) + lambda(b)); }

  /// A facet that is visible from `in` (Heitz 2018), with density D G1(in) (in.h) / cos_in.
  Vec3f visible_facet(const Vec3f& n, const Vec3f& in, Sample2 s) const {
    const auto [t, b] = tangents(n);
    const float alpha = std::sqrt(alpha2_);
    const Vec3f v = Vec3f(alpha * t.dot(in), alpha * b.dot(in), n.dot(in)).normalized();
    const float flat = v.x() * v.x() + v.y() * v.y();
    const Vec3f t1 = flat > 1e-12f ? Vec3f(-v.y(), v.x(), 0) / std::sqrt(flat) : Vec3f(1, 0, 0);
    const Vec3f t2 = v.cross(t1);
    const float r = std::sqrt(s.u), angle = 2 * k_pi * s.v, p1 = r * std::cos(angle), share = (1 + v.z()) / 2;
    const float p2 = std::lerp(std::sqrt(std::max(0.0f, 1 - p1 * p1)), r * std::sin(angle), share);
    const Vec3f h = p1 * t1 + p2 * t2 + std::sqrt(std::max(0.0f, 1 - p1 * p1 - p2 * p2)) * v;
    return (alpha * h.x() * t + alpha * h.y() * b + std::max(0.0f, h.z()) * n).normalized();
  }
  Bounce mirror(const Vec3f& n, const Vec3f& in, Sample2 s, float factor) const {
    const Vec3f h = visible_facet(n, in, s);
    const Vec3f out = 2 * in.dot(h) * h - in;
    const float cos_in = std::max(n.dot(in), 1e-4f), cos_out = n.dot(out);
    if (cos_out <= 0) return {out, Colour::Zero()};
    const float visible = joint_masking(cos_in, cos_out) * (1 + lambda(cos_in));  // G2 / G1
    return {out, Colour::Constant(coat_ * fresnel(in.dot(h)) * visible * factor)};
  }

  Colour albedo_;
  float coat_;
  float alpha2_;
};

/// Albedo of the scatterings inside half a space that shows `albedo` when they go equally to all sides (fit of Chiang, Kutz and Burley
/// 2016, "Practical and controllable subsurface scattering for production path tracing").
Colour albedo_inside(const Colour& albedo) {
  const auto a = albedo.array();
  return 1 - (a * (-5.09406f + a * (2.61188f - 4.31805f * a))).exp();
}

/// Where a ray ends, with all that is needed to go on.
struct Hit {
  Vec3f at;
  Vec3f face_normal;  ///< towards where the ray came from
  Vec3f normal;       ///< smooth
  Colour albedo;
  Gloss gloss;
  bool seen = true;  ///< by the camera; grain is not worth its time where light only passes on
};

/// Height of the grain at a point in units of its size, and its slope: bumps up and down, or pits in a plane.
Noise relief(const Grain& grain, const Vec3f& q) {
  Noise height = fractal_noise(q, 3);
  if (!grain.pores) return height;
  constexpr float k_plane = -0.05f;  ///< pits are what lies below
  if (height.value >= k_plane) return {0, Vec3f::Zero()};
  height.value -= k_plane;
  return height;
}

/// Normal tilted and albedo varied by the object's grain at texture coordinates `p`.
void roughen(Hit& hit, const Grain& grain, const Vec3f& p) {
  const Vec3f q = p / grain.size;
  const auto [height, slope] = relief(grain, q);
  const float tone = grain.pores ? 2 * height : fractal_noise(q * 0.37f, 3).value;
  hit.albedo *= std::clamp(1 + grain.mottle * tone, 0.0f, 1.2f);
  hit.normal = (hit.normal - grain.bump * (slope - slope.dot(hit.normal) * hit.normal)).normalized();
}

template <class T>
T across(const T& a, const T& b, const T& c, float u, float v) {
  return a * (1 - u - v) + b * u + c * v;
}

using Object = std::variant<TriangleObject, SphereObject>;

void check_lengths(const TriangleObject& object) {
  const auto vertices = object.vertices.size();
  const bool fits = object.albedos.size() == vertices && (object.normals.empty() || object.normals.size() == object.triangles.size()) &&
                    (object.texture.empty() || object.texture.size() == vertices);
  const bool inside = std::all_of(object.triangles.begin(), object.triangles.end(),
                                  [&](const auto& t) { return std::all_of(t.begin(), t.end(), [&](auto v) { return v < vertices; }); });
  if (!fits || !inside) throw std::invalid_argument("a picture's mesh has lists of other lengths than its vertices and triangles");
}

}  // namespace

/// Embree's scene and the objects by their number in it.
struct PathTracer::Scene {
  RTCDevice device = rtcNewDevice("threads=1");
  RTCScene scene = rtcNewScene(device);
  std::vector<Object> objects;
  const Lamp* lamp = nullptr;
  const Sky* sky = nullptr;
  float clearance = 1e-4f;  ///< of a new ray from the surface that it leaves [m]

  Scene() { rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST); }
  ~Scene() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  void attach(RTCGeometry geometry) {
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
  }
  void commit();

  bool intersect(const Vec3f& from, const Vec3f& towards, Hit& hit, float farthest = k_far) const;
  bool visible(const Vec3f& from, const Vec3f& towards, float distance) const;
  void fill_hit(const TriangleObject& object, const RTCHit& found, Hit& hit) const;
  void fill_hit(const SphereObject& object, const RTCHit& found, Hit& hit) const;

  Colour sky_light(const Vec3f& direction) const { return sky->below + (direction.z() + 1) / 2 * (sky->above - sky->below); }
  Colour lamp_light(const Hit& hit, const Reflection& reflection, const Vec3f& in, Sample2 s) const;
  bool wander(Hit& hit, Colour& share, PathSamples& samples) const;
  Colour path(Vec3f from, Vec3f towards, int most_bounces, PathSamples& samples) const;
};

void PathTracer::Scene::commit() {
  rtcCommitScene(scene);
  RTCBounds box{};
  rtcGetSceneBounds(scene, &box);
  const Vec3f size(box.upper_x - box.lower_x, box.upper_y - box.lower_y, box.upper_z - box.lower_z);
  if (!objects.empty()) clearance = 1e-6f * size.norm();
}

void PathTracer::Scene::fill_hit(const TriangleObject& object, const RTCHit& found, Hit& hit) const {
  const auto& [a, b, c] = object.triangles[found.primID];
  hit.albedo = across(object.albedos[a], object.albedos[b], object.albedos[c], found.u, found.v);
  if (!object.normals.empty()) {
    const auto& n = object.normals[found.primID];
    hit.normal = across(n[0], n[1], n[2], found.u, found.v).normalized();
  }
  if (object.grain.size <= 0 || !hit.seen) return;
  const auto& where = object.texture.empty() ? object.vertices : object.texture;
  roughen(hit, object.grain, across(where[a], where[b], where[c], found.u, found.v));
}

void PathTracer::Scene::fill_hit(const SphereObject& object, const RTCHit& found, Hit& hit) const {
  hit.albedo = object.albedos[found.primID];
}

bool PathTracer::Scene::intersect(const Vec3f& from, const Vec3f& towards, Hit& hit, float farthest) const {
  RTCRayHit query{};
  query.ray = {from.x(), from.y(), from.z(), 0, towards.x(), towards.y(), towards.z(), 0, farthest, ~0u, 0, 0};
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
  hit.face_normal = Vec3f(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z).normalized();
  hit.normal = hit.face_normal;
  std::visit(
      [&](const auto& object) {
        hit.gloss = object.gloss;
        fill_hit(object, query.hit, hit);
      },
      objects[query.hit.geomID]);
  if (hit.face_normal.dot(towards) > 0) hit.face_normal = -hit.face_normal;
  if (hit.normal.dot(hit.face_normal) < 0) hit.normal = -hit.normal;  // seen from behind, or triangles turned inside out
  hit.at = from + query.ray.tfar * towards + clearance * hit.face_normal;
  return true;
}

bool PathTracer::Scene::visible(const Vec3f& from, const Vec3f& towards, float distance) const {
  RTCRay ray{from.x(), from.y(), from.z(), 0, towards.x(), towards.y(), towards.z(), 0, distance, ~0u, 0, 0};
  rtcOccluded1(scene, &ray);
  return ray.tfar > 0;
}

/// Light that comes straight from a point of the lamp and is reflected towards `in`.
Colour PathTracer::Scene::lamp_light(const Hit& hit, const Reflection& reflection, const Vec3f& in, Sample2 s) const {
  if (lamp->half_width <= 0) return Colour::Zero();
  const auto [t, b] = tangents(lamp->direction);
  const Vec3f point = lamp->centre + lamp->half_width * ((2 * s.u - 1) * t + (2 * s.v - 1) * b);
  const Vec3f way = point - hit.at;
  const float distance2 = way.squaredNorm(), distance = std::sqrt(distance2);
  const Vec3f out = way / distance;
  const float cosine = -lamp->direction.dot(out);
  if (cosine <= 0 || hit.face_normal.dot(out) <= 0 || hit.normal.dot(out) <= 0) return Colour::Zero();
  if (!visible(hit.at, out, distance * 0.9999f)) return Colour::Zero();
  const float area = 4 * lamp->half_width * lamp->half_width;
  return reflection.towards(hit.normal, in, out).cwiseProduct(lamp->radiance) * (cosine * area / distance2);
}

/// The way of light below the surface at `hit`: free flights between scatterings. `hit` becomes where it comes out, with an albedo of 1,
/// and `share` is multiplied by what was not absorbed. False if nothing comes out.
bool PathTracer::Scene::wander(Hit& hit, Colour& share, PathSamples& samples) const {
  constexpr int k_most_flights = 256;
  const Colour scattered = albedo_inside(hit.albedo);
  Vec3f at = hit.at - 2 * clearance * hit.face_normal, towards = cosine_direction(-hit.face_normal, samples.uniform2());
  Colour left = Colour::Ones();
  for (int flights = 0; flights < k_most_flights; ++flights) {
    const float flight = -hit.gloss.depth * std::log(1 - samples.uniform());
    Hit wall;
    wall.seen = false;
    if (intersect(at, towards, wall, flight)) {
      wall.at -= 2 * clearance * wall.face_normal;
      wall.face_normal = -wall.face_normal;
      wall.normal = -wall.normal;
      wall.albedo = Colour::Ones();
      wall.gloss = {};
      hit = wall;
      share = share.cwiseProduct(left);
      return true;
    }
    at += flight * towards;
    left = left.cwiseProduct(scattered);
    const float goes_on = std::min(1.0f, 4 * left.maxCoeff());  // Russian roulette
    if (samples.uniform() >= goes_on) return false;
    left /= goes_on;
    const float z = 2 * samples.uniform() - 1, angle = 2 * k_pi * samples.uniform(), r = std::sqrt(1 - z * z);
    towards = {r * std::cos(angle), r * std::sin(angle), z};
  }
  return false;
}

/// Light that comes along a path: at each hit straight from the lamp, and from the sky where it leaves the scene.
Colour PathTracer::Scene::path(Vec3f from, Vec3f towards, int most_bounces, PathSamples& samples) const {
  constexpr int k_sure_bounces = 3;  // to end paths sooner saves a twentieth of the time and doubles the variance
  Colour light = Colour::Zero(), share = Colour::Ones();
  for (int bounce = 0;; ++bounce) {
    Hit hit;
    hit.seen = bounce == 0;
    if (!intersect(from, towards, hit)) return light + share.cwiseProduct(bounce == 0 ? sky->backdrop : sky_light(towards));
    if (bounce == most_bounces) return light;
    const PathSamples::AtHit choose = samples.at_hit(bounce);
    const bool translucent = bounce == 0 && hit.gloss.depth > 0;
    const Reflection reflection(translucent ? Colour::Zero() : hit.albedo, hit.gloss);
    const Vec3f in = -towards;
    light += share.cwiseProduct(lamp_light(hit, reflection, in, choose.lamp));
    Reflection::Bounce next = reflection.bounce(hit.normal, in, choose.direction, choose.lobe);
    if (translucent && choose.lobe >= reflection.chance_of_mirror(hit.normal, in)) {
      share *= reflection.share_below(hit.normal, in) / (1 - reflection.chance_of_mirror(hit.normal, in));
      if (!wander(hit, share, samples)) return light;
      const Reflection outlet(Colour::Ones(), Gloss{});
      light += share.cwiseProduct(lamp_light(hit, outlet, hit.normal, samples.uniform2()));
      next = outlet.bounce(hit.normal, hit.normal, samples.uniform2(), 1);
    }
    const auto& [out, weight] = next;
    share = share.cwiseProduct(weight);
    if (hit.face_normal.dot(out) <= 0 || share.maxCoeff() <= 0) return light;
    if (bounce >= k_sure_bounces) {  // Russian roulette: end dim paths, count the others for them
      const float goes_on = std::min(0.95f, 2 * share.maxCoeff());
      if (samples.uniform() >= goes_on) return light;
      share /= goes_on;
    }
    from = hit.at;
    towards = out;
  }
}

PathTracer::PathTracer() : scene_(std::make_unique<Scene>()) {}
PathTracer::~PathTracer() = default;

void PathTracer::add(TriangleObject object) {
  check_lengths(object);
  const RTCGeometry geometry = rtcNewGeometry(scene_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* points = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3f), object.vertices.size());
  void* corners =
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(object.triangles[0]), object.triangles.size());
  if (!points || !corners) throw std::bad_alloc();
  std::memcpy(points, reinterpret_cast<const float*>(object.vertices.data()), object.vertices.size() * sizeof(Vec3f));
  std::memcpy(corners, object.triangles.data(), object.triangles.size() * sizeof(object.triangles[0]));
  scene_->attach(geometry);
  scene_->objects.emplace_back(std::move(object));
}

void PathTracer::add(SphereObject object) {
  if (object.albedos.size() != object.spheres.size()) throw std::invalid_argument("a picture's spheres and their colours differ in number");
  const RTCGeometry geometry = rtcNewGeometry(scene_->device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  const std::size_t bytes = sizeof(Eigen::Vector4f);
  void* spheres = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, bytes, object.spheres.size());
  if (!spheres) throw std::bad_alloc();
  std::memcpy(spheres, reinterpret_cast<const float*>(object.spheres.data()), object.spheres.size() * bytes);
  scene_->attach(geometry);
  scene_->objects.emplace_back(std::move(object));
}

Radiance PathTracer::expose(const Camera& camera, const Exposure& exposure, const std::function<void(double)>& progress) {
  Scene& scene = *scene_;
  scene.lamp = &lamp;
  scene.sky = &sky;
  scene.commit();
  const Vec3f forward = (camera.target - camera.eye).normalized(), right = forward.cross(camera.up).normalized(), up = right.cross(forward);
  const auto width = static_cast<float>(exposure.width), height = static_cast<float>(exposure.height);
  const float half_width = camera.half_height * width / height;
  const auto take_path = [&](int row, int column, std::uint32_t number) -> Colour {
    const int pixel = row * exposure.width + column;
    PathSamples samples(static_cast<std::uint32_t>(pixel), number);
    const Sample2 p = samples.in_pixel();
    const float x = (2 * (static_cast<float>(column) + p.u) / width - 1) * half_width;
    const float y = (1 - 2 * (static_cast<float>(row) + p.v) / height) * camera.half_height;
    return scene.path(camera.eye, (forward + x * right + y * up).normalized(), exposure.most_bounces, samples);
  };
  return bake::expose(exposure, take_path, progress);
}

}  // namespace bake
