// SPDX-License-Identifier: MIT
#include "solver/program/waiting.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "solver/io/processors.h"

namespace bake {

void let_waiting_threads_sleep(char** words) {
  // Some thirty microseconds: as long as another thread takes to finish the work that was handed out last, and no longer than falling
  // asleep and waking up take.
  constexpr const char* k_spins = "3000";
  if (std::getenv("GOMP_SPINCOUNT") || std::getenv("OMP_WAIT_POLICY")) return;
  std::error_code unknown;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown);
  if (unknown || ::setenv("GOMP_SPINCOUNT", k_spins, 1) != 0) return;
  const Unbound unbound;
  ::execv(program.c_str(), words);
}

}  // namespace bake
