/// @file
/// What can happen to a grading, and what an instructor decides about single students.
#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "judge/build/work_folder.hpp"
#include "judge/class/canonical_names.hpp"
#include "judge/class/csv_table.hpp"
#include "judge/class/interruption.hpp"
#include "project/harness/command.hpp"
#include "project/harness/skip.hpp"
#include "project/judge/class/handed_in_class.hpp"

using namespace tumble;
using test::CommandResult;
namespace fs = std::filesystem;

namespace {

/// Ann is right, Ben has a mistake in one of two exercises.
struct TwoStudents {
  judge::WorkFolder work;
  fs::path handed_in = work.path() / "handed in", out = work.path() / "grades";
  std::string judge_program = "'" + test::variable("TUMBLE_FIXTURE_JUDGE").string() + "' ";

  TwoStudents() {
    test::write_files(handed_in / "ann", test::both());
    test::write_files(handed_in / "ben",
                      {{"carry.cpp", test::carry()}, {"twice.cpp", test::wrong_twice()}});
  }
  CommandResult run(const std::string& arguments) const {
    return test::run_command("cd '" + work.path().string() + "' && " + judge_program + arguments);
  }
  CommandResult grade(const std::string& options = "") const {
    return run("grade 'handed in' " + options);
  }
  CommandResult grade_with(const std::string& settings, const std::string& options = "") const {
    test::write_file(work.path() / "course.json", settings);
    return grade("--course course.json " + options);
  }
  judge::CsvTable table() const {
    return judge::read_csv(test::text_of(out / "grades.csv"), "grades.csv");
  }
  /// A cell of the table; empty if there is no such row.
  std::string cell(const std::string& student, const char* column) const {
    const judge::CsvTable all = table();
    for (const auto& row : all.rows)
      if (row[0] == student) return row[*all.column({column})];
    return "";
  }
  nlohmann::json record(const std::string& student) const {
    return nlohmann::json::parse(test::text_of(out / "students" / (student + ".json")));
  }
};

bool tells(const CommandResult& result, const std::string& part) {
  return result.output.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("grading: one at a time in a folder") {
  const TwoStudents two;
  fs::create_directories(two.out);
  const int lock = ::open((two.out / "lock").c_str(), O_RDWR | O_CREAT, 0644);
  REQUIRE(::flock(lock, LOCK_EX) == 0);
  const CommandResult refused = two.grade();
  CHECK(refused.status == 2);
  CHECK_MESSAGE(tells(refused, "another grading is at work in grades"), refused.output);
  CHECK(::dprintf(lock, "process 4711 on lab3") > 0);
  CHECK(tells(two.grade(), "in grades, process 4711 on lab3: wait for its end"));
  ::close(lock);
  CHECK(two.grade().status == 0);
}

TEST_CASE("grading: a damaged record costs nothing, and is named") {
  const TwoStudents two;
  REQUIRE(two.grade().status == 0);
  const std::string before = test::text_of(two.out / "grades.csv");
  test::write_file(two.out / "students/ben.json", "{\"student\": \"ben");
  const CommandResult report = two.run("report");
  CHECK_MESSAGE(report.status == 0, report.output);
  CHECK(tells(report, "left out: ben: "));
  CHECK(test::text_of(two.work.path() / "report.html").find("ben: ") != std::string::npos);
  const CommandResult again = two.grade();
  CHECK_MESSAGE(again.status == 0, again.output);
  CHECK(tells(again, "ben is graded anew, and it is kept as ben.json.damaged"));
  CHECK(test::text_of(two.out / "grades.csv") == before);
  CHECK(fs::exists(two.out / "students/ben.json.damaged"));
}

TEST_CASE("grading: Ctrl-C writes what is there, and says how to go on") {
  const TwoStudents two;
  for (int i = 0; i < 30; ++i)
    for (const char* unit : {"carry", "twice"})
      test::write_file(two.handed_in / ("s" + std::to_string(i)) / (std::string(unit) + ".cpp"),
                       test::fixture_solution(unit) + "// " + std::to_string(i) + "\n");
  const fs::path log = two.work.path() / "log";
  const pid_t grading = ::fork();
  if (grading == 0) {
    ::setpgid(0, 0);  // as a terminal does it: the signal goes to all of the group
    const std::string command = "cd '" + two.work.path().string() + "' && exec " +
                                two.judge_program + "grade 'handed in' --jobs 2 > '" +
                                log.string() + "' 2>&1";
    ::execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  for (int i = 0; i < 600 && !fs::exists(two.out / "students/s1.json"); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  ::kill(-grading, SIGINT);
  int status = 0;
  REQUIRE(::waitpid(grading, &status, 0) == grading);
  const std::string said = test::text_of(log);
  CAPTURE(said);
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 130);
  CHECK(said.find("interrupted: the grades count only what is judged so far; the same command "
                  "goes on from there") != std::string::npos);
  CHECK(said.find("the judge has failed") == std::string::npos);
  CHECK(two.table().rows.size() == 32);
  CHECK(two.cell("s9", "note") == "not judged yet: 1.1, 1.2");
  CHECK(two.cell("ann", "points") == "2");
  CHECK(two.grade("--jobs 2").status == 0);
  CHECK(two.cell("s9", "points") == "2");
  CHECK(two.cell("s9", "note") == "");
}

TEST_CASE("grading: who closes the terminal stops it, and nohup does not let them") {
  {
    const judge::Interruption interruption;
    ::raise(SIGHUP);
    CHECK(interruption.asked());
  }
  const auto before = ::signal(SIGHUP, SIG_IGN);
  {
    const judge::Interruption interruption;
    ::raise(SIGHUP);
    CHECK(!interruption.asked());
  }
  ::signal(SIGHUP, before);
}

TEST_CASE("grading: one exercise of one student, again") {
  const TwoStudents two;
  REQUIRE(two.grade().status == 0);
  const auto ann = two.record("ann"), ben = two.record("ben");
  const CommandResult again = two.grade("--only 1.2 --student ben");
  CHECK_MESSAGE(again.status == 0, again.output);
  CHECK(tells(again, "tumble: 1 submission, "));
  CHECK(two.record("ann") == ann);
  CHECK(two.record("ben").at("units")[0] == ben.at("units")[0]);
  CHECK(two.record("ben").at("units")[1].at("summary") == "wrong");
  CHECK(two.table().rows.size() == 2);  // the table is the class's
  const CommandResult unknown = two.grade("--student bne");
  CHECK(unknown.status == 2);
  CHECK(tells(unknown, "there is no submission of 'bne'; did you mean ben?"));
  CHECK(tells(two.grade("--only 7.7"), "there is no exercise or chapter '7.7'"));
  CHECK(two.grade("--only '1.1 – 1.2'").status == 0);  // a range as in course.json
  CHECK(two.grade("--only 1.1,1.2").status == 0);
  CHECK(tells(two.grade("--only 1.1-"), "'1.1-' is half of a range"));
  CHECK(tells(two.grade("--only my-course/1.1"), "there is no exercise or chapter 'my'"));
  CHECK(two.grade("--only my-course/exercises/01_crossing/twice.cpp").status == 0);
}

TEST_CASE("check --student: what that student saw, word for word") {
  const TwoStudents two;
  test::write_archive(two.handed_in / "cem.zip",
                      {{"work/Twice.cpp", test::wrong_twice()}, {"work/carry.cpp", "int x = ;\n"}});
  REQUIRE(two.grade().status == 0);
  fs::remove_all(two.handed_in);  // the grades folder has all that is needed
  const auto without_times = [](std::string text) {
    for (std::size_t at; (at = text.find("  (")) != std::string::npos;)
      text.erase(at, text.find('\n', at) - at);
    return text;
  };
  for (const char* student : {"ben", "cem"}) {
    const CommandResult seen =
        two.run("check --student grades/students/" + std::string(student) + ".json");
    CHECK(seen.status == 1);
    CHECK_MESSAGE(!tells(seen, "the judge has changed since"), seen.output);
    const auto record = two.record(student);
    for (const auto& unit : record.at("units")) {
      const std::string text = unit.at("explanation");
      CHECK_MESSAGE(without_times(seen.output).find(without_times(text)) != std::string::npos,
                    seen.output);
    }
  }
  CHECK(tells(two.run("check --student grades/students/cem.json"), "work/carry.cpp"));
  const CommandResult one = two.run("check 1.2 --student grades/students/ben.json");
  CHECK(tells(one, "time stands still"));
  CHECK_FALSE(tells(one, "1.1 carry"));
  CHECK(two.run("check --student grades/students/ann.json").status == 0);
  CHECK(two.run("--needs check --student grades/students/ben.json").output ==
        "spec.01_crossing.carry\nspec.01_crossing.twice\n");
  CHECK(tells(two.run("check --student nobody.json"), "is not a file"));
}

TEST_CASE("report: the settings that were graded with, and nobody who is gone") {
  const TwoStudents two;
  REQUIRE(two.grade_with(R"({"title": "H 1", "units": ["1.2"], "weights": {"1.2": 5}})").status ==
          0);
  const auto page = [&] {
    CHECK(two.run("report --names").status == 0);
    return test::text_of(two.work.path() / "report.html");
  };
  CHECK(page().find("<h1>H 1</h1>") != std::string::npos);
  CHECK(page().find("2 submissions, 1 exercise, 5 points.") != std::string::npos);
  fs::remove_all(two.handed_in / "ben");
  REQUIRE(two.grade("--course course.json").status == 0);
  CHECK(page().find("1 submission, ") != std::string::npos);
  CHECK(page().find("ben") == std::string::npos);
  CHECK_FALSE(fs::exists(two.out / "feedback/ben.html"));
  CHECK(fs::exists(two.out / "feedback/ann.html"));
}

TEST_CASE("roster: names, numbers, and who has not handed in") {
  const TwoStudents two;
  test::write_file(two.work.path() / "class.csv",
                   "\xef\xbb\xbfName;E-Mail;ID\nAnn Meyer;ann@example.edu;7\n"
                   "Kim, Ben;ben@example.edu;8\nCleo;cleo@example.edu;9\n");
  test::write_files(two.handed_in / "zoe", test::both());
  const CommandResult graded = two.grade("--roster class.csv");
  CHECK_MESSAGE(graded.status == 0, graded.output);
  CHECK(tells(graded, "not found on the roster:\n  zoe\n"));
  CHECK(two.cell("Cleo", "note") == "not handed in");
  CHECK(two.cell("ann", "name") == "Ann Meyer");
  CHECK(two.cell("ben", "id") == "8");
  CHECK(two.table().rows.size() == 4);
  CHECK(two.run("report").status == 0);
  const std::string page = test::text_of(two.work.path() / "report.html");
  CHECK(page.find("3 submissions, 2 exercises, 2 points. 1 of the class has not handed in.") !=
        std::string::npos);
  test::write_file(two.work.path() / "class.csv", "colour,size\nred,7\n");
  CHECK(tells(two.grade("--roster class.csv"),
              "names nobody: it needs a column called name, email or id; it has: colour, size"));
}

TEST_CASE("roster: a folder that macOS has packed is its student's") {
  if (!judge::compares_canonically()) return test::skip("tumble was built without utf8proc");
  const TwoStudents two;
  const std::string as_listed = "Zo\u00eb", as_packed = "Zoe\u0308";
  test::write_files(two.handed_in / as_packed, test::both());
  test::write_file(two.work.path() / "class.csv", "name,id\nann,1\nben,2\n" + as_listed + ",3\n");
  const CommandResult graded = two.grade_with(
      R"({"overrides": {")" + as_listed + R"(": {"1.1": 0.5, "reason": "lost by us"}}})",
      "--roster class.csv");
  CHECK_MESSAGE(graded.status == 0, graded.output);
  CHECK_FALSE(tells(graded, "not found on the roster"));
  CHECK_FALSE(tells(graded, "names students who are not here"));
  CHECK(two.table().rows.size() == 3);
  CHECK(two.cell(as_listed, "id") == "3");
  CHECK(two.cell(as_listed, "points") == "1.5");
  CHECK(test::text_of(two.out / "feedback.zip").find(as_packed + "/feedback.html") !=
        std::string::npos);  // as it came, so it goes back
  CHECK(two.grade("--student " + as_packed).status == 0);
  test::write_files(two.handed_in / as_listed, test::both());
  CHECK(tells(two.grade(), "(an accent in them is written in two ways)"));
}

TEST_CASE("late work, extensions, overrides, extra credit") {
  const TwoStudents two;
  test::write_file(two.work.path() / "class.csv",
                   "name,handed in\nann,2025-12-03T10:00:00Z\nben,2025-12-01T12:10:00Z\n");
  const std::string due = R"("due": "2025-12-01T12:00:00Z", "late": {"grace": 15, "per_day": 10})";
  const auto grade = [&](const std::string& more) {
    return two.grade_with("{" + due + more + "}", "--roster class.csv");
  };
  REQUIRE(grade("").status == 0);
  CHECK(two.cell("ann", "points") == "1.6");
  CHECK(two.cell("ann", "note") == "2 days late: −20 %");
  CHECK(two.cell("ben", "note") == "");  // ten minutes are within the grace
  REQUIRE(grade(R"(, "extensions": {"ann": "2025-12-08T12:00:00Z"})").status == 0);
  CHECK(two.cell("ann", "points") == "2");
  REQUIRE(grade(R"(, "overrides": {"ben": {"1.2": 0.5, "reason": "lost by us"},
                                   "nan": {"points": 2, "reason": "x"}})")
              .status == 0);
  CHECK(two.cell("ben", "points") == "1.5");
  CHECK(two.cell("ben", "1.2 twice") == "0.5");
  CHECK(two.cell("ben", "note") == "given by hand: lost by us");
  CHECK(two.record("ben").at("units")[1].at("passed") == false);  // the verdict stays
  CHECK(tells(grade(R"(, "overrides": {"bne": {"points": 2, "reason": "x"}})"),
              "overrides: there is no bne; did you mean ben?"));
  fs::remove(two.out / "roster.csv");
  const CommandResult spoken = two.grade_with("{" + due + "}");  // nobody knows when
  CHECK(tells(spoken,
              "we don't know when these students handed in, so their work counts as on time:\n  "
              "ann\n  ben\n"));
  test::write_file(two.work.path() / "class.csv",
                   "name,handed in\nann,\"Thursday, 1 January 1970, 1:00 AM\"\n"
                   "ben,2999-01-01T00:00:00Z\n");
  const CommandResult broken = grade("");  // a clock that is wrong makes nobody late
  CHECK(tells(broken, "ann: \"Thursday, 1 January 1970, 1:00 AM\" is a clock that was never set"));
  CHECK(tells(broken, "ben: \"2999-01-01T00:00:00Z\" is still to come"));
  CHECK(two.cell("ben", "note") == "");
  test::write_file(two.work.path() / "class.csv", "name,handed in\nann,Dienstag\nzoe,\n");
  CHECK(tells(grade(""), "ann: \"Dienstag\" cannot be read"));
  REQUIRE(grade(R"(, "overrides": {"zoe": {"points": 1, "reason": "oral"}})").status == 0);
  CHECK(two.cell("zoe", "points") == "1");  // although nothing was handed in
  REQUIRE(grade(R"(, "extra": ["1.2"])").status == 0);
  CHECK(two.cell("ann", "of") == "1");
  CHECK(two.cell("ben", "percent") == "100");
}

TEST_CASE("names in course.json: whatever their case, with and without a roster") {
  const TwoStudents two;
  const std::string by_hand = R"({"overrides": {"BEN": {"1.2": 0.5, "reason": "lost by us"}}})";
  const CommandResult graded = two.grade_with(by_hand);
  CHECK_FALSE_MESSAGE(tells(graded, "names students who are not here"), graded.output);
  CHECK(two.cell("ben", "points") == "1.5");
  CHECK(tells(two.grade("--student Ben"), "1 submission, "));
  CHECK(two.run("report --names").status == 0);
  CHECK(tells(two.grade_with(R"({"overrides": {"BEN": {"1.2": 0.5, "reason": "a"},
                                               "ben": {"1.2": 1, "reason": "b"}}})"),
              "overrides: BEN and ben are one student, ben: which counts?"));
  test::write_files(two.handed_in / "Ben", test::both());
  REQUIRE(two.grade_with(R"({"overrides": {"Ben": {"points": 0.25, "reason": "r"}}})").status == 0);
  CHECK(two.cell("Ben", "points") == "0.25");
  CHECK(two.cell("ben", "points") == "1");
  CHECK(tells(two.grade_with(by_hand), "BEN means 2 students, Ben and ben"));
}

