// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "experiments/common/study_scene.h"
#include "experiments/departures/departures.h"
#include "solver/core/errors.h"
#include "solver/effects/plasticity.h"

namespace bake::studies {

namespace {

constexpr const char* k_dough = R"(density_kg_per_m3 = 1
young_modulus_Pa = 20
initial_porosity = 0.2
initial_saturation = 0.2
initial_temperature_C = 20
water_density_kg_per_m3 = 1
specific_heat_J_per_kgK = 1000
conductivity_W_per_mK = 0
yield_stress_Pa = 1e-2
)";

/// A ball of one metre in air without exchange, nothing flowing.
StudyScene ball(const char* effects, bool quick) {
  StudyScene setting(effects);
  setting.dx = quick ? 0.25 : 0.125;
  setting.low = {-2.5, -2.5, -2.5};
  setting.high = {2.5, 2.5, 2.5};
  setting.time = "safety = 0.5";
  setting.shape = "sphere = { radius_m = 1 }";
  setting.material = k_dough;
  return setting;
}

/// Gas doubles the volume of a moving ball; no water flows. Returns what is left of the water and of the speed.
std::pair<double, double> risen(const char* form, bool quick, double& volume_ratio) {
  StudyScene setting = ball(k_everything, quick);
  setting.material += "production_mol_per_kgs = 2\npeak_temperature_C = 20\n";
  setting.tables = fmt::format("[water]\nform = \"{}\"\n[leavening]\nreference_pressure_Pa = 100\n", form);
  setting.body = "velocity_m_per_s = [0.05, 0, 0]";
  const auto s = setting.begin();
  const double water = s->total(total::water_mass), volume = s->total(total::volume);
  run_to(*s, 15);
  volume_ratio = s->total(total::volume) / volume;
  const double mass = s->total(total::solid_mass) + s->total(total::water_mass);
  return {s->total(total::water_mass) / water, s->total(total::momentum, 0) / mass / 0.05};
}

/// Mean temperature of a ball of 100 C after a while in air of 20 C.
double cooled(const char* form, bool quick) {
  StudyScene setting = ball("heat", quick);
  setting.material = "density_kg_per_m3 = 1\ninitial_temperature_C = 100\nspecific_heat_J_per_kgK = 1\nconductivity_W_per_mK = 1\n";
  setting.tables =
      fmt::format("[heat]\nheat_transfer_form = \"{}\"\n[oven]\ntemperature_C = 20\nheat_transfer_coefficient_W_per_m2K = 1\n", form);
  const auto s = setting.after(0.2);
  return s->total(total::temperature) / s->total(total::volume);
}

double area_found(const char* form, bool quick) {
  StudyScene setting = ball("heat", quick);
  setting.material = "density_kg_per_m3 = 1\nspecific_heat_J_per_kgK = 1\nconductivity_W_per_mK = 1\n";
  setting.surface = fmt::format("form = \"{}\"", form);
  setting.tables = "[oven]\ntemperature_C = 20\nheat_transfer_coefficient_W_per_m2K = 1\n";
  const auto s = setting.after(1e-3);
  return s->booked(booked::area) / (4 * M_PI);
}

/// A ball at 60 C in which gas is made that fills its own initial volume against the atmosphere, after 1 s or when it has burst.
struct Leavened {
  double volume_ratio, plastic_ratio;  ///< mean J and J_P
};
Leavened leavened(const char* form, bool quick) {
  StudyScene setting = ball("motion, heat, elasticity, plasticity, leavening", quick);
  setting.dx *= 2;  // it may grow
  setting.low = {-6, -6, -6};
  setting.high = {6, 6, 6};
  const double moles = 101325 / (8.314 * (60 + 273.15));  // of one atmosphere in the volume at the start [mol/m^3]
  setting.material += fmt::format("production_mol_per_kgs = {}\npeak_temperature_C = 60\nleavener_mol_per_m3 = {}\n", 20 * moles, moles);
  setting.tables = fmt::format("[leavening]\nform = \"{}\"\n", form);
  setting.body = "temperature_C = 60";
  const auto s = setting.begin();
  const double volume = s->total(total::volume);
  constexpr double k_burst = 20;
  Leavened now{1, 1};
  try {
    for (int i = 1; i <= 100 && now.volume_ratio < k_burst; ++i) {
      run_to(*s, 0.01 * i);
      now.volume_ratio = s->total(total::volume) / volume;
    }
  } catch (const RunError&) {
    now.volume_ratio = std::max(now.volume_ratio, k_burst);
  }
  const Snapshot end = s->snapshot();
  const auto& J_P = end["plastic_volume_ratio"];
  now.plastic_ratio = std::accumulate(J_P.begin(), J_P.end(), 0.0) / static_cast<double>(J_P.size());
  return now;
}

/// Strain that a ball of uniform temperature, the one at which it was made, takes by itself.
double strain_of_rest(const char* form, bool quick) {
  StudyScene setting = ball("motion, heat, elasticity", quick);
  setting.material += "expansion_per_K = 1e-3\n";
  setting.motion = "transfer = \"pic\"";
  setting.tables = fmt::format("[heat]\nexpansion_form = \"{}\"\n", form);
  const auto s = setting.begin();
  const double volume = s->total(total::volume);
  run_to(*s, 5);
  return std::log(s->total(total::volume) / volume);
}

/// A bar of one metre at rest whose halves start otherwise than each other, without exchange: what they become is the medium's own doing.
StudyScene halves(const char* effects, const std::string& here, const std::string& there, bool quick) {
  StudyScene setting(effects);
  setting.dx = quick ? 0.1 : 0.05;
  const auto half = [](double x) { return fmt::format("box = {{ centre_m = [{}, 0, 0], half_extents_m = [0.25, 0.1, 0.1] }}", x); };
  setting.tables = fmt::format("[[body]]\nmaterial = \"dough\"\nparticles_per_cell = {}\nshape = {{ {} }}\n{}\n",
                               setting.particles_per_cell, half(-0.25), here);
  setting.shape = half(0.25);
  setting.body = there;
  return setting;
}

/// Largest saturations of the halves of a bar, of which one is wet and one dry at the start, with these keys of [water].
struct Soaked {
  double wet, dry;
};
constexpr double k_soaked = 0.5;  ///< saturation of the wet half at the start
Soaked soaked(const char* water, bool quick) {
  StudyScene setting = halves("water", fmt::format("saturation = {}", k_soaked), "saturation = 0", quick);
  setting.material = "density_kg_per_m3 = 1\nwater_density_kg_per_m3 = 1\ninitial_temperature_C = 1\ndiffusivity_m2_per_sK = 1\n";
  setting.tables = fmt::format("[water]\n{}\n", water) + setting.tables;
  const Snapshot end = setting.after(0.1)->snapshot();
  Soaked most{0, 0};
  for (std::size_t i = 0; i < end.id.size(); ++i) {
    double& half = end.position[i][0] < 0 ? most.wet : most.dry;
    half = std::max(half, end["water_mass"][i] / end["initial_volume"][i]);
  }
  return most;
}

/// Hottest less coldest particle of an insulated bar whose halves started at 0 and 100 C, when conduction has long evened them out [K].
double uneven(const char* heat, bool quick) {
  StudyScene setting = halves("heat", "temperature_C = 0", "temperature_C = 100", quick);
  setting.material += "specific_heat_J_per_kgK = 1\nconductivity_W_per_mK = 1\n";
  setting.heat = heat;
  const auto s = setting.after(1);
  return s->highest(highest::temperature) + s->highest(highest::coldness);
}

/// Rate of the plastic strain under three times the yield stress of 1 Pa with eta = 1, from the solver's return of a short step.
double flow_rate(bool quadratic) {
  constexpr double q = 3, tau_y = 1, eta = 1, mu = 1, dt = 1e-6;
  const auto all = [](double x) { return lanes<double>(x); };
  const auto flowing = all(1) > all(0);
  const auto z = Plasticity::solve<Lanes<double>>(all(0), all(q * q), all(0), 3 * mu, all(tau_y), all(eta / dt), flowing, quadratic);
  const double left = q / (1 + 3 * mu * z[0]);
  return (q - left) / (3 * mu * dt);
}

}  // namespace

