// SPDX-License-Identifier: MIT
// The combinations of effects that are compiled, each for single and double precision. A scene gets the one that has just the
// effects it lists. To add one, add a line; each line becomes a file of its own in the build (solver/CMakeLists.txt), which includes the
// effects that the line names and no others.
#pragma once

#include <memory>
#include <tuple>

#include "solver/effects/declared_effects.h"  // made from the list below
#include "solver/engine/physics.h"

namespace bake {

template <class... Effects>
struct Composition {};

using Compositions = std::tuple<
    // nothing moves
    Composition<FreeSurface, Heat>,         //
    Composition<FreeSurface, Water>,        //
    Composition<FreeSurface, Heat, Water>,  //
    // elastic
    Composition<Motion, Elasticity>,                                         //
    Composition<Motion, FreeSurface, Heat, Elasticity>,                      //
    Composition<Motion, FreeSurface, Water, MovingWater, Elasticity>,        //
    Composition<Motion, FreeSurface, Heat, Water, MovingWater, Elasticity>,  //
    // dough
    Composition<Motion, Elasticity, Plasticity>,                                                    //
    Composition<Motion, FreeSurface, Heat, Elasticity, Plasticity>,                                 //
    Composition<Motion, FreeSurface, Water, MovingWater, Elasticity, Plasticity>,                   //
    Composition<Motion, FreeSurface, Heat, Water, MovingWater, Elasticity, Plasticity>,             //
    Composition<Motion, FreeSurface, Heat, Elasticity, Plasticity, Leavening>,                      //
    Composition<Motion, FreeSurface, Heat, Water, MovingWater, Elasticity, Plasticity, Leavening>,  //
    // set dough that breaks
    Composition<Motion, Elasticity, Plasticity, Brittleness>,                     //
    Composition<Motion, FreeSurface, Heat, Elasticity, Plasticity, Brittleness>,  //
    // with vapour in the pores
    Composition<FreeSurface, Vapour, Heat, Water>,                                                          //
    Composition<Motion, FreeSurface, Vapour, Heat, Water, MovingWater, Elasticity, Plasticity, Leavening>,  //
    // with FLIP, for studies of transfers
    Composition<Motion, FlipMemory, Elasticity>,              //
    Composition<Motion, FlipMemory, Elasticity, Plasticity>,  //
    Composition<Motion, FlipMemory, FreeSurface, Heat, Water, MovingWater, Elasticity, Plasticity, Leavening>>;
inline constexpr int k_compositions = std::tuple_size_v<Compositions>;

/// What the vertices of a skin have, beside what the composition of the flesh has.
using CompositionOfSkin = Composition<Motion>;

/// Makes composition number `index`; each is compiled in a file of its own.
template <class Real, int index>
std::unique_ptr<Physics<Real>> make_composition(const Scene& scene);

}  // namespace bake
