#include <algorithm>
#include <iostream>
#include <thread>

#include "judge/build/work_folder.hpp"
#include "judge/class/class_outputs.hpp"
#include "judge/class/collect.hpp"
#include "judge/class/feedback.hpp"
#include "judge/class/final_grade.hpp"
#include "judge/class/grading_lock.hpp"
#include "judge/class/identical_files.hpp"
#include "judge/class/progress_line.hpp"
#include "judge/commands/commands.hpp"
#include "judge/commands/sandbox.hpp"
#include "support/nearest.hpp"
#include "support/text_file.hpp"
#include "support/wrapped.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

/// What there is to grade.
struct Work {
  WorkFolder unpacked;
  ClassWork all;
  std::optional<Roster> roster;
  RosterMatch match;

  Work(const Course& course, const CourseSettings& settings, const GradeOptions& options) {
    std::optional<Lms> from;
    if (options.from) from = lms_named(*options.from);
    if (options.roster) roster = read_roster(*options.roster);
    all = collect(course, options.folders, from, settings.rules.several, unpacked);
    if (roster) match = judge::match(*roster, all.submissions);
    if (all.lms == Lms::none && roster && !from) all.lms = roster->lms;
  }
};

/// A row for who is on the roster and has handed in nothing.
StudentRecord absent_record(const Member& member) {
  StudentRecord record{!member.who.name.empty()    ? member.who.name
                       : !member.who.email.empty() ? member.who.email
                       : !member.who.id.empty()    ? member.who.id
                                                   : member.login,
                       1,
                       0,
                       "",
                       {}};
  record.who = member.who;
  record.absent = true;
  return record;
}

/// All rows of the table, by the students' names.
std::vector<StudentRecord> rows_of(const Work& work, const GradesFolder& folder,
                                   const CourseSettings& settings) {
  std::vector<StudentRecord> records = records_of(folder, settings, work.all.submissions);
  std::set<std::string> names;
  for (const StudentRecord& record : records) names.insert(record.student);
  for (const Member& member : work.match.missing) {
    StudentRecord record = absent_record(member);
    while (!names.insert(record.student).second) record.student += " (" + member.who.id + ")";
    records.push_back(std::move(record));
  }
  std::stable_sort(
      records.begin(), records.end(),
      [](const StudentRecord& a, const StudentRecord& b) { return a.student < b.student; });
  return records;
}

/// Those of the submissions that are to be judged.
std::vector<Submission> wanted(const std::vector<Submission>& all,
                               const std::vector<std::string>& students) {
  if (students.empty()) return all;
  std::vector<Submission> chosen;
  for (const std::string& student : students) {
    const std::size_t before = chosen.size();
    std::vector<std::string> names;
    for (const Submission& submission : all) {
      StudentRecord record{submission.student, 1, 0, "", {}};
      record.who = submission.who;
      if (is_called(record, student)) chosen.push_back(submission);
      names.push_back(submission.student);
    }
    require(chosen.size() > before, "there is no submission of '", student, "'",
            support::did_you_mean(student, names));
  }
  return chosen;
}

/// Ids of the units that --only names.
std::set<std::string> units_named(const Course& course, const CourseSettings& settings,
                                  const std::vector<std::string>& names) {
  std::set<std::string> ids;
  for (const std::string& name : names)
    for (const Unit& unit : course.select(name)) {
      require(settings.weights.contains(unit.id()), "--only ", name, ": ", unit.number, " ",
              unit.name, " does not count");
      ids.insert(unit.id());
    }
  return ids;
}

/// One line a student, and what there is to know besides the points.
void print_grades(const CourseSettings& settings, const std::vector<StudentRecord>& records) {
  std::size_t width = 7;
  for (const StudentRecord& record : records)
    width = std::max(width, support::characters(escaped(record.student)));
  for (const StudentRecord& record : records) {
    char points[64];
    std::snprintf(points, sizeof points, "%8.2f of %.2f", final_grade(settings, record).points,
                  settings.most());
    const std::string note = escaped(note_on(settings, record));
    std::cout << support::padded(escaped(record.student), width) << points;
    if (!note.empty()) std::cout << (record.refused.empty() ? "  " : "  the submission ") << note;
    std::cout << "\n";
  }
}

/// A list on stderr, cut where nobody reads on.
void say_list(const std::string& head, const std::vector<std::string>& lines) {
  constexpr std::size_t most = 20;
  if (lines.empty()) return;
  std::cerr << "tumble: " << head << "\n";
  for (std::size_t i = 0; i < std::min(most, lines.size()); ++i)
    std::cerr << "  " << escaped(lines[i]) << "\n";
  if (lines.size() > most) std::cerr << "  and " << lines.size() - most << " more\n";
}

/// Every entry that has no row, and why.
void say_left_out(const std::vector<LeftOut>& left_out) {
  constexpr const char* head = "left out, as no submission:";
  if (!left_out.empty()) std::cerr << "tumble: " << head << "\n";
  for (const LeftOut& each : left_out)  // none is hidden: it could be somebody's work
    std::cerr << "  " << escaped(each.what) << ": " << escaped(each.why) << "\n";
}

