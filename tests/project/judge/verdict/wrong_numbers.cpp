/// @file
/// What is said of an answer that is wrong in part, or by a factor.
#include "judge/verdict/wrong_numbers.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace tumble::judge;

namespace {

/// "name: sentence"; empty if there is none.
std::string said_of(const Value& answer, const Value& demanded) {
  Finding finding;
  finding.answer = answer;
  finding.demanded = demanded;
  finding.tolerance = 1e-12;
  name_wrong_numbers(finding);
  if (finding.misconceptions.empty()) return "";
  return finding.misconceptions[0].name + ": " + finding.misconceptions[0].sentence;
}

bool says(const Value& answer, const Value& demanded, const std::string& beginning) {
  const std::string said = said_of(answer, demanded);
  CAPTURE(said);
  return said.starts_with(beginning);
}

const Value four = List{1., 2., 3., 5.};
const Value matrix = List{List{1., 2., 3.}, List{4., 5., 6.}, List{7., 8., 10.}};
const Value parts = List{7., List{1., 2., 3.}, List{4., 5., 6.}};

}  // namespace

TEST_CASE("wrong numbers: one of several, where it stands") {
  CHECK(says(List{1., 2., 9., 5.}, four,
             "one number wrong: Only place 2 of your answer (counted from 0) is wrong."));
  CHECK(says(List{List{1., 2., 3.}, List{4., 5., 0.}, List{7., 8., 10.}}, matrix,
             "one number wrong: Only row 1, column 2 of your answer (counted from 0) is wrong."));
  CHECK(says(List{7., List{1., 2., 3.}, List{4., 9., 6.}}, parts,
             "one number wrong: Only one number of your answer is wrong."));
}

TEST_CASE("wrong numbers: the signs of some") {
  CHECK(
      says(List{1., 2., -3., 5.}, four,
           "some signs wrong: Place 2 of your answer (counted from 0) has the wrong sign, and all "
           "others are right."));
  CHECK(says(List{1., -2., -3., 5.}, four,
             "some signs wrong: Places 1 to 2 of your answer (counted from 0) have the wrong"));
  CHECK(says(List{List{1., -2., 3.}, List{-4., 5., 6.}, List{7., 8., 10.}}, matrix,
             "some signs wrong: Row 0, column 1 and row 1, column 0 of your answer"));
  CHECK(says(List{7., List{1., 2., 3.}, List{-4., -5., -6.}}, parts,
             "some signs wrong: 3 numbers of your answer have the wrong sign"));
}

TEST_CASE("wrong numbers: a factor, of all or of some") {
  CHECK(says(List{2., 4., 6., 10.}, four,
             "off by a factor: Each number of your answer is 2 times what is demanded. Look"));
  CHECK(says(List{1., 2., 1.5, 2.5}, four,
             "off by a factor: Places 2 to 3 of your answer (counted from 0) are each 0.5 times "
             "what is demanded, and all others are right."));
}

TEST_CASE("wrong numbers: the right ones at wrong places") {
  CHECK(says(List{1., 3., 2., 5.}, four,
             "numbers at wrong places: Your answer has the right numbers, but not at their places: "
             "the number at place 1 (counted from 0) belongs to place 2."));
  CHECK(says(List{7., List{4., 5., 6.}, List{1., 2., 3.}}, parts, "numbers at wrong places: Your"));
}

TEST_CASE("wrong numbers: a row or a column of a matrix") {
  CHECK(says(List{List{1., 2., 3.}, List{9., 7., 1.}, List{7., 8., 10.}}, matrix,
             "one row wrong: Only row 1 of your matrix (counted from 0) is wrong."));
  CHECK(says(List{List{1., 0., 3.}, List{4., 8., 6.}, List{7., 9., 10.}}, matrix,
             "one column wrong: Only column 1 of"));
}

TEST_CASE("wrong numbers: a part of a long list") {
  const Value long_one = List{1., 2., 3., 4., 5., 6., 7., 8.};
  CHECK(
      says(List{1., 2., 9., 4., 5., 7.5, 7., 8.}, long_one,
           "some numbers wrong: Places 2 and 5 of your answer (counted from 0) are wrong, and all "
           "others are right."));
  CHECK(said_of(List{0.1, 2.7, 3.1, 4.6, 5.2, 6., 7., 8.}, long_one) == "");  // too many
}

TEST_CASE("wrong numbers: what proves too little gets no name") {
  for (const Value& answer : {Value(List{9., 8., 7., 1.}), Value(List{1., 2., 3.}), Value(List{}),
                              Value(1.), Value(List{1., 2., 3., List{5.}}), Value(std::string("a")),
                              Value(List{0., 0., 0., 0.}), Value(List{1., 2., 3., NAN, 5.})})
    CHECK(said_of(answer, four) == "");
  CHECK(said_of(List{2., 0., 0.}, List{1., 0., 0.}) == "");  // zeros prove nothing
  CHECK(said_of(2., 1.) == "");
  CHECK(said_of(List{2., 3.}, List{1., 3.}) == "");
  CHECK(said_of(List{1.0000001, 2.0000002, 3.0000003, 5.0000005}, four) == "");  // a float
}

TEST_CASE("wrong numbers: what is known already stands") {
  Finding finding;
  finding.answer = List{2., 4., 6., 10.};
  finding.demanded = four;
  finding.misconceptions = {{"never set", "", ""}};
  name_wrong_numbers(finding);
  CHECK(finding.misconceptions[0].name == "never set");
  finding.misconceptions.clear();
  finding.place = "product.cpp:7: stack-use-after-scope";
  name_wrong_numbers(finding);
  CHECK(finding.misconceptions.empty());
}
