// SPDX-License-Identifier: MIT
// Skins in a step: after the pass their forces are added to what it scattered.
#include "solver/core/parallel.h"
#include "solver/core/vector3.h"
#include "solver/effects/skin_of_scene.h"
#include "solver/engine/engine.h"

namespace bake {

template <class Real>
void Engine<Real>::cover(std::vector<SurfaceMesh> skins, const std::vector<NewParticle>& vertices, const std::vector<double>& covers) {
  take_skins(Sheets<Real>(scene_, std::move(skins), next_identity_));
  add(vertices);
  const int column = physics_->column_of(Sheets<Real>::k_cover);
  for (std::size_t b = 0; b < store_.blocks.size(); ++b)
    for (std::int32_t t = skins_->tiles_of(b).first; t < skins_->tiles_of(b).end; ++t)
      for (int l = 0; l < k_width<Real>; ++l) {
        Lanes<Real>* numbers = store_.tile(static_cast<std::size_t>(t));
        numbers[column][l] = static_cast<Real>(covers[static_cast<std::size_t>(identity_of<Real>(numbers, l) - skins_->first_identity())]);
      }
  skins_->find_forces(store_, geometry_, true);
}

template <class Real>
void Engine<Real>::take_skins(Sheets<Real> skins) {
  skins_.emplace(std::move(skins));
  excess_mass_.clear();
  for (std::size_t s = 0; s < scene_.skins.size(); ++s) {
    const Skin& skin = scene_.skins[s];
    for (const double area : vertex_areas(skins_->meshes()[s]))
      excess_mass_.push_back((inertia_of_skin(scene_, skin) - 1) * skin.mass_per_area() * area);
  }
}

/// Forces at t + dt act in the step after. What gravity gives the skin's inertia beyond its mass is taken back.
template <class Real>
void Engine<Real>::pull_skins(double after, bool sample) {
  skins_->find_forces(store_, geometry_, sample);
  const BlockWork<Real> w = work(current_step());
  const Vector3 weight = (-dt_) * gravity_from(after);  // per excess mass
  for (const auto& columns : colours_.columns())
    for_each_parallel(columns.size(), 1, [&](std::size_t c) {
      for (std::int32_t b = columns[c].first; b < columns[c].second; ++b) {
        const auto tiles = skins_->tiles_of(static_cast<std::size_t>(b));
        for (std::int32_t t = tiles.first; t < tiles.end; ++t) {
          const Lanes<Real>* numbers = store_.tile(static_cast<std::size_t>(t));
          Lanes<Real> impulse[3] = {};
          for (int l = 0; l < store_.tiles[static_cast<std::size_t>(t)].count; ++l) {
            const auto vertex = static_cast<std::size_t>(identity_of<Real>(numbers, l) - skins_->first_identity());
            for (std::size_t d = 0; d < 3; ++d)
              impulse[d][l] = static_cast<Real>(dt_) * skins_->force(vertex)[d] + static_cast<Real>(excess_mass_[vertex] * weight[d]);
          }
          kernel_->push(w, b, t, impulse);
        }
      }
    });
}

/// What gravity gave in this step to inertia beyond the mass of skins was booked and is taken back.
template <class Real>
void Engine<Real>::book_weight_of_skins() {
  const Vector3 gravity = gravity_from(time_);
  if (gravity == Vector3{0, 0, 0}) return;
  Vector3 moment{0, 0, 0};
  double mass = 0;
  for (std::size_t v = 0; v < skins_->vertices(); ++v) {
    if (!skins_->is_left(v)) continue;
    mass += excess_mass_[v];
    moment = moment + excess_mass_[v] * skins_->position(v);
  }
  const Vector3 impulse = (-dt_ * mass) * gravity, angular_impulse = (-dt_) * cross(moment, gravity);
  for (std::size_t d = 0; d < 3; ++d) {
    booked_[k_impulse_entry + d] += impulse[d];
    booked_[k_angular_impulse_entry + d] += angular_impulse[d];
  }
}

#define BAKE_INSTANTIATE(Real)                                                                                              \
  template void Engine<Real>::cover(std::vector<SurfaceMesh>, const std::vector<NewParticle>&, const std::vector<double>&); \
  template void Engine<Real>::take_skins(Sheets<Real>);                                                                     \
  template void Engine<Real>::pull_skins(double, bool);                                                                     \
  template void Engine<Real>::book_weight_of_skins();
BAKE_INSTANTIATE(float)
BAKE_INSTANTIATE(double)
#undef BAKE_INSTANTIATE

}  // namespace bake
