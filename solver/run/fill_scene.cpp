// SPDX-License-Identifier: MIT
#include "solver/run/fill_scene.h"

#include <fmt/format.h>

#include <cmath>

#include "solver/boundary/fill.h"
#include "solver/core/vector3.h"
#include "solver/grid/grid.h"
#include "solver/io/particles_file.h"

namespace bake {

namespace {

std::int32_t material_number(const Scene& scene, const std::string& name) {
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    if (scene.materials[i].name == name) return static_cast<std::int32_t>(i);
  throw InputError(scene.file.string() + ": unknown material '" + name + "'");  // the reader has checked it
}

double spacing(const Scene& scene, double particles_per_cell) { return scene.dx() / std::cbrt(particles_per_cell); }

std::uint64_t seed_of(const Scene& scene, std::size_t number) { return static_cast<std::uint64_t>(scene.run.seed) * 1000003u + number; }

std::string name_of_body(std::size_t number) { return fmt::format("body.{}", number); }

ShapeToFill to_fill(const Scene& scene, const Body& body, std::size_t number) {
  return {name_of_body(number), body.shape, body.filling, spacing(scene, body.particles_per_cell), body.jitter, seed_of(scene, number)};
}

ShapeToFill to_fill(const Scene& scene, const Emitter& emitter, std::size_t number) {
  const std::string name = emitter.name.empty() ? std::to_string(number) : emitter.name;
  return {"emitter." + name, emitter.shape, Filling::poisson, spacing(scene, emitter.particles_per_cell), 0, seed_of(scene, 1000 + number)};
}

/// Complains of particles that a run cannot take.
class Expected {
 public:
  Expected(const Scene& scene, const std::string& name)
      : scene_(scene), name_(name), geometry_(scene.domain.min_m, scene.domain.max_m, scene.dx()) {}

  void in_domain(const Point& x) const {
    if (!geometry_.holds(x))
      throw InputError(
          fmt::format("{}: found a particle at ({:g}, {:g}, {:g}) m, outside the domain, allowed: bodies and emitters inside it",
                      scene_.at(name_), x[0], x[1], x[2]));
  }
  /// Is every point that is no further away than `reach` along each axis in the domain?
  bool surely_in_domain(const Point& x, double reach) const {
    const Vector3 r{reach, reach, reach};
    return geometry_.holds(x - r) && geometry_.holds(x + r);
  }
  void some(bool any) const {
    if (!any)
      throw InputError(
          fmt::format("{}: found no particle in its shape at dx = {:.4g} m, allowed: a shape of some cells' size (a finer "
                      "--quality or grid.dx_m, more particles_per_cell)",
                      scene_.at(name_), scene_.dx()));
  }

 private:
  const Scene& scene_;
  const std::string& name_;
  const GridGeometry geometry_;
};

std::vector<Point> fill(const Scene& scene, const ShapeToFill& s) {
  std::vector<Point> points =
      s.filling == Filling::lattice ? fill_lattice(*s.shape, s.spacing, s.jitter, s.seed) : fill_poisson(*s.shape, s.spacing, s.seed);
  const Expected expected(scene, s.name);
  expected.some(!points.empty());
  for (const Point& x : points) expected.in_domain(x);
  return points;
}

void check_lattice(const Scene& scene, const ShapeToFill& s) {
  const Expected expected(scene, s.name);
  bool any = false;
  visit_lattice(
      *s.shape, s.spacing, s.jitter, s.seed, [&](const Point& place) { return !any || !expected.surely_in_domain(place, s.spacing); },
      [&](const Point& x) {
        any = true;
        expected.in_domain(x);
      });
  expected.some(any);
}

ParticlesFile read_file(const Scene& scene, std::size_t number) {
  const auto& path = scene.bodies[number].particles_file;
  const std::string name = name_of_body(number);
  ParticlesFile file;
  try {
    file = read_particles(path);
    for (const std::int32_t m : file.materials)
      if (m < 0 || m >= static_cast<std::int32_t>(scene.materials.size()))
        throw InputError(fmt::format("{}: material: found {}, allowed: 0 to {}", path.string(), m, scene.materials.size() - 1));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", scene.at(name + ".particles_file"), error.what()));
  }
  const Expected expected(scene, name);
  for (const Point& x : file.positions) expected.in_domain(x);
  return file;
}

/// What a body is filled with.
ParticlesFile filling_of(const Scene& scene, std::size_t number) {
  const Body& body = scene.bodies[number];
  if (!body.shape) return read_file(scene, number);
  ParticlesFile filling;
  filling.positions = fill(scene, to_fill(scene, body, number));
  filling.volumes = {body.shape->volume() / static_cast<double>(filling.positions.size())};
  return filling;
}

Point centre_of(const ParticlesFile& filling) {
  const bool alike = filling.volumes.size() == 1;
  double volume = 0;
  Vector3 centre{0, 0, 0};
  for (std::size_t i = 0; i < filling.positions.size(); ++i) {
    volume += filling.volumes[alike ? 0 : i];
    centre = centre + filling.volumes[alike ? 0 : i] * filling.positions[i];
  }
  return volume > 0 ? (1 / volume) * centre : centre;
}

/// How far the shape reaches along `direction`, by rays from points inside it: exact where a ray meets the end face, as in a spout.
double farthest(const Shape& shape, const std::vector<Point>& inside, const Vector3& direction) {
  constexpr int k_most = 100;  // a ray beside the shape's side comes forward slowly, but others do not
  double reach = -k_infinity;
  for (Point x : inside) {
    for (int i = 0; i < k_most && shape.distance(x) < 0; ++i) x = x - shape.distance(x) * direction;
    reach = std::max(reach, dot(x, direction));
  }
  return reach;
}

}  // namespace

void fill_bodies(const Scene& scene, std::size_t most,
                 const std::function<void(std::vector<NewParticle> portion, std::size_t left)>& visit) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    const std::int32_t material = material_number(scene, body.material);
    const ParticlesFile filling = filling_of(scene, b);
    const Point centre = centre_of(filling);
    const std::size_t count = filling.positions.size();
    const bool alike = filling.volumes.size() == 1;
    for (std::size_t first = 0, end; first < count; first = end) {
      end = first + std::min(count - first, most);
      std::vector<NewParticle> portion;
      portion.reserve(end - first);
      for (std::size_t i = first; i < end; ++i) {
        const Point& x = filling.positions[i];
        const Vector3 spin = cross(body.angular_velocity_rad_per_s, x - centre);
        portion.push_back({x, filling.volumes[alike ? 0 : i], filling.materials.empty() ? material : filling.materials[i],
                           body.velocity_m_per_s + spin, body.angular_velocity_rad_per_s, &body});
      }
      visit(std::move(portion), count - end);
    }
  }
}

