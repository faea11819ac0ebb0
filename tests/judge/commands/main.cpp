/// @file
/// The judge's command line; ./tumble calls it.
#include <signal.h>

#include <cmath>
#include <functional>
#include <iostream>

#include "judge/class/lms.hpp"
#include "judge/commands/commands.hpp"
#include "judge/commands/course_file.hpp"
#include "judge/commands/given_files.hpp"
#include "judge/commands/grading_module.hpp"
#include "judge/commands/needs.hpp"
#include "judge/platforms/platform.hpp"
#include "support/command_line.hpp"

using namespace tumble::judge;

namespace {

/// What a command needs that judges nothing.
Targets nothing(const Course&) { return {}; }
Targets everything(const Course&) { return all_specs(); }

/// The parts of the judge that a command runs in, besides the program: targets, too.
Targets no_parts() { return {}; }
Targets grading() { return {"tumble_judge_grading"}; }
Targets grading_of_archives() { return {"tumble_judge_grading", "grading_tools"}; }

constexpr const char* seconds_help =
    "seconds after which we begin no exercise; we report the rest as not judged";
constexpr const char* strict_help = "refuse to judge if a wall of the sandbox is missing";

/// A seed is not negative: without this check, "-1" is read as a huge number.
std::string why_no_seed(const std::string& text) {
  const bool is_number = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  return is_number ? "" : "'" + text + "' is no seed: give a whole number from 0 on";
}
const CLI::Validator is_seed{[](const std::string& text) { return why_no_seed(text); }, "", "seed"};

/// Seconds, more than none. CLI11's own check would name the largest number that there is.
CLI::Validator some_seconds() {
  return {[](const std::string& text) -> std::string {
            double seconds = 0;
            const bool is_number = CLI::detail::lexical_cast(text, seconds);
            return is_number && seconds > 0 && std::isfinite(seconds)
                       ? ""
                       : "it has to be more than 0 s, not " + text;
          },
          "SECONDS"};
}

/// A whole number that is not out of all proportion.
CLI::Validator whole_number_to(int most) {
  const std::string allowed = "1 to " + std::to_string(most);
  return {[=](const std::string& text) -> std::string {
            int number = 0;
            const bool is_number = CLI::detail::lexical_cast(text, number);
            return is_number && number >= 1 && number <= most
                       ? ""
                       : "it has to be a whole number from " + allowed + ", not " + text;
          },
          allowed};
}

class CommandLine {
 public:
  CommandLine() {
    app_.require_subcommand(1);
    for (const char* question : {"--parts", "--needs"})  // ./tumble asks what it has to build
      app_.add_flag(question)->group("");
    add_check();
    add_mine();
    add_progress();
    add_help();
    add_grade();
    add_report();
    add_handout();
    add_export();
    add_platform();
    add_proofs();
  }

  int run(int argc, char** argv) {
    const std::string question = argc > 1 ? argv[1] : "";
    if (question == "--parts") return print(argc, argv, [&](const Course&) { return parts_(); });
    if (question == "--needs")
      return print(argc, argv, [&](const Course& course) { return needs_(course); });
    return tumble::support::run_command_line(app_, argc, argv,
                                             [&] { return run_(read_course(course_file)); });
  }

 private:
  using Run = std::function<int(const Course&)>;
  using Needs = std::function<Targets(const Course&)>;
  using Parts = std::function<Targets()>;

  CLI::App& command(const char* name, const char* what, Run run, Needs needs,
                    Parts parts = no_parts) {
    CLI::App* command = app_.add_subcommand(name, what);
    command->callback(
        [this, run = std::move(run), needs = std::move(needs), parts = std::move(parts)] {
          run_ = run;
          needs_ = needs;
          parts_ = parts;
        });
    return *command;
  }

  /// What a student's files need, wherever they lie.
  static Targets parts_for(const std::optional<fs::path>& from) {
    return from && is_archive(*from) ? grading_of_archives() : no_parts();
  }

  static Targets specs_that_count(const Course& course, const std::optional<fs::path>& settings) {
    return grading_module(course).specs_that_count(course, settings);
  }

  /// One target a line. Of a command line that cannot be carried out, nothing: the command itself
  /// says what is wrong with it.
  int print(int argc, char** argv, const Needs& answer) {
    try {
      app_.parse(argc, argv);
      for (const std::string& target : answer(read_course(course_file)))
        std::cout << target << "\n";
    } catch (const std::exception&) {
      return 0;
    }
    return tumble::support::finished(0);
  }

