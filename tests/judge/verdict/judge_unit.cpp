#include "judge/verdict/judge_unit.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "judge/build/source_code.hpp"
#include "judge/build/submission.hpp"
#include "judge/conversation/student_worker.hpp"
#include "judge/verdict/crash_place.hpp"
#include "judge/verdict/exact_constants.hpp"
#include "judge/verdict/judge_answers.hpp"
#include "judge/verdict/names_from_source.hpp"
#include "judge/verdict/never_set.hpp"

namespace tumble::judge {

namespace {

/// With sanitizers a program ends with a report: a crash, and no text that the student has printed.
void read_report(Finding& finding, const Job& job, const WorkerBuild& build) {
  const bool reported = finding.printed.find("AddressSanitizer") != std::string::npos ||
                        finding.printed.find("runtime error: ") != std::string::npos;
  if (!reported) return;
  finding.place = place_in_report(finding.printed, job.source.filename().string(), build.worker);
  finding.outcome = Outcome::crashed;
  finding.detail = "a sanitizer stopped it";
  if (!finding.place.empty()) finding.printed.clear();
}

/// Whether a run with sanitizers may tell more than is known: of a crash and of a loop without end
/// the line; of a wrong answer without a name, or of one whose name may be chance, because an auto
/// may hold an expression of Eigen whose operands are gone.
bool is_worth_another_run(const Finding& finding, const std::string& source) {
  if (finding.outcome == Outcome::crashed || finding.outcome == Outcome::hung) return true;
  return finding.outcome == Outcome::wrong && finding.answer &&
         (finding.misconceptions.empty() || mentions(source, "auto"));
}

/// A variable that the compiler, asked once more, sees used before it is set.
std::optional<NeverSet> unset_variable(const Job& job, const std::string& source) {
  if (!declares_without_value(source)) return std::nullopt;
  const Job again{job.course, job.unit, job.source, job.folder / "unset"};
  return never_set_in(words_about_unset(again), job.source.filename().string());
}

/// Looks whether right answers come from memory that is gone: an auto of Eigen's, whose operands
/// nothing has overwritten yet, or a variable that was never set. With other flags they would be
/// wrong.
void look_for_luck(UnitResult& result, const Job& job, const Judgement& judgement) {
  if (!judgement.locate_crashes || !result.passed()) return;
  const std::string source = read_submission(job.source);
  if (const auto unset = unset_variable(job, source))
    result.lucky_variable = unset->place + ": " + unset->variable;
  if (!keeps_an_expression(source)) return;
  constexpr int cpu_seconds = 10;  // sanitizers are slow
  result.lucky_place = crash_place(job, {job.unit.id(), result.seed}, cpu_seconds).place;
}

/// Says of the first case that fails where and why, as far as that can be found out.
void look_closer(UnitResult& result, const Job& job, const Judgement& judgement) {
  const auto failed = std::find_if(result.cases.begin(), result.cases.end(),
                                   [](const CaseResult& each) { return !each.passed(); });
  if (failed == result.cases.end() || result.untouched()) return;
  Finding& finding = *failed->finding;
  const std::string source = read_submission(job.source);
  name_from_source(result, source);
  const std::string file = job.source.filename().string();
  if (judgement.locate_crashes && !never_set_in(result.warnings, file))
    if (const auto unset = unset_variable(job, source)) name_variable(finding, *unset);
  if (!judgement.locate_crashes || !is_worth_another_run(finding, source)) return;
  const int cpu_seconds = finding.outcome == Outcome::hung ? 3 : 10;  // sanitizers are slow
  const CrashPlace found =
      crash_place(job, {job.unit.id(), result.seed, failed->number}, cpu_seconds);
  finding.place = found.place;
  result.why_no_place = found.why_not;
  if (!finding.place.empty() && finding.outcome == Outcome::wrong) finding.misconceptions.clear();
  if (const auto gone = expression_that_outlives(source, finding.place))
    finding.misconceptions = {*gone};
}

/// Names what the numbers alone show, where neither the compiler nor a sanitizer has said more.
void name_what_is_left(UnitResult& result, const Job& job, const Judgement& judgement) {
  name_rounded_constant(result, read_submission(job.source));
  drop_unproven_constants(result, job, {job.unit.id(), result.seed, judgement.only_case});
  name_wrong_numbers(result, answer_type(job.course, job.unit));
}

/// Memory and time that a machine does not grant are not used up by the student.
/// @throws std::runtime_error if that may be why a case has ended
void require_full_limits(const UnitResult& result, const Limits& limits) {
  const bool may_be_why =
      std::any_of(result.cases.begin(), result.cases.end(), [](const CaseResult& each) {
        return each.finding && (each.finding->outcome == Outcome::out_of_memory ||
                                each.finding->outcome == Outcome::crashed ||
                                each.finding->outcome == Outcome::hung);
      });
  const std::string lowered = may_be_why ? lowered_limits(limits) : "";
  if (!lowered.empty())
    throw std::runtime_error("this machine allows a student's program only " + lowered);
}

}  // namespace

UnitResult judge_build(const Job& job, const Judgement& judgement, const WorkerBuild& build) {
  UnitResult result = result_of_build(job.unit, job.source, build);
  result.seed = judgement.seed;
  if (build.outcome != BuildOutcome::built) return result;

  StudentWorker worker(build.worker);
  judge_answers(result, {judgement.seed, judgement.seeds, judgement.only_case}, worker);
  require_full_limits(result, build.worker.walls.limits);
  if (judgement.only_sanitized) {
    for (CaseResult& each : result.cases)
      if (each.finding) read_report(*each.finding, job, build);
  } else {
    look_closer(result, job, judgement);
    look_for_luck(result, job, judgement);
    if (!result.passed()) name_what_is_left(result, job, judgement);
  }
  return result;
}

}  // namespace tumble::judge
