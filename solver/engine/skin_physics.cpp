// SPDX-License-Identifier: MIT
// The vertices of skins among the particles of the flesh. Skin number s of a scene with n materials has the material n + s, so that a tile
// holds vertices or flesh. A vertex has mass and no volume: it moves and scatters its momentum, and none of the flesh's effects sees it.
// A scene without skins has the flesh's own physics and nothing of this.
#include <cmath>
#include <stdexcept>

#include "solver/effects/composed_effects.h"
#include "solver/effects/skin_of_scene.h"
#include "solver/engine/model.h"
#include "solver/engine/sheets.h"
#include "solver/grid/particle_store.h"

namespace bake {
namespace {

template <class Real>
class SkinPhysics final : public Physics<Real> {
  using typename Physics<Real>::V;
  using Quantities = std::vector<typename Physics<Real>::Quantity>;

 public:
  SkinPhysics(std::unique_ptr<Physics<Real>> flesh, const Scene& scene)
      : Physics<Real>(*flesh), flesh_(std::move(flesh)), materials_(static_cast<int>(scene.materials.size())) {
    for (const Skin& skin : scene.skins) {
      Material sheet;
      sheet.name = "skin";
      sheet.density_kg_per_m3 = skin.density_kg_per_m3;
      const double inertia = inertia_of_skin(scene, skin);
      sheets_.push_back(compose<Real>(CompositionOfSkin{}, scene_of_skin(scene, sheet, inertia)));
      area_per_mass_.push_back(static_cast<Real>(1 / skin.mass_per_area()));
      closed_.push_back(static_cast<Real>(1 - skin.permeance));
      closes_ |= skin.permeance < 1 && this->needs_surface;
      limit_step_by(skin, inertia * skin.mass_per_area() + flesh_that_moves_along(scene, skin), scene.dx());
    }
    expect_prefix(sheets_.front()->columns, this->columns);
    expect_prefix(sheets_.front()->totals, this->totals);
    expect_prefix(sheets_.front()->bounds, this->bounds);
    if (closes_) {
      area_channel_ = this->scatter_channels;
      this->scatter_channels += 2;
    }
    cover_column_ = this->column_of(Sheets<Real>::k_cover);
    volume_column_ = this->column_of(field::InitialVolume::name);
    mass_column_ = this->column_of(field::SolidMass::name);
  }

  void advance(V* columns, int material, const V* gathered, int gather_stride, V* scattered, int scatter_stride, V* sampled,
               const Step<Real>& step, Report<Real>& report) const override {
    const int skin = material - materials_;
    if (skin < 0) {
      flesh_->advance(columns, material, gathered, gather_stride, scattered, scatter_stride, sampled, step, report);
      close_nothing(scattered);
      return;
    }
    const V cover = columns[cover_column_];  // there is no volume that could change
    of(skin).advance(columns, 0, gathered, gather_stride, scattered, scatter_stride, sampled, step, report);
    columns[cover_column_] = cover;
    put_in_place(columns, skin, scattered, scatter_stride);
  }

  void start(V* columns, int material, const V* velocity, const V* affine, V* scattered, int scatter_stride, const Step<Real>& step,
             Report<Real>& report) const override {
    const int skin = material - materials_;
    if (skin < 0) {
      flesh_->start(columns, material, velocity, affine, scattered, scatter_stride, step, report);
      close_nothing(scattered);
      return;
    }
    of(skin).start(columns, 0, velocity, affine, scattered, scatter_stride, step, report);
    put_in_place(columns, skin, scattered, scatter_stride);
  }

  /// What evaporates through the skin is the share `permeance` of what would through as much open surface:
  /// S_open = S - (1 - permeance) min(S, S_skin).
  void update_nodes(const V* scattered, V* gathered, NodeSums<Real>& sums, const Surroundings<Real>& around, const Step<Real>& step,
                    Budget& booked) const override {
    if (!closes_) return flesh_->update_nodes(scattered, gathered, sums, around, step, booked);
    Surroundings<Real> open = around;
    const V skin = scattered[area_channel_], closed = scattered[area_channel_ + 1], none{};
    open.area -= skin > 0 ? min(around.area, skin) * closed / skin : none;
    flesh_->update_nodes(scattered, gathered, sums, open, step, booked);
  }

