#pragma once
/// @file
/// What is kept of a verdict: for files, for grades, for other programs. The verdict itself knows
/// the arguments and the answers; a record knows what was said about them.

#include <cstdint>
#include <string>
#include <vector>

#include "judge/verdict/unit_result.hpp"

namespace tumble::judge {

struct CaseRecord {
  std::size_t number = 0;  ///< in its unit, from 1
  std::string law;
  std::string outcome;  ///< "passed", "wrong", "crashed", …: name_of(Outcome)
  std::string detail, place;
  std::vector<std::string> misconceptions;  ///< names of those that give the same numbers

  bool passed() const { return outcome == "passed"; }
};

struct UnitRecord {
  std::string unit;    ///< "04_quaternions/product"
  std::string number;  ///< "4.1"
  bool passed = false;
  std::string summary;      ///< in one or two words: "passed", "wrong", "does not compile", …
  std::uint64_t seed = 1;   ///< of the inputs
  std::uint64_t judge = 0;  ///< fingerprint of what else the verdict depends on, if it is kept
  std::size_t laws = 0, laws_that_hold = 0;
  int tries = 1;             ///< how many different files of this student were judged so far
  double seconds = 0;        ///< from the file to the verdict
  std::uint64_t source = 0;  ///< fingerprint of the file that was judged, 0 if there was none
  std::string detail;        ///< of a build that failed
  std::string
      judge_failure;        ///< why there is no verdict, which is nobody's fault; empty if there is
  std::string explanation;  ///< what a student reads
  std::vector<CaseRecord> cases;
};

/// @param result a verdict, its file still there
UnitRecord record_of(const Course& course, const UnitResult& result);

}  // namespace tumble::judge
