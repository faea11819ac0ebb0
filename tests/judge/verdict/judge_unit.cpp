#include "judge/verdict/judge_unit.hpp"

#include <algorithm>

#include "judge/conversation/student_worker.hpp"
#include "judge/spec/run.hpp"
#include "judge/verdict/crash_place.hpp"

namespace tumble::judge {

UnitResult judge_build(const Job& job, const Judgement& judgement, const WorkerBuild& build) {
  UnitResult result;
  result.unit = job.unit;
  result.source = job.source;
  result.seed = judgement.seed;
  result.build = build.outcome;
  result.build_detail = build.detail;
  result.warnings = build.warnings;
  if (build.outcome != BuildOutcome::built) return result;

  StudentWorker worker(build.worker);
  for (int i = 0; i < judgement.seeds && (i == 0 || result.passed()); ++i) {
    result.seed = judgement.seed + static_cast<std::uint64_t>(i);
    result.cases = run_spec({job.unit.id(), result.seed, judgement.only_case}, worker);
  }
  if (!judgement.locate_crashes) return result;
  const auto crashed = std::find_if(
      result.cases.begin(), result.cases.end(),
      [](const CaseResult& c) { return c.finding && c.finding->outcome == Outcome::crashed; });
  if (crashed != result.cases.end())
    crashed->finding->place = crash_place(job, {job.unit.id(), result.seed, crashed->number});
  return result;
}

}  // namespace tumble::judge
