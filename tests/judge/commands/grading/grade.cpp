#include <algorithm>
#include <iostream>
#include <random>
#include <sstream>
#include <thread>

#include "judge/build/work_folder.hpp"
#include "judge/class/collect.hpp"
#include "judge/class/final_grade.hpp"
#include "judge/class/grading_lock.hpp"
#include "judge/class/one_student_each.hpp"
#include "judge/class/progress_line.hpp"
#include "judge/class/shard_manifest.hpp"
#include "judge/class/units_meant.hpp"
#include "judge/commands/grading/finish_grading.hpp"
#include "judge/commands/grading/grade_messages.hpp"
#include "judge/commands/grading/graded_before.hpp"
#include "judge/commands/grading/grading.hpp"
#include "judge/commands/sandbox.hpp"
#include "support/how_many.hpp"
#include "support/nearest.hpp"
#include "support/text_file.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

/// What there is to grade.
struct Work {
  WorkFolder unpacked;
  ClassRoll roll;

  Work(const Course& course, const CourseSettings& settings, const GradeOptions& options) {
    std::optional<Lms> from;
    if (options.from) from = lms_named(*options.from);
    if (options.roster) {
      roll.roster_text = support::read_text(*options.roster);
      roll.roster = roster_in(roll.roster_text, options.roster->string());
    }
    ClassWork all = collect(course, options.folders, from, settings.rules.several, unpacked);
    roll.submissions = std::move(all.submissions);
    roll.left_out = std::move(all.left_out);
    roll.lms = all.lms;
    if (roll.roster) roll.match = judge::match(*roll.roster, roll.submissions);
    if (roll.lms == Lms::none && roll.roster && !from) roll.lms = roll.roster->lms;
  }
};

/// Those of the submissions that are to be judged.
std::vector<Submission> wanted(const std::vector<Submission>& all,
                               const std::vector<std::string>& students) {
  if (students.empty()) return all;
  std::vector<Submission> chosen;
  const std::vector<StudentRecord> records = everybody({all, {}, Lms::none, {}, "", {}});
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const Submission& submission : all) names.push_back(submission.student);
  for (const std::string& student : students) {
    const std::vector<std::string> rows = rows_called(records, student);
    require(!rows.empty(), "there is no submission of '", student, "'",
            support::did_you_mean(student, names));
    std::copy_if(all.begin(), all.end(), std::back_inserter(chosen), [&](const Submission& each) {
      return std::find(rows.begin(), rows.end(), each.student) != rows.end();
    });
  }
  return chosen;
}

/// Ids of the units that --only names, of those that count.
std::set<std::string> units_named(const Course& course, const CourseSettings& settings,
                                  const std::vector<std::string>& names) {
  std::set<std::string> ids;
  for (const std::string& name : names)
    for (const Unit& unit : counted_units(course, settings.units, name)) ids.insert(unit.id());
  return ids;
}

/// Those of them that one shard judges.
std::vector<Submission> in_shard(const std::vector<Submission>& all, const Shard& shard) {
  std::vector<Submission> chosen;
  std::copy_if(all.begin(), all.end(), std::back_inserter(chosen),
               [&](const Submission& each) { return holds(shard, each.student); });
  return chosen;
}

/// What is to be judged: of the whole class, or of a shard of it.
std::vector<Submission> chosen(const std::vector<Submission>& all, const GradeOptions& options,
                               const std::optional<Shard>& shard) {
  std::vector<Submission> named = wanted(all, options.students);
  if (!shard) return named;
  std::vector<Submission> here = in_shard(named, *shard);
  require(options.students.empty() || !here.empty(), "'",
          options.students.empty() ? "" : options.students.front(), "' is in shard ",
          named.empty() ? "" : name_of({shard_number(named.front().student, shard->of), shard->of}),
          ", not in ", name_of(*shard));
  return here;
}

/// Shards of one class need one seed.
void require_seed(const CourseSettings& settings, const GradesFolder& folder) {
  require(settings.seed || fs::exists(folder.seed()),
          "--shard needs a \"seed\" in --course course.json, so that all shards draw the same "
          "inputs. Take a whole number and keep it secret, such as ",
          std::random_device{}());
}

/// What has to be remembered of a shard, until it is merged.
ShardManifest manifest(const Shard& shard, const Grading& grading, const GradeOptions& options,
                       const ClassRoll& roll) {
  ShardManifest said{shard, grading.seed, text_of(options.settings), {}, roll};
  for (const Unit& unit : grading.settings.units) said.judges[unit.id()] = grading.judge.of(unit);
  return said;
}

/// Locks a folder for all of a class, or for one shard beside others.
class FolderLock {
 public:
  FolderLock(const GradesFolder& folder, const std::optional<Shard>& shard)
      : whole_(folder.lock(), folder.path.string(),
               shard ? GradingLock::With::other_shards : GradingLock::With::nobody) {
    if (!shard) return;
    fs::create_directories(folder.shards());
    own_.emplace(manifest_of(folder, *shard).replace_extension(".lock"),
                 folder.path.string() + ", of shard " + name_of(*shard));
  }

