// SPDX-License-Identifier: MIT
// The steps whose instructions are counted.
#pragma once

namespace bake::count {

/// One thread takes the same few steps of a small loaf (analysis/machines/scenes.h), combination by combination, in single precision; under
/// callgrind with --instr-atstart=no the last step of each is counted, and its counts are written with the combination's name.
void take_counted_steps();

}  // namespace bake::count
