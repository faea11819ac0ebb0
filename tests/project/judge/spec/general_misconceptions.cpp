/// @file
/// What is said of numbers that are none.
#include "judge/spec/general_misconceptions.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

#include "judge/spec/likeness.hpp"

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

namespace {

/// A wrong answer that should be 1, 2, 3 …
Finding instead_of_counting(List answer) {
  Finding finding;
  List demanded;
  for (std::size_t i = 0; i < answer.size(); ++i) demanded.emplace_back(static_cast<double>(i + 1));
  finding.demanded = Value(demanded);
  finding.answer = Value(std::move(answer));
  return finding;
}

std::string said_of_places(const List& answer) {
  const auto names = general_misconceptions(instead_of_counting(answer), Inputs::general);
  return names.empty() ? "" : names.front().name + ": " + names.front().sentence;
}

}  // namespace

TEST_CASE("where some numbers are right, the places that were never written are told") {
  volatile double zero = 0;
  if (!std::signbit(zero / zero)) return;  // they look like any other NaN here
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(said_of_places({1., 2., nan, nan}) ==
        "not a number: Places 2 to 3 of your answer (counted from 0) were never written, or come "
        "from a vector that was not. Look at where your loops begin and end, and at the places "
        "that they write to.");
  CHECK(said_of_places({1., 9., nan, 4., nan}).find("Places 2 and 4 of") != std::string::npos);
  CHECK(said_of_places({1., 2., nan}).find("Place 2 of your answer (counted from 0) was never") !=
        std::string::npos);
  CHECK(said_of_places({nan, 2., nan, 4., nan, 6., nan}).find("Places 0, 2, 4, … of") !=
        std::string::npos);
  // Nothing is right: it need not be a loop.
  CHECK(said_of_places({nan, nan}).find("begins with a value") != std::string::npos);
  CHECK(said_of_places({9., nan}).find("begins with a value") != std::string::npos);
}

TEST_CASE("a beginning or an end that is 0, where all else is right, is told") {
  CHECK(said_of_places({1., 2., 3., 4., 0., 0.})
            .starts_with("places left at zero: Places 4 to 5 of your answer (counted from 0) are "
                         "0, and all others"));
  CHECK(said_of_places({0., 0., 3., 4., 5., 6.}).find("Places 0 to 1") != std::string::npos);
  for (const List& other :
       {List{1., 2., 3., 4., 5., 0.}, List{1., 0., 0., 4., 5., 6.}, List{1., 2., 3., 4., 0., 9.},
        List{0., 0., 0., 0., 0., 0.}, List{1., 0., 0., 0., 0., 0.}, List{9., 2., 3., 4., 0., 0.},
        List{1., 2., 3., 0., 0.}})
    CHECK(said_of_places(other).empty());
}

TEST_CASE("the argument as it came: what speaks for it, and what against") {
  const List arguments{1., List{2., 3.}};
  CHECK(equals_argument(arguments, List{2., 3.}));
  CHECK_FALSE(equals_argument(arguments, List{2., 4.}));
  CHECK_FALSE(equals_argument(arguments, List{2.}));
}
