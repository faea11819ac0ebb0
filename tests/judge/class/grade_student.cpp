#include "judge/class/grade_student.hpp"

#include "judge/class/sources.hpp"
#include "judge/course/progress.hpp"
#include "judge/verdict/judge_all.hpp"
#include "support/entry.hpp"

namespace tumble::judge {

namespace {

/// Is a record of before a verdict on this file, with these inputs, by this judge?
bool still_holds(const UnitRecord& unit, std::uint64_t judge, std::uint64_t seed,
                 const fs::path& source) {
  return unit.judge_failure.empty() && unit.judge == judge && unit.seed == seed &&
         unit.source == fingerprint(source);
}

/// Those units whose verdict is known already. If only some are to be judged, then those again, and
/// of the others what is known.
std::vector<UnitRecord> kept(const Grading& grading, const Sources& sources,
                             const std::optional<StudentRecord>& before, const StudentRecord& now) {
  std::vector<UnitRecord> units;
  if (!before) return units;
  for (const Unit& unit : grading.settings.units)
    if (const UnitRecord* known = before->find(unit)) {
      const bool keep = grading.only.empty() ? still_holds(*known, grading.judge.of(unit), now.seed,
                                                           sources.of(unit))
                                             : !grading.only.contains(unit.id());
      if (keep) units.push_back(*known);
    }
  return units;
}

/// What there is to say before anything is judged.
StudentRecord new_record(const Grading& grading, const Submission& submission,
                         const Sources& sources) {
  StudentRecord record{submission.student,
                       seed_of(grading.seed, submission.student),
                       grading.judge.shared(),
                       sources.refused(),
                       {}};
  record.who = submission.who;
  record.notes = sources.notes();
  record.handed_in = submission.handed_in;
  record.marked_late = submission.marked_late;
  record.together = submission.together;
  record.incomplete = submission.incomplete;
  for (const Unit& unit : grading.settings.units)
    if (const auto path = sources.handed_in(unit)) record.files[unit.id()] = *path;
  return record;
}

/// A verdict as it is kept.
UnitRecord unit_record(const Grading& grading, const Sources& sources, const UnitResult& result) {
  UnitRecord unit = record_of(grading.course, result);
  unit.judge = grading.judge.of(result.unit);
  if (!sources.handed_in(result.unit)) unit.summary = not_handed_in;
  for (std::string* text : {&unit.detail, &unit.explanation}) *text = sources.as_handed_in(*text);
  return unit;
}

/// How many files of a unit were judged, with the one that is judged now. The untouched stub is
/// none.
int tries_with(const UnitResult& now, const std::optional<StudentRecord>& before) {
  const UnitRecord* last = before ? before->find(now.unit) : nullptr;
  const int past = last ? last->tries : 0;
  if (!now.judge_failure.empty()) return past;
  const bool is_new = !last || last->source != fingerprint(now.source);
  return past + (is_new && !now.untouched() && support::is_there(now.source) ? 1 : 0);
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
  if (!grading.keep_sources.empty())
    sources.keep(grading.keep_sources / file.stem(), grading.settings.units);
  StudentRecord record = new_record(grading, submission, sources);
  const std::optional<StudentRecord> before = read_record(file);
  const bool is_read = record.refused.empty() && record.incomplete.empty();
  if (is_read) record.units = kept(grading, sources, before, record);
  write_record(file, record, grading.settings);
  std::vector<Unit> open;
  for (const Unit& unit : grading.settings.units) {
    const bool wanted = grading.only.empty() || grading.only.contains(unit.id());
    const bool known = record.find(unit) != nullptr || !is_read || !wanted;
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
  judgement.try_solution = true;
  judgement.builds_at_once = grading.builds_at_once;
  judgement.locate_crashes = false;  // with sanitizers the walls are lower
  judgement.deadline = grading.deadline;
  std::size_t judged = 0;
  judge_all(
      course, open, [&](const Unit& unit) { return sources.of(unit); }, judgement,
      [&](const UnitResult& result) {
        UnitRecord unit = unit_record(grading, sources, result);
        unit.tries = tries_with(result, before);
        add_in_order(record, std::move(unit), grading.settings);
        write_record(file, record, grading.settings);
        done(record);
        ++judged;
      });
  record.out_of_time = judged < open.size();
  if (record.out_of_time) write_record(file, record, grading.settings);
  for (; judged < open.size(); ++judged) done(record);
}

}  // namespace tumble::judge
