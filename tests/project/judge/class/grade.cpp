/// @file
/// A class is graded as an instructor does it, on the course in tests/project/judge/course: every
/// verdict is that of `check`, nothing is graded twice, and a grading that was killed loses
/// nothing.
#include <doctest/doctest.h>

#include <array>
#include <chrono>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "judge/build/work_folder.hpp"
#include "project/harness/command.hpp"
#include "project/judge/attacks/submission.hpp"
#include "project/judge/class/archives.hpp"

using namespace tumble;
using nlohmann::json;
using test::CommandResult;
namespace fs = std::filesystem;

namespace {

const fs::path course = test::variable("TUMBLE_FIXTURE");
const std::string program = "'" + test::variable("TUMBLE_FIXTURE_JUDGE").string() + "' ";

json json_in(const fs::path& file) { return json::parse(test::text_of(file)); }

std::string solution(const std::string& unit) {
  return test::text_of(course / "solutions/01_crossing" / (unit + ".cpp"));
}

/// A class of different talents.
struct Class {
  tumble::judge::WorkFolder work;
  fs::path submissions = work.path() / "submissions", out = work.path() / "grades";

  Class() {
    hand_in("ann", "carry", solution("carry"));
    hand_in("ann", "twice", solution("twice"));
    hand_in("bob", "carry", "#include \"contract.hpp\"\nint x = ;\n");
    hand_in("bob", "twice",
            "#include \"contract.hpp\"\nnamespace crossing {\n"
            "Eigen::VectorXd twice(const Rhs& f, double t, const Eigen::VectorXd& y, double) {\n"
            "  return f(t, f(t, y));\n}\n}\n");
    test::write_archive(submissions / "eve.zip", {{"eve/twice.cpp", solution("twice")}});
    test::write_archive(submissions / "mal.tar.gz", {{"../twice.cpp", solution("twice")}});
  }
  void hand_in(const std::string& student, const std::string& unit, const std::string& text) const {
    const fs::path file = submissions / student / "01_crossing" / (unit + ".cpp");
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
  }
  std::string command(const std::string& options = "") const {
    return program + "grade '" + submissions.string() + "' --out '" + out.string() + "' " + options;
  }
  json record(const std::string& student) const {
    return json_in(out / "students" / (student + ".json"));
  }
  std::map<std::string, fs::file_time_type> times() const {
    std::map<std::string, fs::file_time_type> all;
    for (const auto& entry : fs::directory_iterator(out / "students"))
      all[entry.path().filename().string()] = entry.last_write_time();
    return all;
  }
};

/// A verdict without the time that it took, without the words, which name paths, and without the
/// fingerprint of its judge, which `check` does not need.
json without_words(json unit) {
  for (const char* key : {"seconds", "explanation", "detail", "judge"}) unit.erase(key);
  return unit;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("grade: each student's points, and why") {
  const Class all;
  const CommandResult graded = test::run_command(all.command());
  CHECK_MESSAGE(graded.status == 0, graded.output);
  CHECK(
      contains(graded.output, "mal        0.00 of 2.00  the submission has a path that leads out"));
  CHECK(contains(test::text_of(all.out / "grades.csv"),
                 "student,points,of,percent,passed,note,1.1 carry,1.2 twice\nann,2,2,100,2,,1,1\n"
                 "bob,0,2,0,0,,0,0\neve,1,2,50,1,,0,1\nmal,0,2,0,0,has a path"));
  CHECK(contains(test::text_of(all.out / "junit.xml"), "<testsuite name=\"bob\" tests=\"2\""));
  const json bob = all.record("bob");
  CHECK(bob.at("units")[0].at("summary") == "does not compile");
  CHECK(bob.at("units")[1].at("cases")[0].at("misconceptions")[0] == "time stands still");
  CHECK(contains(bob.at("units")[1].at("explanation"), "It looks like “time stands still”."));
  CHECK(contains(bob.at("units")[0].at("explanation"),
                 "The compiler does not accept 01_crossing/carry.cpp:"));
  CHECK(contains(all.record("eve").at("units")[0].at("explanation"),
                 "01_crossing/carry.cpp does not exist"));
  CHECK(bob.at("seed") != all.record("ann").at("seed"));
}

TEST_CASE("grade: the same verdicts as each alone") {
  const Class all;
  REQUIRE(test::run_command(all.command()).status == 0);
  for (const char* student : {"ann", "bob"}) {
    const json together = all.record(student);
    const fs::path file = all.work.path() / "alone.json";
    test::run_command(program + "check all --from '" + (all.submissions / student).string() +
                      "' --seed " + together.at("seed").dump() + " --json '" + file.string() + "'");
    const json alone = json_in(file);
    for (const std::size_t i : {0u, 1u})
      CHECK(without_words(together.at("units")[i]) == without_words(alone.at("units")[i]));
  }
}

TEST_CASE("grade: what several hand in alike is judged for each of them") {
  const Class all;
  const std::string stub = test::text_of(course / "exercises/01_crossing/twice.cpp");
  const std::array<const char*, 3> students = {"xia", "yan", "zoe"};
  for (const char* student : students) {
    all.hand_in(student, "carry", "#include \"contract.hpp\"\nint x = ;\n");
    all.hand_in(student, "twice", stub);
  }
  const CommandResult graded = test::run_command(all.command("--jobs 1"));
  REQUIRE_MESSAGE(graded.status == 0, graded.output);
  for (const char* student : students) {
    const json units = all.record(student).at("units");
    CHECK(units[0].at("summary") == "does not compile");
    CHECK(units[1].at("tries") == 0);
    CHECK(contains(units[1].at("explanation"), "Nothing is written yet."));
    const fs::path file = all.work.path() / "alone.json";
    test::run_command(program + "check all --from '" + (all.submissions / student).string() +
                      "' --seed " + units[1].at("seed").dump() + " --json '" + file.string() + "'");
    const json alone = json_in(file);
    for (const std::size_t i : {0u, 1u}) {
      json together = without_words(units[i]), by_itself = without_words(alone.at("units")[i]);
      together["tries"] = by_itself.at("tries");  // `check` counts elsewhere
      CHECK(together == by_itself);
    }
  }
}

TEST_CASE("grade: nothing is graded twice, and what has changed is graded again") {
  const Class all;
  REQUIRE(test::run_command(all.command()).status == 0);
  const json before = all.record("bob"), unchanged = all.record("ann");
  all.hand_in("bob", "twice", solution("twice"));
  REQUIRE(test::run_command(all.command()).status == 0);
  const json after = all.record("bob");
  CHECK(after.at("points") == 1);
  CHECK(after.at("units")[0] == before.at("units")[0]);  // to the hundredth of a second
  CHECK(before.at("units")[1].at("tries") == 1);
  CHECK(after.at("units")[1].at("tries") == 2);
  CHECK(all.record("ann") == unchanged);
  CHECK(after.at("seed") == before.at("seed"));
}

TEST_CASE("grade: killed in the middle, it goes on, and nothing is lost") {
  const Class all;
  // Twenty students more, so that there is a middle.
  for (int i = 0; i < 20; ++i)
    for (const char* unit : {"carry", "twice"})
      all.hand_in("s" + std::to_string(i), unit, solution(unit) + "// " + std::to_string(i));
  std::thread killed([&] { test::run_command("exec " + all.command("--jobs 2")); });
  const auto done = [&] {
    return fs::exists(all.out / "students/s1.json") &&
           contains(test::text_of(all.out / "students/s1.json"), "01_crossing/carry");
  };
  for (int i = 0; i < 600 && !done(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  REQUIRE(done());
  // This one, and no other test's.
  test::run_command("pkill -KILL -f '^" + test::variable("TUMBLE_FIXTURE_JUDGE").string() +
                    " grade .*" + all.work.path().string() + "'");
  killed.join();
  std::map<std::string, json> before;
  for (const auto& [file, time] : all.times()) before[file] = json_in(all.out / "students" / file);
  CHECK(before.size() < 24);  // it was the middle
  const CommandResult again = test::run_command(all.command("--jobs 2"));
  CHECK_MESSAGE(again.status == 0, again.output);
  CHECK(all.times().size() == 24);
  std::size_t kept = 0;
  for (const auto& [file, record] : before)
    for (const json& unit : record.at("units")) {
      const json now = json_in(all.out / "students" / file).at("units");
      CHECK(std::find(now.begin(), now.end(), unit) != now.end());
      ++kept;
    }
  CHECK(kept > 0);
  for (int i = 0; i < 20; ++i) CHECK(all.record("s" + std::to_string(i)).at("points") == 2);
}

TEST_CASE("grade: what no time was left for is said, and judged the next time") {
  const Class all;
  const CommandResult late = test::run_command(all.command("--deadline 1e-9"));
  CHECK_MESSAGE(late.status == 1, late.output);
  CHECK(contains(late.output, "no time was left for 3 of 4 submissions"));
  CHECK(contains(test::text_of(all.out / "grades.csv"),
                 "ann,0,2,0,0,2 not judged: no time left,,\n"));
  const CommandResult again = test::run_command(all.command("--deadline 1000"));
  CHECK_MESSAGE(again.status == 0, again.output);
  CHECK(all.record("ann").at("points") == 2);
  CHECK_FALSE(all.record("ann").contains("out_of_time"));
}

TEST_CASE("grade: course.json decides what counts") {
  const Class all;
  const fs::path settings = all.work.path() / "course.json";
  std::ofstream(settings) << R"({"units": ["twice"], "weights": {"1.2": 12}, "credit": "laws"})";
  REQUIRE(test::run_command(all.command("--course '" + settings.string() + "'")).status == 0);
  CHECK(all.record("ann").at("points") == 12);
  CHECK(all.record("ann").at("of") == 12);
  CHECK(all.record("ann").at("units").size() == 1);
  std::ofstream(settings) << R"({"unit": ["twice"]})";
  const CommandResult refused =
      test::run_command(all.command("--course '" + settings.string() + "'"));
  CHECK(refused.status == 2);
  CHECK(contains(refused.output, "has \"unit\", which means nothing here"));
}
