// SPDX-License-Identifier: MIT
#include "solver/run/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

#include "solver/core/parallel.h"
#include "solver/core/symmetric.h"
#include "solver/core/vector3.h"
#include "solver/effects/fields.h"
#include "solver/engine/engine.h"
#include "solver/run/check_scene.h"
#include "solver/run/fill_scene.h"
#include "solver/run/skins.h"
#include "solver/scene/scene.h"

namespace bake {

std::vector<double> Snapshot::operator[](std::string_view column) && { return std::as_const(*this)[column]; }

const std::vector<double>& Snapshot::operator[](std::string_view column) const& {
  for (const auto& [name, values] : columns)
    if (name == column) return values;
  throw std::out_of_range("no column " + std::string(column));
}

namespace {

template <class Real>
class SimulationOf final : public Simulation {
  static constexpr int W = k_width<Real>;
  static constexpr double k_rounding = 1e-12;                           ///< of times that are computed in two ways
  static constexpr std::size_t k_added_at_once = std::size_t{1} << 18;  ///< particles: what is needed to add them, needs memory, too

 public:
  explicit SimulationOf(const Scene& scene) : scene_(scene), engine_(scene_) {
    for (std::size_t i = 0; i < scene_.emitters.size(); ++i)
      emitters_.push_back(std::make_unique<EmitterState>(scene_, scene_.emitters[i], i));
  }

  void begin(std::optional<double> first_target) {
    if (scene_.skins.empty()) {
      fill_bodies(scene_, k_added_at_once, [&](const std::vector<NewParticle>& portion, std::size_t left) {
        engine_.reserve(portion.size() + left);
        engine_.add(portion);
      });
    } else {
      const std::vector<NewParticle> particles = fill_bodies(scene_);
      engine_.add(particles);
      const std::vector<MadeSkin> skins = make_skins(scene_);
      std::vector<SurfaceMesh> meshes;
      std::vector<double> covers;
      for (const MadeSkin& skin : skins) {
        meshes.push_back(skin.mesh);
        covers.insert(covers.end(), skin.covers.begin(), skin.covers.end());
      }
      engine_.cover(std::move(meshes), vertices_of(scene_, skins, particles), covers);
    }
    pour_due();
    engine_.start(std::min(first_target.value_or(1 / scene_.run.frame_rate_per_s), next_event()));
  }

  void resume(const CheckpointReader& in) {
    engine_.read(in);
    const auto poured = in.array<std::int64_t>("poured");
    if (poured.size() != emitters_.size()) throw InputError("the checkpoint has other emitters than the scene");
    if (std::any_of(poured.begin(), poured.end(), [](std::int64_t count) { return count < 0; }))
      throw InputError("the checkpoint has an emitter that has poured less than nothing");
    for (std::size_t i = 0; i < emitters_.size(); ++i) emitters_[i]->skip_to(poured[i]);
  }

  bool advance(double target, double next_target, const std::function<bool()>& after_step) override {
    while (engine_.time() < target) {
      const double event = next_event(), stop = event < target * (1 - k_rounding) ? event : target;  // no step of 1e-15 s between them
      const double after_stop = stop < target ? std::min(target, event_after(stop)) : std::min(next_target, event_after(stop));
      engine_.step(stop, after_stop);
      pour_due();
      if (!after_step()) return engine_.time() >= target;
    }
    return true;
  }

  void set_force(NodalForce force) override { engine_.set_force(std::move(force)); }

  void write(CheckpointWriter& out) const override {
    engine_.write(out);
    std::vector<std::int64_t> poured;
    for (const auto& emitter : emitters_) poured.push_back(emitter->poured());
    out.add("poured", std::span<const std::int64_t>(poured));
  }

