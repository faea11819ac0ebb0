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
  return settings.wants_curve(course) ? all_specs() : specs_of(settings.units);
}

}  // namespace tumble::judge
