#include "judge/verdict/exact_constants.hpp"

#include <algorithm>
#include <exception>
#include <vector>

#include "judge/build/source_code.hpp"
#include "judge/build/submission.hpp"
#include "judge/build/worker_build.hpp"
#include "judge/conversation/student_worker.hpp"
#include "judge/verdict/rounded_constant.hpp"
#include "support/text_file.hpp"

namespace tumble::judge {

namespace {

bool has_name_of_rounded(const CaseResult& each) {
  return each.finding && !each.finding->misconceptions.empty() &&
         each.finding->misconceptions.front().name == rounded_constant_name;
}

/// All cases once more, with exact constants in the student's file; none if it cannot be built.
std::vector<CaseResult> cases_with_exact_constants(const Job& job, const SpecRun& run) {
  const std::filesystem::path folder = job.folder / "exact",
                              source = folder / "source" / job.source.filename();
  try {
    support::write_text_and_folders(source, with_exact_constants(read_submission(job.source)));
    const WorkerBuild build = build_worker({job.course, job.unit, source, folder});
    if (build.outcome != BuildOutcome::built) return {};
    StudentWorker worker(build.worker);
    return run_spec(run, worker);
  } catch (const std::exception&) {  // the verdict stands without the name
    return {};
  }
}

}  // namespace

void drop_unproven_constants(UnitResult& result, const Job& job, const SpecRun& run) {
  if (std::none_of(result.cases.begin(), result.cases.end(), has_name_of_rounded)) return;
  const std::vector<CaseResult> exact = cases_with_exact_constants(job, run);
  const auto is_mended = [&](const CaseResult& each) {
    return std::any_of(exact.begin(), exact.end(), [&](const CaseResult& other) {
      return other.number == each.number && other.passed();
    });
  };
  for (CaseResult& each : result.cases)
    if (has_name_of_rounded(each) && !is_mended(each)) each.finding->misconceptions.clear();
}

}  // namespace tumble::judge
