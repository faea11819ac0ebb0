#include "judge/commands/grading/grade_messages.hpp"

#include <algorithm>
#include <iostream>
#include <map>
#include <utility>

#include "judge/class/feedback.hpp"
#include "judge/class/final_grade.hpp"
#include "judge/class/handed_in.hpp"
#include "judge/class/identical_files.hpp"
#include "support/nearest.hpp"
#include "support/wrapped.hpp"

namespace tumble::judge {

namespace {

/// Every entry that has no row, and why.
void say_left_out(const std::vector<LeftOut>& left_out) {
  constexpr const char* head = "left out, because these are not submissions:";
  if (!left_out.empty()) std::cerr << "tumble: " << head << "\n";
  for (const LeftOut& each : left_out)  // none is hidden: it could be somebody's work
    std::cerr << "  " << escaped(each.what) << ": " << escaped(each.why) << "\n";
}

/// Names in course.json that nobody in the class has.
void say_unknown(const CourseSettings& settings, const std::vector<StudentRecord>& records) {
  std::vector<std::string> names, unknown;
  for (const StudentRecord& record : records) names.push_back(record.student);
  const auto look_for = [&](const std::string& key, const std::string& student) {
    const bool known = std::any_of(records.begin(), records.end(),
                                   [&](const StudentRecord& r) { return is_called(r, student); });
    if (!known)
      unknown.push_back(key + ": there is no " + student + support::did_you_mean(student, names));
  };
  for (const auto& [student, date] : settings.rules.extensions) look_for("extensions", student);
  for (const auto& [student, points] : settings.rules.overrides) look_for("overrides", student);
  say_list("course.json names students who are not here:", unknown);
}

void say_identical(const std::vector<IdenticalFiles>& groups) {
  std::vector<std::string> lines;
  for (const IdenticalFiles& group : groups) {
    std::string line = group.unit.number + " " + group.unit.name + ": ";
    for (std::size_t i = 0; i < group.students.size(); ++i)
      line += (i == 0 ? "" : ", ") + group.students[i];
    lines.push_back(std::move(line));
  }
  say_list("identical files, which identical.csv lists too:", lines);
}

/// Where lateness costs something, work of which nobody knows when it came.
void say_timeless(const CourseSettings& settings, const std::vector<StudentRecord>& records) {
  if (!settings.rules.late) return;
  std::vector<std::string> lines;
  for (const StudentRecord& record : records) {
    const HandedIn time = handed_in(record.handed_in, zone_of(settings.due.value_or("")));
    if (record.absent || time.when || record.marked_late) continue;
    lines.push_back(record.student +
                    (time.doubt.empty() ? "" : ": \"" + record.handed_in + "\" " + time.doubt));
  }
  say_list("we don't know when these students handed in, so their work counts as on time:", lines);
}

/// What the judge has failed at.
std::vector<std::string> failures_of(const std::vector<FailedStudent>& failed,
                                     const std::vector<StudentRecord>& records) {
  std::vector<std::string> lines;
  lines.reserve(failed.size());
  for (const FailedStudent& each : failed) lines.push_back(each.student + ": " + each.why);
  for (const StudentRecord& record : records)
    for (const UnitRecord& unit : record.units)
      if (!unit.judge_failure.empty())
        lines.push_back(record.student + ", " + unit.number + " " +
                        unit.unit.substr(unit.unit.find('/') + 1) + ": " + unit.judge_failure);
  return lines;
}

}  // namespace

void print_grades(const CourseSettings& settings, const std::vector<StudentRecord>& records) {
  std::size_t width = 7;
  for (const StudentRecord& record : records)
    width = std::max(width, support::characters(escaped(record.student)));
  for (const StudentRecord& record : records) {
    char points[64];
    std::snprintf(points, sizeof points, "%8.2f of %.2f", final_grade(settings, record).points,
                  settings.most());
    const std::string note = escaped(note_on(settings, record));
    std::cout << support::padded(escaped(record.student), width) << points;
    if (!note.empty()) std::cout << (record.refused.empty() ? "  " : "  the submission ") << note;
    std::cout << "\n";
  }
}

void say_list(const std::string& head, const std::vector<std::string>& lines) {
  constexpr std::size_t most = 20;
  if (lines.empty()) return;
  std::cerr << "tumble: " << head << "\n";
  for (std::size_t i = 0; i < std::min(most, lines.size()); ++i)
    std::cerr << "  " << escaped(lines[i]) << "\n";
  if (lines.size() > most) std::cerr << "  and " << lines.size() - most << " more\n";
}

void say_about(const std::vector<LeftOut>& left_out, const std::vector<std::string>& strangers,
               const CourseSettings& settings, const std::vector<StudentRecord>& records) {
  say_left_out(left_out);
  say_list("not found on the roster:", strangers);
  say_unknown(settings, records);
  say_identical(identical_files(settings, records));
  say_timeless(settings, records);
}

void say_changes(const std::vector<StudentRecord>& before,
                 const std::vector<StudentRecord>& after) {
  std::map<std::pair<std::string, std::string>, const UnitRecord*> known;
  for (const StudentRecord& record : before)
    for (const UnitRecord& unit : record.units) known[{record.student, unit.unit}] = &unit;
  std::vector<std::string> changes;
  for (const StudentRecord& record : after)
    for (const UnitRecord& unit : record.units) {
      const auto found = known.find({record.student, unit.unit});
      if (found == known.end() || !unit.judge_failure.empty()) continue;
      const UnitRecord& last = *found->second;
      if (last.source == unit.source && last.summary != unit.summary)
        changes.push_back(record.student + ", " + unit.number + ": " + last.summary + " → " +
                          unit.summary);
    }
  say_list("changed verdicts on unchanged files:", changes);
}

bool say_failures(const std::vector<FailedStudent>& failed,
                  const std::vector<StudentRecord>& records, const std::string& again) {
  const std::vector<std::string> lines = failures_of(failed, records);
  for (const std::string& line : lines)
    std::cerr << "tumble: the judge failed at " << escaped(line) << "\n";
  if (!lines.empty())
    std::cerr << "tumble: the judge or this machine has failed here, not a student. No point is "
                 "lost: "
              << again << " judges what is missing\n";
  return !lines.empty();
}

}  // namespace tumble::judge
