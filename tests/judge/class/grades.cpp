#include "judge/class/grades.hpp"

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "judge/class/csv_table.hpp"
#include "judge/class/feedback.hpp"
#include "judge/class/final_grade.hpp"
#include "judge/verdict/markup.hpp"

namespace tumble::judge {

namespace {

std::size_t count_passed(const StudentRecord& record) {
  return static_cast<std::size_t>(std::count_if(record.units.begin(), record.units.end(),
                                                [](const UnitRecord& u) { return u.passed; }));
}

std::size_t count_judge_failures(const StudentRecord& record) {
  return static_cast<std::size_t>(
      std::count_if(record.units.begin(), record.units.end(),
                    [](const UnitRecord& u) { return !u.judge_failure.empty(); }));
}

void write_case(std::ostream& out, const StudentRecord& student, const UnitRecord& unit) {
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "%.3f", unit.seconds);
  out << "    <testcase classname=\"" << markup(student.student) << "\" name=\"" << unit.number
      << " " << markup(unit.unit) << "\" time=\"" << seconds << "\"";
  if (unit.passed)
    out << "/>\n";
  else if (!unit.judge_failure.empty())
    out << ">\n      <error message=\"" << markup("the judge failed: " + unit.judge_failure)
        << "\"/>\n    </testcase>\n";
  else
    out << ">\n      <failure message=\"" << markup(unit.summary) << "\">"
        << markup(unit.explanation) << "</failure>\n    </testcase>\n";
}

void write_unreached(std::ostream& out, const CourseSettings& settings,
                     const StudentRecord& record) {
  if (!record.out_of_time) return;
  for (const Unit& unit : settings.units)
    if (!record.find(unit))
      out << "    <testcase classname=\"" << markup(record.student) << "\" name=\"" << unit.number
          << " " << markup(unit.id()) << "\">\n      <skipped message=\"" << no_time_left
          << "\"/>\n    </testcase>\n";
}

}  // namespace

std::string grades_csv(const CourseSettings& settings, const std::vector<StudentRecord>& records) {
  std::ostringstream out;
  out << "student,points,of,percent,passed,note";
  for (const Unit& unit : settings.units) out << "," << unit.number << " " << unit.name;
  const bool known_elsewhere =
      std::any_of(records.begin(), records.end(),
                  [](const StudentRecord& r) { return !r.who.name.empty() || !r.who.id.empty(); });
  out << (known_elsewhere ? ",name,id,email\n" : "\n");
  const double most = settings.most();
  for (const StudentRecord& record : records) {
    const double points = final_grade(settings, record).points;
    out << foreign_field(record.student) << "," << points_text(points) << "," << points_text(most)
        << "," << points_text(100 * points / most) << "," << count_passed(record) << ","
        << foreign_field(note_on(settings, record));
    for (const Unit& unit : settings.units) {
      const UnitRecord* known = record.find(unit);
      const bool judged = known && known->judge_failure.empty();
      out << "," << (judged ? points_text(unit_points(settings, record, unit)) : "");
    }
    if (known_elsewhere)
      for (const std::string* text : {&record.who.name, &record.who.id, &record.who.email})
        out << "," << foreign_field(*text);
    out << "\n";
  }
  return out.str();
}

std::string grades_junit(const CourseSettings& settings,
                         const std::vector<StudentRecord>& records) {
  std::ostringstream out;
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"" << markup(settings.title)
      << "\">\n";
  for (const StudentRecord& record : records) {
    const std::string& unread = record.refused.empty() ? record.incomplete : record.refused;
    const std::size_t refused = unread.empty() ? 0 : 1;
    const std::size_t unjudged = count_judge_failures(record), errors = refused + unjudged;
    const std::size_t skipped = count_unreached(settings, record);
    out << "  <testsuite name=\"" << markup(record.student) << "\" tests=\""
        << record.units.size() + refused + skipped << "\" failures=\""
        << record.units.size() - count_passed(record) - unjudged << "\" errors=\"" << errors << "\""
        << (skipped > 0 ? " skipped=\"" + std::to_string(skipped) + "\"" : "") << ">\n";
    if (refused > 0)
      out << "    <testcase classname=\"" << markup(record.student)
          << "\" name=\"submission\">\n      <error message=\"" << markup(unread)
          << "\"/>\n    </testcase>\n";
    for (const UnitRecord& unit : record.units) write_case(out, record, unit);
    write_unreached(out, settings, record);
    out << "  </testsuite>\n";
  }
  out << "</testsuites>\n";
  return out.str();
}

}  // namespace tumble::judge
