#include "judge/mine/travelling_curve.hpp"

#include "judge/mine/engine_build.hpp"
#include "judge/mine/measure.hpp"
#include "judge/mine/report.hpp"

namespace tumble::judge::mine {

std::optional<std::string> travelling_curve(const Course& course,
                                            const std::function<fs::path(const Unit&)>& source,
                                            const fs::path& folder) {
  EngineBuilder builder(course, source, folder);
  EngineBuild build = builder.build(course.engine);
  const bool none_own = build.missing().size() == build.parts.size();
  if (!build.does_not_link.empty() || none_own) return std::nullopt;
  Measurement measurement = measure(OwnEngine(build.worker), [](const std::string&) {});
  if (const EngineBuild die = builder.build(course.die); die.does_not_link.empty()) {
    build.add(die);
    measurement.die = die_of(die.worker);
  }
  return figure_of(build, measurement);
}

}  // namespace tumble::judge::mine
