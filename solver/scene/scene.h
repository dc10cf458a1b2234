// SPDX-License-Identifier: MIT
// A scene as plain data: everything a run needs to know, in SI units, as read from a TOML file.
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "solver/boundary/motion_path.h"
#include "solver/boundary/shape.h"
#include "solver/effects/elasticity.h"
#include "solver/effects/heat.h"
#include "solver/effects/leavening.h"
#include "solver/effects/motion.h"
#include "solver/effects/plasticity.h"
#include "solver/effects/water.h"
#include "solver/scene/parameter.h"

namespace bake {

/// Every effect there is, in the order in which they act within a step. Adding an effect adds a name here.
using AllEffects = std::tuple<Motion, Heat, Water, Elasticity, Plasticity, Leavening>;

template <class Effects>
struct SettingsOf;
template <class... Effect>
struct SettingsOf<std::tuple<Effect...>> {
  using type = std::tuple<typename Effect::Settings...>;
  using materials = std::tuple<typename Effect::Material...>;
};

enum class Quality { draft, standard, paper };
constexpr auto choice_names(Quality) { return std::array{"draft", "standard", "paper"}; }
/// Factor on dx: particle counts fall to about 1/64 and 1/8 of the paper's.
constexpr double coarsening(Quality quality) { return quality == Quality::draft ? 4 : quality == Quality::standard ? 2 : 1; }

enum class Precision { single_precision, double_precision };
constexpr auto choice_names(Precision) { return std::array{"single", "double"}; }

enum class KernelOrder { quadratic, cubic };
constexpr auto choice_names(KernelOrder) { return std::array{"quadratic", "cubic"}; }

/// [run]
struct RunSettings {
  double end_s = 1;
  double frame_rate_per_s = 24;
  int seed = 1;
  Precision precision = Precision::single_precision;
  int checkpoint_every_frames = 10;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"end_s", &RunSettings::end_s, "s", positive, "simulated time at which the run ends", Presence::required},
        Parameter{"frame_rate_per_s", &RunSettings::frame_rate_per_s, "1/s", positive, "frames per simulated second"},
        Parameter{"seed", &RunSettings::seed, "1", Range{0, 2147483647, false, false, "a whole number of at least 0"}, "seed of every random choice"},
        Parameter{"precision", &RunSettings::precision, "", any_number, "floating-point numbers of particles and grid"},
        Parameter{"checkpoint_every_frames", &RunSettings::checkpoint_every_frames, "1", Range{1, 1e9, false, false, "a whole number of at least 1"},
                  "a checkpoint is written at the last frame and every so many frames"},
    };
  }
};

/// [grid]
struct GridSettings {
  double dx_m = 0;  ///< at paper quality; multiplied by coarsening(quality)
  KernelOrder kernel = KernelOrder::quadratic;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"dx_m", &GridSettings::dx_m, "m", positive, "distance of grid nodes at paper quality (standard doubles it, draft doubles it again)",
                  Presence::required},
        Parameter{"kernel", &GridSettings::kernel, "", any_number, "B-spline that joins particles and nodes"},
    };
  }
};

/// How a surface acts on the dough that touches it.
enum class Contact { sticky, slip, separating };
constexpr auto choice_names(Contact) { return std::array{"sticky", "slip", "separating"}; }

/// What happens at one face of the domain. `open`: particles that pass are retired and booked.
enum class Face { sticky, slip, separating, open };
constexpr auto choice_names(Face) { return std::array{"sticky", "slip", "separating", "open"}; }

/// [domain] - the box that is simulated. Its far corner is rounded outwards to a whole number of cells.
struct DomainSettings {
  Vector3 min_m = {0, 0, 0};
  Vector3 max_m = {0, 0, 0};
  Face x_min = Face::separating, x_max = Face::separating;
  Face y_min = Face::separating, y_max = Face::separating;
  Face z_min = Face::separating, z_max = Face::separating;
  double friction = 0;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"min_m", &DomainSettings::min_m, "m", any_number, "lower corner of the simulated box", Presence::required},
        Parameter{"max_m", &DomainSettings::max_m, "m", any_number, "upper corner of the simulated box", Presence::required},
        Parameter{"x_min", &DomainSettings::x_min, "", any_number, "rule at the face of smallest x (heat and water never pass a face)"},
        Parameter{"x_max", &DomainSettings::x_max, "", any_number, "rule at the face of largest x"},
        Parameter{"y_min", &DomainSettings::y_min, "", any_number, "rule at the face of smallest y"},
        Parameter{"y_max", &DomainSettings::y_max, "", any_number, "rule at the face of largest y"},
        Parameter{"z_min", &DomainSettings::z_min, "", any_number, "rule at the face of smallest z"},
        Parameter{"z_max", &DomainSettings::z_max, "", any_number, "rule at the face of largest z"},
        Parameter{"friction", &DomainSettings::friction, "1", non_negative, "Coulomb coefficient of separating faces"},
    };
  }
};

