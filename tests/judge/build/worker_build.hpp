#pragma once
/// @file
/// From a student's file to a worker: compile, look what was included, look for assembly, link. The
/// compiler runs behind walls too: a source file can attack it, and what it can read.

#include <filesystem>
#include <stdexcept>

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

/// This machine can build a worker, but not with sanitizers: their libraries are missing.
struct NoSanitizers : std::runtime_error {
  NoSanitizers()
      : std::runtime_error(
            "this machine cannot build with sanitizers (libasan and libubsan are missing?)") {}
};

class ObjectCache;

/// Builds the worker of a job.
/// @param compiled what was compiled before, if anything
/// @throws std::runtime_error if it is not the student's file that fails, but the judge or this
/// machine: no compiler, no walls, a full disk, no memory; NoSanitizers if they alone are missing
WorkerBuild build_worker(const Job& job, Instrumentation instrumentation = Instrumentation::none,
                         const ObjectCache* compiled = nullptr);

/// What the compiler says of a file that compiles, where it may look for variables that are never
/// set: those get no mark here. Empty if it says nothing, or cannot be asked.
std::string words_about_unset(const Job& job);

/// The same as far as the object, which other units' objects can be linked with.
WorkerBuild compile_unit(const Job& job, const ObjectCache* compiled = nullptr);

}  // namespace tumble::judge
