// SPDX-License-Identifier: MIT
// The vocabulary of particle fields: which effect stores them is written in the effects.
#pragma once

#include <type_traits>

namespace bake {

/// A named field of `width` numbers per particle.
template <int Width>
struct Field {
  static constexpr int width = Width;
};

#define BAKE_FIELD(symbol, Type, Width, full_name, units) \
  struct Type : Field<Width> {                            \
    static constexpr const char* name = full_name;        \
    static constexpr const char* unit = units;            \
  };                                                      \
  inline constexpr Type symbol {}

namespace field {
BAKE_FIELD(x, Position, 3, "position", "dx");  // from the first node of the particle's home block: keeps single precision fine
BAKE_FIELD(id, Identity, 1, "id", "");         // bits of a 32-bit integer
BAKE_FIELD(V_0, InitialVolume, 1, "initial_volume", "m^3");
BAKE_FIELD(m_s, SolidMass, 1, "solid_mass", "kg");
BAKE_FIELD(v, Velocity, 3, "velocity", "m/s");
BAKE_FIELD(C, AffineVelocity, 9, "affine_velocity", "1/s");  // C[3 * i + j] = dv_i / dx_j
BAKE_FIELD(J, VolumeRatio, 1, "volume_ratio", "1");
BAKE_FIELD(tau, KirchhoffStress, 6, "kirchhoff_stress", "Pa");
BAKE_FIELD(b_E, ElasticStrain, 6, "elastic_strain", "1");  // elastic left Cauchy-Green strain less the identity
BAKE_FIELD(epsilon, HenckyStrain, 6, "hencky_strain", "1");
BAKE_FIELD(J_P, PlasticVolumeRatio, 1, "plastic_volume_ratio", "1");
BAKE_FIELD(theta, Temperature, 1, "temperature", "C");
BAKE_FIELD(theta_peak, PeakTemperature, 1, "peak_temperature", "C");
BAKE_FIELD(grad_theta, TemperatureGradient, 3, "temperature_gradient", "C/m");
BAKE_FIELD(m_w, WaterMass, 1, "water_mass", "kg");
BAKE_FIELD(q, WaterFlux, 3, "water_flux", "kg/(m^2 s)");
BAKE_FIELD(Q, WaterMomentum, 3, "water_momentum", "kg m/s");  // V q, the momentum of water relative to the solid
BAKE_FIELD(Q_old, ScatteredWaterMomentum, 3, "scattered_water_momentum", "kg m/s");
BAKE_FIELD(nu, ProducedGas, 1, "produced_gas", "mol/m^3");  // per initial volume
BAKE_FIELD(c, Leavener, 1, "leavener", "1");                // unspent share
}  // namespace field

/// Channels of a node. Scattered: sums over particles. Gathered: what the grid update hands back.
namespace channel {
struct Momentum : Field<3> {};       // w m v and impulses [kg m/s]
struct OldMomentum : Field<3> {};    // w m v, without the step's impulses [kg m/s] (FLIP)
struct Mass : Field<1> {};           // w m, the inertial mass [kg]
struct WaterMass : Field<1> {};      // w m_w [kg]
struct WaterChange : Field<1> {};    // flux of the step [kg]
struct WaterCapacity : Field<1> {};  // w V rho_0^w: the water that would fill the node [kg]
struct Evaporability : Field<1> {};  // w V beta_w [kg m/(s K)]
struct Volume : Field<1> {};         // w V [m^3]
struct HeatCapacity : Field<1> {};   // w c [J/K]
struct HeatContent : Field<1> {};    // w c theta [J]
struct HeatChange : Field<1> {};     // heat of the step [J]
inline constexpr Momentum momentum{};
inline constexpr OldMomentum old_momentum{};
inline constexpr Mass mass{};
inline constexpr WaterMass water_mass{};
inline constexpr WaterChange water_change{};
inline constexpr WaterCapacity water_capacity{};
inline constexpr Evaporability evaporability{};
inline constexpr Volume volume{};
inline constexpr HeatCapacity heat_capacity{};
inline constexpr HeatContent heat_content{};
inline constexpr HeatChange heat_change{};

struct NodeVelocity : Field<3> {};       // v_i after the step [m/s]
struct OldNodeVelocity : Field<3> {};    // v_i before the step [m/s] (FLIP)
struct TemperatureChange : Field<1> {};  // theta_i^{n+1} - theta_i^n [K]
struct NodeTemperature : Field<1> {};    // theta_i^{n+1} [C]
struct WaterRatio : Field<1> {};         // dm_i / m_i^w [1]
struct Saturation : Field<1> {};         // s_i^{n+1} [1]
inline constexpr NodeVelocity velocity{};
inline constexpr OldNodeVelocity old_velocity{};
inline constexpr TemperatureChange temperature_change{};
inline constexpr NodeTemperature temperature{};
inline constexpr WaterRatio water_ratio{};
inline constexpr Saturation saturation{};
}  // namespace channel

#undef BAKE_FIELD

/// A list of fields or channels laid side by side.
template <class... F>
struct FieldList {
  static constexpr int width = (0 + ... + F::width);
  template <class Wanted>
  static constexpr bool has = (std::is_same_v<Wanted, F> || ...);
  /// Where `Wanted` starts in the list; the list's width if it is not there.
  template <class Wanted>
  static constexpr int offset = [] {
    int at = 0;
    bool found = false;
    ((found = found || std::is_same_v<Wanted, F>, at += found ? 0 : F::width), ...);
    return at;
  }();
  template <class Visitor>
  static constexpr void for_each(Visitor visit) {
    (visit(F{}), ...);
  }
};

template <class... Lists>
struct Join;
template <class... A>
struct Join<FieldList<A...>> {
  using type = FieldList<A...>;
};
template <class... A, class... B, class... Rest>
struct Join<FieldList<A...>, FieldList<B...>, Rest...> {
  using type = typename Join<FieldList<A..., B...>, Rest...>::type;
};
template <class... Lists>
using Joined = typename Join<FieldList<>, Lists...>::type;

}  // namespace bake
