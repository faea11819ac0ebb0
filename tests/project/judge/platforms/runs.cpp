/// @file
/// A hand-out as a student gets it, and the packages made of it as platforms run them: folders,
/// entry points, no network. One judge is built, without solutions; in the end they are added.
#include <doctest/doctest.h>

#include <filesystem>

#include "judge/build/work_folder.hpp"
#include "project/harness/command.hpp"
#include "project/judge/platforms/files.hpp"
#include "project/judge/platforms/schemas.hpp"

using namespace tumble;
using nlohmann::json;
using test::CommandResult;
namespace fs = std::filesystem;

namespace {

/// A command without a network, where the machine lets us.
std::string without_network(const std::string& command) {
  static const bool possible = test::run_command("unshare -n true").status == 0;
  return (possible ? "unshare -n sh -c \"" : "sh -c \"") + command + "\"";
}

const fs::path chapter_solutions = test::root() / "solutions" / "01_particles";
const char* const wrong_step =
    "#include \"contract.hpp\"\n"
    "namespace particles {\n"
    "Eigen::VectorXd euler_step(const Rhs& f, double t, const Eigen::VectorXd& y, double h) {\n"
    "  return y - h * f(t, y);\n"
    "}\n"
    "}\n";

/// A script of a package, as it is exported; in `folder`.
void take_from_package(const std::string& platform, const fs::path& script,
                       const fs::path& folder) {
  const judge::WorkFolder work;
  const fs::path package = work.path() / "package";
  const CommandResult made =
      test::run_command("'" + test::variable("TUMBLE_JUDGE").string() + "' export " + platform +
                        " '" + package.string() + "'");
  REQUIRE_MESSAGE(made.status == 0, made.output);
  if (fs::exists(package / "autograder.zip"))
    test::run_command("cd '" + package.string() + "' && cmake -E tar xf autograder.zip");
  fs::copy(package / script, folder);
}

struct BuiltCourse {
  judge::WorkFolder work;
  fs::path tree = work.path() / "tumble";
  std::string made;

  BuiltCourse() {
    fs::permissions(work.path(), fs::perms::owner_all | fs::perms::others_exec);
    const CommandResult handout =
        test::run_command("'" + test::variable("TUMBLE_JUDGE").string() +
                          "' handout --chapters 1 '" + tree.string() + "'");
    REQUIRE_MESSAGE(handout.status == 0, handout.output);
    made = handout.output;
    test::write_file(work.path() / "course.json",
                     R"({"title": "Homework 1", "units": ["1"], "seed": 7,
      "weights": {"1.3": 2}, "hidden": ["1.4"]})");
  }
  std::string tumble() const { return "'" + (tree / "tumble").string() + "' --no-install "; }
  std::string platform(const std::string& name, const fs::path& root) const {
    return (tree / "tumble").string() + " --no-install platform " + name + " " + root.string() +
           " --course " + (work.path() / "course.json").string();
  }
  CommandResult in_the_tree(const std::string& command) const {
    return test::run_command("cd '" + tree.string() + "' && " + tumble() + command);
  }
};

/// As a student gets it.
void check_as_handed_out(const BuiltCourse& course) {
  CHECK(test::contains(course.made, "1 chapter, 5 exercises"));
  CHECK_FALSE(fs::exists(course.tree / "solutions"));
  for (const char* other : {"exercises/02_solvers/adaptive_step_size.cpp", "tests/project",
                            "tests/02_solvers", "chapters/02_solvers/README.md", "solutions"})
    CHECK_MESSAGE(!fs::exists(course.tree / other), other);
  const CommandResult untouched = course.in_the_tree("check all");
  CHECK_MESSAGE(untouched.status == 1, untouched.output);
  CHECK_MESSAGE(test::contains(untouched.output, "0 of 5 exercises pass"), untouched.output);
  CHECK(test::contains(course.in_the_tree("solution 1.1 --anyway").output, "has no solutions"));
  CHECK(test::contains(course.in_the_tree("mine").output, "needs functions of every chapter"));
  CHECK(
      test::contains(course.in_the_tree("handout --chapters 1 x").output, "is a hand-out itself"));
}

/// Four of five files; what they call comes from the question's solutions.
void check_on_prairielearn(const BuiltCourse& course) {
  const fs::path grade = course.work.path() / "grade";
  for (const char* unit : {"flatten", "dydt", "midpoint_step", "rk4_step"})
    test::write_file(grade / "student" / (std::string(unit) + ".cpp"),
                     test::text_of(chapter_solutions / (std::string(unit) + ".cpp")));
  test::write_file(grade / "data" / "data.json", R"({"variant_seed": "12"})");
  fs::create_directories(grade / "tests" / "solutions");
  fs::copy(chapter_solutions, grade / "tests" / "solutions" / "01_particles");
  const CommandResult learnt =
      test::run_command(without_network(course.platform("prairielearn", grade)));
  REQUIRE_MESSAGE(learnt.status == 0, learnt.output);
  const std::string results = test::text_of(grade / "results" / "results.json");
  test::check_prairielearn(results);
  CHECK(json::parse(results).at("score").get<double>() == doctest::Approx(4.0 / 6));
  CHECK(json::parse(results).at("tests")[3].at("output") == "");  // hidden
}

