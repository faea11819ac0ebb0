/// @file
/// What a wrong command line is told, whatever CLI11 says.
#include "support/command_line.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace tumble::support;

namespace {

/// What is said of these arguments to a program that takes a point and a count.
std::string said_of(std::vector<const char*> arguments) {
  CLI::App app("", "./tumble");
  std::vector<double> point;
  int count = 0;
  app.add_option("--about", point)->expected(3);
  app.add_option("number", count);
  arguments.insert(arguments.begin(), "program");
  try {
    app.parse(static_cast<int>(arguments.size()), arguments.data());
  } catch (const CLI::ParseError& error) {
    return complaint(app, error);
  }
  return "";
}

}  // namespace

TEST_CASE("values that are too few, too many or no numbers are told in plain words") {
  CHECK(said_of({"--about", "1", "2", "3"}) == "");
  CHECK(said_of({"--about", "nope"}) == "--about: at least 3 values are expected, not 1");
  CHECK(said_of({"--about", "a", "b", "c"}) == "--about: 'a,b,c' is not a number");
  CHECK(said_of({"--about"}) == "--about: a value is missing");
  CHECK(said_of({"x"}) == "number: 'x' is not a number");
  CHECK(said_of({"--abut"}) == "there is no option '--abut'; did you mean --about?");
}
