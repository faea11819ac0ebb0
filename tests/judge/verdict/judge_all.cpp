#include "judge/verdict/judge_all.hpp"

#include <algorithm>
#include <chrono>
#include <deque>
#include <future>
#include <thread>

#include "judge/build/work_folder.hpp"
#include "judge/sandbox/pipe.hpp"
#include "judge/spec/load_spec.hpp"

namespace tumble::judge {

namespace {

struct TimedBuild {
  WorkerBuild build;
  double seconds = 0;
};

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

void judge_all(const Course& course, const std::vector<Unit>& units,
               const std::function<fs::path(const Unit&)>& source, const Judgement& judgement,
               const std::function<void(const UnitResult&)>& done) {
  for (const Unit& unit : units)
    load_spec(unit);  // before anything can be called a student's fault
  const WorkFolder work;
  const auto job_of = [&](const Unit& unit) -> Job {
    return {course, unit, source(unit), work.path() / (unit.chapter + "-" + unit.name)};
  };
  const auto instrumentation =
      judgement.only_sanitized ? Instrumentation::sanitizers : Instrumentation::none;
  const auto start_build = [&](const Unit& unit) {
    return std::async(std::launch::async, [&, job = job_of(unit)] {
      const auto start = Clock::now();
      TimedBuild timed;
      timed.build = build_worker(job, instrumentation, judgement.compiled);
      timed.seconds = seconds_since(start);
      return timed;
    });
  };

  const std::size_t at_once = judgement.builds_at_once > 0
                                  ? judgement.builds_at_once
                                  : std::max(1u, std::thread::hardware_concurrency());
  std::deque<std::future<TimedBuild>> builds;
  std::size_t next = 0;
  const auto start_builds = [&] {
    while (next < units.size() && builds.size() < at_once)
      builds.push_back(start_build(units[next++]));
  };
  start_builds();
  for (const Unit& unit : units) {
    if (Clock::now() >= judgement.deadline) return;
    const TimedBuild built = builds.front().get();
    builds.pop_front();
    start_builds();
    const auto start = Clock::now();
    const Job job = job_of(unit);
    UnitResult result = judge_build(job, judgement, built.build);
    result.seconds = built.seconds + seconds_since(start);
    done(result);
    std::error_code ignored;
    fs::remove_all(job.folder, ignored);  // a class of students would fill the disk
  }
}

}  // namespace tumble::judge
