/// @file
/// Which numbers of a file are constants with a few digits, and when a wrong answer comes from one.
#include "judge/verdict/rounded_constant.hpp"

#include <doctest/doctest.h>

#include "judge/verdict/names_from_source.hpp"

using namespace tumble::judge;

namespace {

std::string meant_in(const std::string& code) {
  const auto found = rounded_constant_in(code);
  return found ? found->digits + " is " + found->meant : "";
}

}  // namespace

TEST_CASE("a rounded constant: fractions and π, rounded or cut off") {
  CHECK(meant_in("y + h * 0.1667 * k") == "0.1667 is 1/6");
  CHECK(meant_in("x = 0.1666;") == "0.1666 is 1/6");
  CHECK(meant_in("x = 0.333 * y;") == "0.333 is 1/3");
  CHECK(meant_in("x = .667;") == ".667 is 2/3");
  CHECK(meant_in("m * 0.0833") == "0.0833 is 1/12");
  CHECK(meant_in("angle * 3.14 / 180") == "3.14 is π");
  CHECK(meant_in("angle * 3.1416 / 180") == "3.1416 is π");
  CHECK(meant_in("angle * 0.01745") == "0.01745 is π/180");
  CHECK(meant_in("q * 0.7071") == "0.7071 is 1/√2");
}

TEST_CASE("a rounded constant: other numbers are none") {
  for (const char* code :
       {"x = 0.5;", "x = 0.3;", "x = 0.25 + 1.75;", "x = 0.34;", "x = 0.16666666666666666;",
        "x = 3.141592653589793;", "x = 3.1;", "x = 9.81;", "x = 1.0 / 6;", "x = 1e-3;", "x = 0.90;",
        "x = 0.333e5;", "double tiny = 0.33;", "0.67 * X + 0.33 * Y", "k + .17", "x = a0.1667;",
        "version 1.0.333", "x = 0.017;", "x = 0.40;"})
    CHECK_MESSAGE(meant_in(code) == "", code);
}

TEST_CASE("a rounded constant: named with its line, where the answer is as nearly right") {
  Finding finding;
  finding.answer = List{1.0002, 2., 3.};
  finding.demanded = List{1., 2., 3.};
  name_rounded_constant(finding, "// 0.3333\ny = x * 0.1667;\n");
  REQUIRE(finding.misconceptions.size() == 1);
  CHECK(finding.misconceptions[0].name == "a rounded constant");
  CHECK(finding.misconceptions[0].sentence ==
        "There is 0.1667 in line 2, which has only a few digits of 1/6. Write 1.0 / 6.");
}

TEST_CASE("a rounded constant: the text with exact ones, comments as they were") {
  CHECK(with_exact_constants("// 0.333 µ\nx = 0.333 * y + 0.5 + .1667;\n") ==
        "// 0.333 µ\nx = 0.33333333333333331 * y + 0.5 + 0.16666666666666666;\n");
}

TEST_CASE("a rounded constant: not named where the answer is off by more, or by next to nothing") {
  for (const double first : {2., 1.01, 1. + 1e-9, 1. + 4e-16}) {
    Finding finding;
    finding.answer = List{first, 2., 3.};
    finding.demanded = List{1., 2., 3.};
    name_rounded_constant(finding, "if (x.norm() > 0.333) y = x;");
    CHECK(finding.misconceptions.empty());
  }
}

TEST_CASE("a rounded constant: what is known already stands") {
  Finding finding;
  finding.answer = List{1.0002, 2., 3.};
  finding.demanded = List{1., 2., 3.};
  finding.misconceptions = {{"never set", "", ""}};
  name_rounded_constant(finding, "y = x * 0.1667;");
  CHECK(finding.misconceptions[0].name == "never set");
  finding.misconceptions.clear();
  finding.place = "product.cpp:7: stack-use-after-scope";
  name_rounded_constant(finding, "y = x * 0.1667;");
  CHECK(finding.misconceptions.empty());
}
