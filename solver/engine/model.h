// SPDX-License-Identifier: MIT
// A model is a list of effects, composed at compile time: columns, channels and code of the effects that are in the list, and of no
// others. What an effect may define stands in solver/effects/effect.h.
#pragma once

#include <bit>
#include <tuple>

#include "solver/effects/common.h"
#include "solver/engine/model_list.h"
#include "solver/engine/physics.h"
#include "solver/scene/scene.h"

namespace bake {

template <class Real, class... Effects>
class Model final : public Physics<Real> {
 public:
  using typename Physics<Real>::V;
  using Stored = Joined<Common::Stored, typename Effects::Stored...>;
  using Transient = Joined<typename Effects::Transient...>;
  using Scattered = Joined<typename Effects::Moments..., typename Effects::Values...>;
  using Gathered = Joined<typename Effects::Gathered...>;
  using Booked = Joined<Common::Booked, typename Effects::Booked...>;
  using Totals = Joined<Common::Totals, typename Effects::Totals...>;
  using Highest = Joined<typename Effects::Highest...>;
  using Bounds = Joined<typename Effects::Bounds...>;
  static constexpr int k_moments = (0 + ... + Effects::Moments::width);
  static_assert(Booked::width <= k_most_booked && Totals::width <= k_most_totals && Highest::width <= k_most_highest &&
                    Bounds::width <= k_most_bounds,
                "more quantities than solver/engine/physics.h has room for");
  // What the engine takes for granted.
  static_assert(Stored::template offset<field::Position> == 0);
  static_assert(Stored::template offset<field::Identity> == 3);
  static_assert(!Gathered::template has<channel::NodeVelocity> || Gathered::template offset<channel::NodeVelocity> == 0);
  static_assert(!Gathered::template has<channel::NodeTemperature> ||
                Gathered::template offset<channel::NodeTemperature> == Gathered::template offset<channel::TemperatureChange> + 1);
  static_assert(Booked::template offset<booked::Impulse> == k_impulse_entry);
  static_assert(Booked::template offset<booked::AngularImpulse> == k_angular_impulse_entry);
  static_assert(Booked::template offset<booked::Area> == k_area_entry);
  static_assert(Booked::template offset<booked::ContactArea> == k_contact_area_entry);

  explicit Model(const Scene& scene);

  void advance(V* columns, int material, const V* gathered, int gather_stride, V* scattered, int scatter_stride, V* sampled,
               const Step<Real>& step, Report<Real>& report) const override;
  void start(V* columns, int material, const V* velocity, const V* affine, V* scattered, int scatter_stride, const Step<Real>& step,
             Report<Real>& report) const override;
  void update_nodes(const V* scattered, V* gathered, NodeSums<Real>& sums, const Surroundings<Real>& around, const Step<Real>& step,
                    Budget& booked) const override;
  void limit_step(const bake::Bounds& most, const StepScale& at, const Scene& scene, StepLimit& limit) const override;
  V conductance(const V* columns, int material) const override;
  void find_springs(const V* columns, int material, V& inertia, V& spring) const override;
  void fill(V* columns, int lane, int material, double volume, const Body& body) const override;

 private:
  template <class Effect>
  using ConstantsOf = typename Effect::template Constants<Real>;
  template <class Effect>
  using NodeConstantsOf = typename Effect::template NodeConstants<Real>;
  struct Constants {
    Real theta_0;
    std::tuple<ConstantsOf<Effects>...> effects;
  };

  struct Books;
  struct NodeBooks;
  struct Shown;
  struct FrameColumns;
  struct Particle;
  struct From;
  struct To;
  struct Node;
  void push_out(Particle& p, const Step<Real>& step, Report<Real>& report) const;
  void count(Particle& p, const Constants& k, const Step<Real>& step, Report<Real>& report) const;
  void count_leaving(Particle& p, const Constants& k, const Step<Real>& step, LaneMask<Real> leaving, Report<Real>& report) const;
  void stress_and_scatter(Particle& p, const Constants& k, V* scattered, int stride, const Step<Real>& step, Report<Real>& report) const;

