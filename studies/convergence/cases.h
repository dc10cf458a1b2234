// SPDX-License-Identifier: MIT
// The cases by name; each stands in a file of its own with its exact solution and what is expected of the solver.
#pragma once

#include "studies/convergence/errors.h"

namespace bake::studies {

std::vector<Errors> slab_cosine(bool quick);
std::vector<Errors> slab_halves(bool quick);
std::vector<Errors> slab_held(bool quick);
std::vector<Errors> slab_held_and_insulated(bool quick);

}  // namespace bake::studies
