/// @file
/// Names from files of others, and numbers for other programs, as they are written.
#include "support/printable.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "support/mesh_notes.hpp"
#include "support/shortest.hpp"
#include "support/terminal.hpp"

using namespace tumble::support;

TEST_CASE("escaped: nothing reaches a terminal that it would obey, and a name is one line") {
  CHECK(escaped("b\n\x1b[31mc\t\x7f") == "b\\n\\x1B[31mc\\t\\x7F");
  CHECK(escaped("Müller ÷ 日本") == "Müller ÷ 日本");
  CHECK(escaped("a\xc2\x9b"
                "b") == "a\\xC2\\x9Bb");  // U+009B begins a command, too
  CHECK(escaped("a\xe2\x80\xae"
                "b") == "a\\xE2\\x80\\xAEb");  // which turns the direction of writing
  CHECK(printable("line\nline\x1b") == "line\nline\\x1B");
}

TEST_CASE("tables, lines and notes: names are escaped, and CSV has them as they are") {
  Table table({"a\x1b", "value"});
  table.add({"b\n\x1b[31mc", "1"});
  CHECK(table.text() ==
        "  a\\x1B          value\n  ────────────   ─────\n"
        "  b\\n\\x1B[31mc       1\n");
  CHECK(table.text_within(10).find('\x1b') == std::string::npos);
  CHECK(table.csv() == "a\x1b,value\n\"b\n\x1b[31mc\",1\n");
  CHECK(fitted("a\x1b b") == "a\\x1B b");
  CHECK(mesh_notes(0, {{.message = "part x\x1b is open"}}).front().find('\x1b') ==
        std::string::npos);
}

TEST_CASE("shortest: few digits, and the same double") {
  CHECK(shortest(0.075) == "0.075");
  CHECK(shortest(0.03) == "0.03");
  CHECK(shortest(-0.0) == "0");
  CHECK(shortest(132) == "132");
  for (const double x :
       {1 / 3., -2 / 3e-200, 1e300 / 7, std::nextafter(0.3, 1),
        std::numeric_limits<double>::denorm_min(), -std::numeric_limits<double>::max()})
    CHECK(std::strtod(shortest(x).c_str(), nullptr) == x);
}

TEST_CASE("number: a zero has no sign") {
  CHECK(number(-0.0) == "0");
  CHECK(number(-1e-300) == "-1e-300");
}
