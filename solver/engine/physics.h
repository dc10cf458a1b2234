// SPDX-License-Identifier: MIT
// What the engine knows of a model: how many numbers go where, and three functions on lanes.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "solver/boundary/obstacles.h"
#include "solver/core/curve.h"
#include "solver/core/lanes.h"
#include "solver/core/step_limit.h"
#include "solver/core/surface_layer.h"

namespace bake {

struct Scene;
struct Body;

/// One step's numbers, in SI units.
template <class Real>
struct Step {
  Real dt = 0;         ///< of the step whose grid is being gathered [s]
  Real dt_next = 0;    ///< of the step that is being scattered [s]
  Real baking_dt = 0;  ///< of heat, water, leavener: dt, but 0 while the dough settles [s]
  Real baking_dt_next = 0;
  Real dx = 0;         ///< node distance [m]
  Real inverse_d = 0;  ///< D^-1 of the kernel [1/m^2]
};

inline constexpr int k_most_booked = 24, k_most_totals = 20, k_most_highest = 4, k_most_bounds = 8;

/// What is booked in a step; which number is which is said by Physics::booked.
using Budget = std::array<double, k_most_booked>;
using Totals = std::array<double, k_most_totals>;
using Highest = std::array<double, k_most_highest>;
using Bounds = std::array<double, k_most_bounds>;
inline constexpr double k_lowest = -1e30;  ///< below every maximum

inline void add_to(Budget& sum, const Budget& part) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += part[i];
}
template <std::size_t n>
void raise_to(std::array<double, n>& most, const std::array<double, n>& others) {
  for (std::size_t i = 0; i < n; ++i) most[i] = std::max(most[i], others[i]);
}

/// Where in a Budget the numbers stand that the engine itself books: those of Common, which come first.
enum CommonEntry { k_impulse_entry = 0, k_angular_impulse_entry = 3, k_area_entry = 6, k_contact_area_entry = 7 };

/// What a block of particles reports besides its scatter coefficients.
template <class Real>
struct Report {
  using V = Lanes<Real>;
  V alive;                      ///< 1 in lanes that hold a particle, else 0; set tile by tile
  Real origin[3] = {};          ///< position of the block's first node [m]
  V open_low[3], open_high[3];  ///< open faces of the domain, relative to the block in node distances
  V bounds[k_most_bounds] = {};
  V booked[k_most_booked] = {};
  const Obstacles* obstacles = nullptr;  ///< if there are any near that expel particles
  const Obstacles* holding = nullptr;    ///< if there is a grip near that holds a temperature
  bool totals_wanted = false;
  Totals totals{};
  Totals retired{};  ///< of the particles that leave in this step
  V highest[k_most_highest];

  Report() {
    for (V& v : highest) v = lanes<Real>(static_cast<Real>(k_lowest));
    for (int d = 0; d < 3; ++d) open_low[d] = lanes<Real>(-std::numeric_limits<Real>::infinity()), open_high[d] = -open_low[d];
  }
  /// Lanes that passed an open face.
  BAKE_INLINE LaneMask<Real> leaving(const V (&x)[3]) const {
    return (x[0] < open_low[0]) | (x[0] > open_high[0]) | (x[1] < open_low[1]) | (x[1] > open_high[1]) | (x[2] < open_low[2]) |
           (x[2] > open_high[2]);
  }
};

/// The surroundings of W nodes.
template <class Real>
struct Surroundings {
  using V = Lanes<Real>;
  V area;                  ///< free surface [m^2]
  V heat_transfer;         ///< sum of area times beta over air and hot colliders [W/K]
  V heat_transfer_source;  ///< sum of area times beta times theta_out [W]
  V saturation;            ///< s_out of the air
  V held;                  ///< temperature that a grip holds [C]
  LaneMask<Real> is_held;
};

/// What the grid update says of W nodes beside the rows that are gathered.
template <class Real>
struct NodeSums {
  using V = Lanes<Real>;
  V inertia{};      ///< what moves, the water that evaporates in this step included [kg]
  V heat_weight{};  ///< heat per degree, heat transfer included; 0 where the temperature is held [J/K] (backward Euler)
  V moved{};        ///< change of the water, evaporation included [kg]
  V evaporated{};   ///< [kg]
  V heat_taken{};   ///< by what changes state at the nodes [J]
};

/// A start that takes speed from the dough until it lies still, before the scene's time begins.
struct SettlingRule {
  double damping = 0;    ///< rate at which velocities decay; 0: there is no such start [1/s]
  double slow = 0;       ///< the dough lies still when none is faster for 1 / damping [m/s]
  double longest = 0;    ///< it ends then, still or not [s]
  int damped_entry = 0;  ///< in a Budget: energy that damping took [J]
};

/// A model as the engine sees it. All arrays of lanes are aligned to the register width.
template <class Real>
class Physics {
 public:
  using V = Lanes<Real>;
  virtual ~Physics() = default;

