/// @file
/// An error in a header is told at the student's line, a static assertion of Eigen's in other
/// words.
#include "judge/build/header_errors.hpp"

#include <doctest/doctest.h>

#include <string>

using tumble::judge::header_errors_at;

namespace {

const std::string source = "/tmp/w/a.cpp";
const std::string text = "int f() {\n  return v * v;\n}\n";
const std::string told =
    "/tmp/w/a.cpp:2:12: error: a vector times a vector: write a.dot(b) for the dot product, "
    "a.cwiseProduct(b) for entry by entry (INVALID_VECTOR_VECTOR_PRODUCT__IF)\n"
    "    2 |   return v * v;\n"
    "      |            ^\n";

std::string seen(const std::string& output) { return header_errors_at(source, text, output); }

}  // namespace

TEST_CASE("gcc tells of the student's line before its error, once is enough for a line") {
  const std::string once =
      "/usr/Eigen/Product.h: In instantiation of 'x':\n"
      "/tmp/w/a.cpp:2:12:   required from here\n"
      "/usr/Eigen/Product.h:415:3: error: static assertion failed: "
      "INVALID_VECTOR_VECTOR_PRODUCT__IF\n"
      "  415 |   EIGEN_STATIC_ASSERT(ProductIsValid)\n"
      "      |   ^\n";
  const std::string before = "/usr/Eigen/Product.h: In instantiation of 'x':\n";
  CHECK(seen(once) == before + told);
  CHECK(seen(once + once) == before + told + before);
}

TEST_CASE("clang tells of it in a note behind its error") {
  CHECK(seen("/usr/Eigen/Product.h:415:3: error: static_assert failed due to requirement 'A || B' "
             "\"INVALID_VECTOR_VECTOR_PRODUCT__IF\"\n"
             "  EIGEN_STATIC_ASSERT(ProductIsValid)\n"
             "/usr/Eigen/StaticAssert.h:33:40: note: expanded from macro 'EIGEN_STATIC_ASSERT'\n"
             "/tmp/w/a.cpp:2:12: note: in instantiation of function template 'x' requested here\n"
             "  return v * v;\n"
             "           ^\n"
             "/tmp/w/a.cpp:3:1: error: expected ';'\n") ==
        told +
            "/usr/Eigen/StaticAssert.h:33:40: note: expanded from macro 'EIGEN_STATIC_ASSERT'\n"
            "/tmp/w/a.cpp:3:1: error: expected ';'\n");
}

TEST_CASE("an error in the student's own line is told in plain words where these are clearer") {
  const std::string place = "/tmp/w/a.cpp:2:12: error: ";
  const std::string quote = "    2 |   return v * v;\n      |            ^\n";
  const auto words_for = [&](const std::string& words) {
    return seen(place + words + "\n  return v * v;\n           ^\n");
  };
  for (const char* sum :
       {"no match for 'operator+' (operand types are 'int' and 'Eigen::Matrix3d')",
        "invalid operands to binary expression ('int' and 'const CwiseBinaryOp<>')"})
    CHECK(words_for(sum) ==
          place +
              "a number can't be added to a matrix, or divided by one: the 1 of a formula for "
              "matrices is Eigen::Matrix3d::Identity()\n" +
              quote);
  CHECK(words_for("no member named 'cout' in namespace 'std'") ==
        place + "std::cout needs #include <iostream>\n" + quote);
  for (const char* kept : {"expected ';'", "invalid operands to binary expression ('A' and 'int')",
                           "no member named 'clamp' in namespace 'std'"})
    CHECK(words_for(kept) == place + kept + "\n  return v * v;\n           ^\n");
  CHECK(words_for("passing 'const V' as 'this' argument discards qualifiers [-fpermissive]")
            .starts_with(place + "this function changes the object that it is called on"));
}

TEST_CASE("the first error of a line in a header is told there, what follows from it is not") {
  CHECK(
      seen("/tmp/w/a.cpp:2:12:   required from here\n"
           "/usr/Eigen/Matrix.h:340:35: error: no matching function for call to '_init2<int, V>'\n"
           "  340 |   Base::template _init2<T0, T1>(x, y);\n"
           "/usr/Eigen/Plain.h:803:30: note: candidate: 'void _init2()'\n"
           "/tmp/w/a.cpp:2:12:   required from here\n"
           "/usr/Eigen/Plain.h:815:30: error: invalid use of incomplete type\n"
           "  815 |   _init2(x);\n") ==
      "/tmp/w/a.cpp:2:12: error: a vector is given its numbers one by one: {0, p[0], p[1], "
      "p[2]}, not {0, p}\n"
      "    2 |   return v * v;\n"
      "      |            ^\n"
      "/usr/Eigen/Plain.h:803:30: note: candidate: 'void _init2()'\n");
  CHECK(
      seen("/usr/stl_algo.h:7:8: error: no match for 'operator<'\n"
           "/tmp/w/a.cpp:2:12: note: in instantiation of function template 'x' requested here\n") ==
      "/tmp/w/a.cpp:2:12: error: no match for 'operator<'\n"
      "    2 |   return v * v;\n"
      "      |            ^\n");
}

