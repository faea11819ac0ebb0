/// @file
/// Text that fits a terminal, and the nearest of several names.
#include <doctest/doctest.h>

#include <sstream>

#include "support/nearest.hpp"
#include "support/table.hpp"
#include "support/wrapped.hpp"

using namespace tumble::support;

TEST_CASE("nearest: the name with the fewest wrong letters, or none") {
  CHECK(edit_distance("product", "product") == 0);
  CHECK(edit_distance("prodct", "product") == 1);
  CHECK(edit_distance("chekc", "check") == 1);
  CHECK(edit_distance("", "abc") == 3);
  const std::vector<std::string> names = {"product", "inverse", "euler_step", "rk4_step"};
  CHECK(nearest("porduct", names) == "product");
  CHECK(nearest("rk_step", names) == "rk4_step");
  CHECK(nearest("euler", names) == "euler_step");
  CHECK_FALSE(nearest("xyzzy", names).has_value());
  CHECK_FALSE(nearest("p", names).has_value());
  CHECK_FALSE(nearest("", names).has_value());
  CHECK(did_you_mean("inverce", names) == "; did you mean inverse?");
  CHECK(did_you_mean("xyzzy", names) == "");
}

TEST_CASE("wrapped: lines break between words, at characters rather than bytes") {
  CHECK(wrapped("one two three", 8, 2) == "one two\n  three");
  CHECK(wrapped("÷÷÷ ÷÷÷ ÷", 7, 0) == "÷÷÷ ÷÷÷\n÷");
  CHECK(wrapped("immeasurable x", 5, 1) == "immeasurable\n x");
  CHECK(wrapped("", 5, 1) == "");
}

TEST_CASE("table: stacked where a line would be longer, itself where not") {
  Table table({"cube", "at the end", "unit"});
  table.add({"position", "1.25  -3.5  0.125", "m"});
  table.add({"velocity", "0  0  -9.8100001", ""});
  CHECK(table.text_within(100) == table.text());
  CHECK(table.text_within(24) ==
        "cube\n"
        "  position\n"
        "    at the end: 1.25\n"
        "      -3.5 0.125\n"
        "    unit: m\n"
        "  velocity\n"
        "    at the end: 0 0\n"
        "      -9.8100001\n");
  std::istringstream lines(table.text_within(24));
  for (std::string line; std::getline(lines, line);) CHECK(characters(line) <= 24);
}
