// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>

namespace bake {

/// The origin of a result, as stored beside it:
/// program: version, commit, dirty (null if unknown), solver (hash of the sources that decide a run's numbers), compiler, flags,
/// build_type; libraries: hdf5, eigen, fmt;
/// machine: cpu, logical_cores, memory_bytes, os; date (UTC, ISO 8601). The name of the machine is left out on purpose.
/// `commit` is "unknown" for sources without git; `dirty` speaks of the program's own sources only.
nlohmann::json provenance();

/// Memory of this machine [bytes].
std::int64_t memory_bytes();

}  // namespace bake
