/// @file
/// The student's commands, as a student uses them, on the course in tests/project/judge/course.
#include <doctest/doctest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "project/harness/command.hpp"
#include "project/harness/skip.hpp"
#include "support/wrapped.hpp"

using tumble::test::CommandResult;
using tumble::test::run_command;
namespace fs = std::filesystem;

namespace {

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  tumble::require(value != nullptr, "ctest sets ", name);
  return value;
}

const fs::path course = variable("TUMBLE_FIXTURE");
const fs::path twice = course / "exercises/01_crossing/twice.cpp";

CommandResult judge(const std::string& arguments) {
  return run_command("'" + variable("TUMBLE_FIXTURE_JUDGE") + "' " + arguments);
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text; }

std::string solution() { return text_of(course / "solutions/01_crossing/twice.cpp"); }

/// The tree as it was handed out, before and after: the tests may run in any order.
struct FreshCourse {
  FreshCourse() { start(); }
  ~FreshCourse() { start(); }
  static void start() {
    judge("reset 1.1");
    judge("reset 1.2");
    fs::remove_all(variable("TUMBLE_FIXTURE_JUDGE") + ".state");
  }
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("list: untouched, tried, passed, changed since") {
  const FreshCourse fresh;
  CHECK(contains(judge("list").output, "0 of 2 exercises pass"));

  write(twice, "#include \"contract.hpp\"\n");
  CHECK(judge("check 1.2").status == 1);
  CHECK(contains(judge("list").output, "wrong signature, 1 try"));

  write(twice, solution());
  CHECK(judge("check 1.2").status == 0);
  CHECK(contains(judge("list").output, "passed, 2 tries"));
  CHECK(contains(judge("list").output, "1 of 2 exercises pass"));

  write(twice, solution() + "\n");
  CHECK(contains(judge("list").output, "changed since the last check"));
  CHECK(contains(judge("list").output, "0 of 2 exercises pass"));
}

TEST_CASE("check: a unit by number or name, a chapter, or the next open one") {
  const FreshCourse fresh;
  CHECK(contains(judge("check twice").output, "1.2 twice  not implemented"));
  CHECK(contains(judge("check").output, "1.1 carry  not implemented"));
  CHECK(contains(judge("check 1").output, "0 of 2 exercises pass"));
  const CommandResult unknown = judge("check 9.9");
  CHECK(unknown.status == 2);
  CHECK(contains(unknown.output,
                 "tumble: there is no exercise or chapter '9.9'; the chapters are 1 crossing"));
  for (const std::string file : {"twice.cpp", "./twice.cpp", "exercises/01_crossing/twice.cpp"})
    CHECK_MESSAGE(contains(judge("check " + file).output, "1.2 twice  not implemented"), file);
  CHECK(contains(judge("check twcie").output, "did you mean twice (1.2)?"));
  CHECK(contains(judge("check 1.2.x").output, "'x' is not the number of a case"));

  fs::copy_file(course / "solutions/01_crossing/carry.cpp",
                course / "exercises/01_crossing/carry.cpp", fs::copy_options::overwrite_existing);
  CHECK(contains(judge("check 1.1").output, "Next: 1.2 twice"));
  CHECK(contains(judge("check").output, "1.2 twice  not implemented"));
}

TEST_CASE("check: what was asked, what came back, the misconception, and how to see it again") {
  const FreshCourse fresh;
  write(twice,
        "#include \"contract.hpp\"\nnamespace crossing {\n"
        "Eigen::VectorXd twice(const Rhs& f, double t, const Eigen::VectorXd& y, double) {\n"
        "  return f(t, f(t, y));\n}\n}\n");
  const std::string output = judge("check 1.2 --seed 5").output;
  for (const char* part :
       {"1.2 twice  wrong, 0 of 3 laws hold", "twice(f, t, y, h) was called with",
        "f = a function of the judge", "Calls of the functions that it was given: 2", "Your answer",
        "Demanded", "It looks like “time stands still”.",
        "To run only this case:  ./tumble check 1.2.1 --seed 5"})
    CHECK_MESSAGE(contains(output, part), output);

  const std::string again = judge("check 1.2.1 --seed 5").output;
  const auto from_question = [](const std::string& text) {
    return text.substr(text.find("was called"), text.find("To run") - text.find("was called"));
  };
  CHECK(from_question(again) == from_question(output));
  CHECK(contains(again, "0 of 1 laws hold"));
  const CommandResult beyond = judge("check 1.2.9");
  CHECK(beyond.status == 2);
  CHECK_MESSAGE(beyond.output == "tumble: 1.2 has cases 1 to 3, and no case 9\n", beyond.output);
}

TEST_CASE("check: where nobody knows the mistake, the section that derives the function is named") {
  const FreshCourse fresh;
  const fs::path page = course / "chapters/01_crossing/README.md";
  fs::create_directories(page.parent_path());
  write(page,
        "# Crossing\n## A step\n<!-- exercise: 1.1 -->\n## Two steps\n<!-- exercise: 1.2 -->\n"
        "## What we have now\n");
  write(twice,
        "#include \"contract.hpp\"\nnamespace crossing {\n"
        "Eigen::VectorXd twice(const Rhs&, double, const Eigen::VectorXd& y, double) {\n"
        "  return 0.7 * y.array() + 3;\n}\n}\n");
  const std::string output = judge("check 1.2").output;
  fs::remove_all(course / "chapters");
  CHECK_MESSAGE(contains(output, "Read chapters/01_crossing/README.md, “Two steps”."), output);
  CHECK_FALSE(contains(judge("check 1.2").output, "Read chapters"));
}

TEST_CASE("check --json: complete after each unit, for other programs") {
  const FreshCourse fresh;
  const fs::path file = fs::temp_directory_path() / "tumble-results-test.json";
  CHECK(judge("check all --solutions --seed 3 --json " + file.string()).status == 0);
  const auto results = nlohmann::json::parse(text_of(file));
  fs::remove(file);
  CHECK(results.at("schema") == "tumble/results/1");
  REQUIRE(results.at("units").size() == 2);
  const auto& unit = results.at("units")[1];
  CHECK(unit.at("unit") == "01_crossing/twice");
  CHECK(unit.at("passed") == true);
  CHECK(unit.at("laws_that_hold") == 3);
  CHECK(unit.at("seed") == 3);
}

TEST_CASE("hint: the next one each time, or the one that is asked for") {
  const FreshCourse fresh;
  CHECK(contains(judge("hint 1.2").output, "hint 1 of 3\n\nHow often is f called?"));
  CHECK(contains(judge("hint 1.2").output, "hint 2 of 3"));
  CHECK(contains(judge("hint 1.2").output, "hand it to f again, at the later time."));
  CHECK(contains(judge("hint 1.2").output, "hint 3 of 3"));
  CHECK(contains(judge("hint 1.2 1").output, "hint 1 of 3"));
  CHECK(contains(judge("hint 1.2 4").output, "there are hints 1 to 3, not 4"));
  CHECK(contains(judge("hint 1").output, "'1' means 1.1 and 1.2; this command takes one of them"));
  CHECK(contains(judge("hint").output, "1.1 carry, hint 1 of 3"));
}

TEST_CASE("reset: the stub again, and nothing is lost") {
  const FreshCourse fresh;
  const std::string stub = text_of(twice);
  write(twice, "my work\n");
  const std::string output = judge("reset 1.2").output;
  CHECK(text_of(twice) == stub);
  const std::string kept =
      output.substr(output.find(": ") + 2, output.find('\n') - output.find(": ") - 2);
  CHECK(contains(output, "Your file is kept: "));
  CHECK(text_of(kept) == "my work\n");
  CHECK_FALSE(contains(judge("reset 1.2").output, "kept"));
}

TEST_CASE("solution: after a pass, or with --anyway") {
  const FreshCourse fresh;
  const CommandResult refused = judge("solution 1.2");
  CHECK(refused.status == 1);
  CHECK(contains(refused.output, "./tumble solution 1.2 --anyway"));
  CHECK(judge("solution 1.2 --anyway").output == solution());
  write(twice, solution());
  judge("check 1.2");
  CHECK(judge("solution 1.2").output == solution());
}

TEST_CASE("watch: judges a file when it is saved") {
  const FreshCourse fresh;
  const fs::path output = fs::temp_directory_path() / "tumble-watch-test";
  std::thread watcher([&] {
    run_command("timeout 60 '" + variable("TUMBLE_FIXTURE_JUDGE") + "' watch > " + output.string());
  });
  const auto appears = [&](const std::string& part) {
    for (int i = 0; i < 300; ++i) {
      if (contains(text_of(output), part)) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return false;
  };
  CHECK(appears("Watching"));
  write(twice, solution());
  CHECK(appears("1.2 twice  passed"));
  run_command("pkill -f '" + variable("TUMBLE_FIXTURE_JUDGE") + " watch'");
  watcher.join();
  fs::remove(output);
}

TEST_CASE("wrong usage: what is wrong, what was meant, and status 2") {
  const std::vector<std::pair<const char*, const char*>> wrong = {
      {"check --sed 3", "tumble: there is no option '--sed'; did you mean --seed?"},
      {"check --seed x", "x"},
      {"check --seed -1", "'-1' is no seed"},
      {"check 1,2", "did you mean 1.2?"},
      {"check 12", "did you mean 1.2?"},
      {"check 1.1 1.2", "tumble: '1.2' is one argument too many"},
      {"check 1.1 --seeds 0", "--seeds"},
      {"chekc 1.1", "tumble: there is no command 'chekc'; did you mean check?"},
      {"reset", "tumble: exercise is required\n"},
      {"solution", "tumble: exercise is required\n"},
      {"hint 1.1 x", "tumble: number: 'x' is not a number\n"},
      {"check 1.1 --from '" __FILE__ "'",
       "tumble: " __FILE__ " is a file: --from takes the folder that holds yours, or a zip\n"},
      {"grade . --out /dev/full",
       "tumble: --out is the folder for the results, and /dev/full is none\n"},
      {"grade . --out /dev/full/grades", "tumble: cannot make the folder /dev/full/grades: "},
      {"", "tumble: "}};
  for (const auto& each : wrong) {
    const auto& arguments = each.first;  // clang 14: no lambda of doctest's takes a binding
    const auto& message = each.second;
    const CommandResult result = judge(arguments);
    CHECK_MESSAGE(result.status == 2, arguments);
    CHECK_MESSAGE(contains(result.output, message), result.output);
  }
  CHECK(contains(judge("check --sed 3").output, "see ./tumble check --help"));
}

TEST_CASE("help: every command's, under the name that users know") {
  for (const std::string command : {"check", "list", "hint", "grade", "export", "matrix"}) {
    const CommandResult help = judge(command + " --help");
    CHECK(help.status == 0);
    CHECK_MESSAGE(contains(help.output, "Usage: ./tumble " + command), help.output);
    CHECK_FALSE(contains(help.output, variable("TUMBLE_FIXTURE_JUDGE")));
  }
}

TEST_CASE("completion knows every option of every command") {
  for (const std::string command : {"check", "list", "watch", "hint", "reset", "solution", "mine",
                                    "handout", "export", "grade", "report", "matrix"}) {
    const std::string words =
        " " + run_command("'" + variable("TUMBLE_ROOT") + "/tumble' completion words " + command +
                          " | tr '\\n' ' '")
                  .output;
    std::istringstream help(judge(command + " --help").output);
    for (std::string word; help >> word;)
      if (word.starts_with("--")) CHECK_MESSAGE(contains(words, " " + word + " "), command, word);
  }
}

TEST_CASE("what a command line needs to be built, one target a line, and nothing else is done") {
  const FreshCourse fresh;
  const std::string needs_carry = "spec.01_crossing.carry\n",
                    needs_twice = "spec.01_crossing.twice\n";
  CHECK(judge("--needs check").output == needs_carry);
  CHECK(judge("--needs check 1.2").output == needs_twice);
  CHECK(judge("--needs check 1.2.1 --from nowhere").output == needs_twice);
  CHECK(judge("--needs check 1 --solutions").output == needs_carry + needs_twice);
  CHECK(judge("--needs matrix twice").output == needs_twice);
  for (const char* all : {"mine", "watch", "stubs", "grade .", "report"})
    CHECK(judge(std::string("--needs ") + all).output == "all_specs\n");
  const fs::path settings = fs::temp_directory_path() / "tumble-needs-test.json";
  write(settings, R"({"units": ["1.2"], "curve": false})");
  const std::string with_settings = " --course '" + settings.string() + "'";
  CHECK(judge("--needs grade ." + with_settings).output == needs_twice);
  CHECK(judge("--needs platform gradescope ." + with_settings).output == needs_twice);
  CHECK(judge("--needs grade --merge a").output == "");
  fs::remove(settings);
  for (const char* none :
       {"list", "hint 1.1", "reset 1.1", "solution 1.1", "sandbox", "handout --chapters 1 x",
        "export gradescope x", "check --help", "check 9.9", "check --nonsense", "nonsense"}) {
    const CommandResult result = judge(std::string("--needs ") + none);
    CHECK_MESSAGE(result.output == "", none);
    CHECK(result.status == 0);
  }
}

TEST_CASE("the parts of the judge that a command line runs in, besides the program") {
  const FreshCourse fresh;
  const std::string grading = "tumble_judge_grading\n", archives = grading + "grading_tools\n";
  for (const std::string command : {"grade .", "grade --merge a", "platform gradescope ."})
    CHECK_MESSAGE(judge("--parts " + command).output == archives, command);
  const fs::path zip = fs::temp_directory_path() / "tumble-parts-test.zip";
  write(zip, "");
  for (const std::string command : {"check", "mine"})
    CHECK(judge("--parts " + command + " --from '" + zip.string() + "'").output == archives);
  fs::remove(zip);
  for (const std::string command :
       {"report", "handout --chapters 1 x", "export gradescope x", "check --student ann.json"})
    CHECK_MESSAGE(judge("--parts " + command).output == grading, command);
  for (const std::string command : {"check", "check 1.2 --from .", "mine", "watch", "list", "hint",
                                    "stubs", "matrix", "grade --help", "grade --nonsense"})
    CHECK_MESSAGE(judge("--parts " + command).output == "", command);
}

TEST_CASE("a full disk is an error") {
  if (!fs::exists("/dev/full")) return tumble::test::skip("there is no /dev/full here");
  for (const char* arguments :
       {"list > /dev/full", "check --help > /dev/full", "check 1.2 --solutions --json /dev/full"}) {
    const CommandResult result =
        run_command("( '" + variable("TUMBLE_FIXTURE_JUDGE") + "' " + arguments + " )");
    CHECK_MESSAGE(result.status == 2, arguments);
    CHECK(contains(result.output, "tumble: "));
  }
  CHECK(fs::is_character_file("/dev/full"));
}

TEST_CASE("list: in a narrow terminal no word is broken") {
  const CommandResult narrow = run_command("COLUMNS=60 script -qec \"'" +
                                           variable("TUMBLE_FIXTURE_JUDGE") + "' list\" /dev/null");
  if (narrow.status == 127) return tumble::test::skip("there is no script(1) here");
  std::istringstream lines(narrow.output);
  for (std::string line; std::getline(lines, line);) CHECK(tumble::support::characters(line) <= 61);
  CHECK(contains(narrow.output, "carry"));
}

TEST_CASE("--strict refuses to judge where a wall is missing, and says which") {
  const bool complete = judge("sandbox").status == 0;
  const CommandResult strict = judge("check 1.2 --solutions --strict");
  CHECK((strict.status == 0) == complete);
  if (!complete) CHECK(contains(strict.output, "--strict: nothing is judged"));
}

TEST_CASE("--strict refuses where the compiler of root's judge would stay root") {
  if (judge("sandbox").status != 0)
    return tumble::test::skip("not all walls stand here: see the case before");
  const fs::path locked = course / "exercises";
  const fs::perms before = fs::status(locked).permissions();
  fs::permissions(locked, fs::perms::owner_all);
  const CommandResult strict = judge("check 1.2 --solutions --strict");
  fs::permissions(locked, before);
  CHECK(strict.status == 2);
  CHECK(contains(strict.output, "other users may not enter"));
}

TEST_CASE("every stub fails every case; the kill matrix is complete") {
  const FreshCourse fresh;
  CHECK(contains(judge("stubs").output, "2 stubs, each fails every case"));
  CHECK(contains(judge("matrix").output, "8 misconceptions, 8 of them killed and named"));
}

TEST_CASE("nothing is left in the folder for temporary files") {
  judge("check 1.2 --solutions");
  for (const auto& entry : fs::directory_iterator(fs::temp_directory_path())) {
    const std::string name = entry.path().filename();
    if (!name.starts_with("tumble-judge-")) continue;
    const fs::path process = "/proc/" + name.substr(13, name.find('-', 13) - 13);
    CHECK_MESSAGE(fs::exists(process), name, " is left behind");  // others may be judging right now
  }
}
