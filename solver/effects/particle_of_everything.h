// SPDX-License-Identifier: MIT
// W particles that have every field there is, outside any model: to call an effect's functions one by one.
#pragma once

#include <map>
#include <string_view>

#include "solver/core/lanes.h"
#include "solver/effects/fields.h"

namespace bake {

template <class Scalar>
struct ParticleOfEverything {
  using Real = Scalar;
  using V = Lanes<Real>;
  using Fields =
      FieldList<field::Position, field::InitialVolume, field::SolidMass, field::Velocity, field::AffineVelocity, field::VolumeRatio,
                field::VolumeRatioBefore, field::KirchhoffStress, field::ElasticStrain, field::HenckyStrain, field::PlasticVolumeRatio,
                field::PlasticDilation, field::Temperature, field::PeakTemperature, field::ThermalStrain, field::LentTemperature,
                field::WaterMass, field::LentWater, field::ProducedGas, field::Leavener>;
  template <class F>
  static constexpr bool has = true;
  template <class F>
  static constexpr bool stores = true;

  V numbers[Fields::width] = {};
  V stiffness{}, shear_stiffness{};

  template <class F>
  auto& operator[](F) {
    V* at = numbers + Fields::template offset<F>;
    if constexpr (F::width == 1)
      return *at;
    else
      return *reinterpret_cast<V(*)[F::width]>(at);
  }
  V mass() { return (*this)[field::m_s] + (*this)[field::m_w]; }
  V own_mass() { return mass() - (*this)[field::m_w_lent]; }
  V volume() { return (*this)[field::V_0] * (*this)[field::J]; }
  V volume_before() { return (*this)[field::V_0] * (*this)[field::J_before]; }
  V temperature() { return (*this)[field::theta]; }
  V peak_temperature() { return (*this)[field::theta_peak]; }
};

/// Takes down what effects book for it.
template <class Scalar>
struct BooksOfEverything {
  using V = Lanes<Scalar>;
  std::map<std::string_view, V> booked;  ///< by symbol

  template <class Q>
  void book(Q, V amount) {
    booked[Q::symbol] += amount;
  }
  template <class Q>
  V operator()(Q) const {
    const auto found = booked.find(Q::symbol);
    return found == booked.end() ? V{} : found->second;
  }
};

}  // namespace bake
