// SPDX-License-Identifier: MIT
#include "solver/io/background_writer.h"

#include <utility>

namespace bake {

BackgroundWriter::~BackgroundWriter() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void BackgroundWriter::put(std::function<void()> job) {
  std::unique_lock lock(mutex_);
  wait_for_at_most(k_most_jobs - 1, lock);
  jobs_.push_back(std::move(job));
  changed_.notify_all();
}

void BackgroundWriter::check() {
  const std::lock_guard lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
}

void BackgroundWriter::finish() {
  std::unique_lock lock(mutex_);
  wait_for_at_most(0, lock);
}

void BackgroundWriter::wait_for_at_most(std::size_t jobs, std::unique_lock<std::mutex>& lock) {
  owner_waits_ = jobs_.size() > jobs;
  changed_.wait(lock, [&] { return jobs_.size() <= jobs; });
  owner_waits_ = false;
  if (failure_) std::rethrow_exception(failure_);
}

void BackgroundWriter::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [&] { return !jobs_.empty() || ends_; });
    if (jobs_.empty()) return;
    const std::function<void()>& job = jobs_.front();  // stays where it is while the owner appends others
    lock.unlock();
    std::exception_ptr failure;
    try {
      job();
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    jobs_.pop_front();
    if (failure) failure_ = failure, jobs_.clear();
    changed_.notify_all();
  }
}

}  // namespace bake
