#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: libgomp1 12.2.0-14+deb12u1, GCC's OpenMP library.
# Behaviour: memory that tasks with dependencies need is lost at the end of a parallel region if another thread than the first of the team
# makes them and does not wait for them itself (taskwait). It grows with every region until the program ends. Which thread that is `single`,
# the usual way, leaves to chance, so how much a program loses differs from run to run, and is more with more threads than cores.
# Expected: the same memory in use after every region. OpenMP 5.1 lets any thread of a team make tasks (2.19.11: dependencies hold between
# siblings), and the end of the region waits for all.
# Seen: after 2000 regions of two tasks each, the second after the first, nothing is left of those that the first thread made, and more than
# 50 kB of the other one's.
source "$(dirname "$0")/common.sh"
debian_packages libgomp1=12.2.0-14+deb12u1
cat >tasks.cpp <<'END'
#include <malloc.h>
#include <omp.h>

#include <cstdio>

// Bytes in use that 2000 regions have added, in which the thread `maker` makes the tasks.
long growth(int maker) {
  long before = 0;
  for (int region = 0; region < 2200; ++region) {
    if (region == 200) before = static_cast<long>(mallinfo2().uordblks);
    int value = 0, twice = 0;
#pragma omp parallel num_threads(2)
    if (omp_get_thread_num() == maker) {
#pragma omp task depend(out : value)
      value = 21;
#pragma omp task depend(in : value)
      twice = 2 * value;
    }
    if (twice != 42) std::puts("wrong");
  }
  return static_cast<long>(mallinfo2().uordblks) - before;
}

int main() {
  const long first = growth(0), other = growth(1);
  std::printf("first thread: %s, other thread: %s\n", first < 5000 ? "nothing" : "more", other > 50000 ? "more than 50 kB" : "less");
}
END
compile tasks.cpp -fopenmp
look_at ./program
conclude "first thread: nothing, other thread: more than 50 kB" \
  "tasks with dependencies lose memory if another thread than the first of a team makes them"
