#pragma once
/// @file
/// What a verdict depends on besides the student's file and the seed. A record of a verdict holds
/// as long as this stays: a judge that is built again from the same files judges alike.

#include <cstdint>

#include "judge/course/course.hpp"

namespace tumble::judge {

class JudgeFingerprint {
 public:
  /// Reads the files of the judge, the library and the toolchain's settings.
  explicit JudgeFingerprint(const Course& course);

  /// With the unit's contract, its spec and what the specs of its chapter share.
  std::uint64_t of(const Unit& unit) const;
  /// Of what all units share.
  std::uint64_t shared() const { return shared_; }

 private:
  const Course& course_;
  std::uint64_t shared_;
};

}  // namespace tumble::judge
