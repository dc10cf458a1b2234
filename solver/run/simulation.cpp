// SPDX-License-Identifier: MIT
#include "solver/run/simulation.h"

#include <fmt/format.h>

#include <algorithm>

#include "solver/core/vector3.h"
#include "solver/effects/fields.h"
#include "solver/effects/water.h"
#include "solver/engine/engine.h"
#include "solver/run/fill_scene.h"
#include "solver/scene/scene.h"

namespace bake {

std::vector<std::string> ledger_columns() {
  return {"time_s",
          "steps",
          "dt_s",
          "particles",
          "retired_particles",
          "clamped_particles",
          "solid_mass_kg",
          "water_mass_kg",
          "water_evaporated_kg",
          "momentum_x_kg_m_per_s",
          "momentum_y_kg_m_per_s",
          "momentum_z_kg_m_per_s",
          "angular_momentum_x_kg_m2_per_s",
          "angular_momentum_y_kg_m2_per_s",
          "angular_momentum_z_kg_m2_per_s",
          "impulse_x_kg_m_per_s",
          "impulse_y_kg_m_per_s",
          "impulse_z_kg_m_per_s",
          "twist_x_kg_m2_per_s",
          "twist_y_kg_m2_per_s",
          "twist_z_kg_m2_per_s",
          "kinetic_J",
          "elastic_J",
          "dissipated_J",
          "heat_content_J",
          "heat_exchanged_J",
          "latent_heat_J",
          "expansion_heat_J",
          "gas_mol",
          "volume_m3",
          "surface_m2",
          "contact_surface_m2",
          "temperature_min_C",
          "temperature_mean_C",
          "temperature_max_C",
          "max_speed_m_per_s",
          "height_m",
          "extent_x_m",
          "extent_y_m",
          "water_limited_kg",
          "vapour_heat_J",
          "water_remap_heat_J",
          "water_remap_momentum_x_kg_m_per_s",
          "water_remap_momentum_y_kg_m_per_s",
          "water_remap_momentum_z_kg_m_per_s",
          "retired_solid_kg",
          "retired_water_kg",
          "retired_momentum_x_kg_m_per_s",
          "retired_momentum_y_kg_m_per_s",
          "retired_momentum_z_kg_m_per_s",
          "retired_angular_momentum_x_kg_m2_per_s",
          "retired_angular_momentum_y_kg_m2_per_s",
          "retired_angular_momentum_z_kg_m2_per_s",
          "retired_heat_J",
          "retired_gas_mol",
          "emitted_solid_kg",
          "emitted_water_kg",
          "emitted_momentum_x_kg_m_per_s",
          "emitted_momentum_y_kg_m_per_s",
          "emitted_momentum_z_kg_m_per_s",
          "emitted_angular_momentum_x_kg_m2_per_s",
          "emitted_angular_momentum_y_kg_m2_per_s",
          "emitted_angular_momentum_z_kg_m2_per_s",
          "emitted_heat_J",
          "emitted_gas_mol"};
}

const std::vector<double>& Snapshot::operator[](std::string_view column) const {
  for (const auto& [name, values] : columns)
    if (name == column) return values;
  throw std::out_of_range("no column " + std::string(column));
}

namespace {

template <class Real>
class SimulationOf final : public Simulation {
  static constexpr int W = k_width<Real>;

 public:
  explicit SimulationOf(const Scene& scene) : scene_(scene), engine_(scene_) {
    for (std::size_t i = 0; i < scene_.emitters.size(); ++i)
      emitters_.push_back(std::make_unique<EmitterState>(scene_, scene_.emitters[i], i));
  }

  void begin() {
    engine_.add(fill_bodies(scene_));
    pour_due();
    engine_.start(first_target());
  }

  void resume(const CheckpointReader& in) {
    engine_.read(in);
    const auto poured = in.array<std::int64_t>("poured");
    if (poured.size() != emitters_.size()) throw InputError("the checkpoint has other emitters than the scene");
    for (std::size_t i = 0; i < emitters_.size(); ++i) emitters_[i]->skip_to(poured[i]);
  }

