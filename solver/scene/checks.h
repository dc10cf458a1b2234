// SPDX-License-Identifier: MIT
// Checks conditions between several values of a scene. Each single value has been checked when it was read.
#pragma once

#include "solver/effects/leavening.h"
#include "solver/scene/entry.h"
#include "solver/scene/scene.h"

namespace bake {

// Each throws an InputError at the table `entry` that `value` was read from. `scene` holds what was read
// before: effects and tables, then materials, then the other lists.
void check(const SceneEntry& entry, const DomainSettings& value, const Scene& scene);
void check(const SceneEntry& entry, const TimeSettings& value, const Scene& scene);
void check(const SceneEntry& entry, const Leavening::Settings& value, const Scene& scene);
void check(const SceneEntry& entry, const Material& value, const Scene& scene);
void check(const SceneEntry& entry, const Body& value, const Scene& scene);
void check(const SceneEntry& entry, const Collider& value, const Scene& scene);
void check(const SceneEntry& entry, const Grip& value, const Scene& scene);
void check(const SceneEntry& entry, const Emitter& value, const Scene& scene);

/// All other tables need no check.
template <class T>
void check(const SceneEntry&, const T&, const Scene&) {}

}  // namespace bake
