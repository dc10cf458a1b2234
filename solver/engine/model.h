// SPDX-License-Identifier: MIT
// A model is a list of effects, composed at compile time: columns, channels and code of the effects that are in the list,
// and of no others.
//
// An effect may define any of these static functions; the model calls those that are there, effect by effect:
//     fill     start values of its columns, from a temperature and a share of leavener
//     gather   from the nodes to the particle, state advanced to t + dt
//     stress   its part of the mixture's Kirchhoff stress, and its stiffness
//     scatter  what the particle gives to the nodes
//     limits   what bounds the step
//     update   what happens at a node (in reverse order: water, then heat, then motion)
//     totals   sums for the ledger
#pragma once

#include <bit>
#include <tuple>

#include "solver/effects/heat.h"
#include "solver/effects/motion.h"
#include "solver/effects/water.h"
#include "solver/engine/model_list.h"
#include "solver/engine/physics.h"
#include "solver/scene/scene.h"

namespace bake {

/// What every particle has whatever the effects.
struct CommonFields {
  using Stored = FieldList<field::Position, field::Identity, field::InitialVolume, field::SolidMass>;
};

template <class Real, class... Effects>
class Model final : public Physics<Real> {
 public:
  using typename Physics<Real>::V;
  using Stored = Joined<CommonFields::Stored, typename Effects::Stored...>;
  using Transient = Joined<typename Effects::Transient...>;
  using Scattered = Joined<typename Effects::Moments..., typename Effects::Values...>;
  using Gathered = Joined<typename Effects::Gathered...>;
  static constexpr int k_moments = (0 + ... + Effects::Moments::width);

  explicit Model(const Scene& scene);

  void advance(V* columns, int material, const V* gathered, int gather_stride, V* scattered, int scatter_stride, V* velocity,
               const Step<Real>& step, Report<Real>& report) const override;
  void start(V* columns, int material, const V* velocity, const V* affine, V* scattered, int scatter_stride, const Step<Real>& step,
             Report<Real>& report) const override;
  void update_nodes(const V* scattered, V* gathered, NodeSums<Real>& sums, const Surroundings<Real>& around, const Step<Real>& step,
                    Budget& booked) const override;
  V conductance(const V* columns, int material) const override;
  void fill(V* columns, int lane, int material, double volume, const Body& body) const override;

 private:
  template <class Effect>
  using ConstantsOf = typename Effect::template Constants<Real>;
  struct Constants {
    Real theta_0;
    double solid_density, water_per_saturation, s_0;  ///< to fill particles
    std::tuple<ConstantsOf<Effects>...> effects;
  };

  struct Particle;
  struct From;
  struct To;
  struct Node;
  void push_out(Particle& p, const Step<Real>& step, Report<Real>& report) const;
  void count(Particle& p, const Constants& k, const Step<Real>& step, Report<Real>& report) const;
  void count_leaving(Particle& p, const Constants& k, const Step<Real>& step, LaneMask<Real> leaving, Report<Real>& report) const;
  void stress_and_scatter(Particle& p, const Constants& k, V* scattered, int stride, const Step<Real>& step, Report<Real>& report) const;

  std::vector<Constants> materials_;
  Real inertia_, latent_heat_, water_specific_heat_;
  bool published_heat_transfer_;
};

/// W particles: p[field] is a column or a transient number (one pack of lanes, or an array of them).
template <class Scalar, class... Effects>
struct Model<Scalar, Effects...>::Particle {
  using Real = Scalar;
  using V = Lanes<Scalar>;
  V* columns;
  const Constants& k;
  V transient[Transient::width > 0 ? Transient::width : 1];  ///< each is written before it is read: zeros would cost a memset per tile
  V stiffness = V{};                                         ///< d tau / d ln J summed over the effects [Pa]