  /// Numbers of one name: a particle's column, or something that is booked, summed or compared.
  struct Quantity {
    std::string name, unit;
    int first, width;
  };
  std::vector<Quantity> columns;  ///< stored per particle, position and identity first
  std::vector<Quantity> booked, totals, highest, bounds;
  /// A derived or stored number of particles, as frames show it.
  struct FrameColumn {
    std::string name, unit;
    std::function<void(const V* columns, int material, double* values)> values;  ///< of a tile's W particles
  };
  std::vector<FrameColumn> frame_columns;
  /// First column of a field, -1 if no effect has it.
  int column_of(std::string_view name) const {
    for (const Quantity& column : columns)
      if (column.name == name) return column.first;
    return -1;
  }
  int column_count = 0;
  int scatter_channels = 0;  ///< numbers per node before the grid update
  int moment_channels = 0;   ///< the first so many of them have coefficients of the node offsets
  int gather_channels = 0;   ///< numbers per node after it

  // What the engine does for the effects; each sets its own.
  bool moves = false;                  ///< nodes have velocities (gathered channels 0 to 2), which gravity and contacts change
  VectorCurve gravity{Vector3{}};      ///< [m/s^2]
  double inertia_scale = 1;            ///< inertial mass over mass
  int speed_bound = 0;                 ///< in Bounds, where something moves: |v|^2 [m^2/s^2]
  int rate_bound = 0;                  ///< and |C|^2 [1/s^2]
  int own_bound = 0;                   ///< and the frequency of a particle alone, squared [1/s^2]
  SettlingRule settling;               ///< how the dough comes to rest before the scene's time begins
  bool samples_stress = false;         ///< what is sampled is not the velocity alone
  bool needs_surface = false;          ///< something passes the surface: it is measured
  bool moves_mass = false;             ///< mass moves between nodes or leaves them: NodeSums::moved and evaporated
  bool implicit_heat = false;          ///< conduction by backward Euler, to
  double heat_tolerance = 0;           ///< this relative residual
  bool printed_heat_transfer = false;  ///< surroundings take beta (theta_out - theta) from the nodes, theta being that before the step
  int volume_channel = -1;             ///< in a scattered row; -1: no surface is measured
  SurfaceLayer<Real> surface_layer;    ///< what resists fluxes through the surface
  double surface_rounding = 0;         ///< area that smoothing takes off a curved surface, per (dx (k_1 + k_2))^2
  int conductivity_channel = -1;       ///< in a scattered row; -1: the layer below the surface resists no heat
  int filled_channel = 0;              ///< in a scattered row: above zero where there are particles
  int temperature_channel = -1;        ///< in a gathered row, the change stands before it; -1: there is none
  double moved_specific_heat = 0;      ///< of the mass that moves or leaves [J/(kg K)]
  int sampled() const { return samples_stress ? 9 : 3; }  ///< numbers of a particle: velocity, Cauchy stress in the order of symmetric.h
  // where in a Budget the engine books what it knows only after the grid update
  int heat_entry = 0;            ///< heat that came in through surfaces [J]
  int left_heat_entry = 0;       ///< heat that mass took along when it left the nodes [J]
  int moved_heat_entry = 0;      ///< what moves between particles less what moves between nodes: heat [J],
  int moved_momentum_entry = 0;  ///< momentum [kg m/s]

  /// Gathers and advances the particles of a tile from t to t + dt, then says what they scatter in the step after.
  /// `gathered`: values, d/dx, d/dy, d/dz, each `gather_stride` lanes apart.
  /// `scattered`: values, then the coefficients of the node offsets per axis (in node distances), `scatter_stride` apart.
  /// `sampled`: if not null, receives what frames show and no column keeps: sampled() numbers.
  virtual void advance(V* columns, int material, const V* gathered, int gather_stride, V* scattered, int scatter_stride, V* sampled,
                       const Step<Real>&, Report<Real>&) const = 0;
  /// What new particles scatter in their first step.
  virtual void start(V* columns, int material, const V* velocity, const V* affine, V* scattered, int scatter_stride, const Step<Real>&,
                     Report<Real>&) const = 0;
  /// Grid update of W nodes: scattered channels in, gathered channels and sums out.
  virtual void update_nodes(const V* scattered, V* gathered, NodeSums<Real>& sums, const Surroundings<Real>&, const Step<Real>&,
                            Budget&) const = 0;
  /// The longest step that the effects allow where particles' maxima are `most`.
  virtual void limit_step(const Bounds& most, const StepScale& at, const Scene& scene, StepLimit& limit) const = 0;
  /// kappa V of a tile's particles [W m/K] (backward Euler).
  virtual V conductance(const V* columns, int material) const = 0;
  /// Inertial mass of a tile's particles [kg], and V_0 times the bulk modulus of all that they are made of [J]; where something moves.
  virtual void find_springs(const V* columns, int material, V& inertia, V& spring) const = 0;
  /// Writes the start state of one particle of a body into its lane.
  virtual void fill(V* columns, int lane, int material, double volume, const Body& body) const = 0;
};

/// The model of a scene: the instantiation that has just the effects that the scene lists. Throws InputError if there is none.
template <class Real>
std::unique_ptr<Physics<Real>> make_physics(const Scene& scene);

/// The same with the scene's skins, if it has any (solver/engine/skin_physics.cpp).
template <class Real>
std::unique_ptr<Physics<Real>> make_physics_with_skins(const Scene& scene);

}  // namespace bake
