#include "judge/commands/grading/finish_grading.hpp"

#include <algorithm>
#include <iostream>
#include <set>

#include "judge/class/class_outputs.hpp"
#include "judge/class/progress_line.hpp"
#include "judge/commands/grading/grade_messages.hpp"

namespace tumble::judge {

namespace {

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
std::vector<StudentRecord> rows_of(const ClassRoll& roll, const GradesFolder& folder,
                                   const CourseSettings& settings) {
  std::vector<StudentRecord> records = records_of(folder, settings, roll.submissions);
  std::set<std::string> names;
  for (const StudentRecord& record : records) names.insert(record.student);
  for (const Member& member : roll.match.missing) {
    StudentRecord record = absent_record(member);
    while (!names.insert(record.student).second) record.student += " (" + member.who.id + ")";
    records.push_back(std::move(record));
  }
  std::stable_sort(
      records.begin(), records.end(),
      [](const StudentRecord& a, const StudentRecord& b) { return a.student < b.student; });
  return records;
}

/// Says for whom no time was left.
/// @return whether there is anybody
bool said_who_is_left(const std::vector<StudentRecord>& records, const GradingRun& run) {
  const auto left = std::count_if(records.begin(), records.end(),
                                  [](const StudentRecord& record) { return record.out_of_time; });
  if (left > 0)
    std::cerr << "tumble: no time was left for " << left << " of " << records.size()
              << " submissions; " << run.again << " goes on with them\n";
  return left > 0;
}

/// Says whose work we do not have whole.
/// @return whether there is anybody
bool said_who_is_incomplete(const std::vector<StudentRecord>& records) {
  std::vector<std::string> lines;
  for (const StudentRecord& record : records)
    if (!record.incomplete.empty()) lines.push_back(record.student + ": " + record.incomplete);
  say_list(
      "not judged, and no point is lost: get the download anew, or ask these students for a .zip "
      "and give it in a folder:",
      lines);
  return !lines.empty();
}

}  // namespace

int finish_class(const ClassRoll& roll, const GradesFolder& folder, const CourseSettings& settings,
                 const GradingRun& run) {
  const std::vector<StudentRecord> records = rows_of(roll, folder, settings);
  const auto written = write_outputs(folder, {settings, records, roll.submissions, roll.lms,
                                              roll.roster ? &*roll.roster : nullptr});
  print_grades(settings, records);
  say_about(roll.left_out, roll.match.strangers, settings, records);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - run.start;
  std::cerr << "tumble: " << duration_text(taken.count()) << "; grades: ";
  for (const fs::path& file : written) std::cerr << file.string() << ", ";
  std::cerr << "one record per student in " << (folder.path / "students").string()
            << ", their feedback in " << folder.feedback().string() << "\n";
  return say_end(records, run);
}

int say_end(const std::vector<StudentRecord>& records, const GradingRun& run) {
  if (run.interrupted) {
    std::cerr << "tumble: interrupted: the grades count only what is judged so far; " << run.again
              << " goes on from there\n";
    return 130;
  }
  const bool has_failed = say_failures(run.failed, records, run.again),
             is_incomplete = said_who_is_incomplete(records),
             unfinished = said_who_is_left(records, run) || is_incomplete;
  return has_failed ? 2 : unfinished ? 1 : 0;
}

}  // namespace tumble::judge
