#include "judge/class/grade_class.hpp"

#include <algorithm>
#include <random>

#include "judge/class/progress_line.hpp"
#include "judge/sandbox/process_pool.hpp"
#include "support/text_file.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

std::uint64_t class_seed(const CourseSettings& settings, const GradesFolder& folder) {
  if (settings.seed) return *settings.seed;
  if (!fs::exists(folder.seed()))
    support::write_text(folder.seed(), std::to_string(std::random_device{}()) + "\n");
  const std::string text = support::read_text(folder.seed());
  require(!text.empty() && text.find_first_not_of("0123456789\n") == std::string::npos &&
              text.size() < 20,
          folder.seed().string(), " is no seed, but '", text, "': delete it to draw a new one");
  return std::stoull(text);
}

std::vector<FailedStudent> grade_class(const Grading& grading,
                                       const std::vector<Submission>& submissions,
                                       const GradesFolder& folder, std::size_t at_once) {
  std::vector<FailedStudent> failed;
  ProgressLine line(submissions.size() * grading.settings.units.size(), "exercises");
  ProcessPool pool;
  pool.at_once = at_once;
  pool.received = [&](std::size_t, const std::string& ticks) {
    for (std::size_t i = 0; i < ticks.size(); ++i) line.tick();
  };
  pool.finished = [&](const FinishedJob& job) {
    if (!job.failure.empty()) failed.push_back({submissions[job.number].student, job.failure});
  };
  run_in_processes(submissions.size(), pool, [&](std::size_t i, const SendBytes& send) {
    grade_student(grading, submissions[i], folder.record_of(submissions[i].student),
                  [&send](const StudentRecord&) { send("."); });
  });
  return failed;
}

std::vector<StudentRecord> records_of(const GradesFolder& folder,
                                      const std::vector<Submission>& submissions) {
  std::vector<StudentRecord> records;
  for (const Submission& submission : submissions)
    if (auto record = read_record(folder.record_of(submission.student)))
      records.push_back(std::move(*record));
  return records;
}

std::vector<StudentRecord> read_records(const GradesFolder& folder) {
  std::vector<fs::path> files;
  if (fs::is_directory(folder.path / "students"))
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.path / "students"))
      if (entry.path().extension() == ".json") files.push_back(entry.path());
  require(!files.empty(), folder.path.string(), " holds no grades: ./tumble grade makes them");
  std::sort(files.begin(), files.end());
  std::vector<StudentRecord> records;
  records.reserve(files.size());
  for (const fs::path& file : files) records.push_back(*read_record(file));
  return records;
}

}  // namespace tumble::judge
