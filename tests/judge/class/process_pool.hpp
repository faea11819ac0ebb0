#pragma once
/// @file
/// Runs jobs in processes of their own, several at a time: a spec runs in one process only, and
/// what one job breaks is not another's.

#include <cstddef>
#include <functional>

namespace tumble::judge {

/// A job that has ended.
struct FinishedJob {
  std::size_t number;
  bool succeeded;  ///< it has not thrown and was not killed
};

/// Runs job(0, tick), …, job(count − 1, tick), at most `at_once` at a time.
/// @param job   runs in a child; what it throws is printed there. It calls tick() whenever a part
/// of
///              it is done
/// @param ticked   is called here for each tick() of a child
/// @param finished is called here when a job has ended
void run_in_processes(std::size_t count, std::size_t at_once,
                      const std::function<void(std::size_t, const std::function<void()>&)>& job,
                      const std::function<void()>& ticked,
                      const std::function<void(FinishedJob)>& finished);

}  // namespace tumble::judge
