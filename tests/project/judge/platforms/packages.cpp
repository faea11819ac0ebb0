/// @file
/// What `export` makes for each platform: what has to be where, and that nothing is given away.
#include <doctest/doctest.h>

#include <fstream>
#include <set>

#include "judge/build/work_folder.hpp"
#include "project/harness/command.hpp"
#include "project/judge/platforms/files.hpp"
#include "project/judge/platforms/schemas.hpp"

using namespace tumble;
using nlohmann::json;
using test::CommandResult;
namespace fs = std::filesystem;

namespace {

struct Packages {
  judge::WorkFolder work;

  explicit Packages(const std::string& settings) {
    std::ofstream(work.path() / "course.json") << settings;
  }
  fs::path operator[](const std::string& platform) const { return work.path() / platform; }

  CommandResult make(const std::string& platform, const std::string& options = "") const {
    return test::run_command("'" + test::variable("TUMBLE_JUDGE").string() + "' export " +
                             platform + " '" + (*this)[platform].string() + "' --course '" +
                             (work.path() / "course.json").string() + "' " + options);
  }
};

/// The paths of the files in a folder, from there.
std::set<std::string> files_in(const fs::path& folder) {
  std::set<std::string> paths;
  for (const fs::directory_entry& each : fs::recursive_directory_iterator(folder))
    if (each.is_regular_file()) paths.insert(each.path().lexically_relative(folder).string());
  return paths;
}

bool is_executable(const fs::path& file) {
  return (fs::status(file).permissions() & fs::perms::owner_exec) != fs::perms::none;
}

const char* const chapter_1 =
    R"({"title": "Homework 1: particles", "units": ["1"], "weights": {"1.2": 3},
        "due": "2026-12-01T23:59+01:00", "seed": 7})";

}  // namespace

/// No file in the folder holds a word that was to be filled in.
void check_filled(const fs::path& folder) {
  for (const char* file : {"README.md", "bundle/autograder.py", "image/Dockerfile",
                           "repository/.github/workflows/tumble.yml"})
    if (fs::exists(folder / file))
      for (const char* word : {"@TITLE@", "@LIMIT@", "@DEADLINE@", "@MINUTES@", "@IMAGE@", "@QID@",
                               "@COPY@", "@ASSESS@", "@CURVE@", "@POINTS@"})
        CHECK_MESSAGE(!test::contains(test::text_of(folder / file), word), file << word);
}

/// The seed of the course is not what the public package holds; that is another one.
void check_no_secret_seed(const json& settings) {
  CHECK(settings.at("seed").is_number_integer());
  CHECK(settings.at("seed") != 7);
}

TEST_CASE("export: one point is one point") {
  const Packages packages(R"({"units": ["1.2"]})");
  REQUIRE(packages.make("gradescope").status == 0);
  CHECK(test::contains(test::text_of(packages["gradescope"] / "README.md"),
                       "a programming assignment worth 1 point. *Configure"));
}

TEST_CASE("export: Gradescope's zip has the two scripts at its root, and the solutions") {
  const Packages packages(chapter_1);
  const CommandResult made = packages.make("gradescope");
  REQUIRE_MESSAGE(made.status == 0, made.output);
  const fs::path source = packages.work.path() / "source";
  fs::create_directory(source);
  const CommandResult unzipped =
      test::run_command("cd '" + source.string() + "' && cmake -E tar xf '" +
                        (packages["gradescope"] / "autograder.zip").string() + "'");
  REQUIRE_MESSAGE(unzipped.status == 0, unzipped.output);
  for (const char* script : {"setup.sh", "run_autograder", "tumble/tumble"})
    CHECK_MESSAGE(is_executable(source / script), script);
  const std::set<std::string> files = files_in(source);
  CHECK(files.count("tumble/solutions/01_particles/dydt.cpp") == 1);
  CHECK(files.count("tumble/solutions/02_solvers/adaptive_step_size.cpp") == 0);
  CHECK(test::json_in(source / "tumble" / "course.json").at("seed") == 7);
  CHECK(test::text_of(packages["gradescope"] / "README.md").find("worth 7 points") !=
        std::string::npos);
  check_filled(packages["gradescope"]);
  CHECK(test::contains(test::text_of(source / "run_autograder"), " --deadline 480\n"));
}

TEST_CASE("export: a limit of time that the instructor has changed") {
  const CommandResult longer = Packages(chapter_1).make("github-actions", "--limit 1200");
  REQUIRE_MESSAGE(longer.status == 0, longer.output);
  const CommandResult too_long = Packages(chapter_1).make("prairielearn", "--limit 900");
  CHECK(too_long.status == 2);
  CHECK(test::contains(too_long.output, "the limit is 900 s"));
}

