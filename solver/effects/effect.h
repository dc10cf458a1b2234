// SPDX-License-Identifier: MIT
// The defaults of every effect, and how its hooks are called.
//
// An effect is a struct that derives from `Effect`. It declares its numbers in lists and its equations in hooks: static functions with
// the following names. A hook that an effect does not have is not called.
//
//   in a step, on lanes of W particles or nodes
//     fill(p, lane, start)                its stored fields of a new particle; `start`: volume, temperature, saturation, leavener, material
//     gather(p, from, k, step, report)    G2P: from the nodes to the particle, whose state advances to t + dt
//     stress(p, k)                        its part of the mixture's Kirchhoff stress, and its stiffness
//     scatter(p, to, k, step, report)     P2G: what the particle gives to the nodes
//     bounds(p, k, step, report)          what bounds the next step: maxima, named in `Bounds`
//     update(node, k, step, budget)       the update of a node (in reverse order: water, then heat, then motion)
//     totals(p, k, step, report)          sums and extremes for the ledger, when it asks for them
//     conductance(p, k)                   kappa V, for backward Euler
//   once
//     largest_step(most, at, scene, limit)   the step that each of `Bounds` allows, and the reason
//     describe(model, scene)              what the engine does for the effect (solver/engine/physics.h)
//     show(frame)                         what a frame shows of its particles
//     ledger(columns)                     columns of the ledger that are computed from others
//   of a scene
//     check_settings(settings, complaint)                 refuses settings that make no sense together
//     check_material(scene, material, own, complaint)     the same for a material
//     check_face(scene, face, complaint)                  the same for a face of the domain
//     idle(scene)                         why the effect can change nothing here although it is listed; "" if it can
//     coefficient(own)                    the key of a coefficient that is given, whether the effect is listed or not; "" if none is
//     swells(own)                         whether the material can change its volume by this effect
//
// `p` is W particles: p[field::theta] is a pack of lanes, or an array of them. `k` is the effect's own `Constants` of a material (in
// `update` its `NodeConstants`). An effect reads others' fields (`if constexpr (P::template has<field::Temperature>)`) and never calls
// them.
#pragma once

#include <array>
#include <tuple>

#include "solver/core/lanes.h"
#include "solver/effects/fields.h"

namespace bake {

struct Effect {
  struct Settings {
    static constexpr auto parameters() { return std::tuple{}; }
  };
  struct Material {
    static constexpr auto parameters() { return std::tuple{}; }
  };
  static constexpr std::array<const char*, 0> needs{};  ///< effects without which it cannot be

  using Stored = FieldList<>;     ///< particle fields that last from step to step
  using Transient = FieldList<>;  ///< particle fields between gather and scatter only
  using Moments = FieldList<>;    ///< channels that are scattered with a first moment
  using Values = FieldList<>;     ///< channels that are scattered without
  using Gathered = FieldList<>;   ///< channels that the grid update hands back
  using Booked = FieldList<>;     ///< exchanges, booked when they happen
  using Totals = FieldList<>;     ///< state that is summed over the particles
  using Highest = FieldList<>;    ///< maxima over the particles, taken with the totals
  using Bounds = FieldList<>;     ///< maxima over the particles that bound the step

  template <class Real>
  struct Constants {
    template <class Scene, class SceneMaterial>
    Constants(const Scene&, const SceneMaterial&) {}
  };
  template <class Real>
  struct NodeConstants {
    template <class Scene>
    explicit NodeConstants(const Scene&) {}
  };
};

/// A part of others that no scene lists: it is there when its `is_implied(scene)` says so. `k_told`: the words that tell users of it; empty
/// if it follows from the effects alone.
template <class E>
concept Implied = requires {
  E::k_told;
};

// has_hook::<name><E>: does E have a member of that name, of whatever signature? Two bases with the same name make it ambiguous.
#define BAKE_HOOK(hook)                     \
  namespace has_hook {                      \
  struct Named_##hook {                     \
    int hook;                               \
  };                                        \
  template <class E>                        \
  struct Twice_##hook : E, Named_##hook {}; \
  template <class E>                        \
  inline constexpr bool hook = !requires {  \
    &Twice_##hook<E>::hook;                 \
  };                                        \
  }

BAKE_HOOK(fill)
BAKE_HOOK(gather)
BAKE_HOOK(stress)
BAKE_HOOK(scatter)
BAKE_HOOK(bounds)
BAKE_HOOK(update)
BAKE_HOOK(totals)
BAKE_HOOK(conductance)
BAKE_HOOK(largest_step)
BAKE_HOOK(describe)
BAKE_HOOK(show)
BAKE_HOOK(ledger)
BAKE_HOOK(check_settings)
BAKE_HOOK(check_material)
BAKE_HOOK(check_face)
BAKE_HOOK(idle)
BAKE_HOOK(coefficient)
BAKE_HOOK(swells)
#undef BAKE_HOOK

/// Calls a hook of effect E if it has one. A hook of the right name that cannot be called like this does not compile.
#define BAKE_CALL(E, hook, ...)                                                                                    \
  do {                                                                                                             \
    if constexpr (has_hook::hook<E>) {                                                                             \
      static_assert(                                                                                               \
          requires { E::hook(__VA_ARGS__); }, "the hook '" #hook "' has a wrong signature: see effects/effect.h"); \
      E::hook(__VA_ARGS__);                                                                                        \
    }                                                                                                              \
  } while (false)

}  // namespace bake
