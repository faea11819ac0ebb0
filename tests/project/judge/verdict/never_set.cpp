/// @file
/// The variable that a compiler says is used before it is set.
#include "judge/verdict/never_set.hpp"

#include <doctest/doctest.h>

using namespace tumble::judge;

namespace {

std::string variable(const std::string& warnings) {
  const auto found = never_set_in(warnings, "drift.cpp");
  return found ? found->variable + " at " + found->place : "none";
}

}  // namespace

TEST_CASE("never set: the words of gcc and of clang") {
  CHECK(variable("drift.cpp:18:10: warning: 'sum' is used uninitialized [-Wuninitialized]\n") ==
        "sum at drift.cpp:18");
  CHECK(variable("drift.cpp:9:1: warning: unused variable 'n' [-Wunused-variable]\n"
                 "drift.cpp:18:10: warning: 'body.a::Body::mass' may be used uninitialized "
                 "[-Wmaybe-uninitialized]\n") == "body.mass at drift.cpp:18");
  CHECK(variable("drift.cpp:35:11: warning: variable 'largest' may be uninitialized when used "
                 "here [-Wconditional-uninitialized]\n") == "largest at drift.cpp:35");
  CHECK(variable("drift.cpp:5:9: warning: variable 'x' is used uninitialized whenever 'if' "
                 "condition is false [-Wsometimes-uninitialized]\n") == "x at drift.cpp:5");
  // In a header, with a note on the student's variable.
  CHECK(variable("warning: 'largest' may be used uninitialized [-Wmaybe-uninitialized]\n"
                 "drift.cpp:28:10: note: 'largest' was declared here\n") ==
        "largest at drift.cpp:28");
  CHECK(variable("drift.cpp:7:3: warning: 'S.Eigen::Matrix<double, 3, 3>::m_storage' is used "
                 "uninitialized [-Wuninitialized]\n") == "S at drift.cpp:7");
}

TEST_CASE("never set: nothing where no variable is named") {
  for (const char* other :
       {"", "drift.cpp:18:10: warning: unused variable 'sum' [-Wunused-variable]\n",
        "drift.cpp:18:10: warning: '<anonymous>' may be used uninitialized\n",
        "warning: 'x' may be used uninitialized\n",
        "drift.cpp:3:2: warning: #warning is used uninitialized\n"})
    CHECK_MESSAGE(variable(other) == "none", other);
}

TEST_CASE("never set: what is declared without a value") {
  for (const char* one : {"double x;", "double largest, above = 0;", "  bool  found ;", "int n;"})
    CHECK_MESSAGE(declares_without_value(one), one);
  for (const char* none : {"double x = 0;", "double x{};", "double f(double a, double b) {",
                           "// double x;", "f(double x)", "double f(int n);", "return double(x);"})
    CHECK_MESSAGE(!declares_without_value(none), none);
}

TEST_CASE("never set: a name that is right keeps its words, and one that fits gets the variable") {
  Finding finding;
  finding.answer = 1.;
  name_variable(finding, {"sum", "a.cpp:3"});
  REQUIRE(finding.misconceptions.size() == 1);
  CHECK(finding.misconceptions[0].name == "never set");
  CHECK(finding.misconceptions[0].sentence.find("“sum” (a.cpp:3)") != std::string::npos);
  finding.misconceptions = {{"sign kept", "The sign.", ""}};
  name_variable(finding, {"sum", "a.cpp:3"});
  CHECK(finding.misconceptions[0].sentence == "The sign.");
  finding.misconceptions = {{"not a number", "NaN.", ""}};
  name_variable(finding, {"sum", "a.cpp:3"});
  CHECK(finding.misconceptions[0].sentence.starts_with("NaN. The compiler sees"));
}
