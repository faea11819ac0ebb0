#pragma once
/// @file
/// From a student's file to a worker: compile, look what was included, look for assembly, link. The
/// compiler runs behind walls too: a source file can attack it, and what it can read.

#include <filesystem>
#include <string>

#include "judge/build/job.hpp"
#include "judge/sandbox/worker_program.hpp"

namespace tumble::judge {

enum class BuildOutcome {
  built,
  refused,            ///< not a source file: missing, empty, a link, too large, no text
  does_not_compile,   ///< errors of the compiler
  forbidden_include,  ///< a header that an exercise may not see
  assembly,           ///< assembler code
  too_expensive,      ///< the compiler needed too much time or memory
  wrong_signature,    ///< compiled, but the function of the contract is not there
};

std::string name_of(BuildOutcome outcome);

struct WorkerBuild {
  BuildOutcome outcome = BuildOutcome::built;
  std::string detail;    ///< what the compiler said, about this file only
  std::string warnings;  ///< of a file that compiles
  /// Whether a failure has its reason in the student's file, as far as the compiler's words tell.
  bool explained = true;
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