  void add_check() {
    CLI::App& app = command(
        "check", "judge what you have written",
        [this](const Course& course) {
          return check_.student ? grading_module(course).check_student(course, check_)
                                : check(course, check_);
        },
        [this](const Course& course) {
          return specs_of(check_.student ? grading_module(course).units_of_student(course, check_)
                                         : units_to_check(course, check_.what));
        },
        [this] { return check_.student ? grading() : parts_for(check_.from); });
    app.add_option("what", check_.what,
                   "exercise (4.1 or product), chapter (4), all; 4.1.3 is one case");
    app.add_option("--seed", check_.seed,
                   "of the random inputs; another one each time if not given")
        ->check(is_seed);
    app.add_option("--seeds", check_.seeds, "try this many, one after the other")
        ->check(whole_number_to(100000));
    app.add_option("--from", check_.from,
                   "folder or zip with the files to judge, instead of exercises/");
    CLI::Option* json =
        app.add_option("--json", check_.json, "write the results here, again after each exercise");
    app.add_option("--student", check_.student,
                   "say again what a student saw: a record of `grade`, grades/students/NAME.json")
        ->excludes(json);
    app.add_flag("--every-case", check_.every_case, "explain every case that fails");
    app.add_flag("--strict", check_.strict, strict_help);
    app.add_flag("--solutions", check_.solutions, "judge the solutions");
    app.add_flag("--once", check_.once, "no second run with sanitizers to look for the line");
    app.add_flag("--sanitize", check_.sanitized, "run with AddressSanitizer and UBSan");
  }

  void add_mine() {
    CLI::App& app = command(
        "mine", "an engine of your own functions, beside the library",
        [this](const Course& course) { return mine_command(course, mine_); }, everything,
        [this] { return parts_for(mine_.from); });
    app.add_flag("--fill", mine_.fill, "take the functions that are missing from the solutions");
    app.add_option("--from", mine_.from, "folder or zip with your files, instead of exercises/");
    app.add_option("--svg", mine_.svg, "write the figure here, instead of build/mine.svg");
    app.add_option("--json", mine_.json, "write the numbers here");
    app.add_flag("--strict", mine_.strict, "refuse to run if a wall of the sandbox is missing");
  }

  void add_progress() {
    command("watch", "judge each file when it is saved", watch, everything);
    command("list", "all exercises, and how far you are", list, nothing);
  }

  void add_help() {
    CLI::App& hints = command(
        "hint", "three hints per exercise, one at a time",
        [this](const Course& course) { return hint(course, unit_, hint_); }, nothing);
    hints.add_option("exercise", unit_, "4.1 or product; the next open one if not given");
    hints.add_option("number", hint_, "1, 2 or 3; the next one if not given");
    command(
        "reset", "put the untouched stub back, keeping your file",
        [this](const Course& course) { return reset(course, unit_); }, nothing)
        .add_option("exercise", unit_, "4.1 or product")
        ->required();
    CLI::App& answer = command(
        "solution", "the solution of an exercise that passes",
        [this](const Course& course) { return solution(course, unit_, anyway_); }, nothing);
    answer.add_option("exercise", unit_, "4.1 or product")->required();
    answer.add_flag("--anyway", anyway_, "although it does not pass");
  }

  void add_grade() {
    CLI::App& app = command(
        "grade", "grade a class, or a part of one",
        [this](const Course& course) { return grading_module(course).grade(course, grade_); },
        [this](const Course& course) {
          return grade_.merge.empty() ? grading_module(course).specs_to_grade(course, grade_)
                                      : Targets{};
        },
        grading_of_archives);
    app.add_option(
        "DIR", grade_.folders,
        "folders with a folder or an archive per student, or a platform's download; those "
        "of before if not given");
    app.add_option("--out", grade_.out,
                   "folder for the results; grading goes on where it was, with the same DIR, "
                   "platform, settings and roster if you give no others")
        ->capture_default_str();
    std::vector<CLI::Option*> about_judging = {
        app.get_option("DIR"),
        app.add_option("--course", grade_.settings,
                       "course.json: exercises, weights, credit, due date, seed"),
        app.add_option("--from", grade_.from,
                       std::string("the platform of the download, if its file names don't tell: ") +
                           lms_names),
        app.add_option("--roster", grade_.roster,
                       "the class list (CSV) with names and numbers; students without a submission "
                       "get a row, too"),
        app.add_option(
               "--only", grade_.only,
               "judge only these exercises, chapters or ranges (1.1-1.3), and again; settings "
               "and roster have to be those of before")
            ->delimiter(','),
        app.add_option("--student", grade_.students,
                       "judge only these students; settings and roster have to be those of before"),
        app.add_option("--jobs", grade_.at_once,
                       "submissions at a time; as many as cores if not given")
            ->check(whole_number_to(1000)),
        app.add_option("--deadline", grade_.seconds, seconds_help)->check(some_seconds()),
        app.add_flag("--strict", grade_.strict, strict_help),
        app.add_option(
            "--shard", grade_.shard,
            "3/10: judge the third of ten parts of the class; a student's name decides the part")};
    CLI::Option* merge =
        app.add_option("--merge", grade_.merge,
                       "folders of all shards: combine them into the grades of the whole class");
    for (CLI::Option* option : about_judging) merge->excludes(option);
  }

