// SPDX-License-Identifier: MIT
// The tables that a scene has once: [run], [grid], [domain], [time], [surface], [oven].
#pragma once

#include <array>
#include <tuple>

#include "solver/core/kernel_order.h"
#include "solver/core/parameter.h"
#include "solver/effects/form.h"

namespace bake {

enum class Quality { draft, standard, paper };
constexpr auto choice_names(Quality) { return std::array{"draft", "standard", "paper"}; }
/// The factor on dx. Draft and standard have about 1/64 and 1/8 of the particles of paper quality.
constexpr double coarsening(Quality quality) { return quality == Quality::draft ? 4 : quality == Quality::standard ? 2 : 1; }

enum class Precision { single_precision, double_precision };
constexpr auto choice_names(Precision) { return std::array{"single", "double"}; }

/// [run]
struct RunSettings {
  double end_s = 1;
  double frame_rate_per_s = 24;
  int seed = 1;
  Precision precision = Precision::single_precision;
  int checkpoint_every_frames = 24;
  bool stress_in_frames = false;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"end_s", &RunSettings::end_s, "s", positive, "simulated time at which the run ends", Presence::required},
        Parameter{"frame_rate_per_s", &RunSettings::frame_rate_per_s, "1/s", positive, "frames per simulated second"},
        Parameter{"seed", &RunSettings::seed, "1", Range{0, 2147483647, false, false, "a whole number of at least 0"},
                  "seed of every random choice"},
        Parameter{"precision", &RunSettings::precision, "", any_number, "floating-point numbers of particles and grid"},
        Parameter{"checkpoint_every_frames", &RunSettings::checkpoint_every_frames, "1",
                  Range{1, 1e9, false, false, "a whole number of at least 1"},
                  "a checkpoint, and the list of the frames, are written at the last frame and every so many frames"},
        Parameter{"stress_in_frames", &RunSettings::stress_in_frames, "", any_number,
                  "whether frames have the columns stress and von_mises, where something moves"},
    };
  }
};

/// [grid]
struct GridSettings {
  double dx_m = 0;  ///< at paper quality; multiplied by coarsening(quality)
  KernelOrder kernel = KernelOrder::quadratic;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"dx_m", &GridSettings::dx_m, "m", positive,
                  "distance of grid nodes at paper quality (standard doubles it, draft doubles it again)", Presence::required},
        Parameter{"kernel", &GridSettings::kernel, "", any_number, "B-spline that joins particles and nodes"},
    };
  }
};

/// The rule at one face of the domain. `open`: particles that pass it are removed and booked as retired. `periodic`: it is the opposite
/// face seen from the other side.
enum class Face { sticky, slip, separating, open, periodic };
constexpr auto choice_names(Face) { return std::array{"sticky", "slip", "separating", "open", "periodic"}; }

/// The faces of the domain.
enum class DomainSide { x_min, x_max, y_min, y_max, z_min, z_max };
constexpr auto choice_names(DomainSide) { return std::array{"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"}; }

/// [domain] - the box that is simulated. Its far corner is rounded outwards to a whole number of cells.
struct DomainSettings {
  Vector3 min_m = {0, 0, 0};
  Vector3 max_m = {0, 0, 0};
  Face x_min = Face::separating, x_max = Face::separating;
  Face y_min = Face::separating, y_max = Face::separating;
  Face z_min = Face::separating, z_max = Face::separating;
  double friction = 0;
  Face face(DomainSide side) const { return std::array{x_min, x_max, y_min, y_max, z_min, z_max}[static_cast<std::size_t>(side)]; }
  /// Are both faces of an axis (0 to 2) periodic?
  bool is_periodic(int axis) const { return face(static_cast<DomainSide>(2 * axis)) == Face::periodic; }
  bool is_periodic() const { return is_periodic(0) || is_periodic(1) || is_periodic(2); }
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"min_m", &DomainSettings::min_m, "m", any_number, "lower corner of the simulated box", Presence::required},
        Parameter{"max_m", &DomainSettings::max_m, "m", any_number, "upper corner of the simulated box", Presence::required},
        Parameter{"x_min", &DomainSettings::x_min, "", any_number,
                  "rule at the face of smallest x (water never passes a face, heat where a [[face]] says so; all passes one "
                  "that is periodic, which the opposite one must be, too)"},
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
        Parameter{"smallest_step_s", &TimeSettings::smallest_step_s, "s", non_negative,
                  "the run stops (exit 3) when stability asks for less; 0: for less than 1e-8 of the time between two frames, or of the "
                  "whole run if that is shorter"},
    };
  }
};

/// [surface] - how the area that touches air is measured.
struct SurfaceSettings {
  Form form = Form::standard;
  double keep_dx = 0;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"form", &SurfaceSettings::form, "", any_number,
                  "grid measure that converges (standard) or boundary particles as in Sec. 6.6 (published)"},
        Parameter{"keep_dx", &SurfaceSettings::keep_dx, "dx", Range{0, 1, false, false, "a number from 0 to 1"},
                  "the standard surface is measured anew once a particle may have moved that far since; 0: when anything moves"},
    };
  }
};

/// [oven] - the surroundings of every free surface.
struct Oven {
  Curve temperature_C{20};
  Curve heat_transfer_coefficient_W_per_m2K{0};
  Curve equilibrium_saturation{0};
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"temperature_C", &Oven::temperature_C, "C", above_absolute_zero, "theta_out: ambient temperature over time"},
        Parameter{"heat_transfer_coefficient_W_per_m2K", &Oven::heat_transfer_coefficient_W_per_m2K, "W/(m^2 K)", non_negative,
                  "beta: heat transfer coefficient of a free surface over time", Presence::optional, "exchange_W_per_m2K"},
        Parameter{"equilibrium_saturation", &Oven::equilibrium_saturation, "1", fraction,
                  "s_out: saturation that the air's humidity would keep at the surface, over time"},
    };
  }
};

}  // namespace bake
