#pragma once
/// @file
/// Test cases that cannot run here, and say so.

#include <doctest/doctest.h>

#include <string>

namespace tumble::test {

/// How many test cases were skipped: if all of them, ctest is told so.
inline unsigned& skipped_cases() {
  static unsigned count = 0;
  return count;
}

/// Says why this test case cannot run here; it has to return then.
inline void skip(const std::string& why) {
  MESSAGE("skipped: " << why);
  ++skipped_cases();
}

}  // namespace tumble::test
