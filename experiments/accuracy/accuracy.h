// SPDX-License-Identifier: MIT
// The study of accuracy: what an error costs, for every setting that can be chosen.
#pragma once

#include "experiments/common/study.h"

namespace bake::studies {

/// Measures what is not yet in <out>/accuracy/*.jsonl, with a line of progress for each; then writes accuracy.json, accuracy.md and the
/// charts of all that is there. Holds if every repeat found the same error and errors fall with dx. With `measure_only` the page is left
/// to a later call, and nothing is judged: such calls may run side by side, each with its own cases.
bool run_accuracy(const StudyOptions& options);

}  // namespace bake::studies