TEST_CASE("export: what is public for PrairieLearn has no solutions, what is not has them") {
  const Packages packages(chapter_1);
  const CommandResult made = packages.make("prairielearn");
  REQUIRE_MESSAGE(made.status == 0, made.output);
  const fs::path folder = packages["prairielearn"];
  test::check_prairielearn_question(test::json_in(folder / "question" / "info.json"));
  const std::set<std::string> image = files_in(folder / "image");
  for (const std::string& file : image) CHECK(file.find("solutions/") == std::string::npos);
  CHECK(image.count("tumble/exercises/09_rigid_body/dydt.cpp") == 1);  // one image for all
  const std::set<std::string> question = files_in(folder / "question");
  for (const char* file :
       {"tests/solutions/01_particles/dydt.cpp", "tests/course.json", "question.html",
        "clientFilesQuestion/dydt.cpp", "clientFilesQuestion/01_particles/contract.hpp"})
    CHECK_MESSAGE(question.count(file) == 1, file);
  const std::string html = test::text_of(folder / "question" / "question.html");
  CHECK(html.find("optional-file-names=\"flatten.cpp,dydt.cpp,") != std::string::npos);
  CHECK(html.find("@") == std::string::npos);
  CHECK(html.find("std::vector&lt;Particle&gt;&amp;") != std::string::npos);
  check_filled(folder);

  const CommandResult two = Packages("{}").make("prairielearn");
  CHECK(two.status == 2);
  CHECK(two.output.find("1.2 and 9.4 dydt cannot be in one question") != std::string::npos);
}

TEST_CASE("export: an exercise that is extra is a question like the others") {
  const Packages packages(R"({"title": "HW 1", "units": ["1.1", "1.2"], "extra": ["1.2"]})");
  const CommandResult made = packages.make("prairielearn", "--each");
  REQUIRE_MESSAGE(made.status == 0, made.output);
  CHECK(test::contains(made.output, R"("maxPoints": 1 and "maxBonusPoints": 1)"));
  for (const char* name : {"1-1-flatten", "1-2-dydt"})
    CHECK_FALSE(
        test::json_in(packages["prairielearn"] / "questions/hw-1" / name / "tests/course.json")
            .contains("extra"));
}

TEST_CASE("export: a question for each exercise, each with its points and its deadline") {
  const Packages packages(R"({"title": "HW 1", "units": ["1.1", "1.2", "9.4"], "seed": 7,
      "weights": {"1.2": 3}, "hidden": ["9.4"]})");
  const CommandResult made = packages.make("prairielearn", "--each --image owner/judge:2");
  REQUIRE_MESSAGE(made.status == 0, made.output);
  const fs::path folder = packages["prairielearn"], questions = folder / "questions" / "hw-1";
  std::set<std::string> ids;
  for (const char* name : {"1-1-flatten", "1-2-dydt", "9-4-dydt"}) {
    CAPTURE(name);
    const json info = test::json_in(questions / name / "info.json");
    test::check_prairielearn_question(info);
    ids.insert(info.at("uuid").get<std::string>());
    const json grader = info.at("externalGradingOptions");
    CHECK(grader.at("image") == "owner/judge:2");
    const int deadline = std::stoi(grader.at("entrypoint").back().get<std::string>());
    CHECK(deadline + 120 <= grader.at("timeout").get<int>());
  }
  CHECK(ids.size() == 3);
  const json dydt = test::json_in(questions / "1-2-dydt" / "tests" / "course.json");
  CHECK(dydt.at("units") == json{"1.2"});
  CHECK(dydt.at("weights") == json{{"1.2", 3}});
  CHECK(dydt.at("seed") == 7);
  CHECK_FALSE(dydt.contains("hidden"));
  CHECK(test::json_in(questions / "9-4-dydt" / "tests" / "course.json").at("hidden") ==
        json{"9.4"});
  CHECK(fs::exists(questions / "9-4-dydt" / "tests/solutions/08_mirtich/mass_properties.cpp"));
  CHECK_FALSE(fs::exists(questions / "1-2-dydt" / "tests/solutions/02_solvers"));
  const json zones = test::json_in(folder / "zones.json");
  CHECK(zones.at("zones")[0].at("questions")[1] == json{{"id", "hw-1/1-2-dydt"}, {"points", 3}});
  check_filled(folder);
}

TEST_CASE("export: names of images are checked before anything is made") {
  const Packages packages(chapter_1);
  const CommandResult wrong = packages.make("prairielearn", "--image OWNER/judge");
  CHECK(wrong.status == 2);
  CHECK(test::contains(wrong.output, "did you mean owner/judge?"));
  CHECK(test::contains(packages.make("gradescope", "--each").output, "--each is for PrairieLearn"));
}

