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

TEST_CASE("why each overload of a library does not fit is left out") {
  CHECK(messages_about("/tmp/w/a.cpp",
                       "/tmp/w/a.cpp: In function 'int f()':\n"
                       "/tmp/w/a.cpp:3:5: error: no match for 'operator*'\n    3 |   x\n"
                       "/tmp/w/a.cpp:3:5: note:   couldn't deduce template parameter 'T'\n"
                       "    3 |   x\n      |    ^\n",
                       true) ==
        "a.cpp: In function 'int f()':\na.cpp:3:5: error: no match for 'operator*'\n    3 |   x\n");
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

TEST_CASE("types of Eigen have the names that one writes") {
  CHECK(messages_about(
            "/tmp/w/a.cpp",
            "/tmp/w/a.cpp:3:5: error: cannot convert 'Eigen::Vector3d' {aka "
            "'Eigen::Matrix<double, 3, 1>'} to 'Eigen::DenseCoeffsBase<Eigen::Matrix<double, "
            "3, 3, 0, 3, 3>, 1>::Scalar' {aka 'double'}\n"
            "    3 | Eigen::Matrix<double, 3, 1> v;\n",
            false) ==
        "a.cpp:3:5: error: cannot convert 'Eigen::Vector3d' to 'double'\n"
        "    3 | Eigen::Matrix<double, 3, 1> v;\n");
  CHECK(messages_about("/tmp/w/a.cpp",
                       "/tmp/w/a.cpp:3:5: error: Eigen::Matrix<double, 2, 3> "
                       "Eigen::Matrix<double, -1, -1> Eigen::Matrix<double, 1, 4> "
                       "Eigen::Matrix<double, 99999999999, 1>\n",
                       false) ==
        "a.cpp:3:5: error: Eigen::Matrix<double, 2, 3> Eigen::MatrixXd Eigen::RowVector4d "
        "Eigen::Matrix<double, 99999999999, 1>\n");
}

TEST_CASE("the alternatives that gcc suggests stand with the suggestion") {
  CHECK(messages_about(
            "/tmp/w/a.cpp",
            "/tmp/w/a.cpp:3:5: error: 'Matrix3d' was not declared in this scope\n"
            "/tmp/w/a.cpp:3:5: note: suggested alternatives:\n"
            "/usr/include/eigen3/Eigen/src/Core/Matrix.h:506:1: note:   'Eigen::Matrix3d'\n"
            "  506 | EIGEN_MAKE_TYPEDEFS_ALL_SIZES(double, d)\n",
            true) ==
        "a.cpp:3:5: error: 'Matrix3d' was not declared in this scope\n"
        "a.cpp:3:5: note: suggested alternatives: 'Eigen::Matrix3d'\n");
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

TEST_CASE("a function of Eigen has a short name, others their own") {
  using tumble::judge::brief_name;
  CHECK(brief_name("Eigen::MatrixBase<Eigen::Matrix<double, 3, 1, 0, 3, 1> >::"
                   "cross_product_return_type<Eigen::Matrix<double, 3, 1, 0, 3, 1> >::type "
                   "Eigen::MatrixBase<Eigen::Matrix<double, 3, 1, 0, 3, 1> >::"
                   "cross<Eigen::Matrix<double, 3, 1, 0, 3, 1> >") == "cross");
  CHECK(brief_name("Eigen::MatrixBase<Eigen::Matrix<double, 3, 3, 0, 3, 3> >::inverse") ==
        "inverse");
  CHECK(brief_name("quaternions::inverse") == "quaternions::inverse");
  CHECK(brief_name("Eigen::>>") == "Eigen::>>");
}

TEST_CASE("forgotten parentheses are named, which gcc does not") {
  using tumble::judge::advice_on;
  CHECK(advice_on("a.cpp:4:40: error: no matching function for call to 'Eigen::Matrix<double, 3, "
                  "1>::Matrix(<unresolved overloaded function type>)'\n")
            .starts_with("(Parentheses forgotten?"));
  CHECK(advice_on("a.cpp:1:1: error: 'x' was not declared in this scope\n").empty());
  for (const char* missing :
       {"a.cpp:8:10: error: 'Quaterniond' is not a member of 'Eigen'\n",
        "a.cpp:8:10: error: no member named 'Quaterniond' in namespace 'Eigen'\n"})
    CHECK(advice_on(missing).find("Eigen/Core alone, and Quaterniond is not") != std::string::npos);
}

TEST_CASE("a contract that is looked for in another folder: the right line is given") {
  using tumble::judge::advice_on;
  for (const char* missing :
       {"a.cpp:1:10: fatal error: ../contract.hpp: No such file or directory\n",
        "a.cpp:1:10: fatal error: '../contract.hpp' file not found\n"})
    CHECK(advice_on(missing) == "(Write #include \"contract.hpp\", without a folder.)\n");
  CHECK(advice_on("a.cpp:1:10: fatal error: matrix.hpp: No such file or directory\n").empty());
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

TEST_CASE("a compiler that was killed says so itself: nobody else's words count") {
  using tumble::judge::says_that_it_was_killed;
  CHECK(says_that_it_was_killed(
      "c++: fatal error: Killed signal terminated program cc1plus\ncompilation terminated.\n"));
  CHECK(says_that_it_was_killed(
      "/tmp/w/a.cpp:3:2: warning: unused\n    3 | int x;\n      |     ^\n"
      "g++-12: fatal error: Killed signal terminated program cc1plus\ncompilation terminated.\n"));
  CHECK(says_that_it_was_killed("g++: internal compiler error: Killed (program cc1plus)\n"));
  CHECK(says_that_it_was_killed(
      "collect2: fatal error: ld terminated with signal 9 [Killed]\ncompilation terminated.\n"));
  CHECK(says_that_it_was_killed(
      "clang: error: unable to execute command: Killed\n"
      "clang: error: clang frontend command failed due to signal (use -v to see invocation)\n"
      "Debian clang version 14.0.6\nclang: note: diagnostic msg: Error generating\n"));
  for (const char* forged :
       {"", "/tmp/w/a.cpp:1:2: warning: #warning \"Killed signal\" [-Wcpp]\n",
        "/tmp/w/a.cpp:1:2: error: #error c++: fatal error: Killed signal terminated program x\n",
        "    1 | c++: fatal error: Killed signal terminated program cc1plus\n",
        "/tmp/w/a.cpp:1:9: note: '#pragma message: \n"
        "c++: fatal error: Killed signal terminated program cc1plus'\n    1 | #pragma message\n",
        "c++: fatal error: Killed signal terminated program cc1plus\n"
        "/tmp/w/a.cpp:9:1: error: expected '}'\n",
        "/tmp/c++: fatal error: Killed signal terminated program cc1plus\n",
        "collect2: error: ld returned 1 exit status: signal 9 [Killed]\n"})
    CHECK_MESSAGE(!says_that_it_was_killed(forged), std::string(forged));
}
