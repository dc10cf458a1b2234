// SPDX-License-Identifier: MIT
// The engine: one scatter (P2G), one grid update and one gather (G2P) per step. The gather of a step and the scatter of the next are
// fused into one pass over the particles (G2P2G). docs/fused_step.md is a map of it.
//
// Between passes the state is: the particles' columns, the scattered grid, the time, and the step that the grid was
// scattered for. Velocity, stress and fluxes live in registers inside the pass and are stored nowhere. That state is what a
// checkpoint holds, so that a run can stop at any step and go on with the same bits.
//
// Same bits for any number of threads: a node's sums have one order (colour, block, tile, lane), sums over
// blocks are added in block order, and threads only decide who does which block.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "solver/core/errors.h"
#include "solver/engine/block_colours.h"
#include "solver/engine/block_kernel.h"
#include "solver/engine/contacts.h"
#include "solver/engine/engine_types.h"
#include "solver/engine/implicit_heat.h"
#include "solver/engine/sheets.h"
#include "solver/engine/surface.h"
#include "solver/engine/time_step.h"
#include "solver/io/checkpoint.h"
#include "solver/scene/scene.h"

namespace bake {

template <class Real>
class Engine {
 public:
  explicit Engine(const Scene& scene);

  /// Makes room for so many particles more.
  void reserve(std::size_t more);
  /// Adds particles, all of them in the domain, between passes, with consecutive identities; those that are poured are booked.
  void add(const std::vector<NewParticle>& particles, bool poured = false);
  /// Puts skins onto the bodies: a mesh at rest for each of the scene's, and their vertices as particles in the same order. Once, after the
  /// bodies were added.
  /// `covers`: of each vertex, the area of the body's surface above it over its own.
  void cover(std::vector<SurfaceMesh> skins, const std::vector<NewParticle>& vertices, const std::vector<double>& covers);
  /// A first pass without time, which finds fluxes, limits and totals, and scatters for the first step. Once, after the first
  /// add; not after read().
  void start(double first_target);
  /// One step: grid update, then gather and scatter. `target` bounds the step, `next_target` the one after a step that
  /// reaches it. If the step reaches `target`, totals (and velocities) are sampled. Throws RunError.
  void step(double target, double next_target);
  /// From now on `force` acts on every node with mass, before contact, and is booked as an impulse. No part of a checkpoint.
  void set_force(NodalForce force) { force_ = std::move(force); }

  double time() const { return time_; }
  double dt() const { return dt_; }
  const Counters& counters() const { return counters_; }
  std::size_t identities_given() const { return static_cast<std::size_t>(next_identity_); }  ///< those of particles are below
  const Budget& booked() const { return booked_; }            ///< sums since the start (area: of the last step)
  const Totals& totals() const { return totals_; }            ///< at the last sample
  const Totals& retired() const { return retired_; }          ///< sums since the start over particles when they left
  const Totals& emitted() const { return emitted_; }          ///< sums since the start over particles when they were poured
  const Highest& highest() const { return highest_; }         ///< at the last sample; -1e30 without particles
  const Bounds& bounds() const { return bounds_; }            ///< of the last step
  const std::vector<Given>& given() const { return given_; }  ///< sums since the start, by their numbers among givers_of(scene)
  const PhaseSeconds& phases() const { return phases_; }
  const Settling& settling() const { return settling_; }
  std::size_t particles() const { return particle_count_; }                  ///< without the vertices of skins
  const Sheets<Real>* skins() const { return skins_ ? &*skins_ : nullptr; }  ///< null without skins
  const ParticleStore<Real>& store() const { return store_; }
  /// [identity][Physics::sampled()] right after a sample; empty where nothing moves.
  const std::vector<Real>& sampled() const { return sampled_; }
  const Physics<Real>& physics() const { return *physics_; }
  const GridGeometry& geometry() const { return geometry_; }
  int scattered_row() const { return kernel_->scattered_row(); }  ///< numbers per node of the scattered grid
  int gathered_row() const { return kernel_->gathered_row(); }    ///< and of the gathered one
  std::size_t active_nodes() const { return active_.at.size() * k_block_nodes; }
  std::size_t bytes() const;                                                   ///< memory of particles and grid
  double next_event(double time) const { return contacts_.next_event(time); }  ///< see Contacts

  void write(CheckpointWriter& out) const;
  void read(const CheckpointReader& in);

