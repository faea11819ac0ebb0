#include "judge/class/feedback.hpp"

#include <chrono>
#include <cstdio>

#include "judge/build/build_outcome.hpp"
#include "judge/class/final_grade.hpp"
#include "judge/class/moment.hpp"
#include "judge/verdict/markup.hpp"
#include "judge/verdict/number_text.hpp"

namespace tumble::judge {

namespace {

constexpr const char* feedback_style = R"(
:root { color-scheme: light dark; }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 56rem; margin: 2rem auto; padding: 0 1rem; }
table { border-collapse: collapse; }
td, th { text-align: left; padding: .3rem 1.2rem .3rem 0; border-bottom: 1px solid #8884; }
td.points { text-align: right; font-variant-numeric: tabular-nums; }
pre { overflow-x: auto; border-left: 4px solid #8886; padding-left: 1rem; font-size: .9rem; }
)";

/// Students see a hidden exercise when it is due.
bool is_hidden_now(const CourseSettings& settings, const Unit& unit) {
  if (!settings.hidden.contains(unit.id())) return false;
  const auto due = moment_of(settings.due.value_or(""));
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return !due || std::chrono::duration_cast<std::chrono::seconds>(now).count() < *due;
}

std::string verdict_on(const StudentRecord& record, const Unit& unit) {
  const UnitRecord* verdict = record.find(unit);
  if (verdict) return verdict->summary;
  if (record.out_of_time) return no_time_left;
  return record.absent ? not_handed_in : record.refused.empty() ? "not judged" : "not read";
}

std::string unit_line(const CourseSettings& settings, const StudentRecord& record,
                      const Unit& unit) {
  return unit.number + " " + unit.name + ": " +
         (is_hidden_now(settings, unit) ? "shown after the due date" : verdict_on(record, unit)) +
         ", " + points_text(unit_points(settings, record, unit)) + " of " +
         points_text(settings.points(unit));
}

std::string total_line(const CourseSettings& settings, const StudentRecord& record) {
  return points_text(final_grade(settings, record).points) + " of " + points_text(settings.most()) +
         " points";
}

/// What a student reads about a unit that does not pass; empty if there is nothing to be said.
std::string explanation_of(const CourseSettings& settings, const StudentRecord& record,
                           const Unit& unit) {
  const UnitRecord* verdict = record.find(unit);
  if (!verdict || verdict->passed || is_hidden_now(settings, unit)) return "";
  if (verdict->summary == not_handed_in) return "";
  return verdict->explanation;
}

/// "the judge failed at 1.3, 1.5: no verdict", or nothing.
std::string judge_failures(const StudentRecord& record) {
  std::string units;
  for (const UnitRecord& unit : record.units)
    if (!unit.judge_failure.empty()) units += (units.empty() ? "" : ", ") + unit.number;
  return units.empty() ? "" : "the judge failed at " + units + ": no verdict";
}

/// "1.3 is refused: euler_step.cpp is empty" of files that were not even compiled, or nothing.
std::vector<std::string> refused_files(const StudentRecord& record) {
  std::vector<std::string> lines;
  for (const UnitRecord& unit : record.units)
    if (unit.summary == name_of(BuildOutcome::refused))
      lines.push_back(unit.number +
                      " is refused: " + unit.detail.substr(0, unit.detail.find('\n')));
  return lines;
}

/// "not judged yet: 1.3, 1.5" of a grading that was interrupted or had no time left, or nothing.
std::string not_judged(const CourseSettings& settings, const StudentRecord& record) {
  if (record.absent || !record.refused.empty()) return "";
  if (!record.incomplete.empty()) return "not judged: " + record.incomplete;
  if (const std::size_t left = count_unreached(settings, record); left > 0)
    return std::to_string(left) + " " + no_time_left;
  std::string units;
  for (const Unit& unit : settings.units)
    if (!record.find(unit)) units += (units.empty() ? "" : ", ") + unit.number;
  return units.empty() ? "" : "not judged yet: " + units;
}

std::string called(const StudentRecord& record) {
  return record.who.name.empty() ? record.student : record.who.name;
}

}  // namespace

std::string points_text(double points) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", points);
  std::string result = text;
  while (result.back() == '0') result.pop_back();
  if (result.back() == '.') result.pop_back();
  return result == "-0" ? "0" : result;
}

std::string note_on(const CourseSettings& settings, const StudentRecord& record) {
  std::vector<std::string> notes;
  if (record.absent) notes.emplace_back("not handed in");
  if (!record.refused.empty()) notes.push_back(record.refused);
  notes.insert(notes.end(), record.notes.begin(), record.notes.end());
  for (std::string& line : refused_files(record)) notes.push_back(std::move(line));
  for (const std::string& open : {judge_failures(record), not_judged(settings, record)})
    if (!open.empty()) notes.push_back(open);
  const FinalGrade grade = final_grade(settings, record);
  notes.insert(notes.end(), grade.because.begin(), grade.because.end());
  std::string text;
  for (const std::string& note : notes) text += (text.empty() ? "" : "; ") + note;
  return text;
}

std::string feedback_text(const CourseSettings& settings, const StudentRecord& record) {
  std::string text =
      settings.title + "\n" + called(record) + ": " + total_line(settings, record) + "\n";
  if (const std::string note = note_on(settings, record); !note.empty()) text += note + "\n";
  text += "\n";
  for (const Unit& unit : settings.units) text += "  " + unit_line(settings, record, unit) + "\n";
  for (const Unit& unit : settings.units)
    if (const std::string why = explanation_of(settings, record, unit); !why.empty())
      text += "\n" + why;
  return printable(text);
}

std::string feedback_html(const CourseSettings& settings, const StudentRecord& record) {
  std::string page =
      "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n<title>" +
      markup(settings.title) + "</title>\n<style>" + feedback_style + "</style>\n<h1>" +
      markup(settings.title) + "</h1>\n<p>" + markup(called(record)) + ": <b>" +
      total_line(settings, record) + "</b></p>\n";
  if (const std::string note = note_on(settings, record); !note.empty())
    page += "<p>" + markup(note) + "</p>\n";
  page += "<table>\n<tr><th>exercise<th>verdict<th>points</tr>\n";
  for (const Unit& unit : settings.units)
    page += "<tr><td>" + unit.number + " " + markup(unit.name) + "<td>" +
            (is_hidden_now(settings, unit) ? "shown after the due date"
                                           : markup(verdict_on(record, unit))) +
            "<td class=\"points\">" + points_text(unit_points(settings, record, unit)) + " of " +
            points_text(settings.points(unit)) + "</tr>\n";
  page += "</table>\n";
  for (const Unit& unit : settings.units)
    if (const std::string why = explanation_of(settings, record, unit); !why.empty())
      page += "<h2>" + unit.number + " " + markup(unit.name) + "</h2>\n<pre>" + markup(why) +
              "</pre>\n";
  return page + "</html>\n";
}

std::string feedback_comment(const CourseSettings& settings, const StudentRecord& record) {
  std::string comment = "<p>" + total_line(settings, record) + "</p><ul>";
  for (const Unit& unit : settings.units)
    comment += "<li>" + markup(unit_line(settings, record, unit)) + "</li>";
  comment += "</ul>";
  if (const std::string note = note_on(settings, record); !note.empty())
    comment += "<p>" + markup(note) + "</p>";
  return comment;
}

}  // namespace tumble::judge
