// SPDX-License-Identifier: MIT
// Which processors this process may use.
#pragma once

#include <sched.h>

namespace bake {

/// How many this process was allowed when it began: those of its affinity, also where OpenMP has bound this thread to one of them.
int allowed_processors();

/// Lets this thread, and what it starts meanwhile, run on all of them. OMP_PROC_BIND binds the thread that a program begins with to one
/// processor, and a program that is started from it would see no other.
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
