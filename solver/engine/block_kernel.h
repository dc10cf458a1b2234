// SPDX-License-Identifier: MIT
// The fused transfers (G2P2G) of one block of particles: gather from the grid (G2P), physics, scatter to the grid (P2G).
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "solver/engine/contacts.h"
#include "solver/engine/physics.h"
#include "solver/grid/grid.h"
#include "solver/grid/scatter.h"

namespace bake {

/// A particle that moved too far from its home block to scatter into the block's tile. It keeps what it has to scatter; the engine
/// moves it to its new home and scatters it after the pass, serially and in block order.
template <class Real>
struct Migrant {
  std::int32_t home;  ///< index of its home block
  std::int32_t tile, lane;
  bool retired;            ///< left through an open face
  bool broken;             ///< a number of its state is not finite
  std::vector<Real> rows;  ///< what it scatters, particle_rows() numbers
};

/// What expels particles, and books what it gave them.
class Expelling final : public Obstacles {
 public:
  Expelling(const Contacts& contacts, Given* given) : contacts_(contacts), given_(given) {}
  bool push_out(Point& x, Vector3& v, double mass) const override { return contacts_.push_out(x, v, mass, given_); }
  bool holds_temperature(const Point& x) const override { return contacts_.holds_temperature(x); }

 private:
  const Contacts& contacts_;
  Given* given_;
};

/// Everything that the kernel needs besides the block itself.
template <class Real>
struct BlockWork {
  ParticleStore<Real>* store = nullptr;
  const Physics<Real>* physics = nullptr;
  const Real* gathered = nullptr;  ///< the grid that the gather reads: rows of gathered_row() numbers
  Real* scattered = nullptr;       ///< the grid that the scatter adds to: rows of scattered_row() numbers
  Step<Real> step;
  Real* sampled = nullptr;  ///< if not null: [identity][Physics::sampled()]
  const Contacts* contacts = nullptr;
  Given* given = nullptr;  ///< if not null: [home block][givers], what solids give the particles that they expel
  std::size_t givers = 0;
  Real origin[3];                  ///< of the grid [m]
  Real low_face[3], high_face[3];  ///< domain, in node distances from the grid's first node
  bool open_low[3] = {}, open_high[3] = {};
};

/// What one block's transfers report.
template <class Real>
struct BlockResult {
  Budget booked{};
  Totals totals{}, retired{};
  Bounds bounds{};
  Highest highest;
  std::int64_t clamped = 0;
  std::vector<Migrant<Real>> migrants;
};

/// Folds lanes into sums and maxima, in a fixed order.
template <class Real>
void collect(const Report<Real>& report, BlockResult<Real>& result) {
  for (std::size_t e = 0; e < result.booked.size(); ++e) result.booked[e] = sum_lanes(report.booked[e]);
  result.totals = report.totals;
  result.retired = report.retired;
  for (std::size_t b = 0; b < result.bounds.size(); ++b) result.bounds[b] = static_cast<double>(largest_lane(report.bounds[b]));
  for (std::size_t h = 0; h < result.highest.size(); ++h) result.highest[h] = static_cast<double>(largest_lane(report.highest[h]));
}

/// Scratch memory of one thread.
template <class Real>
struct Scratch {
  AlignedBuffer<Real> gather_tile, scatter_tile;
};

template <class Real>
class BlockKernel {
 public:
  virtual ~BlockKernel() = default;
  virtual int scattered_row() const = 0;  ///< numbers per node of the grid that the scatter adds to
  virtual int gathered_row() const = 0;   ///< numbers per node of the grid that the gather reads
  /// Gather, physics and scatter of all particles of home block `index`.
  virtual void advance(const BlockWork<Real>&, int index, Scratch<Real>&, BlockResult<Real>&, bool totals) const = 0;
  virtual int particle_rows() const = 0;  ///< numbers that a particle scatters from: its values, and their slopes along each axis
  /// The values and node coefficients of W particles at `x` (block-relative, in node distances), turned into rows: `rows` receives W times
  /// particle_rows() numbers.
  virtual void to_rows(const Physics<Real>&, const Lanes<Real> (&x)[3], Lanes<Real>* scattered, Real* rows) const = 0;
  /// Adds one particle's rows to the grid around home block `index`: new particles, and those that left their block.
  virtual void scatter_rows(const BlockWork<Real>&, int index, const Real (&x)[3], const Real* rows) const = 0;
  /// Adds impulses on the particles of a tile of home block `index` to the momenta, the first three channels [kg m/s].
  virtual void push(const BlockWork<Real>&, int index, int tile, const Lanes<Real> (&impulse)[3]) const = 0;
  /// Takes W nodes' scattered rows: channels as lanes, up to scattered_row() of them. The rows are left zero.
  virtual void take_nodes(Real* rows, Lanes<Real>* channels) const = 0;
  /// Writes W nodes' gathered rows from gathered_row() channels.
  virtual void put_nodes(const Lanes<Real>* channels, Real* rows) const = 0;
};

/// The kernel of an order, with rows wide enough for the physics.
template <class Real>
std::unique_ptr<BlockKernel<Real>> make_block_kernel(KernelOrder order, const Physics<Real>& physics);

}  // namespace bake
