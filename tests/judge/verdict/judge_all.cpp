#include "judge/verdict/judge_all.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <thread>

#include "judge/build/object_cache.hpp"
#include "judge/build/submission.hpp"
#include "judge/build/work_folder.hpp"
#include "judge/course/contract.hpp"
#include "judge/sandbox/pipe.hpp"
#include "judge/sandbox/process_pool.hpp"
#include "judge/spec/load_spec.hpp"
#include "judge/verdict/result_message.hpp"

namespace tumble::judge {

namespace {

/// Is this the exercise as it was handed out?
bool is_stub(const Job& job) {
  try {
    return read_submission(job.source) == stub_of(job.course, job.unit);
  } catch (const Refused&) {
    return false;
  }
}

/// Of a wrong answer: would the course's own solution be right here, with the same inputs?
/// @throws std::runtime_error if not: what was built for the unit is damaged or out of date, or
/// this machine does not compute
void require_solution_passes(const Job& job, const Judgement& judgement) {
  const fs::path solution = job.course.solution(job.unit);
  if (!fs::exists(solution) || judgement.compiled->solution_passes(job.unit)) return;
  const Job known{job.course, job.unit, solution, job.folder / "solution"};
  const UnitResult result = judge_build(known, judgement, build_worker(known));
  if (!result.passed())
    throw std::runtime_error(
        "the course's own solution of " + job.unit.number + " is “" + result.summary() +
        "” here too: is what was built for it damaged, or out of date? ./tumble prepare builds it");
  judgement.compiled->keep_that_solution_passes(job.unit);
}

UnitResult build_and_judge(const Job& job, const Judgement& judgement) {
  const auto start = Clock::now();
  const bool stub = judgement.compiled && is_stub(job);
  if (stub)
    if (const auto known = judgement.compiled->verdict_on_stub(job.unit)) {
      UnitResult result = decode_result(*known, job);
      result.seed = judgement.seed;
      result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
      return result;
    }
  const auto instrumentation =
      judgement.only_sanitized ? Instrumentation::sanitizers : Instrumentation::none;
  const ObjectCache* compiled = judgement.only_sanitized ? nullptr : judgement.compiled;
  const WorkerBuild build = build_worker(job, instrumentation, compiled);
  UnitResult result = judge_build(job, judgement, build);
  const bool answered = build.outcome == BuildOutcome::built && !result.untouched();
  if (judgement.try_solution && answered && !result.passed())
    require_solution_passes(job, judgement);
  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  if (stub && result.untouched())
    judgement.compiled->keep_verdict_on_stub(job.unit, encode_result(result));
  return result;
}

/// What is said of a unit that the judge has failed at.
UnitResult failed_result(const Job& job, const Judgement& judgement, const std::string& why) {
  UnitResult result;
  result.unit = job.unit;
  result.source = job.source;
  result.seed = judgement.seed;
  result.judge_failure = why;
  return result;
}

/// The result of a process that has sent `message` and ended with `failure`.
UnitResult result_of(const Job& job, const Judgement& judgement, const std::string& message,
                     const std::string& failure) {
  if (!failure.empty()) return failed_result(job, judgement, failure);
  try {
    return decode_result(message, job);
  } catch (const std::exception& broken) {
    return failed_result(job, judgement, broken.what());
  }
}

}  // namespace

void judge_all(const Course& course, const std::vector<Unit>& units,
               const std::function<fs::path(const Unit&)>& source, const Judgement& judgement,
               const std::function<void(const UnitResult&)>& done) {
  for (const Unit& unit : units)
    load_spec(unit);  // before anything can be called a student's fault
  const WorkFolder work;
  std::vector<Job> jobs;
  jobs.reserve(units.size());
  for (const Unit& unit : units)
    jobs.push_back({course, unit, source(unit), work.path() / (unit.chapter + "-" + unit.name)});

  std::vector<std::string> messages(jobs.size());
  std::vector<std::optional<UnitResult>> results(jobs.size());
  std::size_t told = 0;
  ProcessPool pool;
  pool.at_once = judgement.builds_at_once > 0 ? judgement.builds_at_once
                                              : std::max(1u, std::thread::hardware_concurrency());
  pool.received = [&](std::size_t i, const std::string& bytes) { messages[i] += bytes; };
  pool.finished = [&](const FinishedJob& ended) {
    const std::size_t i = ended.number;
    const bool not_begun = messages[i].empty() && ended.failure.empty();
    if (not_begun && Clock::now() >= judgement.deadline) return;
    results[i] = result_of(jobs[i], judgement, messages[i], ended.failure);
    std::error_code ignored;
    fs::remove_all(jobs[i].folder, ignored);  // a class of students would fill the disk
    for (; told < results.size() && results[told]; ++told) done(*results[told]);
  };
  run_in_processes(jobs.size(), pool, [&](std::size_t i, const SendBytes& send) {
    if (Clock::now() < judgement.deadline) send(encode_result(build_and_judge(jobs[i], judgement)));
  });
}

}  // namespace tumble::judge