  void add_report() {
    CLI::App& app = command(
        "report", "one page about a class: what to explain again",
        [this](const Course& course) { return grading_module(course).report(course, report_); },
        everything, grading);
    app.add_option("GRADES", report_.grades, "folder that `grade` has made")->capture_default_str();
    app.add_option("--out", report_.out, "the page")->capture_default_str();
    app.add_option("--course", report_.settings,
                   "course.json, if not the one that was graded with");
    app.add_flag("--names", report_.names, "the students' names, too");
  }

  void add_handout() {
    CLI::App& app = command(
        "handout", "a repository for students, without the solutions",
        [this](const Course& course) { return grading_module(course).handout(course, handout_); },
        nothing, grading);
    app.add_option("--chapters", handout_.chapters, "1-4, or 1-4,6");
    app.add_option("--course", handout_.settings, "course.json: the chapters of what counts");
    app.add_option("DIR", handout_.to, "a new folder")->required();
  }

  void add_export() {
    CLI::App& app = command(
        "export", "a package for a platform",
        [this](const Course& course) {
          return grading_module(course).export_package(course, export_);
        },
        nothing, grading);
    app.add_option("PLATFORM", export_.platform, platforms)->required();
    app.add_option("DIR", export_.to, "a new folder")->required();
    app.add_option("--course", export_.settings,
                   "course.json: exercises, weights, credit, hidden, due date, seed");
    app.add_option("--image", export_.image, "name of PrairieLearn's grader image")
        ->capture_default_str();
    app.add_flag("--each", export_.each, "a question for each exercise: PrairieLearn");
    app.add_option("--limit", export_.limit,
                   "seconds that the platform gives a submission, if you have changed them");
  }

  void add_platform() {
    CLI::App& app = command(
        "platform", "grade one submission where a platform has put it",
        [this](const Course& course) { return grading_module(course).platform(course, platform_); },
        [this](const Course& course) { return specs_that_count(course, platform_.settings); },
        grading_of_archives);
    app.add_option("PLATFORM", platform_.platform, platforms)->required();
    app.add_option("ROOT", platform_.root, "/autograder, /grade, the checkout")->required();
    app.add_option("--course", platform_.settings, "course.json");
    app.add_option("--deadline", platform_.seconds, seconds_help)->check(some_seconds());
  }

  void add_proofs() {
    CLI::App& kills = command(
        "matrix", "every spec against every misconception",
        [this](const Course& course) {
          return page_ ? misconceptions_page(course, what_) : matrix(course, what_, seed_);
        },
        [this](const Course& course) { return specs_of(course.select(what_)); });
    kills.add_option("what", what_, "exercise, chapter, all")->capture_default_str();
    kills.add_option("--seed", seed_, "of the random inputs")
        ->check(is_seed)
        ->capture_default_str();
    kills.add_flag("--page", page_, "the page of the book instead: what students get wrong");
    CLI::App& odd = command(
        "odd-answers", "every answer and evaluation put out of shape: the judge survives",
        [this](const Course& course) { return odd_answers(course, what_, seed_); },
        [this](const Course& course) { return specs_of(course.select(what_)); });
    odd.add_option("what", what_, "exercise, chapter, all")->capture_default_str();
    odd.add_option("--seed", seed_, "of the random inputs")->check(is_seed)->capture_default_str();
    command("stubs", "every stub is untouched and fails every case", stubs, everything);
    command("sandbox", "which walls stand here", sandbox, nothing);
  }

  CLI::App app_{"tumble's judge", "./tumble"};
  Run run_;
  Needs needs_;
  Parts parts_;
  CheckOptions check_;
  MineOptions mine_;
  std::string unit_;
  int hint_ = 0;
  bool anyway_ = false;
  GradeOptions grade_;
  ReportOptions report_;
  HandoutOptions handout_;
  PackageOrder export_;
  PlatformOptions platform_;
  std::string what_ = "all";
  std::uint64_t seed_ = 1;
  bool page_ = false;
};

}  // namespace

int main(int argc, char** argv) {
  // Who ignores it hands that on, and a judge that does could not learn how its workers ended.
  signal(SIGCHLD, SIG_DFL);
  return CommandLine().run(argc, argv);
}
