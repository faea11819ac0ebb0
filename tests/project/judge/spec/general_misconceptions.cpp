/// @file
/// What is said of numbers that are none.
#include "judge/spec/general_misconceptions.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

using namespace tumble::judge;

namespace {

/// What is said of a vector with this number in it.
std::string said_of(double x) {
  Finding finding;
  finding.answer = Value(List{1., x});
  const std::vector<Misconception> names = general_misconceptions(finding, Inputs::special);
  REQUIRE(names.size() == 1);
  CHECK(names[0].name == "not a number");
  return names[0].sentence;
}

}  // namespace

TEST_CASE("the NaN of a new matrix is told from one that was computed, where they differ") {
  volatile double zero = 0;
  const double computed = zero / zero;
  const std::string of_division = said_of(computed);
  CHECK(of_division.find("Look for a divisor") != std::string::npos);
  const std::string of_matrix = said_of(std::numeric_limits<double>::quiet_NaN());
  if (std::signbit(computed))
    CHECK(of_matrix.find("before it is set") != std::string::npos);
  else
    CHECK(of_matrix == of_division);
}

TEST_CASE("a NaN that came in is nobody's division") {
  Finding finding;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  finding.answer = Value(nan);
  finding.question = Question{List{1., nan}, 0};
  CHECK(general_misconceptions(finding, Inputs::general)[0].sentence ==
        "What your function was given contains NaN, and so does your answer.");
}
