/// @file
/// A hand-out as a student gets it: untouched it scores nothing, with the solutions copied in
/// everything, and its own tests pass.
#include <doctest/doctest.h>

#include <filesystem>

#include "judge/build/work_folder.hpp"
#include "self/attacks/submission.hpp"
#include "support/command.hpp"

using namespace tumble;
using test::CommandResult;
namespace fs = std::filesystem;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("hand-out: 0 as it is, everything with the solutions") {
  const judge::WorkFolder work;
  fs::permissions(work.path(), fs::perms::owner_all | fs::perms::others_exec);
  const fs::path tree = work.path() / "course";
  const std::string program = "'" + test::variable("TUMBLE_JUDGE").string() + "' ";
  const CommandResult made =
      test::run_command(program + "handout --chapters 1 '" + tree.string() + "'");
  REQUIRE_MESSAGE(made.status == 0, made.output);
  CHECK(contains(made.output, "1 chapters, 5 exercises"));

  CHECK_FALSE(fs::exists(tree / "solutions"));
  for (const char* other : {"exercises/02_solvers/adaptive_step_size.cpp", "tests/self",
                            "tests/02_solvers", "chapters/02_solvers/README.md", "tests/attacks"})
    CHECK_MESSAGE(!fs::exists(tree / other), other);

  const std::string tumble = "cd '" + tree.string() + "' && ./tumble --no-install ";
  const CommandResult untouched = test::run_command(tumble + "check all");
  CHECK_MESSAGE(untouched.status == 1, untouched.output);
  CHECK_MESSAGE(contains(untouched.output, "0 of 5 units pass"), untouched.output);
  CHECK(contains(test::run_command(tumble + "solution 1.1 --anyway").output, "has no solutions"));

  const fs::path solutions = test::root() / "solutions" / "01_particles";
  for (const fs::directory_entry& file : fs::directory_iterator(solutions))
    fs::copy_file(file.path(), tree / "exercises" / "01_particles" / file.path().filename(),
                  fs::copy_options::overwrite_existing);
  const CommandResult solved = test::run_command(tumble + "check all");
  CHECK_MESSAGE(solved.status == 0, solved.output);
  CHECK(contains(solved.output, "5 of 5 units pass"));

  CHECK(contains(test::run_command(tumble + "handout --chapters 1 x").output,
                 "this tree is a hand-out itself"));
}
