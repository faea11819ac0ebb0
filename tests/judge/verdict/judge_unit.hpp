#pragma once
/// @file
/// From a student's file to the verdict on it.

#include <cstdint>

#include "judge/build/job.hpp"
#include "judge/build/worker_build.hpp"
#include "judge/sandbox/pipe.hpp"
#include "judge/verdict/unit_result.hpp"

namespace tumble::judge {

/// What is wanted of a judgement.
struct Judgement {
  std::uint64_t seed = 1;
  int seeds = 1;                   ///< how many, from `seed` on; the first that fails is reported
  std::size_t only_case = 0;       ///< 0: all of them
  bool locate_crashes = true;      ///< build a crashed unit again with sanitizers, to name the line
  bool only_sanitized = false;     ///< everything with sanitizers from the start
  std::size_t builds_at_once = 0;  ///< of judge_all(); 0: as many as there are cores
  /// Before an answer is a mistake, the course's own solution has to pass on this machine. It is
  /// tried once for what `compiled` is kept for.
  bool try_solution = false;
  const ObjectCache* compiled = nullptr;  ///< what was compiled before; not with sanitizers
  Clock::time_point deadline = Clock::time_point::max();  ///< of judge_all(): none begins later
};

/// Holds what was built for a job against the spec of its unit.
UnitResult judge_build(const Job& job, const Judgement& judgement, const WorkerBuild& build);

}  // namespace tumble::judge