  std::vector<Constants> materials_;
  std::vector<Material> described_;  ///< as the scene has them, to fill particles
  std::tuple<NodeConstantsOf<Effects>...> nodes_;
};

/// A report as the effects see it.
template <class Real, class... Effects>
struct Model<Real, Effects...>::Books {
  Report<Real>& report;
  const Real (&origin)[3] = report.origin;  ///< position of the block's first node [m]

  template <class Q>
  BAKE_INLINE void book(Q, V amount, int i = 0) {
    static_assert(Booked::template has<Q>, "no effect of this model lists that quantity in Booked");
    report.booked[Booked::template offset<Q> + i] += report.alive * amount;
  }
  template <class Q>
  void add(Q, V amount, int i = 0) {
    static_assert(Totals::template has<Q>, "no effect of this model lists that quantity in Totals");
    report.totals[static_cast<std::size_t>(Totals::template offset<Q> + i)] += sum_lanes(report.alive * amount);
  }
  template <class Q>
  BAKE_INLINE void highest(Q, V value) {
    static_assert(Highest::template has<Q>, "no effect of this model lists that quantity in Highest");
    V& most = report.highest[Highest::template offset<Q>];
    most = max(most, value);
  }
  template <class Q>
  BAKE_INLINE void bound(Q, V value) {
    static_assert(Bounds::template has<Q>, "no effect of this model lists that quantity in Bounds");
    V& most = report.bounds[Bounds::template offset<Q>];
    most = max(most, value);
  }
  /// May particles be inside of a grip that holds its temperature?
  BAKE_INLINE bool any_held() const { return __builtin_expect(report.holding != nullptr, 0); }
  /// Which of the particles at x (of the block, in node distances) are.
  LaneMask<Real> held(const V* x, const Step<Real>& step) const {
    LaneMask<Real> held{};
    for (int l = 0; l < k_width<Real>; ++l) {
      Point at;
      for (std::size_t d = 0; d < 3; ++d) at[d] = static_cast<double>(origin[d] + step.dx * x[d][l]);
      held[l] = report.alive[l] != 0 && report.holding->holds_temperature(at) ? -1 : 0;
    }
    return held;
  }
};

/// A budget as the effects see it at W nodes.
template <class Real, class... Effects>
struct Model<Real, Effects...>::NodeBooks {
  Budget& budget;
  template <class Q>
  BAKE_INLINE void book(Q, V amount) {
    static_assert(Booked::template has<Q>, "no effect of this model lists that quantity in Booked");
    budget[static_cast<std::size_t>(Booked::template offset<Q>)] += sum_lanes(amount);
  }
};

/// One particle's stored numbers, in double.
template <class Real, class... Effects>
struct Model<Real, Effects...>::Shown {
  const V* columns;
  int lane;
  template <class F>
  double operator[](F) const {
    return static_cast<double>(columns[Stored::template offset<F>][lane]);
  }
  double volume() const {
    if constexpr (Stored::template has<field::VolumeRatio>) return (*this)[field::V_0] * (*this)[field::J];
    return (*this)[field::V_0];
  }
};

/// Takes down what the effects show of their particles in frames.
template <class Real, class... Effects>
struct Model<Real, Effects...>::FrameColumns {
  Model& model;
  template <class F>
  void sampled(F) {}  // no column of the store: whoever samples it writes it
  template <class F>
  void stored(F) {
    add(F::name, F::unit, [](const Shown& p, int) { return p[F{}]; });
  }
  /// `maker(material)` gives the function of a particle.
  template <class Maker>
  void made(const char* name, const char* unit, const char*, Maker maker) {
    std::vector<decltype(maker(model.described_.front()))> of;
    for (const Material& material : model.described_) of.push_back(maker(material));
    add(name, unit, [of](const Shown& p, int material) { return of[static_cast<std::size_t>(material)](p); });
  }

