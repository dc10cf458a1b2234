// SPDX-License-Identifier: MIT
// A run whose bits at its end are compared: with those of other numbers of threads, and of a run that was stopped and went on.
#pragma once

#include <gtest/gtest.h>
#include <omp.h>

#include "solver/io/checkpoint.h"
#include "tests/conservation/dough.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/threads_restored.h"

namespace bake {

class BitsOfRun : public testing::Test {
 protected:
  BitsOfRun(const Scene& of, int until) : scene(of), frames(until) {}
  std::string saved(const Simulation& s) const {
    CheckpointWriter out(file, "run", scene.run.precision);
    s.write(out);
    out.commit();
    return contents(file);
  }
  std::unique_ptr<Simulation> read_again() const { return Simulation::resume(scene, CheckpointReader(file)); }
  /// Bits at the end of the whole run by `n` threads; calls look(simulation) there.
  template <class Look>
  std::string whole_run(int n, Look look) const {
    omp_set_num_threads(n);
    const auto s = Simulation::begin(scene);
    advance(*s, frames);
    look(*s);
    return saved(*s);
  }
  /// The same of a run that was saved after `steps` steps, read again and gone on with.
  std::string stopped_after(int steps) const {
    const auto stopped = Simulation::begin(scene);
    advance(*stopped, frames, steps);
    saved(*stopped);
    const auto second = read_again();
    advance(*second, frames);
    return saved(*second);
  }
  double frame_time(int frame) const { return frame / scene.run.frame_rate_per_s; }
  /// Goes on to frame `last`; stops after `steps` steps if that comes earlier.
  void advance(Simulation& s, int last, int steps = 1 << 30) const {
    const int first = static_cast<int>(s.time() * scene.run.frame_rate_per_s + 1e-9);
    for (int f = first; f < last && steps > 0; ++f) s.advance(frame_time(f + 1), frame_time(f + 2), [&] { return --steps > 0; });
  }

  const Scene scene;
  const int frames;
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "run.h5";
  const ThreadsRestored restored;
};

}  // namespace bake
