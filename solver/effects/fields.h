// SPDX-License-Identifier: MIT
// The vocabulary: named numbers of a particle, of a node, and of the books. Which effect has them is written in the effects.
#pragma once

#include <type_traits>

namespace bake {

/// A named field of `width` numbers.
template <int Width>
struct Field {
  static constexpr int width = Width;
};

/// Declares a field: the paper's symbol (which is how code calls it), its type, how many numbers it has, its name in files, its unit, and
/// what it is, with the equation where there is one. docs/notation.md is made from these.
#define BAKE_FIELD(Symbol, Type, Width, full_name, units, words) \
  struct Type : Field<Width> {                                   \
    static constexpr const char* symbol = #Symbol;               \
    static constexpr const char* name = full_name;               \
    static constexpr const char* unit = units;                   \
    static constexpr const char* meaning = words;                \
  };                                                             \
  inline constexpr Type Symbol {}

/// Of a particle.
namespace field {
BAKE_FIELD(x, Position, 3, "position", "dx",
           "x_p: position from the first node of the particle's home block, which keeps single precision fine");
BAKE_FIELD(id, Identity, 1, "id", "", "bits of a whole number that the particle keeps for life");
BAKE_FIELD(V_0, InitialVolume, 1, "initial_volume", "m^3", "V_p^0: volume at the start");
BAKE_FIELD(m_s, SolidMass, 1, "solid_mass", "kg", "m_p^s: mass of the solid");
BAKE_FIELD(v, Velocity, 3, "velocity", "m/s", "v_p: velocity of the solid");
BAKE_FIELD(C, AffineVelocity, 9, "affine_velocity", "1/s", "C_p: velocity gradient, C[3 i + j] = dv_i / dx_j (APIC)");
BAKE_FIELD(J, VolumeRatio, 1, "volume_ratio", "1", "J_p: volume over initial volume, det F");
BAKE_FIELD(J_before, VolumeRatioBefore, 1, "volume_ratio_before", "1", "J_p before the step, of which the nodes know");
BAKE_FIELD(
    sigma, CauchyStress, 6, "stress", "Pa",
    "sigma = tau / J: Cauchy stress of solid, gas and water together, pulling is positive; XX YY ZZ XY YZ XZ, as ParaView has tensors; "
    "with run.stress_in_frames, and 0 for what was poured in this very moment");
BAKE_FIELD(von_mises, VonMisesStress, 1, "von_mises", "Pa",
           "sqrt(3/2) times the size of the deviator of stress; with run.stress_in_frames");
BAKE_FIELD(tau, KirchhoffStress, 6, "kirchhoff_stress", "Pa", "tau_p = J sigma: Kirchhoff stress of the mixture; xx yy zz yz xz xy");
BAKE_FIELD(b_E, ElasticStrain, 6, "elastic_strain", "1", "b_E - I: elastic left Cauchy-Green strain less the identity [Ding19 Sec. 5.2]");
BAKE_FIELD(epsilon, HenckyStrain, 6, "hencky_strain", "1", "epsilon = 1/2 log b_E: elastic Hencky strain [Ding19 Sec. 5.2]");
BAKE_FIELD(J_P, PlasticVolumeRatio, 1, "plastic_volume_ratio", "1", "J_P: plastic part of J [Ding19 Sec. 5.3]");
BAKE_FIELD(broken, Broken, 1, "broken", "1",
           "d: share of its fracture energy that set dough has spent, from 0, whole, to 1, without strength");
BAKE_FIELD(plastic_work, PlasticWork, 1, "plastic_work", "J/m^3", "w: plastic work of the step, per initial volume");
BAKE_FIELD(plastic_dilation, PlasticDilation, 1, "plastic_dilation", "1/s", "d ln J_P / dt: rate at which volume flows");
BAKE_FIELD(theta, Temperature, 1, "temperature", "C", "theta_p: temperature [Ding19 Eq. 9, 21]");
BAKE_FIELD(theta_peak, PeakTemperature, 1, "peak_temperature", "C", "highest temperature so far, since gelatinisation is not undone");
BAKE_FIELD(thermal_strain, ThermalStrain, 1, "thermal_strain", "1",
           "3 alpha_l (theta - theta_0): volumetric strain at which the solid is free of stress");
BAKE_FIELD(theta_lent, LentTemperature, 1, "lent_temperature", "K",
           "what subgrid diffusion gave in this step; the nodes take it back in the next");
BAKE_FIELD(grad_theta, TemperatureGradient, 3, "temperature_gradient", "C/m", "grad theta at the particle [Ding19 Sec. 6.3]");
BAKE_FIELD(m_w, WaterMass, 1, "water_mass", "kg", "m_p^w: mass of the water [Ding19 Eq. 19]");
BAKE_FIELD(m_w_lent, LentWater, 1, "lent_water", "kg", "what subgrid diffusion gave in this step; the nodes take it back in the next");
BAKE_FIELD(w_spread, WaterSpread, 1, "water_spread", "m^2",
           "integral of K theta dt: water has come from as far as the root of it times s, whatever the temperature was meanwhile");
BAKE_FIELD(q, WaterFlux, 3, "water_flux", "kg/(m^2 s)", "q_p = -K theta rho_w grad s: water's flux through the solid [Ding19 Eq. 22]");
BAKE_FIELD(j_v, VapourFlux, 3, "vapour_flux", "kg/(m^2 s)", "j_v = -n D_v grad rho_v: flux of vapour through the pores, a part of q");
BAKE_FIELD(Q, WaterMomentum, 3, "water_momentum", "kg m/s", "V q: momentum of the water relative to its solid [Ding19 Eq. 25]");
BAKE_FIELD(Q_old, ScatteredWaterMomentum, 3, "scattered_water_momentum", "kg m/s", "V q of the step before, which the nodes know");
BAKE_FIELD(nu, ProducedGas, 1, "produced_gas", "mol/m^3", "nu_p: CO2 made, per initial volume [Ding19 Sec. 5.4]");
BAKE_FIELD(c, Leavener, 1, "leavener", "1", "share of the leavener that is not spent [Ding19 Sec. 5.4]");
}  // namespace field

/// Of a node: sums over particles that are scattered (P2G), and what the grid update hands back to be gathered (G2P).
namespace channel {
BAKE_FIELD(momentum, Momentum, 3, "momentum", "kg m/s", "sum of w m v and of the step's impulses [Ding19 Eq. 26-27]");
BAKE_FIELD(old_momentum, OldMomentum, 3, "old momentum", "kg m/s", "sum of w m v without the step's impulses (FLIP)");
BAKE_FIELD(mass, Mass, 1, "mass", "kg", "sum of w m, the inertial mass");
BAKE_FIELD(water_mass, NodeWaterMass, 1, "water mass", "kg", "m_i^w: sum of w m_w");
BAKE_FIELD(water_change, WaterChange, 1, "water change", "kg", "dm_i^w: water that flows to the node in the step [Ding19 Eq. 25]");
BAKE_FIELD(water_capacity, WaterCapacity, 1, "water capacity", "kg", "water that would fill the node, sum of w V rho_0^w");
BAKE_FIELD(evaporability, Evaporability, 1, "evaporability", "kg m/s", "sum of w V beta_w theta [Ding19 Sec. 6.2]");
BAKE_FIELD(permeability, Permeability, 1, "permeability", "kg m^2/s", "sum of w V rho_0^w K theta: how readily water comes to the surface");
BAKE_FIELD(water_spread, WaterSpread, 1, "water spread", "m^5", "sum of w V times the integral of K theta dt: how deep drying has come");
BAKE_FIELD(hygroscopic_water, HygroscopicWater, 1, "hygroscopic water", "kg", "sum of w m_s X_h: water over which vapour is half as dense");
BAKE_FIELD(vapour_mobility, VapourMobility, 1, "vapour mobility", "m^5/s", "sum of w V n D_v: how readily vapour moves in the pores");
BAKE_FIELD(vapour_transfer, VapourTransfer, 1, "vapour transfer", "m^4/s", "sum of w V h_v: how readily vapour leaves the surface");
BAKE_FIELD(volume, Volume, 1, "volume", "m^3", "V_i: sum of w V [Ding19 Eq. 18]");
BAKE_FIELD(heat_capacity, HeatCapacity, 1, "heat capacity", "J/K", "c_i: sum of w c");
BAKE_FIELD(heat_content, HeatContent, 1, "heat content", "J", "sum of w c theta");
BAKE_FIELD(conductivity, Conductivity, 1, "conductivity", "W m^2/K", "sum of w V kappa");
BAKE_FIELD(heat_lent, LentHeat, 1, "lent heat", "J", "sum of w c theta_lent: what subgrid diffusion gave to the particles around");
BAKE_FIELD(heat_change, HeatChange, 1, "heat change", "J", "dq_i: heat that comes to the node in the step [Ding19 Eq. 9]");

BAKE_FIELD(velocity, NodeVelocity, 3, "node velocity", "m/s", "v_i: after the step");
BAKE_FIELD(old_velocity, OldNodeVelocity, 3, "old node velocity", "m/s", "v_i before the step (FLIP)");
BAKE_FIELD(temperature_change, TemperatureChange, 1, "temperature change", "K", "theta_i^(n+1) - theta_i^n [Ding19 Eq. 21]");
BAKE_FIELD(temperature, NodeTemperature, 1, "node temperature", "C", "theta_i^(n+1)");
BAKE_FIELD(water_loss, WaterLoss, 1, "water loss", "1",
           "min(dm_i^w, 0) / m_i^w: shared by the particles around as their water [Ding19 Eq. 19]");
BAKE_FIELD(water_gain, WaterGain, 1, "water gain", "1",
           "max(dm_i^w, 0) over the water that would fill the node: shared as the particles' volumes");
BAKE_FIELD(saturation, Saturation, 1, "saturation", "1", "s_i^(n+1): share of the volume that is water");
BAKE_FIELD(vapour_density, VapourDensity, 1, "vapour density", "kg/m^3",
           "rho_v: vapour in the pores over the node's water, at theta_i^(n+1)");
}  // namespace channel

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
  static constexpr void for_each([[maybe_unused]] Visitor visit) {
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
