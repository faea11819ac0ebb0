#include "judge/mine/compiled_part.hpp"

#include <utility>

#include "judge/build/worker_build.hpp"
#include "judge/course/contract.hpp"
#include "support/entry.hpp"
#include "support/text_file.hpp"

namespace tumble::judge::mine {

namespace {

/// Whether a line of the file that is no comment throws what a stub throws.
bool throws_not_implemented(const std::string& text) {
  for (auto at = text.find("NotImplemented{"); at != std::string::npos;
       at = text.find("NotImplemented{", at + 1)) {
    const auto line = text.rfind('\n', at) + 1;
    if (text.substr(line, at - line).find("//") == std::string::npos) return true;
  }
  return false;
}

/// What can be said of a file without compiling it; empty if it has to be.
std::string not_written(const Course& course, const Part& part) {
  if (!support::is_there(part.source)) return "there is no file";
  if (!support::is_file(part.source)) return "is not a file";
  if (fs::file_size(part.source) > (1 << 20)) return {};  // refused, with its reason, when compiled
  const std::string text = support::read_text(part.source);
  if (text == stub_of(course, part.unit)) return "nothing is written yet";
  return throws_not_implemented(text) ? "still throws NotImplemented" : "";
}

}  // namespace

void take_solution(const Course& course, Compiled& part, const std::string& why,
                   const fs::path& folder) {
  part.part.missing = why;
  part.object = part.part.unit.solution;
  const fs::path source = course.instead_of_solution(part.part.unit);
  if (part.object.empty() && source != part.part.source && fs::exists(source))
    part.object = compile_unit({course, part.part.unit, source, folder / "solution"}).object;
}

Compiled compile(const Course& course, Part part, const fs::path& folder,
                 const ObjectCache* earlier) {
  Compiled result{std::move(part), {}};
  if (const std::string why = not_written(course, result.part); !why.empty()) {
    take_solution(course, result, why, folder);
    return result;
  }
  const WorkerBuild build =
      compile_unit({course, result.part.unit, result.part.source, folder}, earlier);
  result.object = build.object;
  if (build.outcome == BuildOutcome::built) return result;
  result.part.detail = build.detail;
  take_solution(course, result, name_of(build.outcome), folder);
  return result;
}

}  // namespace tumble::judge::mine
