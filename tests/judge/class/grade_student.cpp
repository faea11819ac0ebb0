#include "judge/class/grade_student.hpp"

#include "judge/build/work_folder.hpp"
#include "judge/class/archive.hpp"
#include "judge/course/progress.hpp"
#include "judge/course/stable_hash.hpp"
#include "judge/verdict/judge_all.hpp"
#include "support/text_file.hpp"

namespace tumble::judge {

namespace {

/// The files of a submission, where the judge can read them.
class Sources {
 public:
  Sources(const Course& course, const std::vector<Unit>& counted, const Submission& submission)
      : folder_(submission.path) {
    if (submission.is_archive) {
      take(unpack(submission.path));
      folder_ = own_.path();
    }
    if (refused_.empty()) files_ = files_of_units(course, counted, files_below(folder_));
  }

  const std::string& refused() const { return refused_; }

  /// A text for the student, in which their files are called as in their submission.
  std::string as_handed_in(std::string text) const {
    const std::string folder = (folder_ / "").string();  // "." made absolute ends with a slash
    for (std::size_t at; (at = text.find(folder)) != std::string::npos;)
      text.erase(at, folder.size());
    return text;
  }

  /// The file of a unit; where it should be, if it was not handed in.
  fs::path of(const Unit& unit) const {
    const auto found = files_.find(unit.id());
    return folder_ /
           (found == files_.end() ? fs::path(unit.chapter) / (unit.name + ".cpp") : found->second);
  }

 private:
  void take(const Unpacked& unpacked) {
    refused_ = unpacked.refused;
    for (const auto& [path, text] : unpacked.files)
      support::write_text_and_folders(own_.path() / path, text);
  }

  WorkFolder own_;
  fs::path folder_;
  std::string refused_;
  std::map<std::string, fs::path> files_;
};

/// Is a record of before a verdict on this file, with these inputs, by this judge?
bool still_holds(const UnitRecord& unit, const StudentRecord& before, const StudentRecord& now,
                 const fs::path& source) {
  return unit.judge_failure.empty() && before.judge == now.judge && unit.seed == now.seed &&
         unit.source == fingerprint(source);
}

/// Those units whose verdict is known already.
std::vector<UnitRecord> kept(const CourseSettings& settings, const Sources& sources,
                             const std::optional<StudentRecord>& before, const StudentRecord& now) {
  std::vector<UnitRecord> units;
  if (!before) return units;
  for (const Unit& unit : settings.units)
    if (const UnitRecord* known = before->find(unit))
      if (still_holds(*known, *before, now, sources.of(unit))) units.push_back(*known);
  return units;
}

/// How many files of a unit were judged, with the one that is judged now. The untouched stub is
/// none.
int tries_with(const UnitResult& now, const std::optional<StudentRecord>& before) {
  const UnitRecord* last = before ? before->find(now.unit) : nullptr;
  const int past = last ? last->tries : 0;
  if (!now.judge_failure.empty()) return past;
  const bool is_new = !last || last->source != fingerprint(now.source);
  return past + (is_new && !now.untouched() && fs::exists(now.source) ? 1 : 0);
}

void add_in_order(StudentRecord& record, UnitRecord unit, const CourseSettings& settings) {
  record.units.push_back(std::move(unit));
  std::vector<UnitRecord> ordered;
  for (const Unit& each : settings.units)
    if (const UnitRecord* known = record.find(each)) ordered.push_back(*known);
  record.units = std::move(ordered);
}

}  // namespace

void grade_student(const Grading& grading, const Submission& submission,
                   const std::filesystem::path& file,
                   const std::function<void(const StudentRecord&)>& done) {
  const Sources sources(grading.course, grading.settings.units, submission);
  StudentRecord record{submission.student,
                       seed_of(grading.seed, submission.student),
                       grading.judge,
                       sources.refused(),
                       {}};
  const std::optional<StudentRecord> before = read_record(file);
  if (record.refused.empty()) record.units = kept(grading.settings, sources, before, record);
  write_record(file, record, grading.settings);
  std::vector<Unit> open;
  for (const Unit& unit : grading.settings.units) {
    const bool known = record.find(unit) != nullptr || !record.refused.empty();
    if (known)
      done(record);
    else
      open.push_back(unit);
  }
  Course course = grading.course;
  course.stand_in = [&](const Unit& unit) {
    return grading.solutions.empty() ? sources.of(unit)
                                     : grading.solutions / unit.chapter / (unit.name + ".cpp");
  };
  Judgement judgement;
  judgement.seed = record.seed;
  judgement.compiled = &grading.compiled;
  judgement.builds_at_once = grading.builds_at_once;
  judgement.locate_crashes = false;  // with sanitizers the walls are lower
  judgement.deadline = grading.deadline;
  std::size_t judged = 0;
  judge_all(
      course, open, [&](const Unit& unit) { return sources.of(unit); }, judgement,
      [&](const UnitResult& result) {
        UnitRecord unit = record_of(grading.course, result);
        unit.tries = tries_with(result, before);
        for (std::string* text : {&unit.detail, &unit.explanation})
          *text = sources.as_handed_in(*text);
        add_in_order(record, std::move(unit), grading.settings);
        write_record(file, record, grading.settings);
        done(record);
        ++judged;
      });
  record.out_of_time = judged < open.size();
  if (record.out_of_time) write_record(file, record, grading.settings);
  for (; judged < open.size(); ++judged) done(record);
}

std::uint64_t judge_fingerprint() {
  const fs::path self = "/proc/self/exe";
  return fs::exists(self) ? stable_hash(support::read_text(self)) : 0;
}

}  // namespace tumble::judge
