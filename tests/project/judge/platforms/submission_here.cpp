/// @file
/// One submission where a platform has put it, judged with the course in
/// tests/project/judge/course: what is said of it, and what is said when no time is left.
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

std::string solution(const std::string& unit) {
  return test::text_of(test::variable("TUMBLE_FIXTURE") / "solutions/01_crossing" /
                       (unit + ".cpp"));
}

/// A root as each platform lays it out.
struct Root {
  judge::WorkFolder work;
  fs::path path = work.path() / "root";

  Root() {
    fs::permissions(work.path(), fs::perms::owner_all | fs::perms::others_exec);
    test::write_file(path / "data" / "data.json", "{}");
    test::write_file(path / "submission_metadata.json", R"({"id": 1, "users": []})");
    for (const char* folder : {"student", "submission"}) fs::create_directories(path / folder);
  }
  CommandResult judged(const std::string& platform, const std::string& options = "",
                       const std::string& environment = "") const {
    return test::run_command("cd '" + path.string() + "' && " + environment + " '" +
                             test::variable("TUMBLE_FIXTURE_JUDGE").string() + "' platform " +
                             platform + " . " + options);
  }
  json results() const { return test::json_in(path / "results" / "results.json"); }
};

double points_of(const json& gradescope) {
  double sum = 0;
  for (const json& each : gradescope.at("tests")) sum += each.at("score").get<double>();
  return sum;
}

}  // namespace

TEST_CASE(
    "a folder solutions/ is handed in as well as any other, unless it lies beside exercises/") {
  const Root root;
  for (const char* unit : {"carry", "twice"})
    test::write_file(root.path / "submission/solutions/01_crossing" / (std::string(unit) + ".cpp"),
                     solution(unit));
  REQUIRE(root.judged("gradescope").status == 0);
  CHECK(points_of(root.results()) == 2);
  test::write_file(root.path / "submission/exercises/01_crossing/carry.cpp", solution("carry"));
  REQUIRE(root.judged("gradescope").status == 0);
  CHECK(points_of(root.results()) == 1);
}

TEST_CASE("no message holds a path of the machine, where the root is . as well") {
  const Root root;
  test::write_file(root.path / "exercises/01_crossing/carry.cpp",
                   "#include \"contract.hpp\"\nint x = ;\n");
  const fs::path summary = root.work.path() / "summary.md";
  const CommandResult judged =
      root.judged("github-actions", "", "GITHUB_STEP_SUMMARY=" + summary.string());
  REQUIRE_MESSAGE(judged.status == 1, judged.output);
  const std::string junit = test::text_of(root.path / "results" / "junit.xml");
  CHECK(test::contains(junit, "exercises/01_crossing/carry.cpp"));
  CHECK(test::contains(junit, "01_crossing/twice.cpp does not exist"));
  for (const std::string& text : {junit, test::text_of(summary), judged.output})
    CHECK_MESSAGE(!test::contains(text, root.work.path().string()), text);
}

TEST_CASE("hidden words are nowhere that students of GitHub can read them") {
  const Root root;
  test::write_file(root.path / "course.json", R"({"hidden": ["1.2"], "seed": 3})");
  test::write_file(root.path / "exercises/01_crossing/carry.cpp", solution("carry"));
  const CommandResult judged = root.judged("github-actions", "--course course.json");
  const std::string junit = test::text_of(root.path / "results" / "junit.xml");
  CHECK(test::contains(junit, "<failure message=\"hidden\"></failure>"));
  CHECK_FALSE(test::contains(junit + judged.output, "twice.cpp"));
}

TEST_CASE("PrairieLearn: what does not compile costs no attempt") {
  const Root root;
  test::write_file(root.path / "student/carry.cpp", solution("carry"));
  test::write_file(root.path / "student/twice.cpp", "#include \"contract.hpp\"\nint x = ;\n");
  REQUIRE(root.judged("prairielearn").status == 0);
  test::check_prairielearn(test::text_of(root.path / "results" / "results.json"));
  const json j = root.results();
  CHECK(j.at("gradable") == false);
  CHECK(j.at("format_errors") == json{"1.2: does not compile"});
  CHECK(test::contains(j.at("output"), "The compiler does not accept twice.cpp"));
  test::write_file(root.path / "student/twice.cpp", solution("twice"));
  REQUIRE(root.judged("prairielearn").status == 0);
  CHECK(root.results().at("score") == 1);
}

TEST_CASE("a deadline: what is not reached says so, and the results are whole") {
  const Root root;
  for (const char* unit : {"carry", "twice"})
    test::write_file(root.path / "submission" / (std::string(unit) + ".cpp"), solution(unit));
  const CommandResult late = root.judged("gradescope", "--deadline 1e-9");
  REQUIRE_MESSAGE(late.status == 0, late.output);
  CHECK(test::contains(late.output, "2 not judged: no time left"));
  test::check_gradescope(root.results());
  CHECK(points_of(root.results()) == 0);
  const json unreached = root.results();  // a range that begins with a temporary would be gone
  for (const json& each : unreached.at("tests"))
    CHECK(each.at("output") == "Not judged: no time left.");
  REQUIRE(root.judged("gradescope", "--deadline 1000").status == 0);
  CHECK(points_of(root.results()) == 2);
  CHECK(root.judged("gradescope", "--deadline 0").status == 2);
}

TEST_CASE("a flood of text in a result that a platform takes") {
  const Root root;
  const std::string printed = solution("twice") +
                              "\n#include <cstdio>\nnamespace {\nconst int flood = [] {\n"
                              "  for (int i = 0; i < 60000; ++i) std::fputc('x', stderr);\n"
                              "  return 0;\n}();\n}\n";
  std::string wrong = printed;
  wrong.replace(wrong.find("return f("), 9, "return 2 * f(");
  test::write_file(root.path / "student/twice.cpp", wrong);
  REQUIRE(root.judged("prairielearn").status == 0);
  const std::string text = test::text_of(root.path / "results" / "results.json");
  CHECK(text.size() < 20'000);
  CHECK(test::contains(text, "It printed"));
}
