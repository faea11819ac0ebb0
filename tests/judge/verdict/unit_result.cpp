#include "judge/verdict/unit_result.hpp"

#include <algorithm>

namespace tumble::judge {

std::size_t UnitResult::passed_cases() const {
  return static_cast<std::size_t>(
      std::count_if(cases.begin(), cases.end(), [](const CaseResult& c) { return c.passed(); }));
}

bool UnitResult::passed() const { return !cases.empty() && passed_cases() == cases.size(); }

bool UnitResult::untouched() const {
  return !cases.empty() && std::all_of(cases.begin(), cases.end(), [](const CaseResult& c) {
    return c.finding && c.finding->outcome == Outcome::not_implemented;
  });
}

std::string UnitResult::summary() const {
  if (!judge_failure.empty()) return "judge failed";
  if (build != BuildOutcome::built) return name_of(build);
  if (passed()) return "passed";
  const auto failed =
      std::find_if(cases.begin(), cases.end(), [](const CaseResult& c) { return !c.passed(); });
  return failed == cases.end() ? "no cases" : name_of(failed->finding->outcome);
}

}  // namespace tumble::judge
