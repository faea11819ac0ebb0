#include "judge/class/grades.hpp"

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "judge/verdict/markup.hpp"
#include "support/csv.hpp"

namespace tumble::judge {

namespace {

/// With at most two digits behind the point, and none that is not needed.
std::string points_text(double points) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", points);
  std::string result = text;
  while (result.back() == '0') result.pop_back();
  if (result.back() == '.') result.pop_back();
  return result;
}

/// What a student chose to write must not become a formula in a spreadsheet.
std::string foreign_field(const std::string& text) {
  const bool is_formula =
      !text.empty() && std::string("=+-@\t\r").find(text[0]) != std::string::npos;
  return support::csv_field(is_formula ? "'" + text : text);
}

std::size_t count_passed(const StudentRecord& record) {
  return static_cast<std::size_t>(std::count_if(record.units.begin(), record.units.end(),
                                                [](const UnitRecord& u) { return u.passed; }));
}

std::size_t count_judge_failures(const StudentRecord& record) {
  return static_cast<std::size_t>(
      std::count_if(record.units.begin(), record.units.end(),
                    [](const UnitRecord& u) { return !u.judge_failure.empty(); }));
}

/// The units that the deadline has come before.
std::size_t count_unreached(const CourseSettings& settings, const StudentRecord& record) {
  return record.out_of_time ? settings.units.size() - record.units.size() : 0;
}

/// Why the row is not what it should be.
std::string note_on(const CourseSettings& settings, const StudentRecord& record) {
  std::string note = record.refused, failed;
  const auto add = [&](const std::string& more) { note += (note.empty() ? "" : "; ") + more; };
  for (const UnitRecord& unit : record.units)
    if (!unit.judge_failure.empty()) failed += (failed.empty() ? "" : ", ") + unit.number;
  if (!failed.empty()) add("the judge failed at " + failed + ": no verdict");
  if (const std::size_t left = count_unreached(settings, record); left > 0)
    add(std::to_string(left) + " " + no_time_left);
  return note;
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
  out << "\n";
  const double most = settings.most();
  for (const StudentRecord& record : records) {
    const double points = earned(settings, record);
    out << foreign_field(record.student) << "," << points_text(points) << "," << points_text(most)
        << "," << points_text(100 * points / most) << "," << count_passed(record) << ","
        << foreign_field(note_on(settings, record));
    for (const Unit& unit : settings.units) {
      const UnitRecord* known = record.find(unit);
      const bool judged = known && known->judge_failure.empty();
      out << "," << (judged ? points_text(settings.earned(*known)) : "");
    }
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
    const std::size_t refused = record.refused.empty() ? 0 : 1;
    const std::size_t unjudged = count_judge_failures(record), errors = refused + unjudged;
    const std::size_t skipped = count_unreached(settings, record);
    out << "  <testsuite name=\"" << markup(record.student) << "\" tests=\""
        << record.units.size() + refused + skipped << "\" failures=\""
        << record.units.size() - count_passed(record) - unjudged << "\" errors=\"" << errors << "\""
        << (skipped > 0 ? " skipped=\"" + std::to_string(skipped) + "\"" : "") << ">\n";
    if (refused > 0)
      out << "    <testcase classname=\"" << markup(record.student)
          << "\" name=\"submission\">\n      <error message=\"" << markup(record.refused)
          << "\"/>\n    </testcase>\n";
    for (const UnitRecord& unit : record.units) write_case(out, record, unit);
    write_unreached(out, settings, record);
    out << "  </testsuite>\n";
  }
  out << "</testsuites>\n";
  return out.str();
}

}  // namespace tumble::judge
