/// @file
/// The judge survives every answer and every evaluation: of the wrong size, NaN, infinite, huge.
#include <doctest/doctest.h>

#include <cstdlib>

#include "project/harness/command.hpp"

TEST_CASE("every unit's spec survives answers and evaluations out of shape, and lets none pass") {
  const char* program = std::getenv("TUMBLE_JUDGE");
  REQUIRE(program != nullptr);
  const auto tried = tumble::test::run_command("'" + std::string(program) + "' odd-answers all");
  CHECK_MESSAGE(tried.status == 0, tried.output);
}
