/// @file
/// Values as a student reads them, whatever a hostile worker sends.
#include "judge/verdict/number_text.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <string>

using namespace tumble::judge;

TEST_CASE("numbers, vectors, matrices") {
  CHECK(text_of(0.1, 17) == "0.10000000000000001");
  CHECK(text_of(0.1, 9) == "0.1");
  CHECK(text_of(-std::numeric_limits<double>::infinity(), 9) == "-infinity");
  CHECK(text_of(List{1.0, std::int64_t{2}, std::string("x")}, 9) == "(1, 2, \"x\")");
  CHECK(text_of(List{List{1.0, -2.0}, List{0.5, 4.0}}, 9, 2) == "[    1   -2  ]\n  [  0.5    4  ]");
  CHECK(text_of(FunctionId{0}, 9) == "a function of the judge");
}

TEST_CASE("a giant stays short") {
  Value nested = List(100, 1.0);
  for (int i = 0; i < 2; ++i) nested = List(100, nested);
  CHECK(text_of(nested, 9).size() < 100000);
  CHECK(text_of(List(100000, 1.0), 9).size() < 200);
  CHECK(text_of(List(1000, List(1000, 1.0)), 9).size() < 5000);
  CHECK(text_of(std::string(100000, 'x'), 9).size() < 100);
}

TEST_CASE("what a terminal would take for commands is shown as a question mark") {
  CHECK(printable("a\x1b[31mb\x7f\n\tc") == "a?[31mb?\n\tc");
  CHECK(printable("\xc2\x9b"
                  "31m") == "?31m");
  CHECK(printable("x\xe2\x80\xae"
                  "y\xe2\x81\xa7") == "x?y?");
  CHECK(printable("ω̇ = ½ 🙂") == "ω̇ = ½ 🙂");
  CHECK(one_line("a\nb\tc") == "a b c");
  CHECK(one_line(std::string(600, 'x')).size() == 503);
}
