// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "solver/effects/all_effects.h"
#include "solver/effects/flip_memory.h"
#include "solver/effects/free_surface.h"
#include "solver/effects/moving_water.h"
#include "solver/engine/model_list.h"
#include "solver/scene/scene.h"

namespace bake {

namespace {

static_assert(k_compositions == BAKE_MODELS, "solver/CMakeLists.txt must find all of Compositions");

template <class Effect, class... Effects>
constexpr bool in(Composition<Effects...>) {
  return (std::is_same_v<Effects, Effect> || ...);
}

static_assert(std::apply([](auto... c) { return ((in<MovingWater>(c) == (in<Motion>(c) && in<Water>(c))) && ...); }, Compositions{}),
              "water moves with its solid in just the compositions with motion and water");

/// Has the composition exactly the effects that the scene lists? What is no effect of its own follows from the scene.
template <class... Effects>
bool fits(Composition<Effects...> composition, const Scene& scene) {
  std::size_t found = 0;
  const auto one = [&](std::string_view name) {
    if (name == FreeSurface::name || name == MovingWater::name) return true;
    if (name == FlipMemory::name) return scene.of<Motion>().transfer == Motion::Transfer::flip;
    ++found;
    return scene.lists(name);
  };
  const bool flip = scene.lists(Motion::name) && scene.of<Motion>().transfer == Motion::Transfer::flip;
  return (one(Effects::name) && ...) && found == scene.effects.size() && flip == in<FlipMemory>(composition);
}

template <class Real, int... I>
std::unique_ptr<Physics<Real>> find(const Scene& scene, std::integer_sequence<int, I...>) {
  std::unique_ptr<Physics<Real>> made;
  (void)((fits(std::tuple_element_t<I, Compositions>{}, scene) && (made = make_composition<Real, I>(scene), true)) || ...);
  return made;
}

template <class... Effects>
std::string words(Composition<Effects...>) {
  std::string text;
  const auto one = [&](std::string_view name) {
    if (name == FreeSurface::name || name == MovingWater::name) return;
    text += (text.empty() ? "" : "+") + std::string(name == FlipMemory::name ? "flip" : name);
  };
  (one(Effects::name), ...);
  return text;
}

}  // namespace

template <class Real>
std::unique_ptr<Physics<Real>> make_physics(const Scene& scene) {
  auto made = find<Real>(scene, std::make_integer_sequence<int, k_compositions>{});
  if (made) return made;
  std::string listed, known;
  for (const std::string& name : scene.effects) listed += (listed.empty() ? "" : "+") + name;
  std::apply([&](auto... c) { ((known += (known.empty() ? "" : ", ") + words(c)), ...); }, Compositions{});
  const bool flip = scene.lists(Motion::name) && scene.of<Motion>().transfer == Motion::Transfer::flip;
  throw InputError(scene.file.string() + ": effects: found " + (listed.empty() ? "none" : listed) +
                   (flip ? " with transfer = \"flip\"" : "") + ", allowed: " + known);
}

template std::unique_ptr<Physics<float>> make_physics(const Scene&);
template std::unique_ptr<Physics<double>> make_physics(const Scene&);

}  // namespace bake
