#include <algorithm>
#include <iostream>
#include <thread>

#include "judge/build/work_folder.hpp"
#include "judge/class/grade_class.hpp"
#include "judge/class/grades.hpp"
#include "judge/class/progress_line.hpp"
#include "judge/commands/commands.hpp"
#include "judge/commands/sandbox.hpp"
#include "support/text_file.hpp"

namespace tumble::judge {

namespace {

/// One line a student, and what was refused.
void print_grades(const CourseSettings& settings, const std::vector<StudentRecord>& records) {
  std::size_t width = 7;
  for (const StudentRecord& record : records) width = std::max(width, record.student.size());
  for (const StudentRecord& record : records) {
    char points[64];
    std::snprintf(points, sizeof points, "%8.2f of %.2f", earned(settings, record),
                  settings.most());
    std::cout << record.student << std::string(width - record.student.size(), ' ') << points;
    if (!record.refused.empty()) std::cout << "  the submission " << record.refused;
    std::cout << "\n";
  }
}

/// Says for whom no time was left.
/// @return whether there is anybody
bool said_who_is_left(const std::vector<StudentRecord>& records) {
  const auto left = std::count_if(records.begin(), records.end(),
                                  [](const StudentRecord& record) { return record.out_of_time; });
  if (left > 0)
    std::cerr << "tumble: no time was left for " << left << " of " << records.size()
              << " submissions; the same command goes on there\n";
  return left > 0;
}

/// Says what the judge has failed at.
/// @return whether there was anything
bool report_failures(const std::vector<FailedStudent>& failed,
                     const std::vector<StudentRecord>& records) {
  for (const FailedStudent& each : failed)
    std::cerr << "tumble: the judge failed at " << each.student << ": " << each.why << "\n";
  bool any = !failed.empty();
  for (const StudentRecord& record : records)
    for (const UnitRecord& unit : record.units) {
      if (unit.judge_failure.empty()) continue;
      any = true;
      std::cerr << "tumble: the judge failed at " << record.student << ", " << unit.number << " "
                << unit.unit.substr(unit.unit.find('/') + 1) << ": " << unit.judge_failure << "\n";
    }
  if (any)
    std::cerr << "tumble: these are failures of the judge or of this machine, and cost nobody a "
                 "point for good: the same command again judges what is missing\n";
  return any;
}

}  // namespace

int grade(const Course& course, const GradeOptions& options) {
  const CourseSettings settings = settings_or_default(course, options.settings);
  const std::vector<Submission> submissions = submissions_in(options.folders);
  if (!may_judge(course, options.strict ? Strangers::strictly : Strangers::yes)) return 2;
  const GradesFolder folder{options.out};
  fs::create_directories(folder.path / "students");
  const WorkFolder compiled;
  fs::permissions(compiled.path(), fs::perms::owner_all);  // nobody else's, not even to look in
  const ObjectCache cache(compiled.path());
  const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  const std::size_t students_at_once = options.at_once.value_or(cores);
  // A compiler takes 150 MB: no more of them than cores.
  const std::size_t builds_at_once = std::max<std::size_t>(1, cores / students_at_once);
  Grading grading{course, settings,      class_seed(settings, folder), judge_fingerprint(),
                  cache,  builds_at_once};
  if (options.seconds) grading.deadline = after(*options.seconds);
  std::cerr << "tumble: " << submissions.size() << " submissions, " << settings.units.size()
            << " exercises each\n";
  const auto start = std::chrono::steady_clock::now();
  const std::vector<FailedStudent> failed =
      grade_class(grading, submissions, folder, students_at_once);
  const std::vector<StudentRecord> records = records_of(folder, submissions);
  support::write_text(folder.csv(), grades_csv(settings, records));
  support::write_text(folder.junit(), grades_junit(settings, records));
  print_grades(settings, records);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  std::cerr << "tumble: " << duration_text(taken.count()) << "; grades: " << folder.csv().string()
            << ", " << folder.junit().string() << ", one file a student in "
            << (folder.path / "students").string() << "\n";
  const bool has_failed = report_failures(failed, records), unfinished = said_who_is_left(records);
  return has_failed ? 2 : unfinished ? 1 : 0;
}

}  // namespace tumble::judge