/// Names in course.json that nobody in the class has.
void say_unknown(const CourseSettings& settings, const std::vector<StudentRecord>& records) {
  std::vector<std::string> names, unknown;
  for (const StudentRecord& record : records) names.push_back(record.student);
  const auto look_for = [&](const std::string& key, const std::string& student) {
    const bool known = std::any_of(records.begin(), records.end(),
                                   [&](const StudentRecord& r) { return is_called(r, student); });
    if (!known)
      unknown.push_back(key + ": there is no " + student + support::did_you_mean(student, names));
  };
  for (const auto& [student, date] : settings.rules.extensions) look_for("extensions", student);
  for (const auto& [student, points] : settings.rules.overrides) look_for("overrides", student);
  say_list("course.json names students who are not here:", unknown);
}

void say_identical(const std::vector<IdenticalFiles>& groups) {
  std::vector<std::string> lines;
  for (const IdenticalFiles& group : groups) {
    std::string line = group.unit.number + " " + group.unit.name + ": ";
    for (std::size_t i = 0; i < group.students.size(); ++i)
      line += (i == 0 ? "" : ", ") + group.students[i];
    lines.push_back(std::move(line));
  }
  say_list("identical files, which identical.csv lists too:", lines);
}

/// What to know of the class before the grades are given away.
void say_about(const Work& work, const CourseSettings& settings,
               const std::vector<StudentRecord>& records) {
  say_left_out(work.all.left_out);
  say_list("not on the roster:", work.match.strangers);
  say_unknown(settings, records);
  say_identical(identical_files(settings, records));
  const auto timeless = std::count_if(records.begin(), records.end(), [](const StudentRecord& r) {
    return !r.absent && r.handed_in.empty() && !r.marked_late;
  });
  if (settings.rules.late && timeless > 0)
    std::cerr << "tumble: of " << timeless
              << " submissions nobody says when they came: they count as in time\n";
}

/// Keeps the settings for the report.
void keep_settings(const GradesFolder& folder, const std::optional<fs::path>& settings) {
  std::error_code was_not_there;
  if (settings)
    support::write_text(folder.settings(), support::read_text(*settings));
  else
    fs::remove(folder.settings(), was_not_there);
}

/// What was written, and how it ended.
int finish(const Work& work, const GradesFolder& folder, const CourseSettings& settings,
           const std::vector<std::string>& failed, const Interruption& interruption,
           std::chrono::steady_clock::time_point start) {
  const std::vector<StudentRecord> records = rows_of(work, folder, settings);
  const auto written = write_outputs(folder, {settings, records, work.all.submissions, work.all.lms,
                                              work.roster ? &*work.roster : nullptr});
  print_grades(settings, records);
  say_about(work, settings, records);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  std::cerr << "tumble: " << duration_text(taken.count()) << "; grades: ";
  for (const fs::path& file : written) std::cerr << file.string() << ", ";
  std::cerr << "one file a student in " << (folder.path / "students").string() << ", for them in "
            << folder.feedback().string() << "\n";
  if (interruption.asked()) {
    std::cerr << "tumble: interrupted: the grades are those of what was judged; the same command "
                 "goes on there\n";
    return 130;
  }
  for (const std::string& student : failed)
    std::cerr << "tumble: the judge has failed at " << escaped(student)
              << ", see above; the same command again goes on there\n";
  return failed.empty() ? 0 : 2;
}

}  // namespace

int grade(const Course& course, const GradeOptions& options) {
  const CourseSettings settings = settings_or_default(course, options.settings);
  const Work work(course, settings, options);
  const std::vector<Submission> submissions = wanted(work.all.submissions, options.students);
  if (!may_judge(course, options.strict ? Strangers::strictly : Strangers::yes)) return 2;
  const GradesFolder folder{options.out};
  fs::create_directories(folder.path / "students");
  const GradingLock lock(folder.lock());
  keep_settings(folder, options.settings);
  const WorkFolder compiled;
  fs::permissions(compiled.path(), fs::perms::owner_all);  // nobody else's, not even to look in
  const ObjectCache cache(compiled.path());
  const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
  const std::size_t students_at_once = options.at_once.value_or(cores);
  // A compiler takes 150 MB: no more of them than cores.
  const std::size_t builds_at_once = std::max<std::size_t>(1, cores / students_at_once);
  Grading grading{course, settings,      class_seed(settings, folder), judge_fingerprint(),
                  cache,  builds_at_once};
  grading.only = units_named(course, settings, options.only);
  std::cerr << "tumble: " << submissions.size() << " submissions, " << settings.units.size()
            << " exercises each\n";
  say_list("records:", set_damaged_aside(folder, work.all.submissions));
  const auto start = std::chrono::steady_clock::now();
  const Interruption interruption;
  const std::vector<std::string> failed =
      grade_class(grading, submissions, folder, students_at_once, interruption);
  return finish(work, folder, settings, failed, interruption, start);
}

}  // namespace tumble::judge
