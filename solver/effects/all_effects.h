// SPDX-License-Identifier: MIT
// Every effect that a scene can list. Who needs one or two of them includes those instead.
#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "solver/effects/common.h"
#include "solver/effects/listed_effects.h"  // made from the list below: includes each effect's header

namespace bake {

/// In the order in which they act within a step. Adding an effect adds a line.
using AllEffects = std::tuple<  //
    Motion,                     //
    Heat,                       //
    Water,                      //
    Elasticity,                 //
    Plasticity,                 //
    Leavening>;

/// Calls `visit.template operator()<Effect>()` for every effect in the order of AllEffects.
template <class Visit>
void for_each_effect(Visit visit) {
  [&]<class... Effect>(std::tuple<Effect...>*) { (visit.template operator()<Effect>(), ...); }(static_cast<AllEffects*>(nullptr));
}

/// Names of all effects, in the order of AllEffects.
inline std::vector<std::string> effect_names() {
  std::vector<std::string> names;
  for_each_effect([&]<class Effect>() { names.emplace_back(Effect::name); });
  return names;
}

}  // namespace bake
