// SPDX-License-Identifier: MIT
#include "solver/io/processors.h"

#include <omp.h>

#include <vector>

namespace bake {
namespace {

cpu_set_t present_affinity() {
  cpu_set_t set;
  CPU_ZERO(&set);
  ::sched_getaffinity(0, sizeof set, &set);
  return set;
}

/// OpenMP's places, if it binds threads to them, are what was allowed before it did.
cpu_set_t all_allowed() {
  cpu_set_t all;
  CPU_ZERO(&all);
  for (int place = 0; place < omp_get_num_places(); ++place) {
    std::vector<int> processors(static_cast<std::size_t>(omp_get_place_num_procs(place)));
    omp_get_place_proc_ids(place, processors.data());
    for (const int processor : processors)
      if (processor < CPU_SETSIZE) CPU_SET(static_cast<std::size_t>(processor), &all);
  }
  return CPU_COUNT(&all) > 0 ? all : present_affinity();
}

}  // namespace

Unbound::Unbound() : before_(present_affinity()) {
  const cpu_set_t all = all_allowed();
  ::sched_setaffinity(0, sizeof all, &all);
}

Unbound::~Unbound() { ::sched_setaffinity(0, sizeof before_, &before_); }

}  // namespace bake
