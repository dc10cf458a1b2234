// SPDX-License-Identifier: MIT
// Which processors this process may use.
#pragma once

#include <sched.h>

namespace bake {

/// Lets this thread, and what it starts meanwhile, run on all that this process was allowed when it began (omp_get_num_procs tells how
/// many). OMP_PROC_BIND binds the thread that a program begins with to one processor, and a program that is started from it would see no
/// other.
class Unbound {
 public:
  Unbound();
  ~Unbound();
  Unbound(const Unbound&) = delete;
  Unbound& operator=(const Unbound&) = delete;

 private:
  cpu_set_t before_;
};

}  // namespace bake
