/// @file
/// What the judge finds in the module that grades.
#include <memory>

#include "judge/class/settings.hpp"
#include "judge/class/sources.hpp"
#include "judge/commands/grading/graded_before.hpp"
#include "judge/commands/grading/grading.hpp"
#include "judge/commands/grading_module.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

Targets specs_that_count(const Course& course, const std::optional<fs::path>& file) {
  const CourseSettings settings = settings_or_default(course, file);
  return settings.wants_curve(course) ? all_specs() : specs_of(settings.units);
}

Targets specs_to_grade(const Course& course, const GradeOptions& options) {
  std::string taken;
  return specs_that_count(course, as_before(options, taken).settings);
}

std::function<fs::path(const Unit&)> unpacked(const Course& course, const fs::path& archive,
                                              const std::string& called) {
  Submission submission{"", archive};
  submission.is_archive = true;
  const auto sources = std::make_shared<Sources>(course, course.units, submission);
  require(sources->refused().empty(), called, " ", sources->refused());
  return [sources](const Unit& unit) { return sources->of(unit); };
}

}  // namespace

extern "C" const GradingModule tumble_grading_module = {
    grade,         report,           hand_out,         export_package, grade_on_platform,
    check_student, units_of_student, specs_that_count, specs_to_grade, unpacked};

}  // namespace tumble::judge
