#include "judge/platforms/platform.hpp"

#include <algorithm>
#include <iostream>
#include <random>

#include "judge/build/work_folder.hpp"
#include "judge/class/grade_student.hpp"
#include "judge/class/submissions.hpp"
#include "judge/commands/given_files.hpp"
#include "judge/commands/grading/grading.hpp"
#include "judge/commands/mine_module.hpp"
#include "judge/commands/sandbox.hpp"
#include "judge/platforms/fitted.hpp"
#include "support/text_file.hpp"

namespace tumble::judge {

namespace {

/// Exercises that are judged at a time. A compiler takes 150 MB at most: two of them stay far below
/// the 768 MB that Gradescope gives, however many processors the container can see.
constexpr std::size_t compilers_at_once = 2;

void write_files(const PlatformRun& run, const StudentRecord& record, const std::string& figure) {
  for (const auto& [file, text] : run.files(record, figure))
    support::write_text_and_folders(file, text);
}

/// The student's own engine, if there is one to be made.
std::string figure_of(const Grading& grading, const PlatformRun& run, const fs::path& folder) {
  if (grading.course.engine.empty()) return "";
  Course course = grading.course;
  if (!run.solutions.empty())
    course.stand_in = [&](const Unit& unit) { return file_in(run.solutions, unit); };
  const auto files = files_of_units(course, grading.settings.units, files_below(run.submission));
  const auto source = [&](const Unit& unit) {
    const auto found = files.find(unit.id());
    return run.submission / (found == files.end() ? fs::path("not handed in") : found->second);
  };
  return mine_module(course).travelling_curve(course, source, folder).value_or("");
}

/// A platform's log, which students may read.
void print_verdicts(const CourseSettings& settings, const StudentRecord& record) {
  for (const UnitRecord& unit : without_hidden(settings, fitted(record)).units)
    std::cout << unit.explanation << "\n";
  if (record.out_of_time)
    std::cout << settings.units.size() - record.units.size() << " " << no_time_left << "\n";
  std::cout << earned(settings, record) << " of " << settings.most() << " points\n";
}

/// Says of each unit without a verdict that this machine has failed.
void say_failed(const CourseSettings& settings, StudentRecord& record, const std::string& why) {
  std::cerr << "tumble: " << why << "\n";
  for (const Unit& unit : settings.units) {
    if (record.find(unit)) continue;
    UnitRecord failed;
    failed.unit = unit.id();
    failed.number = unit.number;
    failed.summary = "judge failed";
    failed.judge_failure = why;
    failed.explanation = "The judge failed before it came to " + unit.number + " " + unit.name +
                         ". This is not a verdict on your code.\n";
    record.units.push_back(std::move(failed));
  }
}

}  // namespace

int grade_on_platform(const Course& course, const PlatformOptions& options) {
  const Clock::time_point deadline =
      options.seconds ? after(*options.seconds) : Clock::time_point::max();
  const CourseSettings settings = settings_or_default(course, options.settings);
  const PlatformRun run = platform_run(options.platform, options.root, settings);
  write_files(run, {}, "");           // valid from the beginning, whatever comes
  may_judge(course, Strangers::yes);  // if not, each exercise says so in its result
  const WorkFolder work, compiled;
  fs::permissions(compiled.path(), fs::perms::owner_all);
  const ObjectCache cache(compiled.path());
  const JudgeFingerprint judge(course);
  Grading grading{course, settings, settings.seed.value_or(std::random_device{}()), judge, cache};
  grading.builds_at_once = compilers_at_once;
  grading.solutions = run.solutions;
  grading.deadline = deadline;
  StudentRecord record;
  try {
    grade_student(grading, {run.identity, run.submission, false}, compiled.path() / "record.json",
                  [&](const StudentRecord& now) {
                    record = now;
                    write_files(run, record, "");
                  });
  } catch (const std::runtime_error& why) {
    say_failed(settings, record, why.what());
    write_files(run, record, "");
  }
  if (settings.wants_curve(course) && Clock::now() < deadline)
    write_files(run, record, figure_of(grading, run, work.path() / "engine"));
  print_verdicts(settings, record);
  const bool all =
      !record.out_of_time && std::all_of(record.units.begin(), record.units.end(),
                                         [](const UnitRecord& unit) { return unit.passed; });
  const bool failed =
      std::any_of(record.units.begin(), record.units.end(),
                  [](const UnitRecord& unit) { return !unit.judge_failure.empty(); });
  return failed ? 2 : run.status_tells && !all ? 1 : 0;
}

int export_package(const Course& course, const PackageOrder& order) {
  for (const std::string& note : make_package(course, order))
    std::cerr << "tumble: " << note << "\n";
  std::cerr << "tumble: what goes where: ";
  std::cout << (order.to / "README.md").string() << "\n";
  return 0;
}

}  // namespace tumble::judge