  double time() const override { return engine_.time(); }
  double dt() const override { return engine_.dt(); }
  std::size_t particles() const override { return engine_.particles(); }
  const Counters& counters() const override { return engine_.counters(); }
  const Settling& settling() const override { return engine_.settling(); }
  double amount(Sum kind, std::string_view symbol, int i) const override {
    const Physics<Real>& physics = engine_.physics();
    switch (kind) {
      case Sum::booked:
        return number(physics.booked, engine_.booked(), symbol, i);
      case Sum::total:
        return number(physics.totals, engine_.totals(), symbol, i);
      case Sum::retired:
        return number(physics.totals, engine_.retired(), symbol, i);
      case Sum::emitted:
        return number(physics.totals, engine_.emitted(), symbol, i);
      case Sum::highest:
        return particles() == 0 ? 0 : number(physics.highest, engine_.highest(), symbol, i);
      case Sum::bound:
        return number(physics.bounds, engine_.bounds(), symbol, i);
    }
    return 0;
  }
  const std::vector<Giver>& givers() const override { return givers_; }
  const std::vector<Given>& given() const override { return engine_.given(); }
  Box3 extent() const override {
    Box3 box{{k_infinity, k_infinity, k_infinity}, {-k_infinity, -k_infinity, -k_infinity}};
    for_each_particle([&](const ParticleSlot& p) {
      const Point x = position(p);
      for (std::size_t d = 0; d < 3; ++d) box.low[d] = std::min(box.low[d], x[d]), box.high[d] = std::max(box.high[d], x[d]);
    });
    return box;
  }
  std::size_t bytes() const override { return engine_.bytes(); }
  std::size_t active_nodes() const override { return engine_.active_nodes(); }

  double inertia_scale() const override { return engine_.physics().inertia_scale; }
  std::string memory_words() const override {
    const auto& physics = engine_.physics();
    return fmt::format("{} numbers ({} bytes) per particle, {} scattered and {} gathered channels ({} bytes) per node",
                       physics.column_count, static_cast<std::size_t>(physics.column_count) * sizeof(Real), physics.scatter_channels,
                       physics.gather_channels, static_cast<std::size_t>(engine_.scattered_row() + engine_.gathered_row()) * sizeof(Real));
  }

  Snapshot snapshot() const override {
    Snapshot s;
    const std::vector<ParticleSlot> slots = slots_by_identity();
    for (const ParticleSlot& p : slots) {
      s.id.push_back(identity_of<Real>(p.columns, p.lane));
      s.material.push_back(engine_.store().tiles[p.tile].material);
      s.position.push_back(position(p));
      if (!engine_.sampled().empty()) s.velocity.push_back(velocity(p));
    }
    for (const auto& c : engine_.physics().columns) {
      if (c.first == k_position_column || c.first == k_identity_column) continue;
      auto& values = s.columns.emplace_back(c.name, std::vector<double>()).second;
      values.reserve(slots.size() * static_cast<std::size_t>(c.width));
      for (const ParticleSlot& p : slots)
        for (int i = 0; i < c.width; ++i) values.push_back(number(p, c.first + i));
    }
    return s;
  }

  FrameData frame() const override {
    const std::vector<std::uint32_t> rows = rows_by_identity();
    FrameData frame;
    frame.members = members();
    for (const auto& make : parts_of_frame(rows)) make(frame);
    return frame;
  }

  WrittenFrame written_frame(FrameWriter& writer, const std::filesystem::path& file, const std::filesystem::path& skin) const override {
    constexpr std::size_t k_whole = std::size_t{1} << 19;  // particles of a frame that may be there as a whole
    if (particles() <= k_whole || engine_.skins()) {
      const FrameData flesh = frame();
      const std::optional<Mesh> mesh = skin_mesh(flesh);
      return {writer.write(file, time(), flesh), mesh ? written_mesh(skin, *mesh) : nullptr};
    }
    const std::vector<std::uint32_t> rows = rows_by_identity();
    const auto parts = parts_of_frame(rows);
    const auto part_of = [&](std::size_t part) {
      FrameData frame;
      parts[part](frame);
      return frame;
    };
    return {writer.write(file, time(), particles(), members(), parts.size(), part_of), nullptr};
  }

  const SkinSums& skin_sums() const override {
    static const SkinSums none;
    return engine_.skins() ? engine_.skins()->sums() : none;
  }

