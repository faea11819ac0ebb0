#pragma once
/// @file
/// The verdict on one unit.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "judge/build/build_outcome.hpp"
#include "judge/course/course.hpp"
#include "judge/protocol/finding.hpp"

namespace tumble::judge {

struct UnitResult {
  Unit unit;
  std::filesystem::path source;
  std::uint64_t seed = 1;  ///< of the inputs
  BuildOutcome build = BuildOutcome::built;
  std::string build_detail, warnings;
  std::vector<CaseResult> cases;  ///< empty if it was not built
  /// Why there is no verdict: the judge itself failed, or this machine. Empty if it did not.
  std::string judge_failure;
  /// Where right answers come from memory that is gone, "torque.cpp:11: stack-use-after-scope".
  std::string lucky_place;
  /// The variable that right answers may come from although it was never set, with its place.
  std::string lucky_variable;
  /// What this machine failed at when it looked for the line of a mistake. The verdict stands.
  std::string why_no_place;
  double seconds = 0;  ///< from the file to the verdict

  std::size_t passed_cases() const;
  /// Built, and every law of the spec holds.
  bool passed() const;
  /// The stub as it was handed out: nobody has started.
  bool untouched() const;
  /// In one or two words: "passed", "wrong", "does not compile", "crashed", "judge failed", …
  std::string summary() const;
};

}  // namespace tumble::judge
