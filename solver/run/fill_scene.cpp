// SPDX-License-Identifier: MIT
#include "solver/run/fill_scene.h"

#include <cmath>

#include "solver/boundary/fill.h"
#include "solver/core/vector3.h"
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
      const ParticlesFile file = read_particles(body.particles_file);
      for (std::size_t i = 0; i < file.positions.size(); ++i) {
        const std::int32_t m = file.materials.empty() ? material : file.materials[i];
        if (m < 0 || m >= static_cast<std::int32_t>(scene.materials.size()))
          throw InputError(body.particles_file.string() + ": material: found " + std::to_string(m) + ", allowed: 0 to " +
                           std::to_string(scene.materials.size() - 1));
        add(file.positions[i], file.volumes[i], m);
      }
    } else {
      const double h = spacing(scene, body.particles_per_cell);
      const auto points = body.filling == Filling::lattice ? fill_lattice(*body.shape, h, body.jitter, seed_of(scene, b))
                                                           : fill_poisson(*body.shape, h, seed_of(scene, b));
      for (const Point& x : points) add(x, h * h * h, material);
    }
    spin_about_centre(particles, first, body.angular_velocity_rad_per_s);
  }
  return particles;
}

EmitterState::EmitterState(const Scene& scene, const Emitter& emitter, std::size_t number)
    : from_(emitter.from_s), until_(emitter.until_s), body_() {
  body_.material = emitter.material;
  body_.temperature_C = emitter.temperature_C;
  body_.saturation = emitter.saturation;
  const double h = spacing(scene, emitter.particles_per_cell), speed = length(emitter.velocity_m_per_s);
  const Vector3 direction = (1 / speed) * emitter.velocity_m_per_s;
  double low = k_infinity, high = -k_infinity;
  for (const Point& x : fill_lattice(*emitter.shape, h, 0.5, seed_of(scene, 1000 + number))) {
    portion_.push_back({x, h * h * h, material_number(scene, emitter.material), emitter.velocity_m_per_s, {0, 0, 0}, &body_});
    low = std::min(low, dot(x, direction));
    high = std::max(high, dot(x, direction));
  }
  // the column of dough is as long as its particles reach, and half a spacing more at either end
  period_ = portion_.empty() ? k_infinity : (high - low + h) / speed;
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
