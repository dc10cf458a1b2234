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
  return {
      "emitter." + name, emitter.shape, Filling::lattice, spacing(scene, emitter.particles_per_cell), 0.5, seed_of(scene, 1000 + number)};
}

/// Complains of particles that a run cannot take.
class Expected {
 public:
  Expected(const Scene& scene, const std::string& name)
      : scene_(scene), name_(name), geometry_(scene.domain.min_m, scene.domain.max_m, scene.dx()) {}

  void in_domain(const Point& x) const {
    if (!geometry_.holds(x))
      throw InputError(
          fmt::format("{}: {}: found a particle at ({:g}, {:g}, {:g}) m, outside the domain, allowed: bodies and emitters inside it",
                      scene_.file.string(), name_, x[0], x[1], x[2]));
  }
  /// Is every point that is no further away than `reach` along each axis in the domain?
  bool surely_in_domain(const Point& x, double reach) const {
    const Vector3 r{reach, reach, reach};
    return geometry_.holds(x - r) && geometry_.holds(x + r);
  }
  void some(bool any) const {
    if (!any)
      throw InputError(
          fmt::format("{}: {}: found no particle in its shape at dx = {:.4g} m, allowed: a shape of some cells' size (a finer "
                      "--quality or grid.dx_m, more particles_per_cell)",
                      scene_.file.string(), name_, scene_.dx()));
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
  ParticlesFile file = read_particles(path);
  for (const std::int32_t m : file.materials)
    if (m < 0 || m >= static_cast<std::int32_t>(scene.materials.size()))
      throw InputError(fmt::format("{}: material: found {}, allowed: 0 to {}", path.string(), m, scene.materials.size() - 1));
  const std::string name = name_of_body(number);
  const Expected expected(scene, name);
  for (const Point& x : file.positions) expected.in_domain(x);
  return file;
}

void spin_about_centre(std::vector<NewParticle>& particles, std::size_t first, const Vector3& angular_velocity) {
  double volume = 0;
  Vector3 centre{0, 0, 0};
  for (std::size_t i = first; i < particles.size(); ++i) {
    volume += particles[i].volume;
    centre = centre + particles[i].volume * particles[i].x;
  }
  if (volume > 0) centre = (1 / volume) * centre;
  for (std::size_t i = first; i < particles.size(); ++i)
    particles[i].velocity = particles[i].velocity + cross(angular_velocity, particles[i].x - centre);
}

}  // namespace

std::vector<NewParticle> fill_bodies(const Scene& scene) {
  std::vector<NewParticle> particles;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    const std::size_t first = particles.size();
    const std::int32_t material = material_number(scene, body.material);
    const auto add = [&](const Point& x, double volume, std::int32_t m) {
      particles.push_back({x, volume, m, body.velocity_m_per_s, body.angular_velocity_rad_per_s, &body});
    };
    if (!body.shape) {
      const ParticlesFile file = read_file(scene, b);
      for (std::size_t i = 0; i < file.positions.size(); ++i)
        add(file.positions[i], file.volumes[i], file.materials.empty() ? material : file.materials[i]);
    } else {
      const std::vector<Point> points = fill(scene, to_fill(scene, body, b));
      const double volume = body.shape->volume() / static_cast<double>(points.size());
      for (const Point& x : points) add(x, volume, material);
    }
    spin_about_centre(particles, first, body.angular_velocity_rad_per_s);
  }
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
    : from_(emitter.from_s), until_(emitter.until_s), body_() {
  body_.material = emitter.material;
  body_.temperature_C = emitter.temperature_C;
  body_.saturation = emitter.saturation;
  const ShapeToFill s = to_fill(scene, emitter, number);
  const double h = s.spacing, speed = length(emitter.velocity_m_per_s);
  const Vector3 direction = (1 / speed) * emitter.velocity_m_per_s;
  double low = k_infinity, high = -k_infinity;
  for (const Point& x : fill(scene, s)) {
    portion_.push_back({x, h * h * h, material_number(scene, emitter.material), emitter.velocity_m_per_s, {0, 0, 0}, &body_});
    low = std::min(low, dot(x, direction));
    high = std::max(high, dot(x, direction));
  }
  // the column of dough is as long as its particles reach, and half a spacing more at either end
  period_ = (high - low + h) / speed;
}

double EmitterState::next_time() const {
  const double next = from_ + static_cast<double>(poured_) * period_;
  return next < until_ ? next : k_infinity;
}

std::vector<NewParticle> EmitterState::pour() {
  ++poured_;
  std::vector<NewParticle> particles = portion_;
  for (NewParticle& p : particles) p.body = &body_;
  return particles;
}

}  // namespace bake