  std::optional<Mesh> skin_mesh(const FrameData& flesh) const override {
    if (!engine_.skins()) return {};
    const Sheets<Real>& skins = *engine_.skins();
    Mesh mesh;
    mesh.time_s = time();
    MeshField area{"area_ratio", "1", 1, {}}, curvature{"curvature", "1/m", 1, {}}, number{"skin", "1", 1, {}};
    for (std::size_t v = 0; v < skins.vertices(); ++v)
      mesh.points.insert(mesh.points.end(), skins.position(v).begin(), skins.position(v).end());
    for (const SkinVertexState& state : skins.vertex_states()) {
      area.values.push_back(state.area_ratio);
      curvature.values.push_back(state.curvature);
    }
    std::size_t first = 0;
    for (std::size_t s = 0; s < skins.meshes().size(); ++s) {
      for (const SurfaceTriangle& t : skins.meshes()[s].triangles) {
        const bool whole =
            std::all_of(t.begin(), t.end(), [&](std::int32_t v) { return skins.is_left(first + static_cast<std::size_t>(v)); });
        if (!whole) continue;
        for (const std::int32_t v : t) mesh.cells.push_back(static_cast<std::int64_t>(first) + v);
      }
      number.values.insert(number.values.end(), skins.meshes()[s].points.size(), static_cast<double>(s));
      first += skins.meshes()[s].points.size();
    }
    if (!engine_.sampled().empty()) mesh.fields.push_back({"velocity", "m/s", 3, skin_velocities(skins)});
    mesh.fields.push_back(std::move(area));
    mesh.fields.push_back(std::move(curvature));
    mesh.fields.push_back(std::move(number));
    for (MeshField& field : flesh_at(mesh.points, flesh, engine_.geometry().dx())) mesh.fields.push_back(std::move(field));
    return mesh;
  }

 private:
  /// [m] of the domain from the origin along an axis
  double farthest_coordinate() const {
    double farthest = 0;
    for (int d = 0; d < 3; ++d) farthest = std::max({farthest, std::abs(scene_.domain.min_m[d]), std::abs(scene_.domain.max_m[d])});
    return farthest;
  }

  std::vector<double> skin_velocities(const Sheets<Real>& skins) const {
    std::vector<double> all(3 * skins.vertices(), 0);
    const auto& store = engine_.store();
    for (std::size_t b = 0; b < store.blocks.size(); ++b)
      for (std::int32_t t = skins.tiles_of(b).first; t < skins.tiles_of(b).end; ++t)
        for_each_particle_of(b, static_cast<std::size_t>(t), [&](const ParticleSlot& p) {
          const Vector3 v = velocity(p);
          std::copy(v.begin(), v.end(), &all[3 * static_cast<std::size_t>(identity_of<Real>(p.columns, p.lane) - skins.first_identity())]);
        });
    return all;
  }

  /// Whatever happens next besides frames: pouring, colliders that come and go.
  double next_event() const { return event_after(engine_.time()); }
  double event_after(double time) const {
    double next = engine_.next_event(time);
    for (const auto& emitter : emitters_)
      if (emitter->next_time() > time * (1 + k_rounding)) next = std::min(next, emitter->next_time());
    return next;
  }
  void pour_due() {
    for (const auto& emitter : emitters_)
      while (emitter->next_time() <= engine_.time() * (1 + k_rounding)) engine_.add(emitter->pour(), true);
  }

  /// What a list of quantities has of that symbol; 0 if it is not in it.
  template <class Numbers>
  static double number(const std::vector<typename Physics<Real>::Quantity>& list, const Numbers& numbers, std::string_view symbol, int i) {
    for (const auto& q : list)
      if (q.name == symbol) return numbers[static_cast<std::size_t>(q.first) + static_cast<std::size_t>(i)];
    return 0;
  }

  /// Where a particle is kept; its numbers are the lane of the tile's columns.
  struct ParticleSlot {
    std::size_t block, tile;
    int lane;
    const Lanes<Real>* columns;
  };

