/// @file
/// What is said of a worker that has ended: the assertion that it has printed, in the words of each
/// library.
#include "judge/conversation/endings.hpp"

#include <doctest/doctest.h>
#include <signal.h>

using tumble::judge::crashed, tumble::judge::Outcome, tumble::judge::tells_an_assertion,
    tumble::judge::threw;

namespace {

std::string told(const std::string& printed) { return crashed(SIGABRT, printed).what(); }

}  // namespace

TEST_CASE("an assertion is told, as glibc, libstdc++, wasi-libc and libc++ print it") {
  CHECK(told("x: x.cpp:3: int f(): Assertion `a == 1' failed.\n") == "an assertion failed, a == 1");
  CHECK(
      told(
          "/usr/v.h:1125: T& v::operator[](size_type): Assertion '__n < this->size()' failed.\n") ==
      "an assertion failed, __n < this->size() (an index out of range)");
  CHECK(told("Assertion failed: index >= 0 && index < size() (Eigen/a.h: operator(): 181)\n") ==
        "an assertion failed, index >= 0 && index < size() (an index out of range)");
  CHECK(told("/v.h:9: libc++ Hardening assertion __n < size() failed: vector[] index out of "
             "bounds\n") == "an assertion failed, __n < size() (an index out of range)");
}

TEST_CASE("an index out of range is called so, in the words of each library's at()") {
  const auto said = [](const std::string& what) { return std::string(threw(what).what()); };
  CHECK(said("vector") == "vector (an index out of range)");
  CHECK(said("vector::_M_range_check: __n (which is 2) >= this->size() (which is 0)") ==
        "vector::_M_range_check: __n (which is 2) >= this->size() (which is 0) (an index out of "
        "range)");
  CHECK(said("no such vector") == "no such vector");
}

TEST_CASE("what an assertion of Eigen's is about, and its words where it has some") {
  const auto about = [](const std::string& assertion) {
    return told("w: Eigen/a.h:3: f(): Assertion `" + assertion + "' failed.\n");
  };
  CHECK(about("row >= 0 && row < rows() && col >= 0 && col < cols()")
            .ends_with("cols() (an index out of range)"));
  for (const char* part :
       {"startRow >= 0 && BlockRows >= 0 && startRow + BlockRows <= xpr.rows() && startCol >= 0",
        "(i>=0) && ( ((BlockRows==1) && (BlockCols==XprType::ColsAtCompileTime) && i<xpr.rows())"})
    CHECK(
        about(part).ends_with("(a segment, a block, a row or a column that reaches past the end)"));
  for (const char* sizes :
       {"aLhs.rows() == aRhs.rows() && aLhs.cols() == aRhs.cols()", "size() == other.size()",
        "dst.rows() == src.rows() && dst.cols() == src.cols()"})
    CHECK(about(sizes).ends_with("(two vectors or matrices of different sizes)"));
  CHECK(
      about("(!check_transpose_aliasing_run_time_selector <typename Derived::Scalar,X>::run(d, o))"
            " && \"aliasing detected during transposition, use transposeInPlace() \" \"or evaluate "
            "the "
            "rhs into a temporary using .eval()\"") ==
      "an assertion failed, aliasing detected during transposition, use transposeInPlace() or "
      "evaluate the rhs into a temporary using .eval()");
  CHECK(about("a == 1 && b").ends_with("a == 1 && b"));
}

TEST_CASE("an abort is what the libraries print before it, or a call of abort()") {
  CHECK(told("") == "SIGABRT: abort() was called");
  CHECK(told("terminate called after throwing an instance of 'int'\n")
            .starts_with("SIGABRT: an exception was never caught"));
  CHECK(told("double free or corruption (out)\n").starts_with("SIGABRT: its memory was damaged"));
}

TEST_CASE("the last assertion counts, and none is no assertion") {
  CHECK(told("Assertion `a' failed.\nhello\nAssertion `b' failed.\nbye\n") ==
        "an assertion failed, b");
  CHECK(told("Assertion of mine\n").starts_with("SIGABRT: "));
  CHECK(told("").starts_with("SIGABRT: "));
}

TEST_CASE("other signals have their own words, whatever was printed") {
  const auto ending = crashed(SIGFPE, "Assertion `a' failed.\n");
  CHECK(ending.outcome == Outcome::crashed);
  CHECK(std::string(ending.what()).starts_with("SIGFPE: "));
}

TEST_CASE("a line that a student prints is kept, the assertion's is not") {
  CHECK_FALSE(tells_an_assertion("my Assertion "));
  CHECK(tells_an_assertion("x.cpp:3: int f(): Assertion `a == 1' failed."));
  CHECK(tells_an_assertion("Assertion failed: a == 1 (x.cpp: f: 3)"));
}
