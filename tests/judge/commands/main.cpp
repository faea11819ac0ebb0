/// @file
/// The judge's command line; ./tumble calls it.
#include <CLI/CLI.hpp>
#include <functional>
#include <iostream>

#include "judge/commands/commands.hpp"
#include "judge/platforms/platform.hpp"

using namespace tumble::judge;

namespace {

/// Options of `check` that only make sense for what it is given.
void add_check(CLI::App& app, CheckOptions& options) {
  app.add_option("what", options.what,
                 "unit (4.1 or product), chapter (4), all; 4.1.3 is one case");
  app.add_option("--seed", options.seed,
                 "of the random inputs; another one each time if not given");
  app.add_option("--seeds", options.seeds, "try this many, one after the other")
      ->check(CLI::Range(1, 100000));
  app.add_option("--from", options.from, "folder with the files to judge, instead of exercises/");
  app.add_option("--json", options.json, "write the results here, again after each unit");
  app.add_flag("--every-case", options.every_case, "explain every case that fails");
  app.add_flag("--strict", options.strict, "refuse to judge if a wall of the sandbox is missing");
  app.add_flag("--solutions", options.solutions, "judge the solutions");
  app.add_flag("--sanitize", options.sanitized, "run with AddressSanitizer and UBSan");
}

void add_mine(CLI::App& app, MineOptions& options) {
  app.add_flag("--fill", options.fill, "take the functions that are missing from the solutions");
  app.add_option("--from", options.from, "folder with your files, instead of exercises/");
  app.add_option("--svg", options.svg, "write the figure here, instead of build/mine.svg");
  app.add_option("--json", options.json, "write the numbers here");
  app.add_flag("--strict", options.strict, "refuse to run if a wall of the sandbox is missing");
}

void add_grade(CLI::App& app, GradeOptions& options) {
  app.add_option("DIR", options.folders, "folders of submissions: a folder or archive a student")
      ->required();
  app.add_option("--out", options.out, "folder for the results; grading goes on where it was")
      ->capture_default_str();
  app.add_option("--course", options.settings,
                 "course.json: units, weights, credit, due date, seed");
  app.add_option("--jobs", options.at_once, "submissions at a time; as many as cores if not given")
      ->check(CLI::Range(1, 1000));
  app.add_flag("--strict", options.strict, "refuse to judge if a wall of the sandbox is missing");
}

void add_report(CLI::App& app, ReportOptions& options) {
  app.add_option("GRADES", options.grades, "folder that `grade` has made")->capture_default_str();
  app.add_option("--out", options.out, "the page")->capture_default_str();
  app.add_option("--course", options.settings, "course.json: units, weights, credit");
  app.add_flag("--names", options.names, "the students' names, too");
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("tumble's judge", "tumble");
  app.require_subcommand(1);
  std::function<int(const Course&)> run;
  const auto command = [&](const char* name, const char* what,
                           std::function<int(const Course&)> f) {
    CLI::App* sub = app.add_subcommand(name, what);
    sub->callback([&run, f = std::move(f)] { run = f; });
    return sub;
  };

  CheckOptions options;
  add_check(*command("check", "judge what you have written",
                     [&](const Course& course) { return check(course, options); }),
            options);
  MineOptions mine_options;
  add_mine(*command("mine", "an engine of your own functions, beside the library",
                    [&](const Course& course) { return mine_command(course, mine_options); }),
           mine_options);
  command("watch", "judge each file when it is saved", watch);
  command("list", "all units, and how far you are", list);

  std::string unit, what = "all";
  int number = 0;
  bool anyway = false;
  std::uint64_t seed = 1;
  CLI::App* hints = command("hint", "three hints a unit, one at a time",
                            [&](const Course& course) { return hint(course, unit, number); });
  hints->add_option("unit", unit)->required();
  hints->add_option("number", number, "1, 2 or 3; the next one if not given");
  command("reset", "put the untouched stub back, keeping your file",
          [&](const Course& course) { return reset(course, unit); })
      ->add_option("unit", unit)
      ->required();
  CLI::App* answer = command("solution", "the solution of a unit that passes",
                             [&](const Course& course) { return solution(course, unit, anyway); });
  answer->add_option("unit", unit)->required();
  answer->add_flag("--anyway", anyway, "although it does not pass");

  GradeOptions grading;
  add_grade(*command("grade", "grade a class",
                     [&](const Course& course) { return grade(course, grading); }),
            grading);

  ReportOptions reporting;
  add_report(*command("report", "one page about a class: what to explain again",
                      [&](const Course& course) { return report(course, reporting); }),
             reporting);

  std::string chapters;
  std::filesystem::path to;
  CLI::App* handing_out =
      command("handout", "a repository for students, without the solutions",
              [&](const Course& course) { return handout_command(course, chapters, to); });
  handing_out->add_option("--chapters", chapters, "1-4, or 1-4,6")->required();
  handing_out->add_option("DIR", to, "a new folder")->required();

  ExportOptions package;
  CLI::App* exporting = command("export", "a package for a platform", [&](const Course& course) {
    return export_command(course, package);
  });
  exporting->add_option("PLATFORM", package.platform, platforms)->required();
  exporting->add_option("DIR", package.to, "a new folder")->required();
  exporting->add_option("--course", package.settings,
                        "course.json: units, weights, credit, hidden, due date, seed");
  exporting->add_option("--image", package.image, "name of PrairieLearn's grader image")
      ->capture_default_str();

  PlatformOptions place;
  CLI::App* on_platform =
      command("platform", "grade one submission where a platform has put it",
              [&](const Course& course) { return platform_command(course, place); });
  on_platform->add_option("PLATFORM", place.platform, platforms)->required();
  on_platform->add_option("ROOT", place.root, "/autograder, /grade, the checkout")->required();
  on_platform->add_option("--course", place.settings, "course.json");

  CLI::App* kills = command("matrix", "every spec against every misconception",
                            [&](const Course& course) { return matrix(course, what, seed); });
  kills->add_option("what", what);
  kills->add_option("--seed", seed);
  command("stubs", "every stub is untouched and fails every case", stubs);
  command("sandbox", "which walls stand here", sandbox);

  CLI11_PARSE(app, argc, argv);
  try {
    return run(read_course(TUMBLE_COURSE));
  } catch (const std::exception& e) {
    std::cerr << "tumble: " << e.what() << "\n";
    return 2;
  }
}
