/// @file
/// The course is sound: what is written down for students holds for every unit.
#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "project/harness/command.hpp"

using tumble::test::CommandResult;
using tumble::test::run_command;

namespace {

CommandResult judge(const std::string& arguments) {
  const char* program = std::getenv("TUMBLE_JUDGE");
  tumble::require(program != nullptr, "ctest sets TUMBLE_JUDGE");
  return run_command("'" + std::string(program) + "' " + arguments);
}

}  // namespace

TEST_CASE("the kill matrix: every misconception is failed by its spec, and named") {
  for (const char* seed : {"1", "2", "3"}) {
    const CommandResult matrix = judge(std::string("matrix all --seed ") + seed);
    CHECK_MESSAGE(matrix.status == 0, matrix.output);
  }
}

TEST_CASE("the table of misconceptions in the tree is the one that the specs give") {
  const char* root = std::getenv("TUMBLE_ROOT");
  REQUIRE(root != nullptr);
  std::ifstream file(std::string(root) + "/tests/project/kill_matrix.md");
  const std::string table{std::istreambuf_iterator<char>(file), {}};
  const std::string now = judge("matrix all --seed 1").output;
  CHECK_MESSAGE(table.ends_with(now), "write it anew: ./tumble matrix all --seed 1");
}

TEST_CASE("the page of what students get wrong is the one that the specs give") {
  const char* root = std::getenv("TUMBLE_ROOT");
  REQUIRE(root != nullptr);
  std::ifstream file(std::string(root) + "/chapters/for_instructors/what_students_get_wrong.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  CHECK_MESSAGE(page == judge("matrix all --page").output,
                "write it anew: ./tumble matrix all --page");
}

TEST_CASE("every stub is untouched, has its hints, and fails every case of its spec") {
  const CommandResult stubs = judge("stubs");
  CHECK_MESSAGE(stubs.status == 0, stubs.output);
}

TEST_CASE("every solution passes, with many seeds") {
  const CommandResult check = judge("check all --solutions --seed 1 --seeds 10");
  CHECK_MESSAGE(check.status == 0, check.output);
}

TEST_CASE("every solution passes with AddressSanitizer and UndefinedBehaviorSanitizer") {
  const CommandResult check = judge("check all --solutions --seed 1 --sanitize");
  CHECK_MESSAGE(check.status == 0, check.output);
}