std::vector<Consequence> all_consequences(bool quick) {
  std::vector<Consequence> all;
  double grown = 0, grown_published = 0;
  const auto [water, speed] = risen("standard", quick, grown);
  const auto [water_published, speed_published] = risen("published", quick, grown_published);
  all.push_back({"Eq. 25", "the water's mass changes by - m_w div v dt", "no such term: the water moves with the solid that carries it",
                 fmt::format("water left in a ball that gas has blown up to {:.2f} times its volume (published: {:.2f}), no flux", grown,
                             grown_published),
                 "1: nothing leaves", water, water_published, water_published < 0.9});
  all.push_back({"Eq. 27", "the momentum changes by - m v div v dt", "no such term: a particle's momentum is not thinned by expansion",
                 "speed left of the same ball, which nobody pushes", "1: nobody pushes", speed, speed_published, speed_published < 0.9});
  const Soaked spread = soaked("", quick), stuck = soaked("form = \"published\"\nsubgrid_diffusion = 0", quick);
  all.push_back({"Eq. 19", "what nodes gain and lose is shared by the water that their particles have",
                 "gains are shared by volume, losses by water; what differs within a cell decays",
                 fmt::format("largest saturation of a dry half of a bar, 0.1 s after it touched a half of saturation {}", k_soaked),
                 fmt::format("between 0 and {}: water spreads", k_soaked), spread.dry, stuck.dry, stuck.dry == 0 && spread.dry > 0.1});
  all.push_back({"Eq. 19", "the same", "the same", "largest saturation of that wet half",
                 fmt::format("at most {}: it only gives; 1 is water alone", k_soaked), spread.wet, stuck.wet,
                 stuck.wet > 1 && spread.wet <= k_soaked});
  const double even = uneven("", quick), kept = uneven("subgrid_diffusion = 0", quick);
  all.push_back(
      {"Eq. 21", "particles take the change of their nodes and keep what differs within a cell",
       "what differs within a cell decays as conduction over dx would have it (subgrid diffusion)",
       "hottest less coldest particle of an insulated bar, halves of 0 and 100 C, after 1 s, ten decay times of its slowest wave [K]",
       "0: it has evened out", even, kept, kept > 50 && even < 1});
  const double cold = cooled("standard", quick), hot = cooled("published", quick);
  all.push_back({"Sec. 4, 6.3", "the flux into the body is beta (theta - theta_out)", "beta (theta_out - theta)",
                 "mean temperature of a ball of 100 C after 0.2 s in air of 20 C", "between 20 and 100 C: it cools", cold, hot, hot > 100});
  const double area = area_found("standard", quick), printed = area_found("published", quick);
  all.push_back({"Sec. 6.6", "boundary particles, one for every empty node next to dough, each a disc",
                 "gradient of the filled volume on the grid", "area found of a sphere, over the true one", "1", area, printed,
                 std::abs(printed - 1) > 0.3});
  const Leavened risen_to = leavened("standard", quick), blown = leavened("published", quick);
  all.push_back({"Eq. 13", "p = nu R theta / n, theta in degrees Celsius, no atmosphere",
                 "all pore gas, absolute temperature, against the atmosphere",
                 "volume ratio after 1 s (or when beyond 20) of a ball whose leavener makes its own volume of gas",
                 "about 2: its own volume of gas, and warmer pores", risen_to.volume_ratio, blown.volume_ratio,
                 blown.volume_ratio > 2 * risen_to.volume_ratio});
  constexpr double n_0 = 0.2;
  const double J_P = risen_to.plastic_ratio;
  all.push_back({"Sec. 5.4", "n = J_P - 1 + n_0", "n = 1 - (1 - n_0) / J_P: the skeleton does not shrink",
                 fmt::format("pore fraction of that ball, n_0 = 0.2, whose plastic volume ratio is now {:.2f}", J_P), "below 1",
                 1 - (1 - n_0) / J_P, J_P - 1 + n_0, J_P - 1 + n_0 > 1});
  const double rest = strain_of_rest("standard", quick), drift = strain_of_rest("published", quick);
  all.push_back({"Eq. 10", "thermal stress c lambda J theta", "beta_T (theta - theta_0), free of stress where the dough was made",
                 "ln J that a ball takes at the temperature at which it was made", "0", rest, drift, std::abs(drift) > 1e-3});
  all.push_back({"Eq. 12", "overstress q^2 - tau_y^2, viscosity in Pa^3 s",
                 "the distance q - tau_y, viscosity in Pa s: Table 2's make sense",
                 "rate of strain at three times the yield stress of 1 Pa with eta = 1 [1/s]", "2: overstress over viscosity",
                 flow_rate(false), flow_rate(true), flow_rate(true) > 2 * flow_rate(false)});
  return all;
}

}  // namespace bake::studies
