/// @file
/// What is said of an answer that is wrong in part, or by a factor.
#include "judge/verdict/wrong_numbers.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "judge/verdict/judge_answers.hpp"

using namespace tumble::judge;

namespace {

const AnswerType mass_properties{{"mass", "centre", "inertia"}};
const AnswerType sums{{"a", "b", "ab", "bb"}};

/// "name: sentence"; empty if there is none.
std::string said_of(const Value& answer, const Value& demanded, const AnswerType& type = {}) {
  Finding finding;
  finding.answer = answer;
  finding.demanded = demanded;
  finding.tolerance = 1e-12;
  name_wrong_numbers(finding, type);
  if (finding.misconceptions.empty()) return "";
  return finding.misconceptions[0].name + ": " + finding.misconceptions[0].sentence;
}

bool says(const Value& answer, const Value& demanded, const std::string& beginning,
          const AnswerType& type = {}) {
  const std::string said = said_of(answer, demanded, type);
  CAPTURE(said);
  return said.starts_with(beginning);
}

const Value four = List{1., 2., 3., 5.};
const Value matrix = List{List{1., 2., 3.}, List{4., 5., 6.}, List{7., 8., 10.}};
const Value parts = List{7., List{1., 2., 3.}, List{4., 5., 6.}};

}  // namespace

TEST_CASE("wrong numbers: one of several, where it stands") {
  CHECK(says(List{1., 2., 9., 5.}, four,
             "one wrong number: Only place 2 of your answer (counted from 0) is wrong; all others "
             "are right."));
  CHECK(says(
      List{List{1., 2., 3.}, List{4., 5., 0.}, List{7., 8., 10.}}, matrix,
      "one wrong number: Only row 1, column 2 of your answer (counted from 0) is wrong. Compare"));
  CHECK(says(List{7., List{1., 2., 3.}, List{4., 9., 6.}}, parts,
             "one wrong number: Only one number in inertia of your answer is wrong; all others",
             mass_properties));
}

TEST_CASE("wrong numbers: the signs of some") {
  CHECK(
      says(List{1., 2., -3., 5.}, four,
           "some wrong signs: Place 2 of your answer (counted from 0) has the wrong sign, and all "
           "others are right."));
  CHECK(says(List{1., -2., -3., 5.}, four,
             "some wrong signs: Places 1 to 2 of your answer (counted from 0) have the wrong"));
  CHECK(says(List{List{1., -2., 3.}, List{-4., 5., 6.}, List{7., 8., 10.}}, matrix,
             "some wrong signs: Row 0, column 1 and row 1, column 0 of your answer"));
  CHECK(says(List{7., List{1., 2., 3.}, List{-4., -5., -6.}}, parts,
             "some wrong signs: In your answer, inertia has the wrong sign", mass_properties));
}

TEST_CASE("wrong numbers: a factor, of all or of some") {
  CHECK(says(List{2., 4., 6., 10.}, four,
             "a wrong factor: Each number of your answer is 2 times the demanded one. Look"));
  CHECK(says(List{1., 2., 1.5, 2.5}, four,
             "a wrong factor: Places 2 to 3 of your answer (counted from 0) are each 0.5 times "
             "the demanded one, and all others are right. Look"));
}

TEST_CASE("wrong numbers: a factor is looked for where somebody may have forgotten it") {
  const auto looks = [](double factor) {
    const std::string said = said_of(List{factor, 2 * factor, 3 * factor, 5 * factor}, four);
    CHECK(said.starts_with("a wrong factor: "));
    return said.find("Look for a factor") != std::string::npos;
  };
  for (const double factor : {2., 1. / 6, 2. / 3, 12., 3.14159265358979323846, -2., std::sqrt(0.5)})
    CHECK_MESSAGE(looks(factor), factor);
  for (const double factor : {0.641, 1.2345, 13., 0.3333}) CHECK_MESSAGE(!looks(factor), factor);
}