 private:
  template <class ValueOf>
  void add(const char* name, const char* unit, ValueOf value_of) {
    model.frame_columns.push_back({name, unit, [value_of](const V* columns, int material, double* values) {
                                     for (int lane = 0; lane < k_width<Real>; ++lane)
                                       values[lane] = value_of(Shown{columns, lane}, material);
                                   }});
  }
};

/// W particles: p[field] is a column or a transient number (one pack of lanes, or an array of them).
template <class Scalar, class... Effects>
struct Model<Scalar, Effects...>::Particle {
  using Real = Scalar;
  using V = Lanes<Scalar>;
  V* columns;
  const Constants& k;
  V transient[Transient::width > 0 ? Transient::width : 1];  ///< each is written before it is read: zeros would cost a memset per tile
  V stiffness = V{};                                         ///< to waves of pressure, K + 4/3 mu, summed over the effects [Pa]
  V shear_stiffness = V{};                                   ///< its mu [Pa]

  BAKE_INLINE Particle(V* columns_of_tile, const Constants& constants) : columns(columns_of_tile), k(constants) {}

  BAKE_INLINE V bulk_stiffness() const { return stiffness - Real(4. / 3) * shear_stiffness; }  ///< K [Pa]

  template <class F>
  static constexpr bool stores = Stored::template has<F>;
  template <class F>
  static constexpr bool has = Stored::template has<F> || Transient::template has<F>;

  template <class F>
  BAKE_INLINE auto& operator[](F) {
    static_assert(has<F>, "no effect of this model has that field");
    V* at = stores<F> ? columns + Stored::template offset<F> : transient + Transient::template offset<F>;
    if constexpr (F::width == 1)
      return *at;
    else
      return *reinterpret_cast<V(*)[F::width]>(at);
  }
  BAKE_INLINE V mass() {
    if constexpr (has<field::WaterMass>) return (*this)[field::m_s] + (*this)[field::m_w];
    return (*this)[field::m_s];
  }
  /// Without the water that subgrid diffusion lent.
  BAKE_INLINE V own_mass() {
    if constexpr (has<field::LentWater>) return mass() - (*this)[field::m_w_lent];
    return mass();
  }
  BAKE_INLINE V volume() {
    if constexpr (has<field::VolumeRatio>) return (*this)[field::V_0] * (*this)[field::J];
    return (*this)[field::V_0];
  }
  /// As the nodes know it.
  BAKE_INLINE V volume_before() {
    if constexpr (has<field::VolumeRatioBefore>) return (*this)[field::V_0] * (*this)[field::J_before];
    return volume();
  }
  BAKE_INLINE V temperature() {
    if constexpr (has<field::Temperature>) return (*this)[field::theta];
    return lanes<Real>(k.theta_0);
  }
  BAKE_INLINE V peak_temperature() {
    if constexpr (has<field::PeakTemperature>) return (*this)[field::theta_peak];
    return lanes<Real>(k.theta_0);
  }
};

template <class Real, class... Effects>
struct Model<Real, Effects...>::From {
  const V* gathered;
  int stride;
  template <class C>
  BAKE_INLINE V value(C, int i = 0) const {
    static_assert(Gathered::template has<C>, "no effect of this model gathers that channel");
    return gathered[Gathered::template offset<C> + i];
  }
  template <class C>
  BAKE_INLINE V gradient(C, int i, int axis) const {
    return gathered[(1 + axis) * stride + Gathered::template offset<C> + i];
  }
};

template <class Real, class... Effects>
struct Model<Real, Effects...>::To {
  BAKE_INLINE To() {  // stores, not a call of memset for every tile
#pragma GCC unroll 32
    for (V& v : values) v = V{};
#pragma GCC unroll 32
    for (auto& m : moments)
#pragma GCC unroll 3
      for (V& v : m) v = V{};
  }
  V values[Scattered::width];
  V moments[k_moments > 0 ? k_moments : 1][3];  ///< coefficient of r = x_i - x_p [1/m]
  template <class C>
  BAKE_INLINE V& value(C, int i = 0) {
    static_assert(Scattered::template has<C>, "no effect of this model scatters that channel");
    return values[Scattered::template offset<C> + i];
  }
  template <class C>
  BAKE_INLINE V& moment(C, int i, int axis) {
    static_assert(Scattered::template offset<C> < k_moments, "not a channel with moments");
    return moments[Scattered::template offset<C> + i][axis];
  }
};

/// W nodes: node[channel] is what was scattered, node.out(channel) what will be gathered.
template <class Real, class... Effects>
struct Model<Real, Effects...>::Node {
  const V* scattered;
  V* gathered;
  const Surroundings<Real>& surroundings;
  NodeSums<Real>& sums;

