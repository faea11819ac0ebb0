#include "judge/commands/needs.hpp"

#include "judge/class/settings.hpp"

namespace tumble::judge {

Targets specs_of(const std::vector<Unit>& units) {
  Targets targets;
  for (const Unit& unit : units) targets.push_back("spec." + unit.chapter + "." + unit.name);
  return targets;
}

Targets all_specs() { return {"all_specs"}; }

Targets specs_that_count(const Course& course, const std::optional<fs::path>& file) {
  const CourseSettings settings = settings_or_default(course, file);
  if (settings.wants_curve(course)) return all_specs();
  Targets targets = specs_of(settings.units);
  targets.emplace_back("grading_tools");  // submissions are archives, feedback is a zip
  return targets;
}

}  // namespace tumble::judge
