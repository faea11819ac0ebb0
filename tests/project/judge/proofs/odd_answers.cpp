/// @file
/// The judge survives every answer and every evaluation: of the wrong size, NaN, infinite, huge.
#include "judge_command.hpp"

TEST_CASE("every unit's spec survives answers and evaluations out of shape, and lets none pass") {
  tumble::test::check_that_it_succeeds("odd-answers all");
}
