#pragma once
/// @file
/// What has become of a student's file on its way to a worker.

#include <string>

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

struct BuildReport {
  BuildOutcome outcome = BuildOutcome::built;
  std::string detail;    ///< what the compiler said, about this file only
  std::string warnings;  ///< of a file that compiles
  /// Whether a failure has its reason in the student's file, as far as the compiler's words tell.
  bool explained = true;
  /// Whether the course's own files take part in these words: what a linker misses, which headers
  /// are allowed. If they are damaged, a right answer fails so.
  bool involves_course = false;

  bool is_certain() const { return explained && !involves_course; }
};

}  // namespace tumble::judge