  BAKE_INLINE Particle(V* columns_of_tile, const Constants& constants) : columns(columns_of_tile), k(constants) {}

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
  BAKE_INLINE V volume() {
    if constexpr (has<field::VolumeRatio>) return (*this)[field::V_0] * (*this)[field::J];
    return (*this)[field::V_0];
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
  Real inertia;  ///< inertial mass per mass
  Real latent_heat_per_kg, water_specific_heat;
  bool published_heat_transfer;

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
    return gathered[Gathered::template offset<C> + i];
  }
};

// Calls the expression for every effect that has such a function; `constants` are the effect's own.
#define BAKE_FOR_EACH_EFFECT(...)                                                                                              \
  {                                                                                                                            \
    const auto one = [&]<class Effect>([[maybe_unused]] const ConstantsOf<Effect>& constants) __attribute__((always_inline)) { \
      if constexpr (requires { __VA_ARGS__; }) __VA_ARGS__;                                                                    \
    };                                                                                                                         \
    (one.template operator()<Effects>(std::get<ConstantsOf<Effects>>(k.effects)), ...);                                        \
  }

template <class Real, class... Effects>
Model<Real, Effects...>::Model(const Scene& scene) {
  int at = 0;
  Stored::for_each([&](auto f) {
    this->columns.push_back({f.name, f.unit, at, f.width});
    at += f.width;
  });
  this->column_count = at;
  this->scatter_channels = Scattered::width;
  this->moment_channels = k_moments;
  this->gather_channels = Gathered::width;
  this->moves = Stored::template has<field::VolumeRatio>;
  this->has_heat = Stored::template has<field::Temperature>;
  this->has_water = Stored::template has<field::WaterMass>;
  this->implicit_heat = this->has_heat && scene.of<Heat>().integrator == Heat::Integrator::backward_euler;
  if constexpr (Scattered::template has<channel::Volume>) this->volume_channel = Scattered::template offset<channel::Volume>;
  if constexpr (Scattered::template has<channel::Mass>)
    this->filled_channel = Scattered::template offset<channel::Mass>;
  else
    this->filled_channel = this->volume_channel;
  if constexpr (Gathered::template has<channel::NodeTemperature>)
    this->temperature_channel = Gathered::template offset<channel::NodeTemperature>;
  inertia_ = static_cast<Real>(scene.of<Motion>().inertia_scale);
  latent_heat_ = static_cast<Real>(scene.of<Water>().latent_heat_J_per_kg);
  water_specific_heat_ = static_cast<Real>(scene.of<Heat>().water_specific_heat_J_per_kgK);
  published_heat_transfer_ = scene.of<Heat>().heat_transfer_form == Form::published;
  for (const Material& m : scene.materials)
    materials_.push_back({static_cast<Real>(m.initial_temperature_C),
                          m.density_kg_per_m3,
                          this->has_water ? of<Water>(m).water_density_kg_per_m3 : 0,
                          m.initial_saturation,
                          {ConstantsOf<Effects>(scene, m)...}});
}

template <class Real, class... Effects>
void Model<Real, Effects...>::fill(V* columns, int lane, int material, double volume, const Body& body) const {
  const Constants& k = materials_[static_cast<std::size_t>(material)];
  Particle p(columns, k);
  const double theta = body.temperature_C.value_or(static_cast<double>(k.theta_0));
  const double saturation = body.saturation.value_or(k.s_0);
  // Density is that of the mixture at the material's own saturation: a wetter body has more water on the same solid.
  p[field::V_0][lane] = static_cast<Real>(volume);
  p[field::m_s][lane] = static_cast<Real>(volume * (k.solid_density - k.water_per_saturation * k.s_0));
  if constexpr (Stored::template has<field::WaterMass>)
    p[field::m_w][lane] = static_cast<Real>(volume * k.water_per_saturation * saturation);
  BAKE_FOR_EACH_EFFECT(Effect::fill(p, lane, theta, body.leavener));
}

template <class Real, class... Effects>
void Model<Real, Effects...>::advance(V* columns, int material, const V* gathered, int gather_stride, V* scattered, int scatter_stride,
                                      V* velocity, const Step<Real>& step, Report<Real>& report) const {
  const Constants k = materials_[static_cast<std::size_t>(material)];
  Particle p(columns, k);
  const From from{gathered, gather_stride};
  BAKE_FOR_EACH_EFFECT(Effect::gather(p, from, constants, step, report));
  if constexpr (Stored::template has<field::VolumeRatio>)
    if (__builtin_expect(report.obstacles != nullptr, 0)) push_out(p, step, report);
  stress_and_scatter(p, k, scattered, scatter_stride, step, report);
  if constexpr (Particle::template has<field::Velocity>) {
    if (velocity)
      for (int i = 0; i < 3; ++i) velocity[i] = p[field::v][i];
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
  BAKE_FOR_EACH_EFFECT(Effect::stress(p, constants));
  // before the scatter: what a particle still owes the nodes is not yet theirs
  if constexpr (Stored::template has<field::VolumeRatio>) {
    const auto leaving = report.leaving(p[field::x]);
    if (__builtin_expect(any(leaving), 0)) count_leaving(p, k, step, leaving, report);
  }
  if (report.totals_wanted) count(p, k, step, report);
  To to;
  BAKE_FOR_EACH_EFFECT(Effect::scatter(p, to, constants, step, report));
  BAKE_FOR_EACH_EFFECT(Effect::limits(p, constants, step, report));
  for (int c = 0; c < Scattered::width; ++c) scattered[c] = to.values[c];
  for (int axis = 0; axis < 3; ++axis)
    for (int c = 0; c < k_moments; ++c) scattered[(1 + axis) * stride + c] = step.dx * to.moments[c][axis];
}

/// Particles that an obstacle expels; what it gives them is booked.
template <class Real, class... Effects>
void Model<Real, Effects...>::push_out(Particle& p, const Step<Real>& step, Report<Real>& report) const {
  const V mass = inertia_ * p.mass();
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
    if (!report.obstacles->push_out(x, v)) continue;
    const auto m = static_cast<double>(mass[l]);
    const Vector3 impulse = m * (v - v_0), twist = m * (cross(x, v) - cross(x_0, v_0));
    for (int d = 0; d < 3; ++d) {
      const auto i = static_cast<std::size_t>(d);
      p[field::x][d][l] += static_cast<Real>(x[i] - x_0[i]) / step.dx;
      p[field::v][d][l] = static_cast<Real>(v[i]);
      report.booked[static_cast<int>(Entry::impulse_x) + d][l] += static_cast<Real>(impulse[i]);
      report.booked[static_cast<int>(Entry::twist_x) + d][l] += static_cast<Real>(twist[i]);
    }
  }
}

/// Sums for the ledger over the lanes that are alive.
template <class Real, class... Effects>
void Model<Real, Effects...>::count(Particle& p, const Constants& k, const Step<Real>& step, Report<Real>& report) const {
  report.add(Total::solid_mass, p[field::m_s]);
  report.add(Total::volume, p.volume());
  BAKE_FOR_EACH_EFFECT(Effect::totals(p, constants, step, report));
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
  Node node{scattered, gathered, around, sums, inertia_, latent_heat_, water_specific_heat_, published_heat_transfer_};
  const auto one = [&]<class Effect>() {
    if constexpr (requires { Effect::update(node, step, booked); }) Effect::update(node, step, booked);
  };
  const auto reversed = [&]<class First, class... Rest>(const auto& self) {
    if constexpr (sizeof...(Rest) > 0) self.template operator()<Rest...>(self);
    one.template operator()<First>();
  };
  reversed.template operator()<Effects...>(reversed);
}

template <class Real, class... Effects>
typename Model<Real, Effects...>::V Model<Real, Effects...>::conductance(const V* columns, int material) const {
  if constexpr (Stored::template has<field::Temperature>) {
    const Constants& k = materials_[static_cast<std::size_t>(material)];
    Particle p(const_cast<V*>(columns), k);
    return std::get<ConstantsOf<Heat>>(k.effects).kappa * p.volume();
  }
  return V{};
}

#undef BAKE_FOR_EACH_EFFECT

template <class Real, class... Effects>
std::unique_ptr<Physics<Real>> compose(Composition<Effects...>, const Scene& scene) {
  return std::make_unique<Model<Real, Effects...>>(scene);
}

}  // namespace bake
