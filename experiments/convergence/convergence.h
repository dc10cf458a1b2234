// SPDX-License-Identifier: MIT
// The study of convergence: every case at its resolutions, in one table.
#pragma once

#include "experiments/common/study.h"

namespace bake::studies {

/// Measures all cases, with a line of progress for each on standard error; prints the table; writes orders.json and orders.md.
bool run_convergence(const StudyOptions& options);

}  // namespace bake::studies
