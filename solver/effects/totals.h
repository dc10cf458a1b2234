// SPDX-License-Identifier: MIT
// What is booked and summed: the ledger's raw entries.
#pragma once

#include <array>

#include "solver/core/lanes.h"

namespace bake {

/// Exchanges that are booked when they happen, summed over a step.
enum class Entry {
  evaporated,     ///< water that left through surfaces [kg]
  water_limited,  ///< water that a node would have owed; zero while diffusion is stable [kg]
  exchanged,      ///< heat that came in through surfaces, colliders and grips [J]
  latent,         ///< heat taken by evaporation [J]
  vapour_heat,    ///< heat content of the water that evaporated [J]
  expansion,      ///< heat taken by thermal expansion [J]
  dissipated,     ///< plastic work [J]
  impulse_x,      ///< momentum given by gravity, colliders, grips and faces, less what vapour takes [kg m/s]
  impulse_y,
  impulse_z,
  twist_x,  ///< angular momentum given by them, about the origin [kg m^2/s]
  twist_y,
  twist_z,
  remapped_heat,  ///< what the water's move between particles added beyond what its move between nodes did [J]
  remapped_x,     ///< the same of the momentum [kg m/s]
  remapped_y,
  remapped_z,
  area,          ///< surface that touches air [m^2]
  contact_area,  ///< surface that touches heated colliders [m^2]
  count
};
inline constexpr int k_entries = static_cast<int>(Entry::count);
using Budget = std::array<double, k_entries>;

inline void add_to(Budget& sum, const Budget& part) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += part[i];
}

template <class V>
BAKE_INLINE void book(Budget& booked, Entry entry, V amount) {
  booked[static_cast<int>(entry)] += sum_lanes(amount);
}

/// State that is summed over the particles when asked for.
enum class Total {
  solid_mass,  ///< [kg]
  water_mass,  ///< [kg]
  momentum_x,  ///< sum of m v + V q, the flux being that of the step before [kg m/s]
  momentum_y,
  momentum_z,
  angular_x,  ///< about the origin, with the affine part [kg m^2/s]
  angular_y,
  angular_z,
  kinetic,       ///< [J]
  elastic,       ///< [J]
  heat_content,  ///< sum of c theta, from 0 C [J]
  gas,           ///< produced CO2 [mol]
  volume,        ///< [m^3]
  temperature,   ///< sum of V theta [m^3 C]
  count
};
inline constexpr int k_totals = static_cast<int>(Total::count);
using Totals = std::array<double, k_totals>;

}  // namespace bake
