// SPDX-License-Identifier: MIT
#include "experiments/accuracy/running.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/machines/stopwatch.h"
#include "experiments/common/study_scene.h"
#include "reference/compare/recipe_of.h"
#include "solver/core/errors.h"
#include "solver/effects/all_effects.h"
#include "solver/run/fill_scene.h"
#include "solver/run/ledger.h"

namespace bake::studies::accuracy {

namespace {

template <class Work>
void timed(Found& found, Work work) {
  const bench::Stopwatch watch;
  work();
  found.wall_s += watch.wall_s();
  found.cpu_s += watch.cpu_s();
}

void count_steps(const Simulation& simulation, Found& found) {
  found.particles = static_cast<std::int64_t>(simulation.particles());
  found.steps = simulation.counters().steps;
  found.particle_steps = simulation.counters().particle_steps;
}

/// The solver, whose step is fused: one pass over the particles.
class Fused final : public Running {
 public:
  Fused(const Scene& scene, const NodalForce& force) : simulation_(Simulation::begin(scene)) {
    if (force) simulation_->set_force(force);
  }
  void advance(double time, Found& found) override {
    timed(found, [&] { run_to(*simulation_, time); });
  }
  void count(Found& found) const override { count_steps(*simulation_, found); }
  Snapshot snapshot() const override { return simulation_->snapshot(); }
  std::vector<std::string> ledger_names() const override { return ledger_columns(); }
  std::vector<double> ledger_row() const override { return bake::ledger_row(*simulation_); }
  void write_frame_file(const std::filesystem::path& path) const override { simulation_->write_frame_file(path); }

 private:
  std::unique_ptr<Simulation> simulation_;
};

/// The textbook baker, whose step is staged as the paper's: scatter, grid, gather. The solver goes along to choose the steps.
class Staged final : public Running {
 public:
  explicit Staged(const Scene& scene) : scene_(scene), chooser_(Simulation::begin(scene)), baker_(recipe_of(scene)) {
    if (!scene.emitters.empty()) throw std::logic_error("emitters by the textbook");
    for (const NewParticle& p : fill_bodies(scene)) baker_.add(beginning_of(scene, p, filled_++));
    baker_.step(0, surroundings_of(scene, 0, 0));
    water_at_start_ = sum([](const textbook::Particle& p) { return p.m_w; });
  }

  void advance(double time, Found& found) override {
    while (chooser_->time() < time) {
      const double begin = chooser_->time(), dt = chooser_->dt();
      chooser_->advance(time, time, [] { return false; });
      const textbook::Surroundings surroundings = surroundings_of(scene_, begin, dt);
      timed(found, [&] { baker_.step(dt, surroundings); });
    }
    if (baker_.particles().size() != static_cast<std::size_t>(filled_))
      throw RunError("particles left the domain, which the textbook does not book");
  }
  void count(Found& found) const override { count_steps(*chooser_, found); }

  Snapshot snapshot() const override {
    Snapshot s;
    std::vector<double> temperature, water, volume;
    for (const textbook::Particle& p : baker_.particles()) {
      s.id.push_back(p.id);
      s.material.push_back(p.material);
      s.position.push_back({p.x[0], p.x[1], p.x[2]});
      s.velocity.push_back({p.v[0], p.v[1], p.v[2]});
      temperature.push_back(p.theta);
      water.push_back(p.m_w);
      volume.push_back(p.V_0);
    }
    s.columns = {{field::Temperature::name, temperature}, {field::WaterMass::name, water}, {field::InitialVolume::name, volume}};
    return s;
  }

  std::vector<std::string> ledger_names() const override {
    return {"time_s",  "volume_m3",         "water_mass_kg",        "water_evaporated_kg", "temperature_mean_C",
            "gas_mol", "emitted_volume_m3", "emitted_water_mass_kg"};
  }
  std::vector<double> ledger_row() const override {
    const double volume = sum([](const textbook::Particle& p) { return p.V(); });
    const double water = sum([](const textbook::Particle& p) { return p.m_w - p.m_w_lent; });
    return {chooser_->time(),
            volume,
            water,
            water_at_start_ - water,  // of bodies that stay in the domain
            sum([](const textbook::Particle& p) { return p.theta * p.V(); }) / volume,
            sum([](const textbook::Particle& p) { return p.nu * p.V_0; }),
            0,  // nothing is poured
            0};
  }
  void write_frame_file(const std::filesystem::path& path) const override {
    std::vector<float> x, temperature;
    std::vector<std::int64_t> id;
    for (const textbook::Particle& p : baker_.particles()) {
      id.push_back(p.id);
      for (int d = 0; d < 3; ++d) x.push_back(static_cast<float>(p.x[d]));
      temperature.push_back(static_cast<float>(p.theta));
    }
    write_frame(path, chooser_->time(), {x, {{"id", "1", id}, {"temperature", "C", temperature}}});
  }

 private:
  template <class Of>
  double sum(Of of) const {
    double all = 0;
    for (const textbook::Particle& p : baker_.particles()) all += of(p);
    return all;
  }

  const Scene scene_;
  std::unique_ptr<Simulation> chooser_;
  textbook::Baker baker_;
  std::int64_t filled_ = 0;  ///< particles
  double water_at_start_ = 0;
};

/// A run that came apart asks for ever smaller steps: it is to fail, not to go on for hours. Those that held took at most a fifth of these.
Scene bounded(Scene scene, double end_s) {
  constexpr double k_most_steps = 3e5;
  scene.time.smallest_step_s = std::max(scene.time.smallest_step_s, end_s / k_most_steps);
  return scene;
}

std::unique_ptr<Running> begin(const Scene& scene, By by, const NodalForce& force) {
  if (by == By::solver) return std::make_unique<Fused>(scene, force);
  if (force) throw std::logic_error("a force by the textbook");
  return std::make_unique<Staged>(scene);
}

}  // namespace

Found run(const Scene& scene, By by, double end_s, const Work& work, const NodalForce& force) {
  omp_set_num_threads(1);
  Found found;
  std::unique_ptr<Running> running;
  try {
    running = begin(bounded(scene, end_s), by, force);
    work(*running, found);
    if (!std::isfinite(found.error)) found.failure = "the result is no number";
  } catch (const RunError& error) {
    found.failure = error.what();
  }
  if (running) running->count(found);
  return found;
}

Found simulate(const Scene& scene, By by, const std::vector<double>& times, const Compare& compare, const NodalForce& force) {
  const auto work = [&](Running& running, Found& found) {
    std::vector<Snapshot> seen;
    for (const double t : times) {
      if (t > 0) running.advance(t, found);
      seen.push_back(running.snapshot());
    }
    found.error = compare(seen);
  };
  return run(scene, by, times.back(), work, force);
}

}  // namespace bake::studies::accuracy
