#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# libgomp, GCC's OpenMP library: memory that tasks with dependencies leave behind.
#
# In a parallel region one thread makes two tasks, the second of which depends on the first. OpenMP 5.1 (2.19.11, depend clause) lets any
# thread of the team do so, and `#pragma omp single`, the usual way, leaves it to chance which. If it is the first thread of the team, the
# memory in use is the same after every region. If it is another one, the table of the dependencies that its implicit task has made is lost
# at the end of the region, unless that thread itself waits for its tasks (`taskwait`) before: memory grows with every region, until the
# program ends. So whether a program with `single` leaks, and how much, differs from run to run, and is more with more threads than cores.
#
# Seen with GCC 12.2.0 of Debian 12 on x86-64: after 2000 regions nothing is left of those of the first thread, and more than 50 kB of the
# other one's.
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

version=$(g++ -dumpfullversion 2>/dev/null) || cannot_try "there is no g++"
[[ $version == 12.2.0 ]] || cannot_try "this is g++ $version, not 12.2.0"

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
g++ -std=c++17 -O1 -fopenmp tasks.cpp -o tasks 2>compile.log || cannot_try "tasks.cpp does not compile"
look_at ./tasks
conclude "first thread: nothing, other thread: more than 50 kB" \
  "tasks with dependencies lose memory if another thread than the first of a team makes them"
