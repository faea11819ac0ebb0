#include "judge/platforms/results.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <nlohmann/json.hpp>

#include "judge/platforms/fitted.hpp"
#include "judge/verdict/json.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

using nlohmann::ordered_json;

namespace {

std::string title(const Unit& unit) { return unit.number + " " + unit.name; }

bool is_hidden(const CourseSettings& settings, const Unit& unit) {
  return settings.hidden.contains(unit.id());
}

/// Why there is no verdict.
std::string without_verdict(const StudentRecord& record) {
  return record.out_of_time ? no_time_left : "not judged yet";
}

/// What a student reads about a unit, judged or not.
std::string words_about(const StudentRecord& record, const Unit& unit) {
  if (!record.refused.empty()) return "The submission " + record.refused + ".";
  if (const UnitRecord* verdict = record.find(unit)) return verdict->explanation;
  std::string sentence = without_verdict(record) + ".";
  sentence[0] = 'N';
  return sentence;
}

double points_of(const CourseSettings& settings, const StudentRecord& record, const Unit& unit) {
  const UnitRecord* verdict = record.find(unit);
  return verdict ? settings.earned(*verdict) : 0;
}

bool passed(const StudentRecord& record, const Unit& unit) {
  const UnitRecord* verdict = record.find(unit);
  return verdict && verdict->passed;
}

std::set<std::string> names_of_misconceptions(const StudentRecord& record, const Unit& unit) {
  std::set<std::string> names;
  if (const UnitRecord* verdict = record.find(unit))
    for (const CaseRecord& each : verdict->cases)
      names.insert(each.misconceptions.begin(), each.misconceptions.end());
  return names;
}

double seconds_of(const StudentRecord& record) {
  double sum = 0;
  for (const UnitRecord& unit : record.units) sum += unit.seconds;
  return sum;
}

/// An SVG as an address that a page can show.
std::string data_url(const std::string& svg) {
  static constexpr char digits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string url = "data:image/svg+xml;base64,";
  for (std::size_t i = 0; i < svg.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < svg.size() ? static_cast<unsigned char>(svg[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      url += i + k <= svg.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return url;
}

std::string now_in_utc() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

/// As Markdown's block of code: whatever is in it, it stays text.
std::string indented(const std::string& text) {
  std::string lines = "    ";
  for (const char c : text) lines += c == '\n' ? std::string("\n    ") : std::string(1, c);
  return lines + "\n";
}

constexpr const char* about_the_figure =
    "An engine with your functions: its error against its time, beside the library's.";

/// Verdicts that cost no attempt: a file does not compile, or the judge itself failed.
std::vector<const UnitRecord*> not_gradable(const StudentRecord& record) {
  std::vector<const UnitRecord*> units;
  for (const UnitRecord& unit : record.units)
    if (unit.summary == name_of(BuildOutcome::does_not_compile) ||
        unit.summary == name_of(BuildOutcome::wrong_signature) || !unit.judge_failure.empty())
      units.push_back(&unit);
  return units;
}

/// "The judge failed at 4.1 and 4.3 …", where it did; else empty.
std::string words_about_failures(const StudentRecord& record) {
  std::string units;
  for (const UnitRecord& unit : record.units)
    if (!unit.judge_failure.empty()) units += (units.empty() ? "" : ", ") + unit.number;
  if (units.empty()) return "";
  return "The judge failed at " + units +
         ": these points are not a grade of your code. Hand in again; if it fails again, tell your "
         "instructor.";
}

/// Of all points; more than 1 with extra ones, which no platform takes.
double share(const CourseSettings& settings, const StudentRecord& record) {
  return std::clamp(earned(settings, record) / settings.most(), 0., 1.);
}

/// Hundredths of a point.
long hundredths(double points) { return std::lround(100 * points); }

}  // namespace

std::string gradescope_results(const CourseSettings& settings, const StudentRecord& all,
                               const std::string& figure) {
  const StudentRecord record = fitted(all);
  ordered_json j{{"execution_time", seconds_of(record)},
                 {"visibility", "visible"},
                 {"stdout_visibility", "hidden"},
                 {"tests", ordered_json::array()}};
  const std::string failures = words_about_failures(record);
  if (!record.refused.empty()) j["output"] = "The submission " + record.refused + ".";
  if (!failures.empty()) j["output"] = failures;
  if (!figure.empty()) {
    j["output"] = (failures.empty() ? "" : "<p>" + failures + "</p>") + "<p>" + about_the_figure +
                  "</p><img src=\"" + data_url(figure) + "\" alt=\"" + about_the_figure + "\">";
    j["output_format"] = "html";
  }
  for (const Unit& unit : settings.units)
    j["tests"].push_back(
        {{"name", title(unit)},
         {"number", unit.number},
         {"score", points_of(settings, record, unit)},
         {"max_score", settings.points(unit)},
         {"status", passed(record, unit) ? "passed" : "failed"},
         {"output", words_about(record, unit)},
         {"output_format", "text"},
         {"visibility", is_hidden(settings, unit) ? "after_due_date" : "visible"},
         {"extra_data", {{"misconceptions", names_of_misconceptions(record, unit)}}}});
  return text_of(j);
}

std::string prairielearn_results(const CourseSettings& settings, const StudentRecord& all,
                                 const std::string& figure) {
  const StudentRecord whole = fitted(all), record = without_hidden(settings, whole);
  const std::vector<const UnitRecord*> unreadable = not_gradable(whole);  // gives nothing away
  ordered_json j{{"gradable", record.refused.empty() && unreadable.empty()}};
  if (!record.refused.empty()) {
    j["format_errors"] = {"The submission " + record.refused + "."};
    return text_of(j);
  }
  if (!unreadable.empty()) {
    j["message"] = "This costs no attempt: there is nothing to grade yet.";
    std::string reasons;
    for (const UnitRecord* unit : unreadable) {
      j["format_errors"].push_back(unit->number + ": " + unit->summary);
      reasons += unit->explanation;
    }
    j["output"] = reasons;
    return text_of(j);
  }
  j["score"] = share(settings, record);
  j["tests"] = ordered_json::array();
  for (const Unit& unit : settings.units)
    j["tests"].push_back({{"name", title(unit)},
                          {"points", points_of(settings, record, unit)},
                          {"max_points", settings.points(unit)},
                          {"output", words_about(record, unit)}});
  if (!figure.empty()) j["images"] = {{{"label", about_the_figure}, {"url", data_url(figure)}}};
  return text_of(j);
}

std::string classroom50_result(const CourseSettings& settings, const StudentRecord& all,
                               const std::map<std::string, std::string>& environment) {
  const StudentRecord record = without_hidden(settings, fitted(all));
  const auto variable = [&](const std::string& name) {
    const auto found = environment.find(name);
    require(found != environment.end(), "the environment lacks ", name, ": Classroom 50 sets it");
    return found->second;
  };
  ordered_json j{{"schema", "classroom50/result/v1"},
                 {"classroom", variable("CLASSROOM")},
                 {"assignment", variable("ASSIGNMENT")},
                 {"assignment_type", variable("ASSIGNMENT_TYPE")},
                 {"owner", variable("OWNER")},
                 {"submission", variable("SUBMISSION_TAG")},
                 {"commit", variable("COMMIT_URL")},
                 {"release", variable("RELEASE_URL")},
                 {"review", variable("REVIEW_URL")},
                 {"datetime", now_in_utc()},  // the runner puts the commit's in its place
                 {"score", 0},
                 {"max-score", 0},
                 {"tests", ordered_json::array()}};
  long score = 0, most = 0;
  for (const Unit& unit : settings.units) {
    const long points = hundredths(points_of(settings, record, unit)),
               out_of = hundredths(settings.points(unit));
    score += points;
    most += out_of;
    j["tests"].push_back({{"test-name", title(unit)},
                          {"passed", passed(record, unit)},
                          {"score", points},
                          {"max-score", out_of},
                          {"output", words_about(record, unit)}});
  }
  j["score"] = score;
  j["max-score"] = most;
  return text_of(j);
}

std::string markdown_results(const CourseSettings& settings, const StudentRecord& all) {
  const StudentRecord record = without_hidden(settings, fitted(all));
  char total[64];
  std::snprintf(total, sizeof total, "%.2f of %.2f points", earned(settings, record),
                settings.most());
  std::string text = "### " + settings.title + ": " + total + "\n\n";
  if (!record.refused.empty()) return text + words_about(record, settings.units.front()) + "\n";
  text += "| exercise | verdict | points |\n|---|---|---|\n";
  std::string explanations;
  for (const Unit& unit : settings.units) {
    const UnitRecord* verdict = record.find(unit);
    char points[64];
    std::snprintf(points, sizeof points, "%.2f of %.2f", points_of(settings, record, unit),
                  settings.points(unit));
    text += "| " + title(unit) + " | " + (verdict ? verdict->summary : without_verdict(record)) +
            " | " + points + " |\n";
    if (verdict && !verdict->passed && !verdict->explanation.empty())
      explanations += "\n" + indented(verdict->explanation);
  }
  return text + explanations;
}

}  // namespace tumble::judge
