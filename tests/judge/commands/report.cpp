#include "judge/class/report.hpp"

#include <iostream>

#include "judge/class/grade_class.hpp"
#include "judge/commands/commands.hpp"
#include "support/text_file.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

int report(const Course& course, const ReportOptions& options) {
  const CourseSettings settings = settings_or_default(course, options.settings);
  const std::vector<StudentRecord> records = read_records(GradesFolder{options.grades});
  support::write_text(options.out,
                      report_html(settings, records, options.names ? Names::shown : Names::hidden));
  std::cerr << "tumble: " << records.size() << " submissions, on one page: ";
  std::cout << options.out.string() << "\n";
  return 0;
}

}  // namespace tumble::judge
