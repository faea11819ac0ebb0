#pragma once
/// @file
/// Where a case goes wrong: it runs again with sanitizers, which name the line. Runs only for those
/// who judge their own work: behind these walls a program may do more (it reads about itself in
/// /proc).

#include <string>

#include "judge/build/job.hpp"
#include "judge/sandbox/worker_program.hpp"
#include "judge/spec/run.hpp"

namespace tumble::judge {

struct CrashPlace {
  std::string place;    ///< "product.cpp:7: division by zero"; empty if it is not known
  std::string why_not;  ///< what this machine fails at: it has no sanitizers, its disk is full
};

/// Where a case goes wrong: the place for the first case of `run` that fails with sanitizers, empty
/// if these find nothing. For a loop without end, the line where its time was up.
/// @param cpu_seconds how long it may compute
CrashPlace crash_place(const Job& job, const SpecRun& run, int cpu_seconds);

/// The same from what a worker with sanitizers has printed.
/// @param file name of the student's file
std::string place_in_report(const std::string& report, const std::string& file,
                            const WorkerProgram& worker);

}  // namespace tumble::judge
