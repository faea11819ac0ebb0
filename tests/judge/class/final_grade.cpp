#include "judge/class/final_grade.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "judge/class/canonical_names.hpp"
#include "judge/class/handed_in.hpp"
#include "support/how_many.hpp"

namespace tumble::judge {

namespace {

/// What a map says about a student; null if nothing.
template <class Value>
const Value* said_about(const std::map<std::string, Value>& all, const StudentRecord& record) {
  for (const auto& [student, value] : all)
    if (is_called(record, student)) return &value;
  return nullptr;
}

/// "2.5"
std::string short_text(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", x);
  return text;
}

/// How many days late, the first that has begun counts.
struct Lateness {
  int days = 0;           ///< 0 if it is in time or nobody knows
  int if_clock_went = 0;  ///< if a clock without a zone was put forward since the due date
};

int days_begun(double seconds) {
  return seconds > 0 ? static_cast<int>(std::ceil(seconds / 86400)) : 0;
}

Lateness lateness(const CourseSettings& settings, const StudentRecord& record) {
  const std::string* extension = said_about(settings.rules.extensions, record);
  const std::string due = extension ? *extension : settings.due.value_or("");
  const auto limit = moment_of(due), time = handed_in(record.handed_in, zone_of(due)).when;
  if (!limit) return {};
  // Who has an extension is late for the platform, which does not know it.
  if (!time) return record.marked_late && !extension ? Lateness{1, 1} : Lateness{};
  const double late = static_cast<double>(*time - *limit) - 60 * settings.rules.late->grace;
  constexpr double summer_time = 3600;
  return {days_begun(late), days_begun(names_zone(record.handed_in) ? late : late - summer_time)};
}

void subtract_late(const CourseSettings& settings, const StudentRecord& record, FinalGrade& grade) {
  if (!settings.rules.late) return;
  const LateRule& rule = *settings.rules.late;
  const auto [days, if_clock_went] = lateness(settings, record);
  if (days == 0) return;
  std::string text = support::how_many(days, "day") + " late";
  if (days > 1 && if_clock_went < days)  // no clock is put forward within the first hour
    text += " (" + std::to_string(if_clock_went) + " if summer time began after the due date)";
  if (rule.days && days > *rule.days) {
    grade.points = 0;
    grade.because.push_back(text + ", and nothing counts after " + std::to_string(*rule.days));
    return;
  }
  const double percent = std::min(100.0, days * rule.per_day);
  grade.points *= 1 - percent / 100;
  grade.because.push_back(text + ": −" + short_text(percent) + " %");
}

}  // namespace

bool is_called(const StudentRecord& record, const std::string& what) {
  const auto same = [](const std::string& a, const std::string& b) {
    return !a.empty() && folded(a) == folded(b);
  };
  // Two rows may differ by the case of a letter: their names are meant exactly.
  return canonical(record.student) == canonical(what) || same(record.who.id, what) ||
         same(record.who.name, what) || same(record.who.email, what);
}

bool is_complete(const CourseSettings& settings, const StudentRecord& record) {
  const Override* by_hand = said_about(settings.rules.overrides, record);
  if (record.absent || !record.refused.empty() || (by_hand && by_hand->points)) return true;
  if (!record.incomplete.empty()) return false;
  return std::all_of(settings.units.begin(), settings.units.end(), [&](const Unit& unit) {
    const UnitRecord* verdict = record.find(unit);
    return (verdict && verdict->judge_failure.empty()) ||
           (by_hand && by_hand->units.contains(unit.id()));
  });
}

double unit_points(const CourseSettings& settings, const StudentRecord& record, const Unit& unit) {
  if (const Override* by_hand = said_about(settings.rules.overrides, record))
    if (const auto given = by_hand->units.find(unit.id()); given != by_hand->units.end())
      return given->second;
  const UnitRecord* verdict = record.find(unit);
  return verdict ? settings.earned(*verdict) : 0;
}

FinalGrade final_grade(const CourseSettings& settings, const StudentRecord& record) {
  FinalGrade grade;
  grade.earned = earned(settings, record);
  for (const Unit& unit : settings.units) grade.points += unit_points(settings, record, unit);
  const Override* by_hand = said_about(settings.rules.overrides, record);
  if (by_hand && by_hand->points) {
    grade.points = *by_hand->points;
  } else {
    subtract_late(settings, record, grade);
  }
  grade.by_hand = by_hand != nullptr;
  if (by_hand) grade.because.push_back("given by hand: " + by_hand->reason);
  return grade;
}

}  // namespace tumble::judge