TEST_CASE("grading: numbers that make no sense are refused in plain words") {
  const TwoStudents two;
  CHECK(tells(two.grade("--deadline 0"), "--deadline: it has to be more than 0 s, not 0\n"));
  CHECK(tells(two.grade("--deadline x"), "--deadline: it has to be more than 0 s, not x\n"));
  CHECK(
      tells(two.grade("--jobs 0"), "--jobs: it has to be a whole number from 1 to 1000, not 0\n"));
}

TEST_CASE("several submissions of a student: the last, or the best") {
  const TwoStudents two;
  test::write_files(two.work.path() / "second/ben", {{"twice.cpp", test::twice()}});
  const CommandResult unsaid = two.run("grade 'handed in' second");
  CHECK(unsaid.status == 2);
  CHECK(tells(unsaid, "\"several\" in course.json says which counts"));
  test::write_file(two.work.path() / "course.json",
                   R"({"several": "last", "weights": {"1.1": 3}})");
  REQUIRE(two.run("grade 'handed in' second --course course.json").status == 0);
  CHECK(two.cell("ben", "points") == "1");
  CHECK(two.cell("ben", "note") == "the last of 2 submissions");
  test::write_file(two.work.path() / "course.json",
                   R"({"several": "best", "weights": {"1.1": 3}})");
  REQUIRE(two.run("grade 'handed in' second --course course.json").status == 0);
  CHECK(two.cell("ben", "points") == "3");
  CHECK(two.cell("ben", "note") == "the best of 2 submissions: number 1");
  CHECK(two.cell("ann", "note") == "");
  CHECK(two.run("check 1.1 --student grades/students/ben.json").status == 0);
}