  template <class C>
  static constexpr bool scatters = Scattered::template has<C>;
  template <class C>
  BAKE_INLINE auto& operator[](C) const {
    const V* at = scattered + Scattered::template offset<C>;
    if constexpr (C::width == 1)
      return *at;
    else
      return *reinterpret_cast<const V(*)[C::width]>(at);
  }
  template <class C>
  BAKE_INLINE V& out(C, int i = 0) {
    static_assert(Gathered::template has<C>, "no effect of this model gathers that channel");
    return gathered[Gathered::template offset<C> + i];
  }
};

// Calls a hook of every effect that has it; `constants` are the effect's own.
#define BAKE_FOR_EACH_EFFECT(hook, ...)                                                                                        \
  {                                                                                                                            \
    const auto one = [&]<class Effect>([[maybe_unused]] const ConstantsOf<Effect>& constants) __attribute__((always_inline)) { \
      BAKE_CALL(Effect, hook, __VA_ARGS__);                                                                                    \
    };                                                                                                                         \
    (one.template operator()<Effects>(std::get<ConstantsOf<Effects>>(k.effects)), ...);                                        \
  }

/// Where the numbers of a list stand, by the names of its fields or by their symbols.
template <class List, class Quantities>
void list_quantities(Quantities& quantities, bool by_symbol) {
  int at = 0;
  List::for_each([&](auto f) {
    quantities.push_back({by_symbol ? f.symbol : f.name, f.unit, at, f.width});
    at += f.width;
  });
}

template <class Real, class... Effects>
Model<Real, Effects...>::Model(const Scene& scene) : described_(scene.materials), nodes_(NodeConstantsOf<Effects>(scene)...) {
  list_quantities<Stored>(this->columns, false);
  list_quantities<Booked>(this->booked, true);
  list_quantities<Totals>(this->totals, true);
  list_quantities<Highest>(this->highest, true);
  list_quantities<Bounds>(this->bounds, true);
  this->column_count = Stored::width;
  this->scatter_channels = Scattered::width;
  this->moment_channels = k_moments;
  this->gather_channels = Gathered::width;
  if constexpr (Scattered::template has<channel::Volume>) this->volume_channel = Scattered::template offset<channel::Volume>;
  if constexpr (Scattered::template has<channel::Mass>)
    this->filled_channel = Scattered::template offset<channel::Mass>;
  else
    this->filled_channel = this->volume_channel;
  for (const Material& m : scene.materials)
    materials_.push_back({static_cast<Real>(m.initial_temperature_C), {ConstantsOf<Effects>(scene, m)...}});

  FrameColumns frame{*this};
  const auto one = [&]<class Effect>() {
    BAKE_CALL(Effect, describe, *this, scene);
    BAKE_CALL(Effect, show, frame);
  };
  one.template operator()<Common>();
  (one.template operator()<Effects>(), ...);
}

template <class Real, class... Effects>
void Model<Real, Effects...>::fill(V* columns, int lane, int material, double volume, const Body& body) const {
  const Constants& k = materials_[static_cast<std::size_t>(material)];
  const Material& m = described_[static_cast<std::size_t>(material)];
  Particle p(columns, k);
  const struct {
    double volume, temperature_C, saturation, leavener;
    const Material& material;
  } start{volume, body.temperature_C.value_or(static_cast<double>(k.theta_0)), body.saturation.value_or(m.initial_saturation),
          body.leavener, m};
  Common::fill(p, lane, start);
  BAKE_FOR_EACH_EFFECT(fill, p, lane, start);
}

template <class Real, class... Effects>
void Model<Real, Effects...>::advance(V* columns, int material, const V* gathered, int gather_stride, V* scattered, int scatter_stride,
                                      V* sampled, const Step<Real>& step, Report<Real>& report) const {
  const Constants k = materials_[static_cast<std::size_t>(material)];
  Particle p(columns, k);
  const From from{gathered, gather_stride};
  Books books{report};
  BAKE_FOR_EACH_EFFECT(gather, p, from, constants, step, books);
  if constexpr (Stored::template has<field::VolumeRatio>)
    if (__builtin_expect(report.obstacles != nullptr, 0)) push_out(p, step, report);
  stress_and_scatter(p, k, scattered, scatter_stride, step, report);
  if constexpr (Particle::template has<field::Velocity>) {
    if (sampled) {
      for (int i = 0; i < 3; ++i) sampled[i] = p[field::v][i];
      if (this->samples_stress)
        for (int i = 0; i < 6; ++i) sampled[3 + i] = p[field::tau][i] / p[field::J];
    }
  }
}

template <class Real, class... Effects>
void Model<Real, Effects...>::start(V* columns, int material, const V* velocity, const V* affine, V* scattered, int scatter_stride,
                                    const Step<Real>& step, Report<Real>& report) const {
  const Constants k = materials_[static_cast<std::size_t>(material)];
  Particle p(columns, k);
  for (V& c : p.transient) c = V{};
  if constexpr (Particle::template has<field::Velocity>) {
    for (int i = 0; i < 3; ++i) p[field::v][i] = velocity[i];
    for (int i = 0; i < 9; ++i) p[field::C][i] = affine[i];
  }
  stress_and_scatter(p, k, scattered, scatter_stride, step, report);
}

template <class Real, class... Effects>
BAKE_INLINE void Model<Real, Effects...>::stress_and_scatter(Particle& p, const Constants& k, V* scattered, int stride,
                                                             const Step<Real>& step, Report<Real>& report) const {
  if constexpr (Particle::template has<field::KirchhoffStress>)
    for (V& component : p[field::tau]) component = V{};
  BAKE_FOR_EACH_EFFECT(stress, p, constants);
  // before the scatter: what a particle still owes the nodes is not yet theirs
  if constexpr (Stored::template has<field::VolumeRatio>) {
    const auto leaving = report.leaving(p[field::x]);
    if (__builtin_expect(any(leaving), 0)) count_leaving(p, k, step, leaving, report);
  }
  if (report.totals_wanted) count(p, k, step, report);
  To to;
  Books books{report};
  BAKE_FOR_EACH_EFFECT(scatter, p, to, constants, step, books);
  BAKE_FOR_EACH_EFFECT(bounds, p, constants, step, books);
  for (int c = 0; c < Scattered::width; ++c) scattered[c] = to.values[c];
  for (int axis = 0; axis < 3; ++axis)
    for (int c = 0; c < k_moments; ++c) scattered[(1 + axis) * stride + c] = step.dx * to.moments[c][axis];
}

/// Particles that an obstacle expels; what it gives them is booked.
template <class Real, class... Effects>
void Model<Real, Effects...>::push_out(Particle& p, const Step<Real>& step, Report<Real>& report) const {
  const V mass = static_cast<Real>(this->inertia_scale) * p.own_mass();
  for (int l = 0; l < k_width<Real>; ++l) {
    if (report.alive[l] == 0) continue;
    Point x;
    Vector3 v;
    for (int d = 0; d < 3; ++d) {
      x[static_cast<std::size_t>(d)] = static_cast<double>(report.origin[d] + step.dx * p[field::x][d][l]);
      v[static_cast<std::size_t>(d)] = static_cast<double>(p[field::v][d][l]);
    }
    const Point x_0 = x;
    const Vector3 v_0 = v;
    const auto m = static_cast<double>(mass[l]);
    if (!report.obstacles->push_out(x, v, m)) continue;
    const Vector3 impulse = m * (v - v_0), angular_impulse = m * (cross(x, v) - cross(x_0, v_0));
    for (int d = 0; d < 3; ++d) {
      const auto i = static_cast<std::size_t>(d);
      p[field::x][d][l] += static_cast<Real>(x[i] - x_0[i]) / step.dx;
      p[field::v][d][l] = static_cast<Real>(v[i]);
      report.booked[k_impulse_entry + d][l] += static_cast<Real>(impulse[i]);
      report.booked[k_angular_impulse_entry + d][l] += static_cast<Real>(angular_impulse[i]);
    }
  }
}

/// Sums for the ledger over the lanes that are alive.
template <class Real, class... Effects>
void Model<Real, Effects...>::count(Particle& p, const Constants& k, const Step<Real>& step, Report<Real>& report) const {
  Books books{report};
  Common::totals(p, k, step, books);
  BAKE_FOR_EACH_EFFECT(totals, p, constants, step, books);
}

/// Those that leave are summed apart, and no longer alive.
template <class Real, class... Effects>
void Model<Real, Effects...>::count_leaving(Particle& p, const Constants& k, const Step<Real>& step, LaneMask<Real> leaving,
                                            Report<Real>& report) const {
  Report<Real> gone;
  std::copy(report.origin, report.origin + 3, gone.origin);
  gone.alive = leaving ? report.alive : 0 * report.alive;
  count(p, k, step, gone);
  for (std::size_t i = 0; i < gone.totals.size(); ++i) report.retired[i] += gone.totals[i];
  report.alive = leaving ? 0 * report.alive : report.alive;
}

template <class Real, class... Effects>
void Model<Real, Effects...>::update_nodes(const V* scattered, V* gathered, NodeSums<Real>& sums, const Surroundings<Real>& around,
                                           const Step<Real>& step, Budget& booked) const {
  Node node{scattered, gathered, around, sums};
  NodeBooks books{booked};
  const auto one = [&]<class Effect>() { BAKE_CALL(Effect, update, node, std::get<NodeConstantsOf<Effect>>(nodes_), step, books); };
  const auto reversed = [&]<class First, class... Rest>(const auto& self) {
    if constexpr (sizeof...(Rest) > 0) self.template operator()<Rest...>(self);
    one.template operator()<First>();
  };
  reversed.template operator()<Effects...>(reversed);
}

template <class Real, class... Effects>
void Model<Real, Effects...>::limit_step(const bake::Bounds& most, const StepScale& at, const Scene& scene, StepLimit& limit) const {
  const auto of = [&]<class Q>(Q) {
    static_assert(Bounds::template has<Q>, "no effect of this model lists that quantity in Bounds");
    return most[static_cast<std::size_t>(Bounds::template offset<Q>)];
  };
  const auto one = [&]<class Effect>() { BAKE_CALL(Effect, largest_step, of, at, scene, limit); };
  (one.template operator()<Effects>(), ...);
}

template <class Real, class... Effects>
typename Model<Real, Effects...>::V Model<Real, Effects...>::conductance(const V* columns, int material) const {
  const Constants& k = materials_[static_cast<std::size_t>(material)];
  Particle p(const_cast<V*>(columns), k);
  V sum{};
  const auto one = [&]<class Effect>(const ConstantsOf<Effect>& constants) {
    if constexpr (has_hook::conductance<Effect>) sum += Effect::conductance(p, constants);
  };
  (one.template operator()<Effects>(std::get<ConstantsOf<Effects>>(k.effects)), ...);
  return sum;
}

template <class Real, class... Effects>
void Model<Real, Effects...>::find_springs(const V* columns, int material, V& inertia, V& spring) const {
  inertia = spring = V{};
  if constexpr (Particle::template has<field::KirchhoffStress>) {
    const Constants& k = materials_[static_cast<std::size_t>(material)];
    Particle p(const_cast<V*>(columns), k);
    for (V& c : p.transient) c = V{};
    BAKE_FOR_EACH_EFFECT(stress, p, constants);
    inertia = static_cast<Real>(this->inertia_scale) * p.mass();
    spring = p[field::V_0] * p.bulk_stiffness();
  }
}

#undef BAKE_FOR_EACH_EFFECT

template <class Real, class... Effects>
std::unique_ptr<Physics<Real>> compose(Composition<Effects...>, const Scene& scene) {
  return std::make_unique<Model<Real, Effects...>>(scene);
}

}  // namespace bake