/// The checkout is the student's repository, with a link where results go.
void check_on_classroom50(const BuiltCourse& course) {
  const fs::path checkout = course.work.path() / "checkout";
  test::write_file(checkout / "exercises/01_particles/euler_step.cpp",
                   test::text_of(chapter_solutions / "euler_step.cpp"));
  const fs::path not_ours = course.work.path() / "not_ours";
  test::write_file(not_ours, "not ours");
  fs::create_symlink(not_ours, checkout / "result.json");
  const fs::path bundle = course.work.path();  // tumble/ and course.json lie there
  take_from_package("classroom50", "bundle/autograder.py", bundle);
  const std::string environment =
      "CLASSROOM=c ASSIGNMENT=a ASSIGNMENT_TYPE=individual OWNER=ann COMMIT_URL=https://c "
      "RELEASE_URL=https://r REVIEW_URL=https://v SUBMISSION_TAG=submit/1 "
      "CLASSROOM50_BUNDLE_DIR=" +
      bundle.string();
  const CommandResult classroom =
      test::run_command("cd '" + checkout.string() + "' && " + environment + " python3 '" +
                        (bundle / "autograder.py").string() + "'");
  REQUIRE_MESSAGE(classroom.status == 0, classroom.output);
  CHECK(test::text_of(not_ours) == "not ours");
  test::check_classroom50(test::json_in(checkout / "result.json"));
  CHECK(test::json_in(checkout / "result.json").at("score") == 200);
  CHECK(test::contains(test::text_of(checkout / "release-body.md"), "2.00 of 6.00 points"));
}

/// In the student's tree: all solved, and then not.
void check_on_github_actions(const BuiltCourse& course) {
  for (const fs::directory_entry& file : fs::directory_iterator(chapter_solutions))
    fs::copy_file(file.path(), course.tree / "exercises/01_particles" / file.path().filename(),
                  fs::copy_options::overwrite_existing);
  const CommandResult solved = course.in_the_tree("check all");
  CHECK_MESSAGE(solved.status == 0, solved.output);
  CHECK(test::contains(solved.output, "5 of 5 exercises pass"));
  const fs::path summary = course.work.path() / "summary.md";
  const CommandResult pushed = test::run_command("GITHUB_STEP_SUMMARY=" + summary.string() + " " +
                                                 course.platform("github-actions", course.tree));
  CHECK_MESSAGE(pushed.status == 0, pushed.output);
  CHECK(test::contains(test::text_of(summary), "6.00 of 6.00 points"));
  CHECK(test::contains(test::text_of(course.tree / "results/junit.xml"),
                       "tests=\"5\" failures=\"0\""));
  test::write_file(course.tree / "exercises/01_particles/euler_step.cpp", wrong_step);
  CHECK(test::run_command(course.platform("github-actions", course.tree)).status == 1);
}

double points_in(const fs::path& autograder) {
  const json j = test::json_in(autograder / "results" / "results.json");
  test::check_gradescope(j);
  double points = 0;
  for (const json& each : j.at("tests")) points += each.at("score").get<double>();
  return points;
}

/// What the package's README tells instructors to try: a zip of solutions/ has all points.
void check_own_check_of_gradescope(const BuiltCourse& course, const fs::path& autograder) {
  const fs::path submission = autograder / "submission";
  fs::remove_all(submission);
  fs::create_directories(submission / "solutions");
  fs::copy(course.tree / "solutions" / "01_particles", submission / "solutions" / "01_particles");
  const CommandResult graded =
      test::run_command(without_network((autograder / "run_autograder").string()));
  REQUIRE_MESSAGE(graded.status == 0, graded.output);
  CHECK(points_in(autograder) == 6);
}

/// The tree has the chapter_solutions, too.
void check_on_gradescope(const BuiltCourse& course) {
  const fs::path autograder = course.work.path() / "autograder";
  fs::create_directories(autograder / "source");
  fs::create_directories(course.tree / "solutions");
  fs::copy(chapter_solutions, course.tree / "solutions" / "01_particles");
  fs::copy_file(course.work.path() / "course.json", course.tree / "course.json");
  fs::create_directory_symlink(course.tree, autograder / "source" / "tumble");
  take_from_package("gradescope", "run_autograder", autograder);
  test::write_file(autograder / "submission" / "euler_step.cpp", wrong_step);
  test::write_file(autograder / "submission" / "rk4_step.cpp",
                   test::text_of(chapter_solutions / "rk4_step.cpp"));
  test::write_file(autograder / "submission_metadata.json",
                   R"({"id": 5, "users": [{"id": 3, "email": "a@b", "name": "Ann"}]})");
  // The build has to look for solutions again.
  fs::last_write_time(course.tree / "CMakeLists.txt", fs::file_time_type::clock::now());
  const CommandResult judged = course.in_the_tree("check all --solutions");
  REQUIRE_MESSAGE(judged.status == 0, judged.output);
  CHECK(test::contains(judged.output, "5 of 5 exercises pass"));
  const CommandResult graded =
      test::run_command(without_network((autograder / "run_autograder").string()));
  REQUIRE_MESSAGE(graded.status == 0, graded.output);
  CHECK(points_in(autograder) == 1);
  const json j = test::json_in(autograder / "results" / "results.json");
  CHECK(j.at("tests")[3].at("visibility") == "after_due_date");
  CHECK(test::contains(j.at("tests")[2].at("output"), "✗"));
  CHECK_FALSE(test::contains(j.dump(), "Ann"));
  check_own_check_of_gradescope(course, autograder);
}

}  // namespace

TEST_CASE("a hand-out, and the platforms that judge with it") {
  const BuiltCourse course;
  check_as_handed_out(course);
  check_on_prairielearn(course);
  if (test::run_command("python3 --version").status == 0)
    check_on_classroom50(course);
  else
    MESSAGE("Classroom 50's shim is skipped: there is no python3");
  check_on_github_actions(course);
  check_on_gradescope(course);
}
