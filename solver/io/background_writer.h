// SPDX-License-Identifier: MIT
// Files that a thread of their own writes while the solver goes on.
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace bake {

/// Does jobs in a thread of its own, one after another in the order given. If a job throws, those behind it are dropped, and every later
/// call of the owner throws the same. One thread owns it.
class BackgroundWriter {
 public:
  BackgroundWriter() : thread_([this] { run(); }) {}
  /// Does the jobs that are left; what they throw is lost, so call finish() before.
  ~BackgroundWriter();
  BackgroundWriter(const BackgroundWriter&) = delete;
  BackgroundWriter& operator=(const BackgroundWriter&) = delete;

  /// Adds a job. Waits until fewer than two are left, so that a disk that fails is noticed soon.
  void put(std::function<void()> job);
  /// Throws if a job has failed.
  void check();
  /// Waits until all jobs are done.
  void finish();

 private:
  static constexpr std::size_t k_most_jobs = 2;

  void run();
  /// Throws the failure if there is one.
  void wait_for_at_most(std::size_t jobs, std::unique_lock<std::mutex>& lock);

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> jobs_;  ///< the first one is being done
  std::exception_ptr failure_;
  bool ends_ = false;
  std::thread thread_;  ///< last, because it uses all of the others
};

}  // namespace bake
