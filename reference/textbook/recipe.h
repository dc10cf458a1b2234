// SPDX-License-Identifier: MIT
// What is baked, and with which form of each equation. SI units, temperatures in degrees Celsius.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "reference/textbook/algebra.h"

namespace bake::textbook {

/// `published` is an equation as it is printed in [Ding19], `standard` the one that the project holds to be right.
enum class Form { standard, published };
enum class Kernel { quadratic, cubic };
/// How grad w is taken: `spline` is the derivative of the weight, as in [Ding19]; `moments` is D^-1 w r.
enum class Gradient { moments, spline };
enum class Transfer { apic, pic, flip };
enum class HeatStep { forward_euler, backward_euler };
enum class Norm { distance, quadratic };
enum class Rule { open, sticky, slip, separating };

inline constexpr double k_gas_constant = 8.314;       ///< R [J/(mol K)]
inline constexpr double k_zero_celsius = 273.15;      ///< [K]
inline constexpr double k_one_atmosphere = 101325.0;  ///< [Pa]

struct Material {
  double density = 0;           ///< of the mixture at the start, water included [kg/m^3]
  double initial_porosity = 0;  ///< n_0 [1]
  double s_0 = 0;               ///< saturation at the start [1]
  double theta_0 = 0;           ///< temperature at the start [C]
  // elasticity
  double young_modulus = 0;  ///< E [Pa]
  double poisson_ratio = 0;  ///< nu [1]
  // heat
  double alpha_s = 0;                             ///< heat capacity of the solid per mass [J/(kg K)]
  double kappa = 0;                               ///< conductivity [W/(m K)]
  double alpha_l = 0;                             ///< linear thermal expansion [1/K]
  double transition_heat = 0;                     ///< latent heat of melting or setting, per mass of the solid [J/kg]
  double transition_from = 0, transition_to = 1;  ///< between which it is taken up [C]
  // water
  double rho_w = 0;   ///< intrinsic density of water [kg/m^3]
  double K = 0;       ///< Fick's constant [m^2/(s K)]
  double beta_w = 0;  ///< evaporation [kg/(m^2 s K)]
  double c_hat = 0;   ///< water pressure per saturation [Pa]
  // plasticity: fig. 8
  double theta[4] = {}, tau_y[4] = {}, eta[4] = {};  ///< [C], [Pa], [Pa s]
  // leavening
  double alpha_g = 0, theta_r = 0, delta_theta = 1;                 ///< [mol/(kg s)], [C], [K]
  double leavener_total = std::numeric_limits<double>::infinity();  ///< [mol/m^3]

  double lambda() const { return young_modulus * poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio)); }
  double mu() const { return young_modulus / (2 * (1 + poisson_ratio)); }
  double bulk() const { return young_modulus / (3 * (1 - 2 * poisson_ratio)); }
};

struct Recipe {
  bool motion = false, heat = false, water = false, elasticity = false, plasticity = false, leavening = false;
  std::vector<Material> materials;

  double dx = 0;                             ///< [m]
  Vector low;                                ///< corner of the domain, a node [m]
  int cells[3] = {};                         ///< of the domain
  Rule faces[3][2] = {};                     ///< lower and upper face of each axis
  bool periodic[3] = {false, false, false};  ///< the two faces of an axis are one
  bool is_periodic() const { return periodic[0] || periodic[1] || periodic[2]; }
  bool mirrors[3][2] = {{true, true}, {true, true}, {true, true}};  ///< faces that dough is mirrored at when its surface is measured
  double face_friction = 0;
  Kernel kernel = Kernel::quadratic;
  Gradient gradient = Gradient::moments;

  Transfer transfer = Transfer::apic;
  double flip_blend = 0.95;
  double inertia_scale = 1;  ///< inertial mass per mass

  HeatStep heat_step = HeatStep::forward_euler;
  Form heat_transfer_form = Form::standard, expansion_form = Form::standard, water_form = Form::standard, leavening_form = Form::standard,
       porosity_form = Form::standard, surface_form = Form::standard;
  Norm norm = Norm::distance;
  double heat_subgrid = 1, water_subgrid = 1;    ///< rate of subgrid diffusion, in units of the diffusivity over dx^2
  double alpha_w = 0;                            ///< heat capacity of water per mass [J/(kg K)]
  double latent_heat = 0;                        ///< L_v [J/kg]
  double reference_pressure = k_one_atmosphere;  ///< p_ref [Pa]
  bool pores_open = false;                       ///< pores hold no vacuum
};

/// How deep below the surface the nodes are that fluxes through it are taken at [m]: dough of that depth resists them. `strength`: b / (1 +
/// b), b = beta dx / kappa.
inline double layer_depth(const Recipe& recipe, double strength) {
  return recipe.dx * ((recipe.kernel == Kernel::quadratic ? 0.76 : 0.74) + 0.18 * strength);
}

/// A rigid object that touches dough, at one time.
struct Solid {
  std::function<double(const Vector&)> distance;  ///< signed, negative inside [m]
  std::function<Vector(const Vector&)> normal;    ///< outward, of length 1
  std::function<Vector(const Vector&)> velocity;  ///< of the solid [m/s]
  Rule rule = Rule::separating;
  double friction = 0;
  bool expels = false;               ///< also moves particles out, one by one
  bool is_grip = false;              ///< holds what is inside it: no surface of its own
  bool covers = true;                ///< shuts off the surface that it touches from the air
  std::optional<double> theta = {};  ///< [C]; a collider without it passes no heat
  double beta = 0;                   ///< [W/(m^2 K)]; infinite: the dough's surface has that temperature
  double flux = 0;                   ///< that comes in whatever the temperatures are [W/m^2]
};

struct Air {
  double beta = 0;   ///< [W/(m^2 K)]
  double theta = 0;  ///< theta_out [C]
  double s_out = 0;  ///< saturation that its humidity would keep
};

/// The surroundings of the dough during one step.
struct Surroundings {
  Vector gravity;  ///< [m/s^2]
  Air air;
  std::vector<Solid> solids;
  std::vector<Solid> walls;  ///< faces of the domain that pass heat, as solids beyond them, whose rules for motion are the faces'
};

}  // namespace bake::textbook
