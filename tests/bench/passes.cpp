// SPDX-License-Identifier: MIT
// Gather, scatter and law by themselves. A step does all three in one pass over the particles, so each is the difference between two
// passes of the same kernel over the same particles, on one thread, one after the other:
//   gather    a pass whose law does nothing and whose tiles hold no particle that scatters: tiles of nodes are loaded and added back,
//             weights made, values and gradients gathered and transposed, states looked over for what is not finite
//   scatter   a pass whose law does nothing, less the former
//   law       a whole pass, less that; every time from the same state
// In the whole pass the law hides some of the memory's latency that the others show, so the three need not add up to a step.
#include <benchmark/benchmark.h>
#include <omp.h>

#include <algorithm>

#include "analysis/machines/scenes.h"
#include "analysis/machines/stopwatch.h"
#include "solver/engine/engine.h"
#include "solver/grid/sort_particles.h"
#include "solver/run/fill_scene.h"
#include "tests/bench/counters.h"
#include "tests/bench/flops.h"
#include "tests/bench/steps.h"

namespace bake::bench {

namespace {

/// A law that does nothing, for particles and nodes of a true one's size.
template <class Real>
class Still final : public Physics<Real> {
  using V = Lanes<Real>;

 public:
  explicit Still(const Physics<Real>& like) {
    this->column_count = like.column_count;
    this->scatter_channels = like.scatter_channels;
    this->moment_channels = like.moment_channels;
    this->gather_channels = like.gather_channels;
  }
  void advance(V*, int, const V* gathered, int, V* scattered, int, V*, const Step<Real>&, Report<Real>&) const override {
    benchmark::DoNotOptimize(gathered);
    benchmark::DoNotOptimize(scattered);
  }
  void start(V*, int, const V*, const V*, V*, int, const Step<Real>&, Report<Real>&) const override {}
  void update_nodes(const V*, V*, NodeSums<Real>&, const Surroundings<Real>&, const Step<Real>&, Budget&) const override {}
  void limit_step(const Bounds&, const StepScale&, const Scene&, StepLimit&) const override {}
  V conductance(const V*, int) const override { return V{}; }
  void find_springs(const V*, int, V&, V&) const override {}
  void fill(V*, int, int, double, const Body&) const override {}
};

/// The particles of a loaf after some steps, freshly ordered, between two grids at rest.
template <class Real>
class Passes {
 public:
  explicit Passes(double particles)
      : scene_(loaf(k_combinations[12], sizeof(Real) == 4 ? Precision::single_precision : Precision::double_precision, particles)),
        physics_(make_physics<Real>(scene_)),
        still_(*physics_),
        kernel_(make_block_kernel<Real>(scene_.grid.kernel, *physics_)),
        engine_(scene_),
        contacts_(scene_, engine_.geometry()) {
    engine_.add(fill_bodies(scene_));
    engine_.start(1);
    for (int step = 0; step < 20; ++step) engine_.step(1, 1);
    store_ = ParticleStore<Real>(engine_.store());
    sort_particles<Real>(store_, nullptr, engine_.geometry(), nullptr);
    kept_.resize_and_forget(store_.data.size());
    std::copy_n(store_.data.data(), store_.data.size(), kept_.data());
    for (const Tile& tile : store_.tiles) counts_.push_back(tile.count);
    active_.surround(store_.blocks, engine_.geometry());
    const std::size_t nodes = active_.at.size() * k_block_nodes;
    gathered_.resize_and_forget(nodes * static_cast<std::size_t>(kernel_->gathered_row()));
    scattered_.resize_and_forget(nodes * static_cast<std::size_t>(kernel_->scattered_row()));
    contacts_.prepare(engine_.time());
    pass(still_);  // blocks learn which nodes they touch
  }

  double particles() const { return static_cast<double>(engine_.particles()); }
  double nodes_per_particle() const { return static_cast<double>(active_.at.size() * k_block_nodes) / particles(); }
  const Physics<Real>& physics() const { return *physics_; }
  const Scene& scene() const { return scene_; }
  const BlockKernel<Real>& kernel() const { return *kernel_; }

  // Each gives seconds.
  double gather_s() {
    for (Tile& tile : store_.tiles) tile.count = 0;
    const double seconds = pass(still_);
    for (std::size_t t = 0; t < counts_.size(); ++t) store_.tiles[t].count = counts_[t];
    return seconds;
  }
  double transfer_s() { return pass(still_); }
  double whole_s() {
    const double seconds = pass(*physics_);
    std::copy_n(kept_.data(), kept_.size(), store_.data.data());
    return seconds;
  }

 private:
  double pass(const Physics<Real>& physics) {
    const double dx = engine_.geometry().dx();
    BlockWork<Real> work;
    work.store = &store_;
    work.physics = &physics;
    work.gathered = gathered_.data();
    work.scattered = scattered_.data();
    work.contacts = &contacts_;
    work.step.dt = work.step.dt_next = work.step.baking_dt = work.step.baking_dt_next = static_cast<Real>(engine_.dt());
    work.step.dx = static_cast<Real>(dx);
    work.step.inverse_d = static_cast<Real>(4 / (dx * dx));
    for (int d = 0; d < 3; ++d) {
      work.origin[d] = static_cast<Real>(engine_.geometry().origin({0, 0, 0})[static_cast<std::size_t>(d)]);
      work.low_face[d] = static_cast<Real>(engine_.geometry().low_face());
      work.high_face[d] = static_cast<Real>(engine_.geometry().high_face(d));
    }
    std::vector<BlockResult<Real>> results(store_.blocks.size());
    const Stopwatch watch;
    for (std::size_t b = 0; b < store_.blocks.size(); ++b) kernel_->advance(work, static_cast<int>(b), scratch_, results[b], false);
    return watch.wall_s();
  }