  bool advance(double target, double next_target, const std::function<bool()>& after_step) override {
    while (engine_.time() < target) {
      const double stop = std::min(target, next_event());
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
  const Budget& booked() const override { return engine_.booked(); }
  const Totals& totals() const override { return engine_.totals(); }
  const Totals& retired() const override { return engine_.retired(); }
  const Totals& emitted() const override { return engine_.emitted(); }
  std::pair<double, double> temperatures() const override { return {engine_.temperature_low(), engine_.temperature_high()}; }
  std::size_t bytes() const override { return engine_.bytes(); }
  std::size_t active_nodes() const override { return engine_.active_nodes(); }

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
      if (engine_.velocity().size() > 0) s.velocity.push_back(velocity(p));
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

  std::vector<double> ledger_row() const override {
    const Totals& t = engine_.totals();
    const Budget& b = engine_.booked();
    const Counters& c = engine_.counters();
    const auto total = [&](Total which) { return t[static_cast<std::size_t>(which)]; };
    const auto booked = [&](Entry which) { return b[static_cast<std::size_t>(which)]; };
    Point low{k_infinity, k_infinity, k_infinity}, high{-k_infinity, -k_infinity, -k_infinity};
    for_each_particle([&](const ParticleSlot& p) {
      const Point x = position(p);
      for (std::size_t d = 0; d < 3; ++d) low[d] = std::min(low[d], x[d]), high[d] = std::max(high[d], x[d]);
    });
    const bool none = engine_.particles() == 0, cold = none || !engine_.physics().has_heat;
    const auto [coldest, hottest] = temperatures();
    std::vector<double> row{engine_.time(),
                            double(c.steps),
                            engine_.dt(),
                            double(engine_.particles()),
                            double(c.retired),
                            double(c.clamped),
                            total(Total::solid_mass),
                            total(Total::water_mass),
                            booked(Entry::evaporated)};
    for (const Total which :
         {Total::momentum_x, Total::momentum_y, Total::momentum_z, Total::angular_x, Total::angular_y, Total::angular_z})
      row.push_back(total(which));
    for (const Entry which : {Entry::impulse_x, Entry::impulse_y, Entry::impulse_z, Entry::twist_x, Entry::twist_y, Entry::twist_z})
      row.push_back(booked(which));
    for (const double value : {total(Total::kinetic),
                               total(Total::elastic),
                               booked(Entry::dissipated),
                               total(Total::heat_content),
                               booked(Entry::exchanged),
                               booked(Entry::latent),
                               booked(Entry::expansion),
                               total(Total::gas),
                               total(Total::volume),
                               booked(Entry::area),
                               booked(Entry::contact_area),
                               cold ? 0 : coldest,
                               cold ? 0 : total(Total::temperature) / total(Total::volume),
                               cold ? 0 : hottest,
                               engine_.largest_speed(),
                               none ? 0 : high[2] - low[2],
                               none ? 0 : high[0] - low[0],
                               none ? 0 : high[1] - low[1],
                               booked(Entry::water_limited),
                               booked(Entry::vapour_heat),
                               booked(Entry::remapped_heat),
                               booked(Entry::remapped_x),
                               booked(Entry::remapped_y),
                               booked(Entry::remapped_z)})
      row.push_back(value);
    for (const Totals& who : {engine_.retired(), engine_.emitted()})
      for (const Total which : {Total::solid_mass, Total::water_mass, Total::momentum_x, Total::momentum_y, Total::momentum_z,
                                Total::angular_x, Total::angular_y, Total::angular_z, Total::heat_content, Total::gas})
        row.push_back(who[static_cast<std::size_t>(which)]);
    return row;
  }

  void write_frame_file(const std::filesystem::path& path) const override {
    const std::vector<ParticleSlot> slots = slots_by_identity();
    std::vector<float> x, v;
    std::vector<std::int64_t> id, material;
    for (const ParticleSlot& p : slots) {
      id.push_back(identity_of<Real>(p.columns, p.lane));
      material.push_back(engine_.store().tiles[p.tile].material);
      for (const double c : position(p)) x.push_back(static_cast<float>(c));
      if (engine_.velocity().size() > 0)
        for (const double c : velocity(p)) v.push_back(static_cast<float>(c));
    }
    FrameData frame;
    frame.positions = x;
    frame.columns.push_back({"id", "1", std::span<const std::int64_t>(id)});
    frame.columns.push_back({"material", "1", std::span<const std::int64_t>(material)});
    if (!v.empty() || (slots.empty() && engine_.physics().moves))
      frame.columns.push_back({"velocity", "m/s", std::span<const float>(v), 3});
    std::vector<std::vector<float>> kept;  // spans into it
    kept.reserve(16);
    const auto scalar = [&](const char* name, const char* unit, auto value_of) {
      std::vector<float>& values = kept.emplace_back();
      values.reserve(slots.size());
      for (const ParticleSlot& p : slots) values.push_back(static_cast<float>(value_of(p)));
      frame.columns.push_back({name, unit, std::span<const float>(values)});
    };
    const auto column = [&](const char* name) { return engine_.physics().column_of(name); };
    const auto stored = [&](const char* name, const char* unit, int column) {
      scalar(name, unit, [=](const ParticleSlot& p) { return number(p, column); });
    };
    const auto material_of = [&](const ParticleSlot& p) -> const Material& {
      return scene_.materials[static_cast<std::size_t>(engine_.store().tiles[p.tile].material)];
    };
    const int V_0 = column(field::InitialVolume::name), J = column(field::VolumeRatio::name), m_w = column(field::WaterMass::name);
    const auto volume = [=](const ParticleSlot& p) { return J < 0 ? number(p, V_0) : number(p, V_0) * number(p, J); };
    scalar("volume", "m^3", volume);
    if (J >= 0) stored("volume_ratio", "1", J);
    if (const int theta = column(field::Temperature::name); theta >= 0) {
      stored("temperature", "C", theta);
      stored("peak_temperature", "C", column(field::PeakTemperature::name));
    }
    if (m_w >= 0) {
      stored("water_mass", "kg", m_w);
      scalar("saturation", "1",
             [&](const ParticleSlot& p) { return number(p, m_w) / (of<Water>(material_of(p)).water_density_kg_per_m3 * volume(p)); });
    }
    if (const int J_P = column(field::PlasticVolumeRatio::name); J_P >= 0) {
      stored("plastic_volume_ratio", "1", J_P);
      scalar("porosity", "1", [&](const ParticleSlot& p) { return 1 - (1 - material_of(p).initial_porosity) / number(p, J); });
    }
    if (const int nu = column(field::ProducedGas::name); nu >= 0) {
      stored("produced_gas", "mol/m^3", nu);
      stored("leavener", "1", column(field::Leavener::name));
    }
    write_frame(path, engine_.time(), frame);
  }

 private:
  double first_target() const { return std::min(1 / scene_.run.frame_rate_per_s, next_event()); }
  /// Whatever happens next besides frames: pouring, colliders that come and go.
  double next_event() const { return event_after(engine_.time()); }
  double event_after(double time) const {
    double next = engine_.next_event(time);
    for (const auto& emitter : emitters_)
      if (emitter->next_time() > time) next = std::min(next, emitter->next_time());
    return next;
  }
  void pour_due() {
    for (const auto& emitter : emitters_)
      while (emitter->next_time() <= engine_.time()) engine_.add(emitter->pour(), true);
  }

  /// Where a particle is kept; its numbers are the lane of the tile's columns.
  struct ParticleSlot {
    std::size_t block, tile;
    int lane;
    const Lanes<Real>* columns;
  };

  template <class Visit>
  void for_each_particle(Visit visit) const {
    const auto& store = engine_.store();
    for (std::size_t b = 0; b < store.blocks.size(); ++b)
      for (std::int32_t t = store.blocks[b].first_tile; t < store.blocks[b].first_tile + store.blocks[b].tiles; ++t) {
        const auto tile = static_cast<std::size_t>(t);
        for (int l = 0; l < store.tiles[tile].count; ++l) visit(ParticleSlot{b, tile, l, store.tile(tile)});
      }
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
    return origin + engine_.geometry().dx() *
                        Vector3{number(p, k_position_column), number(p, k_position_column + 1), number(p, k_position_column + 2)};
  }
  Vector3 velocity(const ParticleSlot& p) const {
    const Real* v = engine_.velocity().data() + p.tile * 3 * W + p.lane;
    return {double(v[0]), double(v[W]), double(v[2 * W])};
  }

  const Scene scene_;
  Engine<Real> engine_;
  std::vector<std::unique_ptr<EmitterState>> emitters_;
};

template <class Real>
std::unique_ptr<Simulation> make(const Scene& scene, const CheckpointReader* checkpoint) {
  auto simulation = std::make_unique<SimulationOf<Real>>(scene);
  if (checkpoint)
    simulation->resume(*checkpoint);
  else
    simulation->begin();
  return simulation;
}

}  // namespace

std::unique_ptr<Simulation> Simulation::begin(const Scene& scene) {
  return scene.run.precision == Precision::single_precision ? make<float>(scene, nullptr) : make<double>(scene, nullptr);
}

std::unique_ptr<Simulation> Simulation::resume(const Scene& scene, const CheckpointReader& checkpoint) {
  return scene.run.precision == Precision::single_precision ? make<float>(scene, &checkpoint) : make<double>(scene, &checkpoint);
}

}  // namespace bake
