// SPDX-License-Identifier: MIT
// W particles that have every field there is, outside any model: to try an effect's functions one by one.
#pragma once

#include "solver/particles/fields.h"
#include "solver/scene/reader.h"

namespace bake {

template <class Scalar>
struct ParticleOfEverything {
  using Real = Scalar;
  using V = Lanes<Real>;
  using Fields = FieldList<field::Position, field::InitialVolume, field::SolidMass, field::Velocity, field::AffineVelocity,
                           field::VolumeRatio, field::KirchhoffStress, field::ElasticStrain, field::HenckyStrain, field::PlasticVolumeRatio,
                           field::Temperature, field::PeakTemperature, field::WaterMass, field::ProducedGas, field::Leavener>;
  template <class F>
  static constexpr bool has = true;

  V numbers[Fields::width] = {};
  V stiffness{};

  template <class F>
  auto& operator[](F) {
    V* at = numbers + Fields::template offset<F>;
    if constexpr (F::width == 1)
      return *at;
    else
      return *reinterpret_cast<V(*)[F::width]>(at);
  }
  V mass() { return (*this)[field::m_s] + (*this)[field::m_w]; }
  V volume() { return (*this)[field::V_0] * (*this)[field::J]; }
  V temperature() { return (*this)[field::theta]; }
  V peak_temperature() { return (*this)[field::theta_peak]; }
};

/// One material in a box, with every effect; `material` and `tables` are added to it.
inline Scene scene_of_everything(const std::string& material, const std::string& tables = "") {
  return parse_scene(R"(
effects = ["motion", "heat", "water", "elasticity", "plasticity", "leavening"]
[run]
end_s = 1
[grid]
dx_m = 0.1
[domain]
min_m = [0, 0, 0]
max_m = [1, 1, 1]
)" + tables + R"(
[[material]]
name = "dough"
density_kg_per_m3 = 500
young_modulus_Pa = 2e3
specific_heat_J_per_kgK = 20
conductivity_W_per_mK = 100
)" + material,
                     "everything.toml", {});
}

}  // namespace bake
