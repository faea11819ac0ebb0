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

/// "product.cpp:7: division by zero" for the first case of `run` that fails with sanitizers, empty
/// if these find nothing. For a loop without end, the line where its time was up.
/// @param cpu_seconds how long it may compute
std::string crash_place(const Job& job, const SpecRun& run, int cpu_seconds);

/// The same from what a worker with sanitizers has printed.
/// @param file name of the student's file
std::string place_in_report(const std::string& report, const std::string& file,
                            const WorkerProgram& worker);

}  // namespace tumble::judge
