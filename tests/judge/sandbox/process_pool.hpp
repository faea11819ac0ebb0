#pragma once
/// @file
/// Runs jobs in processes of their own, several at a time: a spec runs in one process only, and
/// what one job breaks is not another's.

#include <cstddef>
#include <functional>
#include <string>

namespace tumble::judge {

/// A job that has ended.
struct FinishedJob {
  std::size_t number;
  /// How it ended, if not well: what it threw, or the signal that killed it; empty if it succeeded.
  std::string failure;
};

/// Sends bytes from a job to the process that has started it.
using SendBytes = std::function<void(const std::string& bytes)>;

/// What a judging process may use; the largest honest one needs a tenth of it.
inline constexpr std::size_t memory_of_judging = 3ull << 30;

struct ProcessPool {
  std::size_t at_once = 1;                       ///< jobs that run at the same time
  std::size_t memory_bytes = memory_of_judging;  ///< of one job; what it starts has its own limit
  /// Called here with what a job has sent, in the order in which it was sent.
  std::function<void(std::size_t number, const std::string& bytes)> received;
  /// Called here when a job has ended, after all that it has sent.
  std::function<void(const FinishedJob&)> finished;
};

/// Runs job(0, send), …, job(count − 1, send), each in a child process.
void run_in_processes(std::size_t count, const ProcessPool& pool,
                      const std::function<void(std::size_t number, const SendBytes& send)>& job);

}  // namespace tumble::judge