TEST_CASE("what led nowhere in the file stays as it is") {
  for (const std::string output :
       {"/usr/a.hpp:1:1: error: static assertion failed: X\n",
        "/tmp/w/a.cpp:2:1: error: static assertion failed: mine\n 2 | static_assert(false);\n",
        "/usr/a.hpp:1:1: error: 'x' was not declared\n", ""})
    CHECK(seen(output) == output);
  // Words that are rare are Eigen's own; a line that the file hasn't is not quoted.
  CHECK(seen("/tmp/w/a.cpp:9:12:   required from here\n"
             "/usr/a.hpp:1:1: error: static assertion failed: X\n") ==
        "/tmp/w/a.cpp:9:12: error: X\n");
}

namespace {

/// What is said of an error, in the only line of a file, without that line.
std::string said_of(const std::string& line, std::size_t column, const std::string& words) {
  const std::string place = source + ":1:" + std::to_string(column) + ": error: ";
  const std::string output = header_errors_at(source, line + "\n", place + words + "\n");
  const std::string first = output.substr(0, output.find('\n'));
  return first.starts_with(place) ? first.substr(place.size()) : first;
}

}  // namespace

TEST_CASE(
    "characters that look like others are named, once for a line, in gcc's and clang's words") {
  CHECK(said_of("return\u00a0x;", 1, "extended character \u00a0 is not valid in an identifier") ==
        "this line contains a non-breaking space: type a plain space");
  CHECK(said_of("return x \u2212 1;", 10, "unexpected character <U+2212>") ==
        "this line contains a mathematical minus, −: type a plain one, -");
  CHECK(said_of("s = \u201ca\u201d;", 5, "unexpected character <U+201C>") ==
        "this line contains a typographic quote, “: type a plain one, \"");
  CHECK(said_of("x = 1 // a \u2212 b", 6, "expected ';'") == "expected ';'");
}

TEST_CASE("what is const is copied first, and ^ is no power") {
  const std::string start = "V a(const VectorXd& y, double h) { ";
  const auto column = [&](const std::string& rest, char c) {
    return start.size() + rest.find(c) + 1;
  };
  const std::string copy =
      "y is const, which you can't change: copy it first (Eigen::VectorXd next = y;), and change "
      "the copy";
  for (const char* words : {"no match for 'operator+=' (operand types are 'const Eigen::VectorXd')",
                            "no viable overloaded '+='"})
    CHECK(said_of(start + "y += h * f(t, y);", column("y += h", '+'), words) == copy);
  for (const char* words : {"assignment of read-only location 'y'",
                            "cannot assign to return value because function 'operator[]' returns"})
    CHECK(said_of(start + "y[0] = 1;", column("y[0] = 1;", '='), words) == copy);
  CHECK(said_of(start + "h += y;", column("h += y", '+'), "no viable overloaded '+='") ==
        "no viable overloaded '+='");
  for (const char* words : {"invalid operands of types 'const double' and 'int' to binary "
                            "'operator^'",
                            "invalid operands to binary expression ('const double' and 'int')"})
    CHECK(said_of("return r[1]^2;", 12, words) ==
          "in C++ ^ is no power: write x * x for x², or std::pow(x, n)");
}

TEST_CASE("^ is no power where the sum before it fails, too") {
  CHECK(said_of("return y + h^2 * f(y, t);", 10,
                "no match for 'operator+' (operand types are 'V')") ==
        "in C++ ^ is no power: write x * x for x², or std::pow(x, n)");
}

TEST_CASE("what a right-hand side takes") {
  const std::string takes = "f takes (t, y): first the time, then the state";
  CHECK(said_of("return y + h * f(y);", 17,
                "no match for call to '(const Rhs {aka …}) (double)'") == takes);
  CHECK(said_of("return y + h * f(y);", 16,
                "no matching function for call to object of type 'const Rhs' (aka '…')") == takes);
  const std::string other = "no match for call to '(const Other) (double)'";
  CHECK(said_of("return g(y);", 9, other) == other);
}