  Scene scene_;
  std::unique_ptr<Physics<Real>> physics_;
  Still<Real> still_;
  std::unique_ptr<BlockKernel<Real>> kernel_;
  Engine<Real> engine_;
  Contacts contacts_;
  ParticleStore<Real> store_;
  AlignedBuffer<Real> kept_;
  std::vector<std::int32_t> counts_;
  ActiveBlocks active_;
  AlignedBuffer<Real> gathered_, scattered_;
  Scratch<Real> scratch_;
};

enum class Part { gather, scatter, law };

template <class Real>
void time_part(benchmark::State& state, Part part, double peak_GFLOPs, double triad_GB_per_s) {
  const int all = omp_get_max_threads();
  omp_set_num_threads(1);
  Passes<Real> passes(5e5);
  double seconds = 0;
  for ([[maybe_unused]] auto once : state) {
    double taken = 0;
    if (part == Part::gather) taken = passes.gather_s();
    if (part == Part::scatter) taken = passes.transfer_s() - passes.gather_s();
    if (part == Part::law) taken = passes.whole_s() - passes.transfer_s();
    taken = std::max(taken, 1e-9);  // where others use the machine a difference may come out below zero
    state.SetIterationTime(taken);
    seconds += taken;
  }
  omp_set_num_threads(all);
  const Physics<Real>& physics = passes.physics();
  // the gather reads the columns and the rows, the scatter reads and writes rows, the law writes the columns
  const double flops = part == Part::gather    ? gather_flops(physics)
                       : part == Part::scatter ? scatter_flops(physics)
                                               : law_flops(passes.scene());
  const double nodes = passes.nodes_per_particle();
  const double numbers = part == Part::gather    ? physics.column_count + nodes * passes.kernel().gathered_row()
                         : part == Part::scatter ? 2 * nodes * passes.kernel().scattered_row()
                                                 : physics.column_count;
  const double rate = passes.particles() * static_cast<double>(state.iterations()) / seconds;
  set_counter(state.counters, "M/s", 1e-6 * rate);
  set_counter(state.counters, "ns", 1e9 / rate);
  set_counter(state.counters, "flops", flops);
  set_counter(state.counters, "bytes", static_cast<double>(sizeof(Real)) * numbers);
  set_counter(state.counters, "peak", 1e-9 * flops * rate / peak_GFLOPs);
  set_counter(state.counters, "triad", 1e-9 * static_cast<double>(sizeof(Real)) * numbers * rate / triad_GB_per_s);
}

/// The engine's own clock around the grid update of whole steps: surface measure, exchange, forces and contact.
template <class Real>
void time_grid(benchmark::State& state, int threads, double triad_GB_per_s) {
  const int all = omp_get_max_threads();
  omp_set_num_threads(threads);
  const Scene scene = loaf(k_combinations[12], sizeof(Real) == 4 ? Precision::single_precision : Precision::double_precision, 5e5);
  Engine<Real> engine(scene);
  engine.add(fill_bodies(scene));
  engine.start(1);
  for (int step = 0; step < 20; ++step) engine.step(1, 1);
  const PhaseSeconds before = engine.phases();
  double last = before.grid;
  for ([[maybe_unused]] auto once : state) {
    engine.step(1, 1);
    state.SetIterationTime(engine.phases().grid - last);
    last = engine.phases().grid;
  }
  omp_set_num_threads(all);
  const PhaseSeconds& after = engine.phases();
  const double grid = after.grid - before.grid, transfer = after.transfer - before.transfer, ordering = after.ordering - before.ordering;
  const auto nodes = static_cast<double>(engine.active_nodes()), particles = static_cast<double>(engine.particles());
  const double bytes = sizeof(Real) * (2. * engine.scattered_row() + engine.gathered_row());  // one row is read and cleared, one written
  const double rate = nodes * static_cast<double>(state.iterations()) / grid;
  set_counter(state.counters, "Mnodes/s", 1e-6 * rate);
  set_counter(state.counters, "ns", 1e9 * nodes / particles / rate);
  set_counter(state.counters, "bytes", bytes);
  set_counter(state.counters, "triad", 1e-9 * bytes * rate / triad_GB_per_s);
  for (const auto& [name, seconds] :
       {std::pair("share_grid", grid), std::pair("share_transfer", transfer), std::pair("share_ordering", ordering)})
    set_counter(state.counters, name, seconds / (grid + transfer + ordering));
}

template <class Real>
void register_in(const std::string& precision, const Limits& limits, const Rate& peak) {
  for (const auto& [name, part] : {std::pair("gather", Part::gather), std::pair("scatter", Part::scatter), std::pair("law", Part::law)})
    benchmark::RegisterBenchmark(("Part/" + std::string(name) + "/" + precision + "/500K/threads:1").c_str(), time_part<Real>, part,
                                 peak.one, limits.triad_GB_per_s.one)
        ->Unit(benchmark::kMillisecond)
        ->Iterations(10)
        ->UseManualTime();
  for (const int threads : limits.thread_counts())
    benchmark::RegisterBenchmark(("Part/grid/" + precision + "/500K/threads:" + std::to_string(threads)).c_str(), time_grid<Real>, threads,
                                 threads == 1 ? limits.triad_GB_per_s.one : limits.triad_GB_per_s.all)
        ->Unit(benchmark::kMillisecond)
        ->Iterations(20)
        ->UseManualTime();
}

}  // namespace

void register_passes(const Limits& limits) {
  register_in<float>("single", limits, limits.single_GFLOPs);
  register_in<double>("double", limits, limits.double_GFLOPs);
}

}  // namespace bake::bench
