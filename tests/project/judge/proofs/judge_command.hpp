/// @file
/// Commands of this course's judge.
#pragma once

#include <doctest/doctest.h>

#include <cstdlib>
#include <string>

#include "project/harness/command.hpp"

namespace tumble::test {

/// What the judge says to these arguments.
inline CommandResult judge(const std::string& arguments) {
  const char* program = std::getenv("TUMBLE_JUDGE");
  require(program != nullptr, "ctest sets TUMBLE_JUDGE");
  return run_command("'" + std::string(program) + "' " + arguments);
}

inline void check_that_it_succeeds(const std::string& arguments) {
  const CommandResult result = judge(arguments);
  CHECK_MESSAGE(result.status == 0, result.output);
}

}  // namespace tumble::test