  void limit_step(const Bounds& most, const StepScale& at, const Scene& scene, StepLimit& limit) const override {
    flesh_->limit_step(most, at, scene, limit);
    limit.at_most(at.safety * membrane_limit_, "stretching of a skin");
    limit.at_most(at.safety * bending_limit_, "bending of a skin");
  }

  V conductance(const V* columns, int material) const override {
    return material < materials_ ? flesh_->conductance(columns, material) : V{};
  }

  void find_springs(const V* columns, int material, V& inertia, V& spring) const override {
    const int skin = material - materials_;
    if (skin < 0)
      flesh_->find_springs(columns, material, inertia, spring);
    else
      of(skin).find_springs(columns, 0, inertia, spring);
  }

  /// `volume`: of a vertex, its share of the skin's.
  void fill(V* columns, int lane, int material, double volume, const Body& body) const override {
    const int skin = material - materials_;
    if (skin < 0) return flesh_->fill(columns, lane, material, volume, body);
    for (int c = k_identity_column + 1; c < this->column_count; ++c) columns[c][lane] = 0;
    of(skin).fill(columns, lane, 0, volume, body);
    columns[volume_column_][lane] = 0;
  }

 private:
  const Physics<Real>& of(int skin) const { return *sheets_[static_cast<std::size_t>(skin)]; }

  /// The columns, sums and bounds of a vertex are the first of those of the flesh.
  static void expect_prefix(const Quantities& few, const Quantities& many) {
    for (std::size_t i = 0; i < few.size(); ++i)
      if (i >= many.size() || few[i].name != many[i].name || few[i].first != many[i].first)
        throw std::logic_error("the effect that moves particles is not the first of a composition");
  }

  /// The sheet's waves have the highest frequency 2 c / dx on the grid, and bending that of (2 / dx)^2 sqrt(B / m''), with the mass per
  /// area m'' of the skin and of the flesh that moves along. Sheets on flesh were stable up to 1.7 and 0.8 of the lengths that this gives
  /// (by measurement). Without the flesh m'' is half as large at worst, and what is used of these limits holds still.
  void limit_step_by(const Skin& skin, double mass_per_area, double dx) {
    const double nu = skin.poisson_ratio, mass = this->inertia_scale * mass_per_area;
    membrane_limit_ = std::min(membrane_limit_, 1.7 * dx * std::sqrt(mass * (1 - nu * nu) / (skin.young_modulus_Pa * skin.thickness_m)));
    bending_limit_ = std::min(bending_limit_, 0.8 * dx * dx / 2 * std::sqrt(mass / skin.bending_stiffness()));
  }

  void close_nothing(V* scattered) const {
    if (closes_) scattered[area_channel_] = scattered[area_channel_ + 1] = V{};
  }

  /// What a sheet scatters, three of momentum and the mass, to where the flesh scatters these.
  void put_in_place(const V* columns, int skin, V* scattered, int stride) const {
    const V mass = scattered[3], area = area_per_mass_[static_cast<std::size_t>(skin)] * columns[mass_column_] * columns[cover_column_];
    for (int c = 3; c < this->scatter_channels; ++c) scattered[c] = V{};
    for (int axis = 1; axis < 4; ++axis)
      for (int c = 3; c < this->moment_channels; ++c) scattered[axis * stride + c] = V{};
    scattered[this->filled_channel] = mass;
    if (!closes_) return;
    scattered[area_channel_] = area;
    scattered[area_channel_ + 1] = closed_[static_cast<std::size_t>(skin)] * area;
  }

  std::unique_ptr<Physics<Real>> flesh_;
  std::vector<std::unique_ptr<Physics<Real>>> sheets_;
  int materials_;
  std::vector<Real> area_per_mass_, closed_;
  bool closes_ = false;  ///< does any skin hold water back?
  int area_channel_ = -1, cover_column_, volume_column_, mass_column_;
  double membrane_limit_ = std::numeric_limits<double>::infinity(), bending_limit_ = membrane_limit_;
};

}  // namespace

template <class Real>
std::unique_ptr<Physics<Real>> make_physics_with_skins(const Scene& scene) {
  auto flesh = make_physics<Real>(scene);
  if (scene.skins.empty()) return flesh;
  return std::make_unique<SkinPhysics<Real>>(std::move(flesh), scene);
}

template std::unique_ptr<Physics<float>> make_physics_with_skins(const Scene&);
template std::unique_ptr<Physics<double>> make_physics_with_skins(const Scene&);

}  // namespace bake
