// SPDX-License-Identifier: MIT
#include "solver/run/describe_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "solver/boundary/fill.h"
#include "solver/boundary/scripted.h"
#include "solver/boundary/shapes.h"
#include "solver/effects/fields.h"
#include "solver/engine/physics.h"
#include "solver/run/fill_scene.h"

namespace bake {
namespace {

constexpr double k_least_share = 1e-3;  ///< of the smaller volume: less is rounding, or not worth a line
constexpr double k_most_off = 0.2;      ///< a particle's volume off its usual one by more is worth a warning

/// A body or a collider.
struct Thing {
  std::string name;
  ShapePtr shape;                          ///< null if it comes from a file of particles
  std::span<const NewParticle> particles;  ///< none if it is a collider
  double volume = k_infinity;              ///< [m^3]; of a collider it does not matter
};

/// A collider where it is at one time.
class Placed final : public Shape {
 public:
  Placed(ScriptedShape scripted, double time_s) : scripted_(std::move(scripted)), pose_(scripted_.path.at(time_s)) {}
  double distance(const Point& x) const override { return scripted_.distance(pose_, x); }
  Box3 bounds() const override { return scripted_.bounds(pose_); }

 private:
  ScriptedShape scripted_;
  RigidState pose_;
};

std::vector<Thing> bodies_of(const Scene& scene, const std::vector<NewParticle>& particles) {
  std::vector<Thing> things;
  auto first = particles.begin();
  for (const Body& body : scene.bodies) {
    const auto end = std::find_if(first, particles.end(), [&](const NewParticle& p) { return p.body != &body; });
    double volume = 0;
    for (auto p = first; p != end; ++p) volume += p->volume;
    things.push_back({fmt::format("body.{}", things.size()), body.shape, {first, end}, volume});
    first = end;
  }
  return things;
}

std::vector<Thing> colliders_at_start(const Scene& scene) {
  std::vector<Thing> things;
  for (std::size_t i = 0; i < scene.colliders.size(); ++i) {
    const Collider& c = scene.colliders[i];
    ScriptedShape scripted{c.shape, RigidPath(c.motion, c.pivot_m), c.from_s, c.until_s};
    if (!scripted.present(0)) continue;
    things.push_back({"collider." + (c.name.empty() ? std::to_string(i) : c.name), std::make_shared<Placed>(std::move(scripted), 0.0), {}});
  }
  return things;
}

/// Volume that both fill [m^3].
double common_volume(const Thing& a, const Thing& b) {
  if (a.shape && b.shape) return sampled_volume(*make_intersection({a.shape, b.shape}), std::min(a.volume, b.volume));
  const Thing& grains = a.shape ? b : a;
  const ShapePtr& shape = a.shape ? a.shape : b.shape;
  double volume = 0;
  for (const NewParticle& p : grains.particles)
    if (shape && shape->distance(p.x) <= 0) volume += p.volume;
  return volume;
}

/// The line about two things that share space, "" if they do not.
std::string overlap(const Thing& a, const Thing& b) {
  const double volume = common_volume(a, b);
  if (volume < k_least_share * std::min(a.volume, b.volume)) return {};
  const auto share = [&](const Thing& thing) { return fmt::format("{:.2g} % of {}", 100 * volume / thing.volume, thing.name); };
  if (b.particles.empty()) return fmt::format("  overlap      {} lies in {}\n", share(a), b.name);
  return fmt::format("  overlap      {} and {} share {:.3g} m^3: {} and {}\n", a.name, b.name, volume, share(a), share(b));
}

}  // namespace

std::string describe_bodies(const Scene& scene) {
  const std::vector<NewParticle> particles = fill_bodies(scene);
  const std::vector<Thing> bodies = bodies_of(scene, particles), colliders = colliders_at_start(scene);
  const auto physics = make_physics<double>(scene);
  const int solid = physics->column_of(field::SolidMass::name), water = physics->column_of(field::WaterMass::name);
  std::vector<Lanes<double>> columns(static_cast<std::size_t>(physics->column_count));
  std::string text, overlaps, warnings;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const Thing& thing = bodies[b];
    const Body& body = scene.bodies[b];
    double solid_mass = 0, water_mass = 0;
    for (const NewParticle& p : thing.particles) {
      physics->fill(columns.data(), 0, p.material, p.volume, body);
      solid_mass += columns[static_cast<std::size_t>(solid)][0];
      if (water >= 0) water_mass += columns[static_cast<std::size_t>(water)][0];
    }
    text += fmt::format("  {:<12} {}: {:.4g} kg, {:.4g} m^3, {:.4g} kg of it water, {} particles\n", thing.name, body.material,
                        solid_mass + water_mass, thing.volume, water_mass, thing.particles.size());
    for (std::size_t other = b + 1; other < bodies.size(); ++other) overlaps += overlap(thing, bodies[other]);
    for (const Thing& collider : colliders) overlaps += overlap(thing, collider);
    const double usual = std::pow(scene.dx(), 3) / body.particles_per_cell;
    if (const double share = thing.volume / (usual * static_cast<double>(thing.particles.size()));
        body.shape && std::abs(share - 1) > k_most_off)
      warnings += fmt::format(
          "  warning      {}: its particles have {:.2f} of their usual volume: at dx = {:.4g} m its shape is only a few of them thick (its "
          "mass is right; a finer --quality or grid.dx_m, or more particles_per_cell, resolves it)\n",
          thing.name, share, scene.dx());
  }
  return text + overlaps + warnings;
}

}  // namespace bake
