// SPDX-License-Identifier: MIT
// What parts of a scene need of its effects.
#pragma once

#include <string>

#include "solver/effects/heat.h"
#include "solver/effects/motion.h"

namespace bake {

/// What a scene lacks that has an emitter, in one clause; "" if nothing.
std::string what_emitter_needs(const auto& scene) {
  return scene.lists(Motion::name) ? "" : "found an emitter without the effect 'motion', allowed: with it";
}

/// Whether bodies and emitters may have a temperature of their own, other than their material's.
bool tells_temperatures_apart(const auto& scene) { return scene.lists(Heat::name); }

}  // namespace bake
