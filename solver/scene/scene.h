// SPDX-License-Identifier: MIT
// A scene as plain data: all that a run needs, in SI units, as read from a TOML file.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "solver/boundary/motion_path.h"
#include "solver/boundary/shape.h"
#include "solver/core/by_type.h"
#include "solver/core/errors.h"
#include "solver/core/parameter.h"
#include "solver/scene/settings.h"

namespace bake {

/// [[material]]
struct Material {
  std::string name;
  double density_kg_per_m3 = 0;
  double initial_porosity = 0.1;
  double initial_saturation = 0;
  double initial_temperature_C = 20;
  ByType effects;  ///< each effect's own values; keys stand directly in [[material]]
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"name", &Material::name, "", any_number, "how bodies refer to it", Presence::required},
        Parameter{"density_kg_per_m3", &Material::density_kg_per_m3, "kg/m^3", positive,
                  "R_0: initial density of the mixture, water included", Presence::required},
        Parameter{
            "initial_porosity", &Material::initial_porosity, "1", open_fraction,
            "n_0: share of the initial volume that is gas; pores make the yield stress of plastic dough depend on pressure (near 0: not)"},
        Parameter{"initial_saturation", &Material::initial_saturation, "1", fraction,
                  "s_0: share of the initial volume that is water; also where water pressure is zero"},
        Parameter{"initial_temperature_C", &Material::initial_temperature_C, "C", above_absolute_zero,
                  "theta_0: start temperature, also where thermal stress is zero"},
    };
  }
};

/// How a surface acts on the dough that touches it.
enum class Contact { sticky, slip, separating };
constexpr auto choice_names(Contact) { return std::array{"sticky", "slip", "separating"}; }

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
  Vector3 angular_velocity_rad_per_s = {0, 0, 0};
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
        Parameter{"jitter", &Body::jitter, "1", fraction,
                  "random displacement of lattice particles, in lattice spacings (1: anywhere in its own cube)"},
        Parameter{"velocity_m_per_s", &Body::velocity_m_per_s, "m/s", any_number, "start velocity"},
        Parameter{"angular_velocity_rad_per_s", &Body::angular_velocity_rad_per_s, "rad/s", any_number,
                  "omega: start angular velocity about the body's centre of mass", Presence::optional, "spin_rad_per_s"},
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
  bool expels = false;
  bool covers = true;
  std::optional<Curve> temperature_C;  ///< unset: it passes no heat
  double heat_transfer_coefficient_W_per_m2K = 0;
  bool ledger = false;
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
        Parameter{"expels", &Collider::expels, "", any_number,
                  "also moves single particles out of it: for blades, which are so thin that the grid alone would let dough pass"},
        Parameter{"covers", &Collider::covers, "", any_number,
                  "shuts off the surface that it touches, within about two cells, from the air; false for a rack through which the air "
                  "passes: it pushes only, and dough on it exchanges heat and vapour with the air all over"},
        Parameter{"temperature_C", &Collider::temperature_C, "C", above_absolute_zero,
                  "conductive theta over time; without it the collider passes no heat"},
        Parameter{"heat_transfer_coefficient_W_per_m2K", &Collider::heat_transfer_coefficient_W_per_m2K, "W/(m^2 K)", non_negative,
                  "conductive beta: heat transfer coefficient where dough touches it", Presence::optional, "exchange_W_per_m2K"},
        Parameter{"ledger", &Collider::ledger, "", any_number,
                  "the ledger tells which impulse and heat it gave: columns `collider_<name>_impulse_x_kg_m_per_s` and so on"},
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
  std::optional<Curve> temperature_C;  ///< also holds this temperature inside
  bool ledger = false;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"name", &Grip::name, "", any_number, "for messages and the ledger"},
        Parameter{"shape", &Grip::shape, "", any_number, "the region that is held", Presence::required},
        Parameter{"motion", &Grip::motion, "", any_number, "keyframes of the motion that it follows; held still without"},
        Parameter{"pivot_m", &Grip::pivot_m, "m", any_number, "point about which it turns"},
        Parameter{"from_s", &Grip::from_s, "s", Range{}, "it grips from this time"},
        Parameter{"until_s", &Grip::until_s, "s", Range{}, "it lets go at this time"},
        Parameter{"temperature_C", &Grip::temperature_C, "C", above_absolute_zero, "also holds this temperature"},
        Parameter{"ledger", &Grip::ledger, "", any_number,
                  "the ledger tells which impulse it gave: columns `grip_<name>_impulse_x_kg_m_per_s` and so on"},
    };
  }
};

/// [[face]] - what a face of the domain does beside its rule for motion, which stands in [domain]. One that passes no heat is a mirror.
struct DomainFace {
  DomainSide at = DomainSide::x_min;
  std::optional<Curve> temperature_C;
  std::optional<double> heat_transfer_coefficient_W_per_m2K;  ///< unset: the dough's surface has the wall's temperature
  std::optional<Curve> heat_flux_W_per_m2;
  bool passes_heat() const { return temperature_C || heat_flux_W_per_m2; }
  bool ledger = false;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"at", &DomainFace::at, "", any_number, "which face; its rule for motion stands in [domain]", Presence::required},
        Parameter{"temperature_C", &DomainFace::temperature_C, "C", above_absolute_zero,
                  "conductive theta of the wall behind the face over time; without it and without a flux no heat passes"},
        Parameter{
            "heat_transfer_coefficient_W_per_m2K", &DomainFace::heat_transfer_coefficient_W_per_m2K, "W/(m^2 K)", non_negative,
            "conductive beta: heat transfer coefficient between wall and dough; without it the dough's surface has the wall's temperature"},
        Parameter{"heat_flux_W_per_m2", &DomainFace::heat_flux_W_per_m2, "W/m^2", any_number,
                  "heat that comes in through the face per area, over time; instead of a temperature"},
        Parameter{"ledger", &DomainFace::ledger, "", any_number,
                  "the ledger tells which impulse and heat it gave: columns `face_<at>_impulse_x_kg_m_per_s` and so on"},
    };
  }
};

