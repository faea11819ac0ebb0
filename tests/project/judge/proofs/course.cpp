/// @file
/// The course is sound: what is written down for students holds for every unit.
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "judge_command.hpp"

using namespace tumble::test;

namespace {

/// A file of the tree.
std::string text_of(const std::string& path) {
  const char* root = std::getenv("TUMBLE_ROOT");
  tumble::require(root != nullptr, "ctest sets TUMBLE_ROOT");
  std::ifstream file(std::string(root) + "/" + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("the kill matrix: every misconception is failed by its spec, and named") {
  const CommandResult matrix = judge("matrix all --seed 1");
  CHECK_MESSAGE(matrix.status == 0, matrix.output);
  CHECK_MESSAGE(
      text_of("tests/project/kill_matrix.md").ends_with(matrix.output),
      "the table in the tree is another: write it anew with ./tumble matrix all --seed 1");
}

TEST_CASE("the page of what students get wrong is the one that the specs give") {
  CHECK_MESSAGE(text_of("chapters/for_instructors/what_students_get_wrong.md") ==
                    judge("matrix all --page").output,
                "write it anew: ./tumble matrix all --page");
}

TEST_CASE("every stub is untouched, has its hints, and fails every case of its spec") {
  check_that_it_succeeds("stubs");
}

TEST_CASE("every solution passes, with a few seeds") {
  check_that_it_succeeds("check all --solutions --seed 1 --seeds 3");
}
