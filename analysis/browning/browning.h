// SPDX-License-Identifier: MIT
// Computes how brown each particle has become, from its history of temperature and water over the frames of a run.
//
// A crust browns by reactions that need heat and dryness (Maillard, then caramel). As first-order kinetics of lightness [after Purlis
// and Salvadori 2009, doi:10.1016/j.foodres.2009.03.007, who fit such a law to bread], with a rate that grows tenfold every so many
// kelvin and in proportion to the water that is gone:
//
//     dB/dt = 1/t_ref 10^((theta - theta_ref) / theta_10) min(1, w / w_ref),    degree = 1 - exp(-B)
//
// where w is the share of its water that the particle has lost since the first frame (the factor is 1 if the run has no water, or
// w_ref is 0).
// The solver does not compute this. It serves the look of pictures and is no claim: scenes compress time and oven, so each view chooses
// t_ref and theta_ref.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "solver/core/parameter.h"

namespace bake {

/// [browning] of a view.
struct BrowningLaw {
  double reference_temperature_C = 150;
  double reference_time_s = 600;
  double tenfold_K = 40;
  double reference_dryness = 0.5;
  static constexpr auto parameters() {
    return std::tuple{
        Parameter{"reference_temperature_C", &BrowningLaw::reference_temperature_C, "C", above_absolute_zero,
                  "theta_ref: at this temperature a dry crust ..."},
        Parameter{"reference_time_s", &BrowningLaw::reference_time_s, "s", positive,
                  "t_ref: ... browns to a degree of 1 - 1/e in this time"},
        Parameter{"tenfold_K", &BrowningLaw::tenfold_K, "K", positive, "theta_10: rise of temperature that makes it ten times as fast"},
        Parameter{"reference_dryness", &BrowningLaw::reference_dryness, "1", fraction,
                  "w_ref: share of its water that must have left for the full rate; 0: heat alone colours, as it sets a chocolate cake"},
    };
  }
};

/// dB/dt [1/s] at a temperature [C] and share of water lost (below 0 counts as 0).
double browning_rate(const BrowningLaw& law, double temperature_C, double dryness);

/// Degree of browning from 0 (raw) to below 1 for B of at least 0.
double browning_degree(double integral);

/// Integrates the browning of the particles of a run from its first frame on.
class BrowningHistory {
 public:
  /// Throws InputError if the folder holds no frames.
  BrowningHistory(std::filesystem::path results, const BrowningLaw& law);

  /// Integrates up to `frame` by the trapezium rule over every frame or, if there are more than k_most_samples, over that many of them.
  /// `frame` must not decrease from call to call. Throws InputError if the run has not come that far or its frames have no temperature.
  void advance_to(int frame);

  /// The degree of browning of each particle. Particles that appear first in the last frame, and unknown ones, are raw.
  std::vector<double> degrees(std::span<const std::int64_t> ids) const;
  /// The position of each particle when it first appeared, x, y, z [m].
  std::vector<double> first_positions(std::span<const std::int64_t> ids) const;

  static constexpr int k_most_samples = 96;

 private:
  void take(int frame);

  struct Particle {
    double integral = 0;  ///< B
    double rate = 0;      ///< at the last frame taken
    double first_water_kg = 0;
    std::array<float, 3> first_position = {0, 0, 0};
    bool seen = false;
  };
  std::filesystem::path results_;
  BrowningLaw law_;
  int last_frame_ = 0;
  int taken_ = -1;  ///< last frame taken
  double time_s_ = 0;
  std::vector<Particle> particles_;  ///< by id
};

/// Number of the frame of a run that shows `time_s`. Throws InputError if the folder holds no run or none of its frames is of that time.
int frame_at(const std::filesystem::path& results, double time_s);

}  // namespace bake