std::vector<NewParticle> fill_bodies(const Scene& scene) {
  std::vector<NewParticle> particles;
  fill_bodies(scene, std::numeric_limits<std::size_t>::max(), [&](const std::vector<NewParticle>& portion, std::size_t) {
    particles.insert(particles.end(), portion.begin(), portion.end());
  });
  return particles;
}

std::vector<ShapeToFill> shapes_to_fill(const Scene& scene) {
  std::vector<ShapeToFill> all;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    if (scene.bodies[b].shape) all.push_back(to_fill(scene, scene.bodies[b], b));
  for (std::size_t e = 0; e < scene.emitters.size(); ++e) all.push_back(to_fill(scene, scene.emitters[e], e));
  return all;
}

void check_filling(const Scene& scene) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    if (!scene.bodies[b].shape) read_file(scene, b);
  for (const ShapeToFill& s : shapes_to_fill(scene)) {
    if (s.filling == Filling::lattice)
      check_lattice(scene, s);
    else
      fill(scene, s);
  }
}

EmitterState::EmitterState(const Scene& scene, const Emitter& emitter, std::size_t number)
    : scene_(scene),
      emitter_(emitter),
      shape_(to_fill(scene, emitter, number)),
      body_(),
      speed_(length(emitter.velocity_m_per_s)),
      direction_((1 / speed_) * emitter.velocity_m_per_s) {
  body_.material = emitter.material;
  body_.temperature_C = emitter.temperature_C;
  body_.saturation = emitter.saturation;
  const std::vector<Point> points = fill(scene, shape_);
  front_ = farthest(*emitter.shape, points, direction_);
  rear_ = -farthest(*emitter.shape, points, -1.0 * direction_);
  const Expected expected(scene, shape_.name);
  for (const Point& x : points) expected.in_domain(x - (dot(x, direction_) - rear_) * direction_);
  slices_ = static_cast<std::int64_t>(std::ceil((front_ - rear_) / shape_.spacing));
  slice_s_ = (front_ - rear_) / (static_cast<double>(slices_) * speed_);
  per_second_ = static_cast<double>(points.size()) * speed_ / (front_ - rear_);
}

double EmitterState::particles_by(double end, bool mean) const {
  const double pours = std::max(std::min(end, emitter_.until_s) - emitter_.from_s, 0.0);
  return per_second_ * pours * (mean ? (end - emitter_.from_s - pours / 2) / end : 1);
}

std::vector<Point> EmitterState::filling(std::int64_t portion) const {
  ShapeToFill other = shape_;
  other.seed += static_cast<std::uint64_t>(portion) << 32;
  std::vector<Point> points = fill_poisson(*other.shape, other.spacing, other.seed);
  return points.empty() ? fill(scene_, shape_) : points;  // a shape of one spacing may be missed now and then
}

double EmitterState::next_time() const {
  const double begun = emitter_.from_s + static_cast<double>(poured_) * slice_s_;
  return begun < emitter_.until_s ? std::min(emitter_.from_s + static_cast<double>(poured_ + 1) * slice_s_, emitter_.until_s) : k_infinity;
}

std::vector<NewParticle> EmitterState::pour() {
  const double now = next_time();
  const std::int64_t portion = poured_ / slices_, slice = poured_ % slices_;
  if (portion != portion_) points_ = filling(portion);
  portion_ = portion;
  const double began = emitter_.from_s + static_cast<double>(portion * slices_) * slice_s_;
  const double thickness = slice_s_ * speed_, volume = emitter_.shape->volume() / static_cast<double>(points_.size());
  std::vector<NewParticle> particles;
  for (const Point& x : points_) {
    const double along = dot(x, direction_), ahead = std::clamp(front_ - along, 0.0, front_ - rear_);
    if (std::min(static_cast<std::int64_t>(ahead / thickness), slices_ - 1) != slice) continue;
    const double through = speed_ * (now - began) - ahead;  // beyond the plane
    if (through < 0) continue;                              // it stays behind when pouring ends
    particles.push_back({x + (rear_ + through - along) * direction_,
                         volume,
                         material_number(scene_, emitter_.material),
                         emitter_.velocity_m_per_s,
                         {0, 0, 0},
                         &body_});
  }
  ++poured_;
  return particles;
}

}  // namespace bake