TEST_CASE("wrong numbers: signs that are lost together") {
  const Value demanded = List{1., -2., -3., 5.};
  CHECK(said_of(List{1., 2., 3., 5.}, demanded).ends_with("an absolute value or a square?"));
  CHECK(said_of(List{1., 2., -3., 5.}, demanded).find("Look at each minus") != std::string::npos);
}

TEST_CASE("wrong numbers: of a struct, by its members") {
  CHECK(says(List{1., 2., 9., 5.}, four,
             "one wrong number: Only ab of your answer is wrong; all others are right.", sums));
  CHECK(says(List{1., -2., 3., -5.}, four,
             "some wrong signs: In your answer, b and bb have the wrong sign", sums));
  CHECK(says(List{1., 3., 2., 5.}, four,
             "numbers in the wrong places: Your answer has the right numbers, but some", sums));
  CHECK(said_of(List{7., List{1., 2., 3.}, List{4., 9., 6.}}, parts) == "");  // names are not known
  CHECK(said_of(List{1., 2., 9., 5.}, four, {{}, true}) == "");
}

TEST_CASE("wrong numbers: right to rounding, or to what a method can do") {
  const double ulp = 0x1p-52;
  CHECK(said_of(List{1., 2., 3. + 1e4 * ulp, 5.}, four) == "");
  CHECK(said_of(List{1., 2., 3. + 4e-9, 5.}, four) == "");
  CHECK(said_of(List{1.0005, 2.001, 3.0015, 5.0025}, four) == "");
  Finding finding;
  finding.answer = List{1. + ulp, 2., 3., 5.};
  finding.demanded = four;
  name_wrong_numbers(finding);  // tolerance 0
  CHECK(finding.misconceptions.empty());
}

TEST_CASE("wrong numbers: infinity where it is demanded is right") {
  CHECK(says(List{1., 2., 9., 5., INFINITY}, List{1., 2., 3., 5., INFINITY},
             "one wrong number: Only place 2"));
}

TEST_CASE("wrong numbers: only of the first case") {
  Finding finding;
  finding.answer = List{2., 4., 6., 10.};
  finding.demanded = four;
  UnitResult result;
  result.cases = {{1, "first", finding}, {2, "second", finding}};
  name_wrong_numbers(result, {});
  CHECK(result.cases[0].finding->misconceptions.size() == 1);
  CHECK(result.cases[1].finding->misconceptions.empty());
}

TEST_CASE("wrong numbers: a struct has no places that are left at zero") {
  Finding finding;
  finding.answer = List{0., 0., 3., 5.};
  finding.demanded = four;
  finding.misconceptions = {{"places left at zero", "", ""}};
  UnitResult result;
  result.cases = {{2, "second", finding}};
  name_wrong_numbers(result, {});
  CHECK(result.cases[0].finding->misconceptions.size() == 1);
  name_wrong_numbers(result, sums);
  CHECK(result.cases[0].finding->misconceptions.empty());
}

TEST_CASE("wrong numbers: the right ones at wrong places") {
  CHECK(says(
      List{1., 3., 2., 5.}, four,
      "numbers in the wrong places: Your answer has the right numbers, but not in their places: "
      "the number at place 1 (counted from 0) belongs to place 2."));
  CHECK(says(List{7., List{4., 5., 6.}, List{1., 2., 3.}}, parts,
             "numbers in the wrong places: Your", mass_properties));
}

TEST_CASE("wrong numbers: a row or a column of a matrix") {
  CHECK(says(List{List{1., 2., 3.}, List{9., 7., 1.}, List{7., 8., 10.}}, matrix,
             "one wrong row: Only row 1 of your matrix (counted from 0) is wrong."));
  CHECK(says(List{List{1., 0., 3.}, List{4., 8., 6.}, List{7., 9., 10.}}, matrix,
             "one wrong column: Only column 1 of"));
}

TEST_CASE("wrong numbers: a part of a long list") {
  const Value long_one = List{1., 2., 3., 4., 5., 6., 7., 8.};
  CHECK(
      says(List{1., 2., 9., 4., 5., 7.5, 7., 8.}, long_one,
           "some wrong numbers: Places 2 and 5 of your answer (counted from 0) are wrong, and all "
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
