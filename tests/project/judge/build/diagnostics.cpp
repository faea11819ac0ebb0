/// @file
/// What a student sees of the compiler's messages.
#include "judge/build/diagnostics.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

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

TEST_CASE("the functions that a linker misses, whichever linker it is") {
  CHECK(tumble::judge::undefined_functions(
            "ld.lld: error: undefined symbol: quaternions::inverse(Eigen::Matrix<double, 4, 1>)\n"
            ">>> referenced by product.cpp:3\n>>> product.o:(quaternions::product(int))\n") ==
        std::vector<std::string>{"quaternions::inverse"});
  CHECK(tumble::judge::undefined_functions(
            "/usr/bin/ld: product.o: in function `quaternions::product(int)':\n"
            "product.cpp:3: undefined reference to `quaternions::inverse(int)'\n"
            "product.cpp:4: undefined reference to `quaternions::inverse(int)'\n") ==
        std::vector<std::string>{"quaternions::inverse"});
}

TEST_CASE("the functions that a linker finds twice, whichever linker it is") {
  const std::vector<std::string> cross{"momentum::cross"};
  using tumble::judge::duplicate_functions;
  CHECK(duplicate_functions("ld.lld: error: duplicate symbol: momentum::cross(int)\n"
                            ">>> defined at torque.cpp:3\n") == cross);
  CHECK(duplicate_functions("/usr/bin/ld: b.o: in function `momentum::cross(int)':\n"
                            "torque.cpp:3: multiple definition of `momentum::cross(int)'; "
                            "a.o:a.cpp:3: first defined here\n") == cross);
  CHECK(duplicate_functions("mold: error: duplicate symbol: a.o: b.o: momentum::cross(int)\n") ==
        cross);
}
