#include "judge/platforms/platform.hpp"

#include <algorithm>
#include <iostream>
#include <random>

#include "judge/build/work_folder.hpp"
#include "judge/class/grade_student.hpp"
#include "judge/class/submissions.hpp"
#include "judge/commands/commands.hpp"
#include "judge/commands/given_files.hpp"
#include "judge/commands/mine_module.hpp"
#include "judge/commands/sandbox.hpp"
#include "judge/platforms/package.hpp"
#include "support/text_file.hpp"

namespace tumble::judge {

namespace {

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

}  // namespace

int platform_command(const Course& course, const PlatformOptions& options) {
  const CourseSettings settings = settings_or_default(course, options.settings);
  const PlatformRun run = platform_run(options.platform, options.root, settings);
  write_files(run, {}, "");  // valid from the beginning, whatever comes
  if (!may_judge(course, Strangers::yes)) return 2;
  const WorkFolder work, compiled;
  fs::permissions(compiled.path(), fs::perms::owner_all);
  const ObjectCache cache(compiled.path());
  Grading grading{course, settings, settings.seed.value_or(std::random_device{}()),
                  judge_fingerprint(), cache};
  grading.solutions = run.solutions;
  StudentRecord record;
  grade_student(grading, {run.identity, run.submission, false}, compiled.path() / "record.json",
                [&](const StudentRecord& now) {
                  record = now;
                  write_files(run, record, "");
                });
  if (settings.wants_curve(course))
    write_files(run, record, figure_of(grading, run, work.path() / "engine"));
  for (const UnitRecord& unit : record.units) std::cout << unit.explanation << "\n";
  std::cout << earned(settings, record) << " of " << settings.most() << " points\n";
  const bool all = std::all_of(record.units.begin(), record.units.end(),
                               [](const UnitRecord& unit) { return unit.passed; });
  return run.status_tells && !all ? 1 : 0;
}

int export_command(const Course& course, const ExportOptions& options) {
  make_package(course, options.platform, options.settings, options.image, options.to);
  std::cerr << "tumble: what goes where: ";
  std::cout << (options.to / "README.md").string() << "\n";
  return 0;
}

}  // namespace tumble::judge