  /// Those of the flesh.
  template <class Visit>
  void for_each_tile(std::size_t block, Visit visit) const {
    const auto& at = engine_.store().blocks[block];
    const std::int32_t end = engine_.skins() ? engine_.skins()->tiles_of(block).first : at.first_tile + at.tiles;
    for (std::int32_t t = at.first_tile; t < end; ++t) visit(static_cast<std::size_t>(t));
  }
  template <class Visit>
  void for_each_particle_of(std::size_t block, std::size_t tile, Visit visit) const {
    const auto& store = engine_.store();
    for (int l = 0; l < store.tiles[tile].count; ++l) visit(ParticleSlot{block, tile, l, store.tile(tile)});
  }
  template <class Visit>
  void for_each_particle(Visit visit) const {
    for (std::size_t b = 0; b < engine_.store().blocks.size(); ++b)
      for_each_tile(b, [&](std::size_t t) { for_each_particle_of(b, t, visit); });
  }
  /// By identity: the particle's row in a list that is ordered by identity and leaves out those that left.
  std::vector<std::uint32_t> rows_by_identity() const {
    std::vector<std::uint32_t> rows(engine_.identities_given(), 0);
    for_each_particle([&](const ParticleSlot& p) { rows[static_cast<std::size_t>(identity_of<Real>(p.columns, p.lane))] = 1; });
    std::exclusive_scan(rows.begin(), rows.end(), rows.begin(), std::uint32_t{0});
    return rows;
  }
  std::pair<std::size_t, std::size_t> members() const { return {engine_.identities_given(), particles()}; }
  /// Each makes the positions or a column of a frame; `rows` must outlive them.
  std::vector<std::function<void(FrameData&)>> parts_of_frame(const std::vector<std::uint32_t>& rows) const {
    std::vector<std::function<void(FrameData&)>> makers;
    makers.push_back([this, &rows](FrameData& frame) {
      if (stores_double_positions(std::is_same_v<Real, double>, farthest_coordinate(), scene_.dx()))
        frame.positions = numbers_of<double>(rows, 3, [&](const ParticleSlot& p, double* x) { std::ranges::copy(position(p), x); });
      else
        frame.positions = numbers_of<float>(rows, 3, [&](const ParticleSlot& p, float* x) { std::ranges::copy(position(p), x); });
    });
    using Whole = std::int64_t;
    makers.push_back([this, &rows](FrameData& frame) {
      frame.columns.push_back(
          {"id", "1", numbers_of<Whole>(rows, 1, [&](const ParticleSlot& p, Whole* id) { *id = identity_of<Real>(p.columns, p.lane); })});
    });
    makers.push_back([this, &rows](FrameData& frame) {
      frame.columns.push_back({"material", "1", numbers_of<Whole>(rows, 1, [&](const ParticleSlot& p, Whole* material) {
                                 *material = engine_.store().tiles[p.tile].material;
                               })});
    });
    const bool samples = !engine_.sampled().empty() || (particles() == 0 && engine_.physics().moves);
    if (samples)
      makers.push_back([this, &rows](FrameData& frame) {
        frame.columns.push_back({"velocity", "m/s",
                                 numbers_of<float>(rows, 3, [&](const ParticleSlot& p, float* v) { std::ranges::copy(velocity(p), v); }),
                                 3});
      });
    if (samples && engine_.physics().samples_stress) {
      makers.push_back([this, &rows](FrameData& frame) {
        frame.columns.push_back({field::CauchyStress::name, field::CauchyStress::unit,
                                 numbers_of<float>(rows, 6, [&](const ParticleSlot& p, float* s) { std::ranges::copy(stress(p), s); }), 6});
      });
      makers.push_back([this, &rows](FrameData& frame) {
        frame.columns.push_back(
            {field::VonMisesStress::name, field::VonMisesStress::unit,
             numbers_of<float>(rows, 1, [&](const ParticleSlot& p, float* s) { *s = static_cast<float>(von_mises(stress(p))); })});
      });
    }
    for (const auto& shown : engine_.physics().frame_columns)
      makers.push_back([this, &rows, &shown](FrameData& frame) {
        frame.columns.push_back({shown.name, shown.unit, shown_numbers(rows, shown)});
      });
    return makers;
  }

