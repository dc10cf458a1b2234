// SPDX-License-Identifier: MIT
#include <utility>

#include "solver/effects/composed_effects.h"
#include "solver/engine/model_list.h"
#include "solver/scene/scene.h"

namespace bake {

namespace {

static_assert(k_compositions == BAKE_MODELS, "solver/CMakeLists.txt must find all of Compositions");

template <class E, class... Effects>
constexpr bool in(Composition<Effects...>) {
  return (std::is_same_v<Effects, E> || ...);
}

/// Is every part that the scene implies in the composition, and no other?
template <class... Effects>
bool implied_parts_fit(Composition<Effects...> composition, const Scene& scene) {
  const auto fits = [&]<class E>(E*) {
    if constexpr (Implied<E>) return E::is_implied(scene) == in<E>(composition);
    return true;
  };
  return [&]<class... E>(std::tuple<E...>*) { return (fits(static_cast<E*>(nullptr)) && ...); }(static_cast<ComposedEffects*>(nullptr));
}

/// Has the composition exactly the effects that the scene lists?
template <class... Effects>
bool fits(Composition<Effects...> composition, const Scene& scene) {
  const std::size_t listed = (0 + ... + (Implied<Effects> ? 0 : 1));
  return listed == scene.effects.size() && ((Implied<Effects> || scene.lists(Effects::name)) && ...) &&
         implied_parts_fit(composition, scene);
}

template <class Real, int... I>
std::unique_ptr<Physics<Real>> find(const Scene& scene, std::integer_sequence<int, I...>) {
  std::unique_ptr<Physics<Real>> made;
  (void)((fits(std::tuple_element_t<I, Compositions>{}, scene) && (made = make_composition<Real, I>(scene), true)) || ...);
  return made;
}

/// "motion+elasticity", with "+flip" where a setting makes a combination of its own.
template <class... Effects>
std::string words(Composition<Effects...>) {
  std::string text;
  const auto one = [&]<class E>(E*) {
    if constexpr (Implied<E>)
      if (std::string_view(E::k_told).empty()) return;
    text += (text.empty() ? "" : "+") + std::string(E::name);
  };
  (one(static_cast<Effects*>(nullptr)), ...);
  return text;
}

}  // namespace

template <class Real>
std::unique_ptr<Physics<Real>> make_physics(const Scene& scene) {
  auto made = find<Real>(scene, std::make_integer_sequence<int, k_compositions>{});
  if (made) return made;
  std::string listed, known, told;
  for (const std::string& name : scene.effects) listed += (listed.empty() ? "" : "+") + name;
  const auto tell = [&]<class E>(E*) {
    if constexpr (Implied<E>)
      if (E::is_implied(scene)) told += E::k_told;
  };
  [&]<class... E>(std::tuple<E...>*) { (tell(static_cast<E*>(nullptr)), ...); }(static_cast<ComposedEffects*>(nullptr));
  std::apply([&](auto... c) { ((known += (known.empty() ? "" : ", ") + words(c)), ...); }, Compositions{});
  throw InputError(scene.at("effects") + ": found " + (listed.empty() ? "none" : listed) + told + ", allowed: " + known);
}

template std::unique_ptr<Physics<float>> make_physics(const Scene&);
template std::unique_ptr<Physics<double>> make_physics(const Scene&);

}  // namespace bake
