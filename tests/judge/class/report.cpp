#include "judge/class/report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <sstream>
#include <utility>

#include "judge/class/feedback.hpp"
#include "judge/class/final_grade.hpp"
#include "judge/spec/load_spec.hpp"
#include "judge/spec/misconception.hpp"
#include "judge/verdict/markup.hpp"
#include "support/how_many.hpp"

namespace tumble::judge {

namespace {

constexpr const char* style_sheet = R"(
:root { color-scheme: light dark; --good: #2a7d4f; --bad: #c4622d; --none: #8886; }
body { font: 16px/1.5 system-ui, sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
table { border-collapse: collapse; width: 100%; }
td, th { text-align: left; vertical-align: top; padding: .35rem .6rem .35rem 0; border-bottom: 1px solid #8884; }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums; }
.bar { display: flex; height: 1.1rem; min-width: 9rem; border-radius: 3px; overflow: hidden; }
.bar i { display: block; height: 100%; }
.passed { background: var(--good); } .failed { background: var(--bad); } .open { background: var(--none); }
.unread { background: repeating-linear-gradient(45deg, var(--none) 0 4px, transparent 4px 8px); }
.key i { display: inline-block; width: .8rem; height: .8rem; margin: 0 .3rem 0 1rem; border-radius: 2px; }
small { opacity: .75; } li { margin-bottom: .5rem; } svg text { fill: currentColor; }
@media (max-width: 40rem) { .bar { min-width: 5rem; } td, th { padding-right: .3rem; } }
)";

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", x);
  return text;
}

/// "3 of 20 (15 %)"
std::string share(std::size_t n, std::size_t of) {
  const double percent = of == 0 ? 0 : 100.0 * static_cast<double>(n) / static_cast<double>(of);
  return std::to_string(n) + " of " + std::to_string(of) + " (" +
         std::to_string(std::lround(percent)) + " %)";
}

/// The misconception of a unit with this name; nothing if the unit has none: "a wrong factor" can
/// be seen in any answer and has nothing to explain, and a newer judge may no longer know a name.
std::optional<Misconception> misconception_named(const Unit& unit, const std::string& name) {
  load_spec(unit);
  for (const Misconception& misconception : misconceptions_of(unit.id()))
    if (misconception.name == name) return misconception;
  return std::nullopt;
}

struct Frequent {
  const UnitStatistics* unit;
  Misconception misconception;
  std::size_t count;
};

/// The misconceptions of units that most students share.
std::vector<Frequent> most_frequent(const std::vector<UnitStatistics>& units, std::size_t most) {
  std::vector<Frequent> all;
  for (const UnitStatistics& unit : units)
    for (const auto& [name, count] : unit.misconceptions)
      if (auto misconception = misconception_named(unit.unit, name))
        all.push_back({&unit, std::move(*misconception), count});
  std::stable_sort(all.begin(), all.end(),
                   [](const Frequent& a, const Frequent& b) { return a.count > b.count; });
  if (all.size() > most) all.resize(most);
  return all;
}

/// Writes the page.
class Page {
 public:
  Page(const CourseSettings& settings, const std::vector<StudentRecord>& records)
      : settings_(settings), records_(records), units_(statistics_of(settings, records)) {}

  std::string text(Names names, const ReportNotes& notes) {
    out_ << "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
         << "<meta name=\"viewport\" content=\"width=device-width\">\n<title>"
         << markup(settings_.title) << "</title>\n<style>" << style_sheet << "</style>\n<h1>"
         << markup(settings_.title) << "</h1>\n";
    add_summary();
    add_unreadable(notes);
    out_ << "<h2>Points</h2>\n";
    add_histogram();
    add_to_explain();
    add_units();
    add_identical(notes, names);
    if (names == Names::shown) add_students();
    out_ << "</html>\n";
    return out_.str();
  }

 private:
  void add_summary() {
    std::size_t refused = 0, absent = 0;
    for (const StudentRecord& record : records_) {
      refused += record.refused.empty() && record.incomplete.empty() ? 0u : 1u;
      absent += record.absent ? 1u : 0u;
    }
    const double most = settings_.most();
    out_ << "<p>" << support::how_many(records_.size() - absent, "submission") << ", "
         << support::how_many(units_.size(), "exercise") << ", " << number(most)
         << (most == 1 ? " point." : " points.");
    if (absent > 0)
      out_ << " " << absent << " of the class " << (absent == 1 ? "has" : "have")
           << " not handed in.";
    if (refused > 0)
      out_ << " " << support::how_many(refused, "submission") << " could not be read.";
    out_ << "</p>\n";
  }

  /// Records that are missing from all numbers of the page.
  void add_unreadable(const ReportNotes& notes) {
    if (notes.unreadable.empty()) return;
    out_ << "<p>Left out, as their records cannot be understood:</p>\n<ul>\n";
    for (const std::string& each : notes.unreadable) out_ << "<li>" << markup(each) << "</li>\n";
    out_ << "</ul>\n";
  }

  void add_identical(const ReportNotes& notes, Names names) {
    if (notes.identical.empty()) return;
    out_ << "<h2>Identical files</h2>\n<p>The same to the letter. Short functions are often "
            "alike: look at them.</p>\n<ul>\n";
    for (const IdenticalFiles& each : notes.identical) {
      out_ << "<li>" << each.unit.number << " " << markup(each.unit.name) << ": ";
      if (names == Names::hidden) out_ << each.students.size() << " students";
      for (std::size_t i = 0; names == Names::shown && i < each.students.size(); ++i)
        out_ << (i == 0 ? "" : ", ") << markup(each.students[i]);
      out_ << "</li>\n";
    }
    out_ << "</ul>\n";
  }

  /// How many students have how many tenths of all points.
  void add_histogram() {
    constexpr int bins = 10, width = 56, height = 120;
    std::vector<std::size_t> count(static_cast<std::size_t>(bins), 0);
    for (const StudentRecord& record : records_) {
      if (record.absent) continue;
      const double part = final_grade(settings_, record).points / settings_.most();
      ++count[static_cast<std::size_t>(std::clamp(static_cast<int>(part * bins), 0, bins - 1))];
    }
    const std::size_t highest =
        std::max<std::size_t>(1, *std::max_element(count.begin(), count.end()));
    out_ << "<svg viewBox=\"0 0 " << bins * width << " " << height + 66
         << "\" role=\"img\" aria-label=\"How many students have which share of the points\" "
            "style=\"max-width:36rem;width:100%\" font-size=\"13\" text-anchor=\"middle\">\n";
    for (int i = 0; i < bins; ++i) {
      const std::size_t n = count[static_cast<std::size_t>(i)];
      const double h = height * static_cast<double>(n) / static_cast<double>(highest);
      out_ << "<rect x=\"" << i * width + 3 << "\" y=\"" << number(20 + height - h) << "\" width=\""
           << width - 6 << "\" height=\"" << number(h) << "\" fill=\"var(--good)\"/>";
      if (n > 0)
        out_ << "<text x=\"" << i * width + width / 2 << "\" y=\"" << number(15 + height - h)
             << "\">" << n << "</text>";
      out_ << "<text x=\"" << i * width + width / 2 << "\" y=\"" << height + 38 << "\">" << i * 10
           << "–" << (i + 1) * 10 << "</text>\n";
    }
    out_ << "<text x=\"" << bins * width / 2 << "\" y=\"" << height + 60
         << "\">% of the points</text>\n";
    out_ << "</svg>\n";
  }

  void add_to_explain() {
    const std::vector<Frequent> frequent = most_frequent(units_, 8);
    out_ << "<h2>To explain again</h2>\n";
    if (frequent.empty()) {
      out_ << "<p>No wrong answer matches a known misconception.</p>\n";
      return;
    }
    out_ << "<ol>\n";
    for (const Frequent& each : frequent) {
      const Misconception& misconception = each.misconception;
      out_ << "<li><b>" << markup(misconception.name) << "</b>, in " << each.unit->unit.number
           << " " << markup(each.unit->unit.name) << ": " << share(each.count, each.unit->all())
           << "<br>" << markup(misconception.sentence);
      if (!misconception.section.empty())
        out_ << " <small>Chapter " << each.unit->unit.chapter_number() << ", “"
             << markup(misconception.section) << "”</small>";
      out_ << "</li>\n";
    }
    out_ << "</ol>\n";
  }

  void add_bar(const UnitStatistics& unit) {
    out_ << R"(<div class="bar" title=")" << unit.passed << " passed, " << unit.failed
         << " not yet, " << unit.not_started << " not started, " << unit.unread << " not read\">";
    for (const auto& [kind, n] :
         {std::pair{"passed", unit.passed}, std::pair{"failed", unit.failed},
          std::pair{"open", unit.not_started}, std::pair{"unread", unit.unread}})
      if (n > 0) out_ << "<i class=\"" << kind << "\" style=\"flex:" << n << "\"></i>";
    out_ << "</div>";
  }

  void add_counts(const char* title, const Counts& counts, std::size_t most) {
    if (counts.empty()) return;
    out_ << "<div><small>" << title << "</small> ";
    for (std::size_t i = 0; i < std::min(most, counts.size()); ++i)
      out_ << (i == 0 ? "" : "; ") << markup(counts[i].first) << " × " << counts[i].second;
    if (counts.size() > most) out_ << "; …";
    out_ << "</div>";
  }

  void add_units() {
    out_ << "<h2>Exercises</h2>\n<p class=\"key\"><small><i class=\"passed\"></i>passed"
            "<i class=\"failed\"></i>not yet<i class=\"open\"></i>not started"
            "<i class=\"unread\"></i>submission not read</small></p>\n"
            "<table>\n<tr><th>exercise<th><th class=\"number\">passed<th class=\"number\">tries"
            "<th>what goes wrong</tr>\n";
    for (const UnitStatistics& unit : units_) {
      out_ << "<tr><td>" << unit.unit.number << " " << markup(unit.unit.name) << "<td>";
      add_bar(unit);
      out_ << "<td class=\"number\">" << unit.passed << " of " << unit.all()
           << "<td class=\"number\">" << (unit.passed > 0 ? number(unit.mean_tries) : "–")
           << "<td>";
      add_counts("", unit.misconceptions, 5);
      add_counts("verdicts:", unit.outcomes, 4);
      add_counts("laws:", unit.laws, 3);
      out_ << "</tr>\n";
    }
    out_ << "</table>\n<p><small>Tries: how many different files we graded until one passed, the "
            "average over the students with a pass. Verdicts, laws and misconceptions count each "
            "student "
            "once, with the file that was graded last.</small></p>\n";
  }

  void add_students() {
    out_ << "<h2>Students</h2>\n<table>\n<tr><th>student<th class=\"number\">points<th>not passed"
            "</tr>\n";
    for (const StudentRecord& record : records_) {
      out_ << "<tr><td>" << markup(record.student) << "<td class=\"number\">"
           << points_text(final_grade(settings_, record).points) << "<td>";
      for (const UnitRecord& unit : record.units)
        if (!unit.passed) out_ << markup(unit.number + " " + unit.summary) << "; ";
      out_ << markup(note_on(settings_, record)) << "</tr>\n";
    }
    out_ << "</table>\n";
  }

  const CourseSettings& settings_;
  const std::vector<StudentRecord>& records_;
  std::vector<UnitStatistics> units_;
  std::ostringstream out_;
};

}  // namespace

std::string report_html(const CourseSettings& settings, const std::vector<StudentRecord>& records,
                        Names names, const ReportNotes& notes) {
  return Page(settings, records).text(names, notes);
}

}  // namespace tumble::judge