  /// `width` numbers of each particle in its row, written by write(slot, its numbers).
  template <class T, class Write>
  std::vector<T> numbers_of(const std::vector<std::uint32_t>& rows, std::size_t width, Write write) const {
    std::vector<T> numbers(width * particles());
    for_each_parallel(engine_.store().blocks.size(), 4, [&](std::size_t b) {
      for_each_tile(b, [&](std::size_t t) {
        for_each_particle_of(b, t, [&](const ParticleSlot& p) { write(p, &numbers[width * row_of(rows, p)]); });
      });
    });
    return numbers;
  }
  std::vector<float> shown_numbers(const std::vector<std::uint32_t>& rows, const typename Physics<Real>::FrameColumn& shown) const {
    std::vector<float> numbers(particles());
    const auto& store = engine_.store();
    for_each_parallel(store.blocks.size(), 4, [&](std::size_t b) {
      for_each_tile(b, [&](std::size_t t) {
        double values[W];
        shown.values(store.tile(t), store.tiles[t].material, values);
        for_each_particle_of(b, t, [&](const ParticleSlot& p) { numbers[row_of(rows, p)] = static_cast<float>(values[p.lane]); });
      });
    });
    return numbers;
  }
  static std::size_t row_of(const std::vector<std::uint32_t>& rows, const ParticleSlot& p) {
    return rows[static_cast<std::size_t>(identity_of<Real>(p.columns, p.lane))];
  }
  std::vector<ParticleSlot> slots_by_identity() const {
    std::vector<ParticleSlot> slots(engine_.identities_given(), ParticleSlot{0, 0, 0, nullptr});
    for_each_particle([&](const ParticleSlot& p) { slots[static_cast<std::size_t>(identity_of<Real>(p.columns, p.lane))] = p; });
    std::erase_if(slots, [](const ParticleSlot& p) { return p.columns == nullptr; });  // those that left
    return slots;
  }
  static double number(const ParticleSlot& p, int column) { return static_cast<double>(p.columns[column][p.lane]); }
  Point position(const ParticleSlot& p) const {
    const Point origin = engine_.geometry().origin(engine_.store().blocks[p.block].at);
    const Point x = origin + engine_.geometry().dx() *
                                 Vector3{number(p, k_position_column), number(p, k_position_column + 1), number(p, k_position_column + 2)};
    return engine_.geometry().any_periodic() ? engine_.geometry().wrapped(x) : x;
  }
  Vector3 velocity(const ParticleSlot& p) const {
    const Real* v = sampled(p);
    return {double(v[0]), double(v[1]), double(v[2])};
  }
  /// The Cauchy stress, ordered as ParaView does.
  std::array<double, 6> stress(const ParticleSlot& p) const {
    constexpr int k_place[6] = {0, 1, 2, k_component[0][1], k_component[1][2], k_component[0][2]};
    std::array<double, 6> s;
    for (std::size_t c = 0; c < 6; ++c) s[c] = double(sampled(p)[3 + k_place[c]]);
    return s;
  }
  static double von_mises(const std::array<double, 6>& s) {
    const double xy = s[0] - s[1], yz = s[1] - s[2], zx = s[2] - s[0];
    return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]));
  }
  const Real* sampled(const ParticleSlot& p) const {
    return engine_.sampled().data() + identity_of<Real>(p.columns, p.lane) * engine_.physics().sampled();
  }

  const Scene scene_;
  const std::vector<Giver> givers_ = givers_of(scene_);
  Engine<Real> engine_;
  std::vector<std::unique_ptr<EmitterState>> emitters_;
};

template <class Real>
std::unique_ptr<Simulation> begun(const Scene& scene, std::optional<double> first_target) {
  auto simulation = std::make_unique<SimulationOf<Real>>(scene);
  simulation->begin(first_target);
  return simulation;
}

template <class Real>
std::unique_ptr<Simulation> resumed(const Scene& scene, const CheckpointReader& checkpoint) {
  auto simulation = std::make_unique<SimulationOf<Real>>(scene);
  simulation->resume(checkpoint);
  return simulation;
}

}  // namespace

std::unique_ptr<Simulation> Simulation::begin(const Scene& scene, std::optional<double> first_target) {
  check_size(scene);
  return scene.run.precision == Precision::single_precision ? begun<float>(scene, first_target) : begun<double>(scene, first_target);
}

std::unique_ptr<Simulation> Simulation::resume(const Scene& scene, const CheckpointReader& checkpoint) {
  return scene.run.precision == Precision::single_precision ? resumed<float>(scene, checkpoint) : resumed<double>(scene, checkpoint);
}

}  // namespace bake
