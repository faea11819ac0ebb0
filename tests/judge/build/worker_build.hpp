#pragma once
/// @file
/// From a student's file to a worker: compile, look what was included, look for assembly, link. The
/// compiler runs behind walls too: a source file can attack it, and what it can read.

#include <filesystem>

#include "judge/build/build_outcome.hpp"
#include "judge/build/job.hpp"
#include "judge/sandbox/worker_program.hpp"

namespace tumble::judge {

struct WorkerBuild : BuildReport {
  fs::path object;       ///< if compiled
  WorkerProgram worker;  ///< if built
};

/// How the worker is to be built.
enum class Instrumentation {
  none,
  sanitizers,  ///< AddressSanitizer and UndefinedBehaviorSanitizer: to find where it crashes
};

class ObjectCache;

/// Builds the worker of a job.
/// @param compiled what was compiled before, if anything
/// @throws std::runtime_error if it is not the student's file that fails, but the judge or this
/// machine: no compiler, no walls, a full disk, no memory
WorkerBuild build_worker(const Job& job, Instrumentation instrumentation = Instrumentation::none,
                         const ObjectCache* compiled = nullptr);

/// The same as far as the object, which other units' objects can be linked with.
WorkerBuild compile_unit(const Job& job);

}  // namespace tumble::judge
