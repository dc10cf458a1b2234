// SPDX-License-Identifier: MIT
// How the threads of a program wait for each other.
#pragma once

namespace bake {

/// Lets waiting threads fall asleep soon. Where other programs use the cores, too, a thread that waits for another one must leave its core
/// to it: spinning as long as OpenMP's library does by default takes six times the time (measured). The library reads how long when it is
/// loaded, so this starts the program anew, with `words` as its arguments, unless the user has said how threads wait (GOMP_SPINCOUNT,
/// OMP_WAIT_POLICY). Call it first thing in main. Where the program cannot be started anew, threads spin.
void let_waiting_threads_sleep(char** words);

}  // namespace bake
