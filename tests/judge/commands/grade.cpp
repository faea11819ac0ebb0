#include <algorithm>
#include <iostream>
#include <thread>

#include "judge/build/work_folder.hpp"
#include "judge/class/class_outputs.hpp"
#include "judge/class/collect.hpp"
#include "judge/class/final_grade.hpp"
#include "judge/class/grading_lock.hpp"
#include "judge/class/progress_line.hpp"
#include "judge/commands/commands.hpp"
#include "judge/commands/grade_messages.hpp"
#include "judge/commands/sandbox.hpp"
#include "support/nearest.hpp"
#include "support/text_file.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

/// What there is to grade.
struct Work {
  WorkFolder unpacked;
  ClassWork all;
  std::optional<Roster> roster;
  RosterMatch match;

  Work(const Course& course, const CourseSettings& settings, const GradeOptions& options) {
    std::optional<Lms> from;
    if (options.from) from = lms_named(*options.from);
    if (options.roster) roster = read_roster(*options.roster);
    all = collect(course, options.folders, from, settings.rules.several, unpacked);
    if (roster) match = judge::match(*roster, all.submissions);
    if (all.lms == Lms::none && roster && !from) all.lms = roster->lms;
  }
};

/// A row for who is on the roster and has handed in nothing.
StudentRecord absent_record(const Member& member) {
  StudentRecord record{!member.who.name.empty()    ? member.who.name
                       : !member.who.email.empty() ? member.who.email
                       : !member.who.id.empty()    ? member.who.id
                                                   : member.login,
                       1,
                       0,
                       "",
                       {}};
  record.who = member.who;
  record.absent = true;
  return record;
}

/// All rows of the table, by the students' names.
std::vector<StudentRecord> rows_of(const Work& work, const GradesFolder& folder,
                                   const CourseSettings& settings) {
  std::vector<StudentRecord> records = records_of(folder, settings, work.all.submissions);
  std::set<std::string> names;
  for (const StudentRecord& record : records) names.insert(record.student);
  for (const Member& member : work.match.missing) {
    StudentRecord record = absent_record(member);
    while (!names.insert(record.student).second) record.student += " (" + member.who.id + ")";
    records.push_back(std::move(record));
  }
  std::stable_sort(
      records.begin(), records.end(),
      [](const StudentRecord& a, const StudentRecord& b) { return a.student < b.student; });
  return records;
}

/// Those of the submissions that are to be judged.
std::vector<Submission> wanted(const std::vector<Submission>& all,
                               const std::vector<std::string>& students) {
  if (students.empty()) return all;
  std::vector<Submission> chosen;
  for (const std::string& student : students) {
    const std::size_t before = chosen.size();
    std::vector<std::string> names;
    for (const Submission& submission : all) {
      StudentRecord record{submission.student, 1, 0, "", {}};
      record.who = submission.who;
      if (is_called(record, student)) chosen.push_back(submission);
      names.push_back(submission.student);
    }
    require(chosen.size() > before, "there is no submission of '", student, "'",
            support::did_you_mean(student, names));
  }
  return chosen;
}

/// Ids of the units that --only names.
std::set<std::string> units_named(const Course& course, const CourseSettings& settings,
                                  const std::vector<std::string>& names) {
  std::set<std::string> ids;
  for (const std::string& name : names)
    for (const Unit& unit : course.select(name)) {
      require(settings.weights.contains(unit.id()), "--only ", name, ": ", unit.number, " ",
              unit.name, " does not count");
      ids.insert(unit.id());
    }
  return ids;
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

/// Keeps the settings for the report.
void keep_settings(const GradesFolder& folder, const std::optional<fs::path>& settings) {
  std::error_code was_not_there;
  if (settings)
    support::write_text(folder.settings(), support::read_text(*settings));
  else
    fs::remove(folder.settings(), was_not_there);
}

/// Writes what there is, says what was written, and how it ended.
int finish(const Work& work, const GradesFolder& folder, const CourseSettings& settings,
           const std::vector<FailedStudent>& failed, const Interruption& interruption,
           std::chrono::steady_clock::time_point start) {
  const std::vector<StudentRecord> records = rows_of(work, folder, settings);
  const auto written = write_outputs(folder, {settings, records, work.all.submissions, work.all.lms,
                                              work.roster ? &*work.roster : nullptr});
  print_grades(settings, records);
  say_about(work.all.left_out, work.match.strangers, settings, records);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  std::cerr << "tumble: " << duration_text(taken.count()) << "; grades: ";
  for (const fs::path& file : written) std::cerr << file.string() << ", ";
  std::cerr << "one file a student in " << (folder.path / "students").string() << ", for them in "
            << folder.feedback().string() << "\n";
  if (interruption.asked()) {
    std::cerr << "tumble: interrupted: the grades are those of what was judged; the same command "
                 "goes on there\n";
    return 130;
  }
  const bool has_failed = say_failures(failed, records), unfinished = said_who_is_left(records);
  return has_failed ? 2 : unfinished ? 1 : 0;
}

}  // namespace

int grade(const Course& course, const GradeOptions& options) {
  const CourseSettings settings = settings_or_default(course, options.settings);
  const Work work(course, settings, options);
  const std::vector<Submission> submissions = wanted(work.all.submissions, options.students);
  const std::set<std::string> only = units_named(course, settings, options.only);
  if (!may_judge(course, options.strict ? Strangers::strictly : Strangers::yes)) return 2;
  const GradesFolder folder{options.out};
  fs::create_directories(folder.path / "students");
  const GradingLock lock(folder.lock());
  keep_settings(folder, options.settings);
  const WorkFolder compiled;
  fs::permissions(compiled.path(), fs::perms::owner_all);  // nobody else's, not even to look in
  const ObjectCache cache(compiled.path());
  const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  const std::size_t students_at_once = options.at_once.value_or(cores);
  // A compiler takes 150 MB: no more of them than cores.
  const std::size_t builds_at_once = std::max<std::size_t>(1, cores / students_at_once);
  const JudgeFingerprint judge(course);
  Grading grading{course, settings, class_seed(settings, folder), judge, cache, builds_at_once};
  grading.only = only;
  if (options.seconds) grading.deadline = after(*options.seconds);
  std::cerr << "tumble: " << submissions.size() << " submissions, " << settings.units.size()
            << " exercises each\n";
  say_list("records:", set_damaged_aside(folder, work.all.submissions));
  const auto start = std::chrono::steady_clock::now();
  const Interruption interruption;
  const std::vector<StudentRecord> before = records_of(folder, settings, submissions);
  const std::vector<FailedStudent> failed =
      grade_class(grading, submissions, folder, students_at_once, interruption);
  say_changes(before, records_of(folder, settings, submissions));
  return finish(work, folder, settings, failed, interruption, start);
}

}  // namespace tumble::judge
