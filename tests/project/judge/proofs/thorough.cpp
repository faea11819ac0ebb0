/// @file
/// What course.cpp proves, with more seeds, and every solution with sanitizers.
#include "judge_command.hpp"

using tumble::test::check_that_it_succeeds;

TEST_CASE("the kill matrix, with other seeds") {
  for (const char* seed : {"2", "3", "4", "5"}) {
    check_that_it_succeeds(std::string("matrix all --seed ") + seed);
  }
}

TEST_CASE("every solution passes, with many seeds") {
  check_that_it_succeeds("check all --solutions --seed 1 --seeds 20");
}

TEST_CASE("every solution passes with AddressSanitizer and UndefinedBehaviorSanitizer") {
  check_that_it_succeeds("check all --solutions --seed 1 --sanitize");
}
