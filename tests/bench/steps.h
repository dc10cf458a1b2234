// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/machines/limits.h"

namespace bake::bench {

/// Whole steps, everything included: named Step/<scene>/<precision>/<size>/threads:<n>.
void register_steps(const Limits& limits);
/// Gather, scatter, law and grid update of a step: named Part/<which>/<precision>/500K/threads:<n>.
void register_passes(const Limits& limits);
/// Ordering and pieces of the law.
void register_parts(const Limits& limits);

}  // namespace bake::bench
