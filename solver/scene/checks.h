// SPDX-License-Identifier: MIT
// Checks conditions between several values of a scene. Each single value has been checked when it was read.
#pragma once

#include <fmt/format.h>

#include "solver/scene/entry.h"
#include "solver/scene/scene.h"

namespace bake {

// Each throws an InputError at the table `entry` that `value` was read from. `scene` holds what was read
// before: effects and tables, then materials, then the other lists.
void check(const SceneEntry& entry, const DomainSettings& value, const Scene& scene);
void check(const SceneEntry& entry, const TimeSettings& value, const Scene& scene);
void check(const SceneEntry& entry, const Material& value, const Scene& scene);
void check(const SceneEntry& entry, const Body& value, const Scene& scene);
void check(const SceneEntry& entry, const Collider& value, const Scene& scene);
void check(const SceneEntry& entry, const Grip& value, const Scene& scene);
void check(const SceneEntry& entry, const DomainFace& value, const Scene& scene);
void check(const SceneEntry& entry, const Emitter& value, const Scene& scene);
void check(const SceneEntry& entry, const Skin& value, const Scene& scene);

/// How an effect's own checks (solver/effects/effect.h) refuse what a table says.
class Complaint {
 public:
  explicit Complaint(const SceneEntry& table) : table_(table) {}
  /// Refuses the value of `key`, or the table where it is not given.
  template <class... Values>
  [[noreturn]] void at(std::string_view key, fmt::format_string<const Values&...> problem, const Values&... values) const {
    table_.find(key).value_or(table_).complain(fmt::format(problem, values...));
  }
  /// Refuses the first of the numbers of `key` that is not above the one before it.
  void unless_rising(std::string_view key, const std::vector<double>& numbers) const;

 private:
  const SceneEntry& table_;
};

/// All other tables: nothing to check.
template <class T>
void check(const SceneEntry&, const T&, const Scene&) {}

}  // namespace bake