 private:
  double baking_dt() const { return settling_.now ? 0 : dt_; }  ///< of heat, water, leavener, gravity
  Step<Real> current_step() const;
  BlockWork<Real> work(const Step<Real>& step);
  void update_grid();
  void measure_surface();
  void look_for_crumbs();
  /// Of omega^2 of a particle alone, the share that particles have which have the fewest others around them.
  double alone() const;
  bool keeps_surface() const { return physics_->needs_surface && scene_.surface.form == Form::standard && scene_.surface.keep_dx > 0; }
  double travelled(double dt) const;
  void write_surface(CheckpointWriter& out) const;
  void read_surface(const CheckpointReader& in);
  void update_block(std::size_t slot, const Air& air, const Step<Real>& step, Budget& booked);
  Given* given_in(std::size_t slot) { return block_given_.data() + slot * given_.size(); }
  Vector3 touched(std::size_t slot, int node, const NodeSums<Real>* sums, const Vector3& v, const NodesAround* around);
  template <class Power>
  void tell_heat(Power power);
  double face_beyond_grip() const;
  bool is_held(std::size_t slot, int node) const;
  void sum_given(const std::vector<Given>& of_blocks);
  /// Its mean over the step that begins at `time`.
  Vector3 gravity_from(double time) const { return physics_->gravity.mean(time, time + baking_dt()); }
  void find_fall(Lanes<Real> (&dv)[3]) const;
  /// Contact of a block's nodes: it depends on each alone; on those around, and follows when all are known; or none is touched, but those
  /// of other blocks depend on them.
  enum class ContactOf : char { own, later, asked };
  class Around;
  void touch_colliders();
  void measure_published_surface(const Air& air);
  bool is_empty(const Real* scattered) const;
  // of a block's nodes, pack by pack: surroundings, sums and channels
  static Surroundings<Real> surroundings(int pack, const BlockSurroundings<Real>* surface, const Air& air);
  void hold_temperatures(std::size_t slot, int first, const Lanes<Real>* scattered, Surroundings<Real>& around) const;
  template <class After>
  void change_velocities(std::size_t slot, const NodeSums<Real>* sums, Lanes<Real> (*nodes)[k_most_channels], Budget& booked,
                         NodeBits which, After after) const;
  void book_momentum(std::size_t slot, const NodeSums<Real>* sums, const Lanes<Real> (*nodes)[k_most_channels], const Lanes<Real> (&dv)[3],
                     Budget& booked) const;
  template <class Theta>
  void book_moved_heat(const NodeSums<Real>* sums, Theta theta, Budget& booked) const;
  Lanes<Real> temperatures(std::size_t slot, int pack) const;
  bool settle_on();
  double next_settling_step();
  void damp(std::size_t slot, const NodeSums<Real>* sums, Lanes<Real> (*nodes)[k_most_channels], Budget& booked) const;
  void pass(double after, double next_dt, bool next_settles, bool sample);
  void take_skins(Sheets<Real> skins);
  void pull_skins(double after, bool sample);
  void book_weight_of_skins();
  void migrate_particles(std::vector<Migrant<Real>>& migrants);
  void after_sorting();
  void remap_blocks(const ActiveBlocks& before);
  void sample_new(const std::vector<NewParticle>& added);
  void reduce(const std::vector<BlockResult<Real>>& results);
  void scatter_new(const ParticleStore<Real>& fresh, const std::vector<Real>& start, bool poured);
  double next_step(double from, double target, double next_target);
  [[noreturn]] void report_broken(const Migrant<Real>& migrant) const;
  std::int32_t home_of(const BlockIndex& block) const;

  const Scene& scene_;
  GridGeometry geometry_;
  std::unique_ptr<Physics<Real>> physics_;
  std::unique_ptr<BlockKernel<Real>> kernel_;
  Contacts contacts_;
  NodalForce force_;
  FreeSurfaceMeasure<Real> surface_;
  /// Since the surface was measured: how far a particle may have moved [dx], and what covered it then. Infinite: it must be measured.
  double surface_travel_ = k_infinity;
  std::vector<double> surface_covers_;
  std::vector<typename FreeSurfaceMeasure<Real>::Nodes> surface_volumes_;  ///< that it was measured from, if a checkpoint will ask for them

  /// What limits the step where particles have few others around them. It is looked for again once particles may have moved by a share of
  /// dx or their stiffness may have changed, but not more often than pays; in between they count as alone.
  static constexpr double k_crumbs_move_dx = 0.2;
  static constexpr std::int64_t k_fewest_steps_per_look = 20, k_most_steps_per_look = 200;
  double crumbs_share_ = 1, crumbs_travel_ = k_infinity;   ///< as found, and how far a particle may have moved since [dx]
  std::int64_t crumbs_looked_ = -k_fewest_steps_per_look;  ///< step of the last look

  ParticleStore<Real> store_;
  AlignedBuffer<Real> scattered_;  ///< what the next grid update takes
  AlignedBuffer<Real> gathered_;   ///< what the last grid update gave
  ActiveBlocks active_;
  BlockColours colours_;
  std::vector<Real> sampled_;
  std::vector<Scratch<Real>> scratch_;
  std::vector<BlockResult<Real>> results_;  ///< of the home blocks in a pass
  std::vector<Budget> block_budgets_;       ///< of the grid's blocks in an update
  std::vector<Given> block_given_;          ///< the same of what each giver gave: [block][givers]
  std::vector<Given> home_given_;           ///< of the home blocks in a pass
  ImplicitHeat<Real> implicit_heat_;
  std::vector<Real> heat_weight_, heat_transfer_;  ///< of the nodes, for backward Euler
  std::vector<NodeSums<Real>> sums_;               ///< of the nodes, W at a time
  std::optional<Sheets<Real>> skins_;
  std::vector<double> excess_mass_;    ///< inertia less mass of the skins' vertices, which gravity must not pull [kg]
  std::vector<ContactOf> contact_of_;  ///< by slot

  /// The longest time without sorting [steps]. Particles of a cell that stand together share what the scatter loads and stores; moving
  /// about, they lose each other long before one of them leaves its block and so has all of them sorted.
  static constexpr std::int64_t k_most_steps_unsorted = 100;

  double time_ = 0, dt_ = 0;
  std::int64_t last_sorted_ = 0;  ///< step of the last sorting
  std::int64_t next_identity_ = 0;
  std::size_t particle_count_ = 0;
  Bounds bounds_{};
  Highest highest_{};
  Counters counters_;
  PhaseSeconds phases_;
  Settling settling_;
  Budget booked_{};
  std::vector<Given> given_;  ///< by their numbers among givers_of(scene)
  Totals totals_{}, retired_{}, emitted_{};
};

extern template class Engine<float>;
extern template class Engine<double>;

}  // namespace bake
