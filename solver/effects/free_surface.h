// SPDX-License-Identifier: MIT
// The volume at the nodes, from which the free surface is measured (solver/engine/surface.h). Part of every model with heat
// or water.
#pragma once

#include "solver/core/lanes.h"
#include "solver/effects/fields.h"

namespace bake {

struct FreeSurface {
  static constexpr const char* name = "free surface";
  using Stored = FieldList<>;
  using Transient = FieldList<>;
  using Moments = FieldList<>;
  using Values = FieldList<channel::Volume>;
  using Gathered = FieldList<>;

  template <class Real>
  struct Constants {
    template <class Scene, class SceneMaterial>
    Constants(const Scene&, const SceneMaterial&) {}
  };

  /// V_i = sum w V   [Ding19 Eq. 18]
  template <class P, class To, class K, class S, class R>
  BAKE_INLINE static void scatter(P& p, To& to, const K&, const S&, R&) {
    to.value(channel::volume) += p.volume();
  }
};

}  // namespace bake