/// [[emitter]] - pours material: the shape is filled again each time the last filling has moved away by its own length.
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
        Parameter{"velocity_m_per_s", &Emitter::velocity_m_per_s, "m/s", any_number, "velocity of what is poured; not zero",
                  Presence::required},
        Parameter{"from_s", &Emitter::from_s, "s", any_number, "pouring starts"},
        Parameter{"until_s", &Emitter::until_s, "s", Range{}, "pouring ends"},
        Parameter{"particles_per_cell", &Emitter::particles_per_cell, "1", Range{0.1, 1000, false, false, "a number from 0.1 to 1000"},
                  "particles per grid cell"},
        Parameter{"temperature_C", &Emitter::temperature_C, "C", above_absolute_zero,
                  "temperature of what is poured; the material's unless given"},
        Parameter{"saturation", &Emitter::saturation, "1", fraction, "saturation of what is poured; the material's unless given"},
    };
  }
};

/// The shape in which a skin has no stress.
enum class StressFree { start };
constexpr auto choice_names(StressFree) { return std::array{"start"}; }

/// [[skin]] - an elastic sheet of triangles on bodies.
struct Skin {
  std::vector<double> body = {0};
  std::filesystem::path mesh_file;
  ShapePtr only;
  double depth_dx = 0.4;
  double young_modulus_Pa = 0;
  double poisson_ratio = 0.3;
  double thickness_m = 0;
  double density_kg_per_m3 = 1000;
  double permeance = 1;
  StressFree stress_free = StressFree::start;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"body", &Skin::body, "", non_negative, "number of the [[body]] that it covers, from 0 in the order of the file"},
        Parameter{"mesh_file", &Skin::mesh_file, "", any_number,
                  "triangles on the body's surface (`bake-mesh skin`); without it they are made for the run's dx, with edges of 0.6 dx"},
        Parameter{"only", &Skin::only, "", any_number, "only triangles inside this shape are kept: a rim, a half"},
        Parameter{"depth_dx", &Skin::depth_dx, "dx", Range{0, 2, false, false, "a number from 0 to 2"},
                  "how deep below the surface its vertices lie; further out they would lose hold of the flesh where it is pulled"},
        Parameter{"young_modulus_Pa", &Skin::young_modulus_Pa, "Pa", positive, "E_f: Young's modulus", Presence::required},
        Parameter{"poisson_ratio", &Skin::poisson_ratio, "1", Range{-0.99, 0.5, false, false, "a number from -0.99 to 0.5"},
                  "nu_f: Poisson's ratio"},
        Parameter{"thickness_m", &Skin::thickness_m, "m", positive,
                  "h: thickness; E_f h resists stretching, B = E_f h^3 / (12 (1 - nu_f^2)) bending", Presence::required},
        Parameter{"density_kg_per_m3", &Skin::density_kg_per_m3, "kg/m^3", positive, "rho_f: density"},
        Parameter{"permeance", &Skin::permeance, "1", fraction,
                  "share of what would evaporate through the open surface that passes the skin"},
        Parameter{"stress_free", &Skin::stress_free, "", any_number, "shape in which it has no stress: that of the start"},
    };
  }
  double mass_per_area() const { return density_kg_per_m3 * thickness_m; }  ///< [kg/m^2]
  /// B [N m].
  double bending_stiffness() const {
    return young_modulus_Pa * thickness_m * thickness_m * thickness_m / (12 * (1 - poisson_ratio * poisson_ratio));
  }
};

struct Scene {
  std::string title;
  std::filesystem::path file;        ///< where it was read from
  std::vector<std::string> effects;  ///< names, in the order of AllEffects (solver/effects/all_effects.h)
  Quality quality = Quality::paper;
  RunSettings run;
  GridSettings grid;
  DomainSettings domain;
  TimeSettings time;
  SurfaceSettings surface;
  Oven oven;
  ByType settings;  ///< [motion], [heat], ... one table per effect
  std::vector<Material> materials;
  std::vector<Body> bodies;
  std::vector<Collider> colliders;
  std::vector<Grip> grips;
  std::vector<DomainFace> faces;
  std::vector<Emitter> emitters;
  std::vector<Skin> skins;
  std::vector<std::string> notices;           ///< lines for the author of the file: keys that were read under their former names
  std::map<std::string, std::string> places;  ///< where keys were found, by dotted name: "bread.toml:12", "override 'run.end_s=2'"

  bool lists(std::string_view effect) const;                     ///< is the effect on?
  std::string at(const std::string& key) const;                  ///< how a message about that key begins: "bread.toml:12: run.end_s"
  double dx() const { return grid.dx_m * coarsening(quality); }  ///< node distance of this run [m]
  template <class Effect>
  const typename Effect::Settings& of() const {
    return settings.get<typename Effect::Settings>();
  }
};

template <class Effect>
const typename Effect::Material& of(const Material& material) {
  return material.effects.template get<typename Effect::Material>();
}

}  // namespace bake
