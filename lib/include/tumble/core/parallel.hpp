#pragma once
/// @file
/// Work that is cut into pieces, done by several threads.

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "tumble/core/require.hpp"

namespace tumble {

/// Calls work(0) … work(count − 1), in any order, by up to `threads` threads: this one and others.
/// What a piece throws is thrown again here, after the others have ended.
/// @throws std::invalid_argument if threads < 1
template <class Work>
void parallel_for(int count, int threads, const Work& work) {
  require(threads >= 1, "the number of threads is ", threads, ", not positive");
  if (threads == 1 || count <= 1) {
    for (int i = 0; i < count; ++i) work(i);
    return;
  }
  std::atomic<int> next = 0;
  std::exception_ptr failure;
  std::mutex failing;
  const auto take_pieces = [&] {
    try {
      for (int i = next++; i < count; i = next++) work(i);
    } catch (...) {
      const std::lock_guard lock(failing);
      if (!failure) failure = std::current_exception();
      next = count;
    }
  };
  {
    std::vector<std::jthread> others;
    for (int i = 1; i < threads && i < count; ++i) others.emplace_back(take_pieces);
    take_pieces();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace tumble
