#include "judge/class/identical_files.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "judge/class/csv_table.hpp"
#include "judge/class/statistics.hpp"

namespace tumble::judge {

namespace {

/// Who has a text, and how many submissions that are.
struct Group {
  IdenticalFiles files;
  std::set<std::string> works;
};

std::vector<IdenticalFiles> identical_in(const Unit& unit,
                                         const std::vector<StudentRecord>& records) {
  std::map<std::uint64_t, Group> groups;
  for (const StudentRecord& record : records) {
    const UnitRecord* verdict = record.find(unit);
    if (!verdict || not_started(*verdict)) continue;
    Group& group = groups[verdict->source];
    group.files.unit = unit;
    group.files.students.push_back(record.student);
    group.works.insert(record.together.empty() ? "of " + record.student : record.together);
  }
  std::vector<IdenticalFiles> found;
  for (auto& [source, group] : groups)
    if (group.works.size() > 1) found.push_back(std::move(group.files));
  // By the first of them: fingerprints are no order that anybody expects.
  std::sort(found.begin(), found.end(), [](const IdenticalFiles& a, const IdenticalFiles& b) {
    return a.students < b.students;
  });
  return found;
}

}  // namespace

std::vector<IdenticalFiles> identical_files(const CourseSettings& settings,
                                            const std::vector<StudentRecord>& records) {
  std::vector<IdenticalFiles> all;
  for (const Unit& unit : settings.units)
    for (IdenticalFiles& group : identical_in(unit, records)) all.push_back(std::move(group));
  return all;
}

std::string identical_csv(const std::vector<IdenticalFiles>& groups) {
  std::string text = "exercise,students\n";
  for (const IdenticalFiles& group : groups) {
    std::string names;
    for (const std::string& student : group.students)
      names += (names.empty() ? "" : "; ") + student;
    text += group.unit.number + " " + group.unit.name + "," + foreign_field(names) + "\n";
  }
  return text;
}

}  // namespace tumble::judge
