#include "judge/class/grade_class.hpp"

#include <algorithm>
#include <random>

#include "judge/class/class_list.hpp"
#include "judge/class/final_grade.hpp"
#include "judge/class/progress_line.hpp"
#include "judge/class/sources.hpp"
#include "judge/sandbox/process_pool.hpp"
#include "support/text_file.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

/// The record of a submission, or one that says why there is none.
StudentRecord record_or_reason(const GradesFolder& folder, const Submission& submission) {
  StudentRecord none{submission.student, 1, 0, "", {}};
  none.who = submission.who;
  try {
    if (auto record = read_record(folder.record_of(submission))) return *record;
  } catch (const std::runtime_error& error) {
    none.notes.emplace_back(error.what());
  }
  return none;
}

/// Makes the record of one of several submissions the student's.
void take_attempt(const GradesFolder& folder, const CourseSettings& settings,
                  const StudentRecord& record, std::size_t attempt) {
  const std::string name = file_name_for(record.student);
  write_record(folder.record_of(record.student), record, settings);
  copy_sources(folder.sources(attempt) / name, folder.sources() / name, settings.units);
}

/// All students with a record, where no list of the class says more.
std::vector<ListedStudent> students_with_records(const GradesFolder& folder) {
  std::vector<ListedStudent> students;
  if (fs::is_directory(folder.path / "students"))
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.path / "students"))
      if (entry.path().extension() == ".json")
        students.push_back({entry.path().stem().string(), false});
  std::sort(students.begin(), students.end(),
            [](const ListedStudent& a, const ListedStudent& b) { return a.student < b.student; });
  return students;
}

}  // namespace

void create(const GradesFolder& folder) {
  std::error_code error;
  require(!fs::exists(folder.path, error) || fs::is_directory(folder.path, error),
          "--out is the folder for the results, and ", folder.path.string(), " is none");
  fs::create_directories(folder.path / "students", error);
  if (error)
    throw std::runtime_error("cannot make the folder " + folder.path.string() + ": " +
                             error.message());
}

void copy_sources(const fs::path& from, const fs::path& to, const std::vector<Unit>& units) {
  for (const Unit& unit : units) {
    const fs::path source = kept_source(from, unit), copy = kept_source(to, unit);
    if (fs::exists(source))
      support::write_text_and_folders(copy, support::read_text(source));
    else
      fs::remove(copy);
  }
}

std::uint64_t class_seed(const CourseSettings& settings, const GradesFolder& folder) {
  if (settings.seed) return *settings.seed;
  if (!fs::exists(folder.seed()))
    support::write_text(folder.seed(), std::to_string(std::random_device{}()) + "\n");
  const std::string text = support::read_text(folder.seed());
  require(!text.empty() && text.find_first_not_of("0123456789\n") == std::string::npos &&
              text.size() < 20,
          folder.seed().string(), " is not a seed, but '", text, "': delete it to draw a new one");
  return std::stoull(text);
}

namespace {

/// Grades a submission in a process of its own.
void grade_one(const Grading& grading, const Submission& submission, const GradesFolder& folder,
               const Interruption& interruption, const SendBytes& send) {
  Interruption::leave_to_system();
  if (interruption.asked()) return;
  const fs::path file = folder.record_of(submission);
  fs::create_directories(file.parent_path());
  Grading mine = grading;
  mine.keep_sources = folder.sources(submission.attempt);
  grade_student(mine, submission, file, [&](const StudentRecord&) {
    send(".");
    if (interruption.asked()) throw std::runtime_error("interrupted");
  });
}

}  // namespace

std::vector<FailedStudent> grade_class(const Grading& grading,
                                       const std::vector<Submission>& submissions,
                                       const GradesFolder& folder, std::size_t at_once,
                                       const Interruption& interruption) {
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
    grade_one(grading, submissions[i], folder, interruption, send);
  });
  return failed;
}

std::vector<std::string> set_damaged_aside(const GradesFolder& folder,
                                           const std::vector<Submission>& submissions) {
  std::vector<std::string> said;
  for (const Submission& submission : submissions) {
    const fs::path file = folder.record_of(submission);
    try {
      read_record(file);
    } catch (const std::runtime_error&) {
      fs::rename(file, file.string() + ".damaged");
      said.push_back(
          escaped(file.string()) + " could not be understood: " + escaped(submission.student) +
          " is graded anew, and it is kept as " + escaped(file.filename().string()) + ".damaged");
    }
  }
  return said;
}

std::vector<StudentRecord> records_of(const GradesFolder& folder, const CourseSettings& settings,
                                      const std::vector<Submission>& submissions) {
  std::vector<StudentRecord> records;
  for (std::size_t i = 0; i < submissions.size();) {
    std::size_t end = i;
    std::optional<StudentRecord> best;
    std::size_t best_attempt = 0;
    std::string incomplete;  // who knows whether that one was better?
    for (; end < submissions.size() && submissions[end].student == submissions[i].student; ++end) {
      StudentRecord record = record_or_reason(folder, submissions[end]);
      if (!record.incomplete.empty()) incomplete = record.incomplete;
      if (best && final_grade(settings, record).points <= final_grade(settings, *best).points)
        continue;
      best = std::move(record);
      best_attempt = submissions[end].attempt;
    }
    best->incomplete = incomplete;
    if (best_attempt > 0) {
      best->notes.push_back("the best of " + std::to_string(end - i) + " submissions: number " +
                            std::to_string(best_attempt));
      take_attempt(folder, settings, *best, best_attempt);
    }
    records.push_back(std::move(*best));
    i = end;
  }
  return records;
}

KeptRecords read_records(const GradesFolder& folder) {
  KeptRecords kept;
  const std::optional<ClassList> list = read_class_list(folder.class_list());
  require(list || !fs::exists(folder.shards()), folder.path.string(),
          " holds shards of a class; when all are judged, ./tumble grade --merge ",
          folder.path.string(), " combines them into grades");
  for (const ListedStudent& listed : list ? list->students : students_with_records(folder)) {
    if (listed.absent) {
      kept.records.push_back({listed.student, 1, 0, "", {}});
      kept.records.back().absent = true;
      continue;
    }
    const fs::path file = folder.record_of(listed.student);
    try {
      std::optional<StudentRecord> record = read_record(file);
      require(record.has_value(), file.string(), " is not there");
      kept.records.push_back(std::move(*record));
    } catch (const std::exception& error) {
      kept.unreadable.push_back(escaped(listed.student) + ": " + escaped(error.what()));
    }
  }
  require(!kept.records.empty(), folder.path.string(),
          " holds no grades: ./tumble grade makes them");
  return kept;
}

}  // namespace tumble::judge
