// SPDX-License-Identifier: MIT
// A toy: a crust browns by a first-order reaction that takes heat. An example of an effect with a stored field, a step limit and a booked
// quantity; tests/toy_effect/toy_effect.sh adds it to a copy of the tree.
#pragma once

#include "solver/effects/heat.h"

namespace bake {

namespace field {
BAKE_FIELD(brown, Brownness, 1, "brownness", "1", "B_p: share of the dough that has browned");
}  // namespace field

namespace booked {
BAKE_FIELD(browning_heat, BrowningHeat, 1, "browning_heat", "J", "heat taken by browning");
}  // namespace booked

namespace bound {
BAKE_FIELD(browning_rate, BrowningRate, 1, "browning_rate", "1/s", "fastest browning");
}  // namespace bound

struct Browning : Effect {
  static constexpr const char* name = "browning";
  static constexpr const char* meaning = "the dough browns where it is hot, which takes heat";
  static constexpr std::array needs{"heat"};

  struct Material {
    double browning_per_s = 0;
    double browning_heat_J_per_kg = 0;
    static constexpr auto parameters() {
      return std::tuple{
          Parameter{"browning_per_s", &Material::browning_per_s, "1/s", non_negative, "rate at 100 C and above, none at 0 C",
                    Presence::required},
          Parameter{"browning_heat_J_per_kg", &Material::browning_heat_J_per_kg, "J/kg", non_negative, "heat taken by all that can brown"},
      };
    }
  };

  using Stored = FieldList<field::Brownness>;
  using Booked = FieldList<booked::BrowningHeat>;
  using Bounds = FieldList<bound::BrowningRate>;

  template <class Real>
  struct Constants {
    Real rate, heat, capacity;
    Constants(const auto& scene, const auto& material) {
      const auto& own = material.effects.template get<Material>();
      rate = static_cast<Real>(own.browning_per_s);
      heat = static_cast<Real>(own.browning_heat_J_per_kg);
      capacity = Heat::Constants<Real>(scene, material).solid;
    }
  };

  static void fill(auto& p, int lane, const auto&) { p[field::brown][lane] = 0; }

  BAKE_INLINE static auto rate(auto& p, const auto& k) {
    return k.rate * clamp(p[field::theta] * 0.01f, 0 * p[field::theta], 0 * p[field::theta] + 1);
  }

  BAKE_INLINE static void gather(auto& p, const auto&, const auto& k, const auto& step, auto& books) {
    const auto browned = step.baking_dt * rate(p, k) * (1 - p[field::brown]);
    p[field::brown] += browned;
    p[field::theta] -= (k.heat / k.capacity) * browned;
    books.book(booked::browning_heat, k.heat * p[field::m_s] * browned);
  }

  BAKE_INLINE static void bounds(auto& p, const auto& k, const auto&, auto& books) { books.bound(bound::browning_rate, rate(p, k)); }

  static void largest_step(const auto& most, const StepScale& at, const auto&, StepLimit& limit) {
    if (most(bound::browning_rate) > 0) limit.at_most(at.safety / most(bound::browning_rate), "browning");
  }

  static void show(auto& frame) { frame.stored(field::brown); }
};

}  // namespace bake