/// [time] - the step is the smallest limit of the effects that are on, times `safety`.
struct TimeSettings {
  double safety = 0.5;
  double cfl = 0.3;
  double largest_step_s = k_infinity;
  double smallest_step_s = 0;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"safety", &TimeSettings::safety, "1", positive, "share of each effect's own stability limit that is used"},
        Parameter{"cfl", &TimeSettings::cfl, "1", open_fraction, "largest particle travel per step, in dx"},
        Parameter{"largest_step_s", &TimeSettings::largest_step_s, "s", positive_or_infinite, "upper bound of the step"},
        Parameter{"smallest_step_s", &TimeSettings::smallest_step_s, "s", non_negative, "the run stops (exit 3) when stability asks for less"},
    };
  }
};

/// [surface] - how the area that touches air is measured.
struct SurfaceSettings {
  Form form = Form::standard;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"form", &SurfaceSettings::form, "", any_number,
                  "grid measure that converges (standard) or boundary particles as in Sec. 6.6 (published)"},
    };
  }
};

/// [oven] - the surroundings of every free surface.
struct Oven {
  Curve temperature_C{20};
  Curve exchange_W_per_m2K{0};
  Curve equilibrium_saturation{0};
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"temperature_C", &Oven::temperature_C, "C", above_absolute_zero, "theta_out: ambient temperature over time"},
        Parameter{"exchange_W_per_m2K", &Oven::exchange_W_per_m2K, "W/(m^2 K)", non_negative, "beta: heat exchange of a free surface over time"},
        Parameter{"equilibrium_saturation", &Oven::equilibrium_saturation, "1", fraction,
                  "s_out: saturation that the air's humidity would keep at the surface, over time"},
    };
  }
};

/// [[material]]
struct Material {
  std::string name;
  double density_kg_per_m3 = 0;
  double initial_porosity = 0.1;
  double initial_saturation = 0;
  double initial_temperature_C = 20;
  SettingsOf<AllEffects>::materials effects;  ///< each effect's own values; keys stand directly in [[material]]
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"name", &Material::name, "", any_number, "how bodies refer to it", Presence::required},
        Parameter{"density_kg_per_m3", &Material::density_kg_per_m3, "kg/m^3", positive, "R_0: initial density of the mixture, water included",
                  Presence::required},
        Parameter{"initial_porosity", &Material::initial_porosity, "1", open_fraction, "n_0: share of the initial volume that is gas"},
        Parameter{"initial_saturation", &Material::initial_saturation, "1", fraction,
                  "s_0: share of the initial volume that is water; also where water pressure is zero"},
        Parameter{"initial_temperature_C", &Material::initial_temperature_C, "C", above_absolute_zero,
                  "theta_0: start temperature, also where thermal stress is zero"},
    };
  }
};

enum class Filling { lattice, poisson };
constexpr auto choice_names(Filling) { return std::array{"lattice", "poisson"}; }

/// [[body]] - a shape filled with particles, or particles from a file.
struct Body {
  std::string material;
  ShapePtr shape;
  std::filesystem::path particles_file;  ///< HDF5: positions [n,3], volumes [n], optional material [n] (index into [[material]])
  Filling filling = Filling::lattice;
  double particles_per_cell = 6;
  double jitter = 0.5;
  Vector3 velocity_m_per_s = {0, 0, 0};
  Vector3 spin_rad_per_s = {0, 0, 0};
  std::optional<double> temperature_C;  ///< default: the material's initial temperature
  std::optional<double> saturation;     ///< default: the material's initial saturation
  double leavener = 1;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"material", &Body::material, "", any_number, "name of its [[material]]", Presence::required},
        Parameter{"shape", &Body::shape, "", any_number, "the solid that is filled (see `bake explain shape`)"},
        Parameter{"particles_file", &Body::particles_file, "", any_number,
                  "HDF5 file with positions [n,3] in m, volumes [n] in m^3 and, if wanted, material [n]; instead of a shape"},
        Parameter{"filling", &Body::filling, "", any_number, "jittered lattice or Poisson disk"},
        Parameter{"particles_per_cell", &Body::particles_per_cell, "1", Range{0.1, 1000, false, false, "a number from 0.1 to 1000"},
                  "particles per grid cell at the start"},
        Parameter{"jitter", &Body::jitter, "1", fraction, "random displacement of lattice particles, in lattice spacings (1: anywhere in its own cube)"},
        Parameter{"velocity_m_per_s", &Body::velocity_m_per_s, "m/s", any_number, "start velocity"},
        Parameter{"spin_rad_per_s", &Body::spin_rad_per_s, "rad/s", any_number, "start angular velocity about the body's centre of mass"},
        Parameter{"temperature_C", &Body::temperature_C, "C", above_absolute_zero, "start temperature; the material's unless given"},
        Parameter{"saturation", &Body::saturation, "1", fraction, "start saturation; the material's unless given"},
        Parameter{"leavener", &Body::leavener, "1", non_negative, "leavener relative to the material's"},
    };
  }
};

