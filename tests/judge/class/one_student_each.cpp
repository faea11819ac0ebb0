#include "judge/class/one_student_each.hpp"

#include <set>

#include "judge/class/file_names.hpp"
#include "judge/class/final_grade.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

StudentRecord only_names(const std::string& student, const Identity& who) {
  StudentRecord record{student, 1, 0, "", {}};
  record.who = who;
  return record;
}

/// Everybody who has a row.
std::vector<StudentRecord> everybody(const ClassRoll& roll) {
  std::vector<StudentRecord> all;
  for (const Submission& each : roll.submissions) all.push_back(only_names(each.student, each.who));
  for (const Member& each : roll.match.missing)
    all.push_back(only_names(each.who.name + " " + each.who.id, each.who));
  return all;
}

}  // namespace

void require_one_student_each(const ClassRules& rules, const ClassRoll& roll) {
  const std::vector<StudentRecord> all = everybody(roll);
  const auto require_one = [&](const char* key, const std::string& name) {
    std::set<std::string> meant;
    for (const StudentRecord& record : all)
      if (is_called(record, name)) meant.insert(record.student);
    require(meant.size() < 2, "course.json, ", key, ": ", escaped(name), " means ", meant.size(),
            " students, ", meant.empty() ? "" : escaped(*meant.begin()), " and ",
            meant.empty() ? "" : escaped(*meant.rbegin()),
            ": call each by number, by e-mail address or by the name of the row");
  };
  for (const auto& [student, date] : rules.extensions) require_one("extensions", student);
  for (const auto& [student, points] : rules.overrides) require_one("overrides", student);
}

}  // namespace tumble::judge
