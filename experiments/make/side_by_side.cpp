// SPDX-License-Identifier: MIT
#include "experiments/make/side_by_side.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace bake {

void side_by_side(std::size_t count, int at_once, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> failed = false;
  std::vector<std::exception_ptr> thrown(count);
  const auto take_turns = [&] {
    for (std::size_t i = next++; i < count && !failed; i = next++) try {
        work(i);
      } catch (...) {
        thrown[i] = std::current_exception();
        failed = true;
      }
  };
  std::vector<std::thread> others;
  for (std::size_t k = 1; k < std::min(count, static_cast<std::size_t>(at_once)); ++k) others.emplace_back(take_turns);
  take_turns();
  for (std::thread& other : others) other.join();
  for (const std::exception_ptr& what : thrown)
    if (what) std::rethrow_exception(what);
}

}  // namespace bake