/// [[collider]] - a rigid thing that dough cannot enter.
struct Collider {
  std::string name;
  ShapePtr shape;
  std::vector<Keyframe> motion;
  Vector3 pivot_m = {0, 0, 0};
  double from_s = -k_infinity;
  double until_s = k_infinity;
  Contact contact = Contact::separating;
  double friction = 0;
  std::optional<Curve> temperature_C;  ///< unset: no conduction, the oven's air reaches between
  double exchange_W_per_m2K = 0;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"name", &Collider::name, "", any_number, "for messages and the ledger"},
        Parameter{"shape", &Collider::shape, "", any_number, "the solid", Presence::required},
        Parameter{"motion", &Collider::motion, "", any_number, "keyframes of its rigid motion; at rest without"},
        Parameter{"pivot_m", &Collider::pivot_m, "m", any_number, "point about which it turns"},
        Parameter{"from_s", &Collider::from_s, "s", Range{}, "it is there from this time"},
        Parameter{"until_s", &Collider::until_s, "s", Range{}, "it is taken away at this time"},
        Parameter{"contact", &Collider::contact, "", any_number, "sticky, slip (no parting), or separating with Coulomb friction"},
        Parameter{"friction", &Collider::friction, "1", non_negative, "Coulomb coefficient (contact = \"separating\")"},
        Parameter{"temperature_C", &Collider::temperature_C, "C", above_absolute_zero, "conductive theta over time; without it the collider passes no heat"},
        Parameter{"exchange_W_per_m2K", &Collider::exchange_W_per_m2K, "W/(m^2 K)", non_negative, "conductive beta: heat exchange where dough touches it"},
    };
  }
};

/// [[grip]] - everything inside the (moving) shape follows its motion.
struct Grip {
  std::string name;
  ShapePtr shape;
  std::vector<Keyframe> motion;
  Vector3 pivot_m = {0, 0, 0};
  double from_s = -k_infinity;
  double until_s = k_infinity;
  std::optional<Curve> temperature_C;  ///< holds this temperature inside, too
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"name", &Grip::name, "", any_number, "for messages and the ledger"},
        Parameter{"shape", &Grip::shape, "", any_number, "the region that is held", Presence::required},
        Parameter{"motion", &Grip::motion, "", any_number, "keyframes of the motion that it follows; held still without"},
        Parameter{"pivot_m", &Grip::pivot_m, "m", any_number, "point about which it turns"},
        Parameter{"from_s", &Grip::from_s, "s", Range{}, "it grips from this time"},
        Parameter{"until_s", &Grip::until_s, "s", Range{}, "it lets go at this time"},
        Parameter{"temperature_C", &Grip::temperature_C, "C", above_absolute_zero, "also holds this temperature"},
    };
  }
};

/// [[emitter]] - pours material: each time what was poured has moved its own length away, the shape is filled anew.
struct Emitter {
  std::string name;
  std::string material;
  ShapePtr shape;
  Vector3 velocity_m_per_s = {0, 0, 0};
  double from_s = 0;
  double until_s = k_infinity;
  double particles_per_cell = 6;
  std::optional<double> temperature_C;
  std::optional<double> saturation;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"name", &Emitter::name, "", any_number, "for messages"},
        Parameter{"material", &Emitter::material, "", any_number, "name of its [[material]]", Presence::required},
        Parameter{"shape", &Emitter::shape, "", any_number, "the spout: filled again and again", Presence::required},
        Parameter{"velocity_m_per_s", &Emitter::velocity_m_per_s, "m/s", any_number, "velocity of what is poured; not zero", Presence::required},
        Parameter{"from_s", &Emitter::from_s, "s", any_number, "pouring starts"},
        Parameter{"until_s", &Emitter::until_s, "s", Range{}, "pouring ends"},
        Parameter{"particles_per_cell", &Emitter::particles_per_cell, "1", Range{0.1, 1000, false, false, "a number from 0.1 to 1000"}, "particles per grid cell"},
        Parameter{"temperature_C", &Emitter::temperature_C, "C", above_absolute_zero, "temperature of what is poured; the material's unless given"},
        Parameter{"saturation", &Emitter::saturation, "1", fraction, "saturation of what is poured; the material's unless given"},
    };
  }
};

struct Scene {
  std::string title;
  std::filesystem::path file;        ///< where it was read from
  std::vector<std::string> effects;  ///< names, in the order of AllEffects
  Quality quality = Quality::paper;
  RunSettings run;
  GridSettings grid;
  DomainSettings domain;
  TimeSettings time;
  SurfaceSettings surface;
  Oven oven;
  SettingsOf<AllEffects>::type settings;  ///< [motion], [heat], ... one table per effect
  std::vector<Material> materials;
  std::vector<Body> bodies;
  std::vector<Collider> colliders;
  std::vector<Grip> grips;
  std::vector<Emitter> emitters;

  bool lists(std::string_view effect) const;                                ///< is the effect on?
  double dx() const { return grid.dx_m * coarsening(quality); }             ///< node distance of this run [m]
  template <class Effect>
  const typename Effect::Settings& of() const { return std::get<typename Effect::Settings>(settings); }
};

template <class Effect>
const typename Effect::Material& of(const Material& material) { return std::get<typename Effect::Material>(material.effects); }

/// A mistake of the user: wrong file, key, value or option. `what()` is one line: file:line: key: found, allowed.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace bake