 private:
  GradingLock whole_;
  std::optional<GradingLock> own_;
};

/// Says a line, whole: other shards may speak on the same terminal.
template <class... Words>
void say(const Words&... words) {
  std::ostringstream line;
  line << "tumble: ";
  (line << ... << words) << "\n";
  std::cerr << line.str();
}

/// Says what a shard is, and how it ended: tables are the whole class's.
int finish_shard(const Shard& shard, const GradesFolder& folder, const CourseSettings& settings,
                 const std::vector<Submission>& all, const GradingRun& run) {
  const std::vector<Submission> own = in_shard(all, shard);
  const int status = say_end(records_of(folder, settings, own), run);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - run.start;
  say(duration_text(taken.count()), "; shard ", name_of(shard), ", ", own.size(), " of ",
      all.size(), " submissions, is ", status == 0 ? "judged" : "not complete", ": ",
      (folder.path / "students").string());
  say("when all ", shard.of, " shards are judged, make the tables: ./tumble grade --merge DIR...");
  return status;
}

/// How much is done at a time. A compiler takes 150 MB: no more of them than cores.
struct Pace {
  std::size_t students, builds_of_each;

  explicit Pace(const std::optional<std::size_t>& wanted) {
    const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
    students = wanted.value_or(cores);
    builds_of_each = std::max<std::size_t>(1, cores / students);
  }
};

/// Says what will be judged; a shard also writes it down, for the merging.
void announce(const Grading& grading, const GradeOptions& options, const ClassRoll& roll,
              std::size_t submissions, const std::optional<Shard>& shard) {
  const std::string exercises =
      support::how_many(grading.settings.units.size(), "exercise") + " each";
  if (!shard) return say(support::how_many(submissions, "submission"), ", ", exercises);
  write_manifest(GradesFolder{options.out}, manifest(*shard, grading, options, roll));
  say("shard ", name_of(*shard), ": ", submissions, " of ",
      support::how_many(roll.submissions.size(), "submission"), ", ", exercises);
}

/// Judges these submissions, as far as it comes.
GradingRun judged(const Grading& grading, const std::vector<Submission>& submissions,
                  const GradesFolder& folder, std::size_t at_once) {
  GradingRun run;
  const Interruption interruption;
  const std::vector<StudentRecord> before = records_of(folder, grading.settings, submissions);
  run.failed = grade_class(grading, submissions, folder, at_once, interruption);
  say_changes(before, records_of(folder, grading.settings, submissions));
  run.interrupted = interruption.asked();
  return run;
}

/// The options with what was given before, which is said.
GradeOptions completed(const GradeOptions& given) {
  std::string taken;
  GradeOptions options = as_before(given, taken);
  const bool has_files = options.settings != given.settings || options.roster != given.roster;
  if (!taken.empty())
    say("as before: ", escaped(taken), has_files ? " (to grade without a file, delete it)" : "");
  require(!options.folders.empty(), "DIR is required: the folder of the submissions; ",
          given.out.string(), " remembers none");
  return options;
}

}  // namespace

int grade(const Course& course, const GradeOptions& given) {
  if (!given.merge.empty()) return merge(course, given);
  const GradeOptions options = completed(given);
  CourseSettings settings = settings_or_default(course, options.settings);
  std::optional<Shard> shard;
  if (options.shard) shard = shard_in(*options.shard);
  const GradesFolder folder{options.out};
  if (shard) require_seed(settings, folder);
  const Work work(course, settings, options);
  settings.rules = with_names_of_rows(settings.rules, everybody(work.roll));
  const std::vector<Submission>& all = work.roll.submissions;
  const std::vector<Submission> submissions = chosen(all, options, shard);
  const std::set<std::string> only = units_named(course, settings, options.only);
  say_what_differs(options);
  if (!may_judge(course, options.strict ? Strangers::strictly : Strangers::yes)) return 2;
  create(folder);
  if (shard) require_same_cut(folder, *shard);
  const FolderLock lock(folder, shard);
  if (!shard) keep(folder, options);  // a shard's manifest has all of it
  const WorkFolder compiled;
  fs::permissions(compiled.path(), fs::perms::owner_all);  // nobody else's, not even to look in
  const ObjectCache cache(compiled.path());
  const Pace pace(options.at_once);
  const JudgeFingerprint judge(course);
  Grading grading{course, settings, class_seed(settings, folder),
                  judge,  cache,    pace.builds_of_each};
  grading.only = only;
  if (options.seconds) grading.deadline = after(*options.seconds);
  announce(grading, options, work.roll, submissions.size(), shard);
  say_list("records:", set_damaged_aside(folder, shard ? submissions : all));
  const GradingRun run = judged(grading, submissions, folder, pace.students);
  return shard ? finish_shard(*shard, folder, settings, all, run)
               : finish_class(work.roll, folder, settings, run);
}

}  // namespace tumble::judge
