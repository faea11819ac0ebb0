#include <algorithm>
#include <iostream>

#include "judge/class/final_grade.hpp"
#include "judge/class/grading_lock.hpp"
#include "judge/class/merge_shards.hpp"
#include "judge/commands/grading/finish_grading.hpp"
#include "judge/commands/grading/grade_messages.hpp"
#include "judge/commands/grading/graded_before.hpp"
#include "judge/commands/grading/grading.hpp"
#include "support/how_many.hpp"

namespace tumble::judge {

namespace {

/// Says whose shards were not judged to the end.
/// @return whether there are any
bool said_unfinished(const ShardedClass& shards, const GradesFolder& out) {
  std::vector<std::size_t> left(shards.count() + 1);
  for (const StudentRecord& record : records_of(out, shards.settings(), shards.roll().submissions))
    if (!is_complete(shards.settings(), record))
      ++left[shard_number(record.student, shards.count())];
  std::vector<std::string> lines;
  for (std::size_t i = 1; i <= shards.count(); ++i)
    if (left[i] > 0)
      lines.push_back("shard " + name_of({i, shards.count()}) + ": " + std::to_string(left[i]) +
                      " students");
  say_list(
      "these shards are not complete, and their students' grades stay open; --shard judges the "
      "rest:",
      lines);
  return !lines.empty();
}

/// Whose records these are was judged by what is here?
bool is_here(const Course& course, const ShardedClass& shards) {
  const JudgeFingerprint judge(course);
  const std::vector<Unit>& units = shards.settings().units;
  return std::all_of(units.begin(), units.end(), [&](const Unit& unit) {
    return shards.judges().at(unit.id()) == judge.of(unit);
  });
}

}  // namespace

int merge(const Course& course, const GradeOptions& options) {
  GradingRun run;
  run.again = "judging their shards again";
  const GradesFolder out{options.out};
  const ShardedClass shards(course, options.merge);
  create(out);
  const GradingLock lock(out.lock(), out.path.string());
  if (!is_here(course, shards))
    std::cerr << "tumble: one judge has judged all the shards, and this tumble is another: "
                 "its specs or its compiler differ\n";
  std::cerr << "tumble: " << support::how_many(shards.count(), "shard") << ", "
            << support::how_many(shards.roll().submissions.size(), "submission") << ", "
            << support::how_many(shards.settings().units.size(), "exercise") << " each\n";
  shards.bring_to(out);
  const ClassRoll& roll = shards.roll();
  keep_files(out, shards.settings_text(),
             roll.roster ? std::optional(roll.roster_text) : std::nullopt);
  const int status = finish_class(roll, out, shards.settings(), run);
  return said_unfinished(shards, out) && status == 0 ? 1 : status;
}

}  // namespace tumble::judge
