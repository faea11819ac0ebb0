/// @file
/// The curves of a student's engine travel with the grade, if a function of it is the student's.
#include <doctest/doctest.h>

#include "judge/build/work_folder.hpp"
#include "project/harness/command.hpp"
#include "project/judge/platforms/files.hpp"
#include "project/judge/platforms/schemas.hpp"

using namespace tumble;
using nlohmann::json;
using test::CommandResult;
namespace fs = std::filesystem;

namespace {

/// What a platform gets for one exercise: 4.8, `text` in its file.
json results_of(const std::string& platform, const std::string& text, const fs::path& root) {
  test::write_file(root / "course.json", R"({"units": ["4.8"], "curve": true})");
  for (const char* folder : {"student", "submission"})
    test::write_file(root / folder / "quaternion_dot.cpp", text);
  test::write_file(root / "data" / "data.json", "{}");
  test::write_file(root / "submission_metadata.json", R"({"id": 1, "users": []})");
  const CommandResult run = test::run_command(
      "'" + test::variable("TUMBLE_JUDGE").string() + "' platform " + platform + " '" +
      root.string() + "' --course '" + (root / "course.json").string() + "'");
  REQUIRE_MESSAGE(run.status == 0, run.output);
  return json::parse(test::text_of(root / "results" / "results.json"));
}

const fs::path dot_solution = test::root() / "solutions/04_quaternions/quaternion_dot.cpp";
const fs::path dot_stub = test::root() / "exercises/04_quaternions/quaternion_dot.cpp";

}  // namespace

TEST_CASE("the student's curve: an image for PrairieLearn, a page for Gradescope") {
  const judge::WorkFolder work;
  const json learnt = results_of("prairielearn", test::text_of(dot_solution), work.path());
  test::check_prairielearn(learnt.dump());
  CHECK(learnt.at("score") == 1);
  REQUIRE(learnt.contains("images"));
  const json scoped = results_of("gradescope", test::text_of(dot_solution), work.path());
  test::check_gradescope(scoped);
  CHECK(scoped.at("output_format") == "html");
}

TEST_CASE("the student's curve: none where nothing is the student's") {
  const judge::WorkFolder work;
  const json learnt = results_of("prairielearn", test::text_of(dot_stub), work.path());
  CHECK(learnt.at("score") == 0);
  CHECK_FALSE(learnt.contains("images"));
}
