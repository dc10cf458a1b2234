// SPDX-License-Identifier: MIT
#include "solver/baker/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "solver/baker/fill_scene.h"
#include "solver/boundary/vector3.h"
#include "solver/particles/fields.h"

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
    for (std::size_t i = 0; i < scene_.emitters.size(); ++i) spouts_.push_back(std::make_unique<Spout>(scene_, scene_.emitters[i], i));
  }

  void begin() {
    engine_.add(fill_bodies(scene_));
    pour_due();
    engine_.start(first_target());
  }

  void resume(const CheckpointReader& in) {
    engine_.read(in);
    const auto poured = in.array<std::int64_t>("poured");
    if (poured.size() != spouts_.size()) throw InputError("the checkpoint has other emitters than the scene");
    for (std::size_t i = 0; i < spouts_.size(); ++i) spouts_[i]->skip_to(poured[i]);
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
    for (const auto& spout : spouts_) poured.push_back(spout->poured());
    out.add("poured", std::span<const std::int64_t>(poured));
  }

  double time() const override { return engine_.time(); }
  double dt() const override { return engine_.dt(); }
  std::size_t particles() const override { return engine_.particles(); }
  const Counters& counters() const override { return engine_.counters(); }
  const Bookings& booked() const override { return engine_.booked(); }
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
                       physics.gather_channels, static_cast<std::size_t>(engine_.row_size()) * sizeof(Real));
  }

  Snapshot snapshot() const override {
    Snapshot s;
    const auto& physics = engine_.physics();
    for (const auto& c : physics.columns)
      if (c.first != k_position_column && c.first != k_identity_column) s.columns.push_back({c.name, {}});
    for_each_particle([&](const Lanes<Real>* columns, std::size_t tile, int l, const Point& origin) {
      s.id.push_back(identity_of<Real>(columns, l));
      s.material.push_back(engine_.store().tiles[tile].material);
      s.position.push_back(position(columns, l, origin));
      if (engine_.velocity().size() > 0) s.velocity.push_back(velocity(tile, l));
      std::size_t at = 0;
      for (const auto& c : physics.columns)
        if (c.first != k_position_column && c.first != k_identity_column) {
          for (int i = 0; i < c.width; ++i) s.columns[at].second.push_back(static_cast<double>(columns[c.first + i][l]));
          ++at;
        }
    });
    sort_by_identity(s);
    return s;
  }

  std::vector<double> ledger_row() const override {
    const Totals& t = engine_.totals();
    const Bookings& b = engine_.booked();
    const Counters& c = engine_.counters();
    const auto total = [&](Total which) { return t[static_cast<std::size_t>(which)]; };
    const auto booked = [&](Entry which) { return b[static_cast<std::size_t>(which)]; };
    Point low{k_infinity, k_infinity, k_infinity}, high{-k_infinity, -k_infinity, -k_infinity};
    for_each_particle([&](const Lanes<Real>* columns, std::size_t, int l, const Point& origin) {
      const Point x = position(columns, l, origin);
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
    const Snapshot s = snapshot();
    const std::size_t n = s.id.size();
    std::vector<float> x, v;
    for (const Vector3& p : s.position)
      for (const double c : p) x.push_back(static_cast<float>(c));
    for (const Vector3& u : s.velocity)
      for (const double c : u) v.push_back(static_cast<float>(c));
    std::vector<std::int64_t> material(s.material.begin(), s.material.end());
    FrameData frame;
    frame.positions = x;
    frame.columns.push_back({"id", "1", std::span<const std::int64_t>(s.id)});
    frame.columns.push_back({"material", "1", std::span<const std::int64_t>(material)});
    if (!v.empty() || (n == 0 && engine_.physics().moves)) frame.columns.push_back({"velocity", "m/s", std::span<const float>(v), 3});
    std::vector<std::vector<float>> kept;  // spans into it
    const auto scalar = [&](const char* name, const char* unit, auto value_of) {
      kept.emplace_back(n);
      for (std::size_t i = 0; i < n; ++i) kept.back()[i] = static_cast<float>(value_of(i));
      frame.columns.push_back({name, unit, std::span<const float>(kept.back())});
    };
    kept.reserve(16);
    const auto has = [&](const char* name) {
      return std::any_of(s.columns.begin(), s.columns.end(), [&](const auto& c) { return c.first == name; });
    };
    const bool moves = has(field::VolumeRatio::name);
    const auto& V_0 = s[field::InitialVolume::name];
    const auto volume = [&](std::size_t i) { return moves ? V_0[i] * s[field::VolumeRatio::name][i] : V_0[i]; };
    scalar("volume", "m^3", volume);
    if (moves) scalar("volume_ratio", "1", [&](std::size_t i) { return s[field::VolumeRatio::name][i]; });
    if (has(field::Temperature::name)) {
      scalar("temperature", "C", [&](std::size_t i) { return s[field::Temperature::name][i]; });
      scalar("peak_temperature", "C", [&](std::size_t i) { return s[field::PeakTemperature::name][i]; });
    }
    if (has(field::WaterMass::name)) {
      scalar("water_mass", "kg", [&](std::size_t i) { return s[field::WaterMass::name][i]; });
      scalar("saturation", "1", [&](std::size_t i) {
        const Material& m = scene_.materials[static_cast<std::size_t>(s.material[i])];
        return s[field::WaterMass::name][i] / (of<Water>(m).water_density_kg_per_m3 * volume(i));
      });
    }
    if (has(field::PlasticVolumeRatio::name)) {
      scalar("plastic_volume_ratio", "1", [&](std::size_t i) { return s[field::PlasticVolumeRatio::name][i]; });
      scalar("porosity", "1", [&](std::size_t i) {
        return 1 - (1 - scene_.materials[static_cast<std::size_t>(s.material[i])].initial_porosity) / s[field::VolumeRatio::name][i];
      });
    }
    if (has(field::ProducedGas::name)) {
      scalar("produced_gas", "mol/m^3", [&](std::size_t i) { return s[field::ProducedGas::name][i]; });
      scalar("leavener", "1", [&](std::size_t i) { return s[field::Leavener::name][i]; });
    }
    write_frame(path, engine_.time(), frame);
  }

 private:
  double first_target() const { return std::min(1 / scene_.run.frame_rate_per_s, next_event()); }
  /// Whatever happens next besides frames: pouring, colliders that come and go.
  double next_event() const { return event_after(engine_.time()); }
  double event_after(double time) const {
    double next = engine_.next_event(time);
    for (const auto& spout : spouts_)
      if (spout->next_time() > time) next = std::min(next, spout->next_time());
    return next;
  }
  void pour_due() {
    for (const auto& spout : spouts_)
      while (spout->next_time() <= engine_.time()) engine_.add(spout->pour(), true);
  }

  template <class Visit>
  void for_each_particle(Visit visit) const {
    const auto& store = engine_.store();
    for (const HomeBlock& block : store.blocks) {
      const Point origin = engine_.lattice().origin(block.at);
      for (std::int32_t t = block.first_tile; t < block.first_tile + block.tiles; ++t)
        for (int l = 0; l < store.tiles[static_cast<std::size_t>(t)].count; ++l)
          visit(store.tile(static_cast<std::size_t>(t)), static_cast<std::size_t>(t), l, origin);
    }
  }
  Point position(const Lanes<Real>* columns, int l, const Point& origin) const {
    Point x;
    for (std::size_t d = 0; d < 3; ++d) x[d] = origin[d] + engine_.lattice().dx() * static_cast<double>(columns[k_position_column + d][l]);
    return x;
  }
  Vector3 velocity(std::size_t tile, int l) const {
    const Real* v = engine_.velocity().data() + tile * 3 * W + l;
    return {double(v[0]), double(v[W]), double(v[2 * W])};
  }
  static void sort_by_identity(Snapshot& s) {
    std::vector<std::size_t> order(s.id.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return s.id[a] < s.id[b]; });
    const auto permute = [&](auto& values, std::size_t width) {
      auto sorted = values;
      for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t k = 0; k < width; ++k) sorted[i * width + k] = values[order[i] * width + k];
      values = std::move(sorted);
    };
    permute(s.id, 1);
    permute(s.material, 1);
    permute(s.position, 1);
    if (!s.velocity.empty()) permute(s.velocity, 1);
    for (auto& [name, values] : s.columns)
      if (!order.empty()) permute(values, values.size() / order.size());
  }

  const Scene scene_;
  Engine<Real> engine_;
  std::vector<std::unique_ptr<Spout>> spouts_;
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
