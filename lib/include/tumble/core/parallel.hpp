#pragma once
/// @file
/// Work that is cut into pieces, done by several threads; by one where the system has no threads.

#include <atomic>
#include <exception>
#include <vector>

#include "tumble/core/require.hpp"

// wasi-libc has threads only where the compiler is asked for them (-pthread defines _REENTRANT).
#if defined(__wasi__) && !defined(_REENTRANT)
#define TUMBLE_HAS_THREADS 0
#else
#define TUMBLE_HAS_THREADS 1
#include <mutex>
#include <thread>
#endif

namespace tumble::detail {

#if TUMBLE_HAS_THREADS

/// Runs what it is given while no other thread does.
class OneAtATime {
 public:
  template <class Work>
  void operator()(const Work& work) {
    const std::lock_guard lock(mutex_);
    work();
  }

 private:
  std::mutex mutex_;
};

/// Threads that are waited for, also when an exception leaves the block. (libc++ has std::jthread
/// since its version 20.)
class JoinedThreads {
 public:
  JoinedThreads() = default;
  JoinedThreads(const JoinedThreads&) = delete;
  JoinedThreads& operator=(const JoinedThreads&) = delete;
  ~JoinedThreads() {
    for (std::thread& thread : threads_) thread.join();
  }

  template <class Work>
  void start(const Work& work) {
    threads_.emplace_back(work);
  }

 private:
  std::vector<std::thread> threads_;
};

#else

/// There is one thread: nothing to wait for.
class OneAtATime {
 public:
  template <class Work>
  void operator()(const Work& work) {
    work();
  }
};

/// Starts nothing: what a thread would take is left to the caller.
class JoinedThreads {
 public:
  template <class Work>
  void start(const Work&) {}
};

#endif

/// Runs `work`; hands what it throws to `failed`.
template <class Work, class Failed>
void run_or(const Work& work, [[maybe_unused]] const Failed& failed) {
#ifdef __cpp_exceptions
  try {
    work();
  } catch (...) {
    failed(std::current_exception());
  }
#else
  work();
#endif
}

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
  detail::OneAtATime failing;
  const auto take_pieces = [&] {
    const auto take = [&] {
      for (int i = next++; i < count; i = next++) work(i);
    };
    detail::run_or(take, [&](const std::exception_ptr& why) {
      failing([&] {
        if (!failure) failure = why;
      });
      next = count;
    });
  };
  {
    detail::JoinedThreads others;
    for (int i = 1; i < threads && i < count; ++i) others.start(take_pieces);
    take_pieces();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace tumble::detail
