#include "judge/class/report.hpp"

#include <algorithm>
#include <iostream>

#include "judge/class/grade_class.hpp"
#include "judge/class/one_student_each.hpp"
#include "judge/commands/grading/grading.hpp"
#include "support/text_file.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

/// Those that were given, else those that were graded with.
CourseSettings settings_of_report(const Course& course, const ReportOptions& options,
                                  const GradesFolder& folder) {
  if (!options.settings && fs::exists(folder.settings()))
    return read_settings(course, folder.settings());
  return settings_or_default(course, options.settings);
}

}  // namespace

int report(const Course& course, const ReportOptions& options) {
  const GradesFolder folder{options.grades};
  const KeptRecords kept = read_records(folder);
  CourseSettings settings = settings_of_report(course, options, folder);
  settings.rules = with_names_of_rows(settings.rules, kept.records);
  const ReportNotes notes{kept.unreadable, identical_files(settings, kept.records)};
  support::write_text(
      options.out,
      report_html(settings, kept.records, options.names ? Names::shown : Names::hidden, notes));
  for (const std::string& each : kept.unreadable) std::cerr << "tumble: left out: " << each << "\n";
  const auto handed_in = std::count_if(kept.records.begin(), kept.records.end(),
                                       [](const StudentRecord& r) { return !r.absent; });
  std::cerr << "tumble: " << handed_in << " submissions, on one page: ";
  std::cout << options.out.string() << "\n";
  return 0;
}

}  // namespace tumble::judge
