#include "judge/mine/travelling_curve.hpp"

#include "judge/mine/engine_build.hpp"
#include "judge/mine/measure.hpp"
#include "judge/mine/report.hpp"

namespace tumble::judge::mine {

std::optional<std::string> travelling_curve(const Course& course,
                                            const std::function<fs::path(const Unit&)>& source,
                                            const fs::path& folder) {
  const EngineBuild build = build_engine(course, source, folder);
  const bool none_own = build.missing().size() == build.parts.size();
  if (!build.does_not_link.empty() || none_own) return std::nullopt;
  return figure_of(build, measure(OwnEngine(build.worker), [](const std::string&) {}));
}

}  // namespace tumble::judge::mine
