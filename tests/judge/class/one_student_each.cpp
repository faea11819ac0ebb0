#include "judge/class/one_student_each.hpp"

#include <map>
#include <set>

#include "judge/class/canonical_names.hpp"
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

/// The one row that is meant; empty if there is none.
std::string row_called(const std::vector<StudentRecord>& all, const char* key,
                       const std::string& name) {
  const std::vector<std::string> rows = rows_called(all, name);
  if (rows.empty()) return "";
  require(rows.size() < 2, "course.json, ", key, ": ", escaped(name), " means ", rows.size(),
          " students, ", escaped(rows.front()), " and ", escaped(rows.back()),
          ": call each by number, by e-mail address or by the name of the row");
  return rows.front();
}

template <class Value>
std::map<std::string, Value> by_row(const std::map<std::string, Value>& said, const char* key,
                                    const std::vector<StudentRecord>& all) {
  std::map<std::string, Value> result;
  std::map<std::string, std::string> name_of_row;
  for (const auto& [name, value] : said) {
    const std::string row = row_called(all, key, name);
    const auto [other, is_new] = name_of_row.try_emplace(row.empty() ? name : row, name);
    require(is_new, "course.json, ", key, ": ", escaped(other->second), " and ", escaped(name),
            " are one student, ", escaped(row), ": which counts?");
    // Who is called by another name than the row's is found by it, and may have no row yet.
    const bool but_for_case = folded(row) == folded(name);
    result[but_for_case ? row : name] = value;
  }
  return result;
}

}  // namespace

std::vector<StudentRecord> everybody(const ClassRoll& roll) {
  std::vector<StudentRecord> all;
  for (const Submission& each : roll.submissions) all.push_back(only_names(each.student, each.who));
  for (const Member& each : roll.match.missing)
    all.push_back(only_names(each.who.name + " " + each.who.id, each.who));
  return all;
}

std::vector<std::string> rows_called(const std::vector<StudentRecord>& all,
                                     const std::string& name) {
  std::set<std::string> exactly, whatever_case;
  for (const StudentRecord& record : all) {
    if (is_called(record, name)) exactly.insert(record.student);
    if (folded(record.student) == folded(name)) whatever_case.insert(record.student);
  }
  const std::set<std::string>& meant = exactly.empty() ? whatever_case : exactly;
  return {meant.begin(), meant.end()};
}

ClassRules with_names_of_rows(ClassRules rules, const std::vector<StudentRecord>& all) {
  rules.extensions = by_row(rules.extensions, "extensions", all);
  rules.overrides = by_row(rules.overrides, "overrides", all);
  return rules;
}

}  // namespace tumble::judge
