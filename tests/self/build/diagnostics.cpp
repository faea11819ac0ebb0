/// @file
/// What a student sees of the compiler's messages.
#include "judge/build/diagnostics.hpp"

#include <doctest/doctest.h>

#include <string>

using tumble::judge::messages_about;

TEST_CASE("messages about the student's file are kept, with the lines that they point at") {
  CHECK(messages_about("/tmp/w/a.cpp",
                       "/tmp/w/a.cpp:3:5: error: expected ';'\n    3 |   x\n      |    ^\n",
                       false) == "a.cpp:3:5: error: expected ';'\n    3 |   x\n      |    ^\n");
}

TEST_CASE("the text of other files does not get through") {
  const std::string output =
      "In file included from /tmp/w/a.cpp:1:\n"
      "/secret/tests.cpp:7:1: error: 'answer' does not name a type\n"
      "    7 | answer = 42;\n      | ^~~~~~\n"
      "/tmp/w/a.cpp:9:1: error: expected '}'\n    9 | {\n";
  CHECK(messages_about("/tmp/w/a.cpp", output, false) ==
        "a.cpp:9:1: error: expected '}'\n    9 | {\n");
  CHECK(messages_about("/tmp/w/a.cpp", output, true) ==
        "error: 'answer' does not name a type\na.cpp:9:1: error: expected '}'\n    9 | {\n");
}

TEST_CASE("a flood of messages is cut") {
  std::string output;
  for (int i = 0; i < 1000; ++i) output += "/tmp/w/a.cpp:1:1: error: again\n";
  CHECK(messages_about("/tmp/w/a.cpp", output, true).size() < 2000);
}