TEST_CASE("export: what students can read neither holds the seed nor hides anything") {
  for (const char* platform : {"classroom50", "github-actions"}) {
    const CommandResult hiding = Packages(R"({"units": ["1"], "hidden": ["1.4"]})").make(platform);
    CHECK(hiding.status == 2);
    CHECK(test::contains(hiding.output, std::string(platform) + " hides nothing"));
  }
}

TEST_CASE("export: Classroom 50's bundle is public and small, its template a hand-out") {
  const Packages packages(chapter_1);
  const CommandResult made = packages.make("classroom50");
  REQUIRE_MESSAGE(made.status == 0, made.output);
  const fs::path folder = packages["classroom50"];
  const json assignment = test::json_in(folder / "assignment.json");
  test::check_classroom50_assignment(assignment);
  CHECK(assignment.at("due") == "2026-12-01T23:59:00+01:00");
  for (const std::string& file : files_in(folder))
    CHECK(file.find("solutions/") == std::string::npos);
  check_filled(folder);
  check_no_secret_seed(test::json_in(folder / "bundle" / "course.json"));
  CHECK(test::contains(made.output, "has a seed of its own"));
  CHECK(fs::exists(folder / "template" / "exercises" / "01_particles" / "dydt.cpp"));
  std::uintmax_t bytes = 0;
  for (const std::string& file : files_in(folder / "bundle"))
    bytes += fs::file_size(folder / "bundle" / file);
  CHECK(bytes < (10 << 20));  // what the runner fetches at most, packed
}

TEST_CASE("export: what students can read names no student") {
  const Packages packages(R"({"title": "HW 1", "units": ["1"], "due": "2026-12-01T23:59:00Z",
      "late": {"per_day": 10}, "extensions": {"doe, jane": "2026-12-08T23:59:00Z"},
      "overrides": {"kim zetsu": {"points": 3, "reason": "fell off a horse"}}})");
  for (const auto& [platform, settings] : std::map<std::string, std::string>{
           {"classroom50", "bundle/course.json"}, {"github-actions", "repository/course.json"}}) {
    const CommandResult made = packages.make(platform);
    REQUIRE_MESSAGE(made.status == 0, made.output);
    CHECK(test::contains(made.output, R"("extensions", "overrides" of your course.json are left)"));
    for (const std::string& file : files_in(packages[platform]))
      for (const char* secret : {"doe, jane", "a horse", "kim zetsu"})
        CHECK_MESSAGE(!test::contains(test::text_of(packages[platform] / file), secret), file);
    const json public_json = test::json_in(packages[platform] / settings);
    CHECK(public_json.at("late") == json{{"per_day", 10}});
    CHECK(public_json.at("due") == "2026-12-01T23:59:00Z");
  }
  REQUIRE(packages.make("gradescope").status == 0);  // which only instructors read
}

TEST_CASE("export: a repository for GitHub, and refusals that say what is wrong") {
  const Packages packages(chapter_1);
  const CommandResult made = packages.make("github-actions");
  REQUIRE_MESSAGE(made.status == 0, made.output);
  const fs::path repository = packages["github-actions"] / "repository";
  CHECK(is_executable(repository / "tumble"));
  CHECK_FALSE(fs::exists(repository / "solutions"));
  const std::string workflow = test::text_of(repository / ".github/workflows/tumble.yml");
  CHECK(test::contains(workflow, "platform github-actions . --course course.json --deadline 480"));
  check_filled(packages["github-actions"]);
  check_no_secret_seed(test::json_in(repository / "course.json"));
  CHECK(test::contains(made.output, "has a seed of its own"));
  // Built, kept, judged: in this order, or a verdict that fails the job costs the next one a build.
  std::size_t at = 0;
  for (const char* step : {"actions/cache/restore@", "./tumble prepare ", "actions/cache/save@",
                           "if: always()", "./tumble --no-install platform "}) {
    CHECK_MESSAGE(workflow.find(step, at) != std::string::npos, step);
    at = workflow.find(step, at);
  }

  CHECK(packages.make("github-actions").output.find("exists already") != std::string::npos);
  CHECK(packages.make("moodle").output.find("there are: gradescope, prairielearn") !=
        std::string::npos);
  const CommandResult wrong = Packages(R"({"units": ["1"], "weight": {}})").make("gradescope");
  CHECK(wrong.status == 2);
  CHECK(wrong.output.find("\"weight\", which means nothing here") != std::string::npos);
}
