#include "judge/verdict/judge_answers.hpp"

#include "judge/spec/run.hpp"
#include "judge/verdict/names_from_source.hpp"
#include "judge/verdict/never_set.hpp"
#include "judge/verdict/wrong_numbers.hpp"

namespace tumble::judge {

UnitResult result_of_build(const Unit& unit, const std::filesystem::path& source,
                           const BuildReport& build) {
  UnitResult result;
  result.unit = unit;
  result.source = source;
  result.build = build.outcome;
  result.build_detail = build.detail;
  result.warnings = build.warnings;
  return result;
}

void judge_answers(UnitResult& result, const Trial& trial, Answerer& answerer) {
  for (int i = 0; i < trial.seeds && (i == 0 || result.passed()); ++i) {
    result.seed = trial.seed + static_cast<std::uint64_t>(i);
    result.cases = run_spec({result.unit.id(), result.seed, trial.only_case}, answerer);
  }
}

void name_from_source(UnitResult& result, const std::string& source) {
  for (CaseResult& each : result.cases)
    if (each.finding) name_from_source(*each.finding, source);
  if (const auto variable = never_set_in(result.warnings, result.source.filename().string()))
    for (CaseResult& each : result.cases)
      if (each.finding) name_variable(*each.finding, *variable);
}

void name_rounded_constant(UnitResult& result, const std::string& source) {
  for (CaseResult& each : result.cases)
    if (each.finding) name_rounded_constant(*each.finding, source);
}

void name_wrong_numbers(UnitResult& result, const AnswerType& type) {
  for (CaseResult& each : result.cases)
    if (each.finding && !type.is_plain()) drop_places(*each.finding);
  // By convention the first case of a spec asks with inputs of every kind.
  if (!result.cases.empty() && result.cases.front().number == 1 && result.cases.front().finding)
    name_wrong_numbers(*result.cases.front().finding, type);
}

}  // namespace tumble::judge
