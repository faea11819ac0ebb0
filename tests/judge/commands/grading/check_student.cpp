#include <algorithm>
#include <iostream>
#include <sstream>

#include "judge/class/file_names.hpp"
#include "judge/class/sources.hpp"
#include "judge/class/student_record.hpp"
#include "judge/commands/grading/grading.hpp"
#include "judge/commands/sandbox.hpp"
#include "judge/verdict/console.hpp"
#include "judge/verdict/judge_all.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

/// What a record of `grade` says, and the files that it is about.
struct Seen {
  StudentRecord record;
  fs::path sources;

  explicit Seen(const fs::path& file) {
    require(fs::is_regular_file(file), file.string(),
            " is not a file: `grade` makes one per student");
    record = *read_record(file);
    sources =
        fs::absolute(file).lexically_normal().parent_path().parent_path() / "sources" / file.stem();
  }

  fs::path source_of(const Unit& unit) const { return kept_source(sources, unit); }
  /// How the student calls the file.
  std::string name_of_file(const Unit& unit) const {
    const auto found = record.files.find(unit.id());
    return found == record.files.end() ? unit.id() + ".cpp" : escaped(found->second);
  }
};

/// A text in which a file is called as its student calls it.
std::string with_own_name(std::string text, const fs::path& root, const fs::path& file,
                          const std::string& name) {
  for (const std::string& path : {file.string(), file.lexically_relative(root).string()})
    for (std::size_t at = 0; (at = text.find(path, at)) != std::string::npos; at += name.size())
      text.replace(at, path.size(), name);
  return text;
}

/// The first line ends with the time that it took, which is never the same.
std::string without_first_line(const std::string& text) {
  const auto end = text.find('\n');
  return end == std::string::npos ? "" : text.substr(end);
}

/// Says a verdict again, and whether it is another one now.
void say_again(const Course& course, const Seen& seen, const UnitResult& result) {
  std::ostringstream text;
  ConsoleStyle plain;
  print_result(text, course, result, plain);
  const std::string now = with_own_name(text.str(), course.root, seen.source_of(result.unit),
                                        seen.name_of_file(result.unit));
  std::cout << now;
  const UnitRecord& before = *seen.record.find(result.unit);
  if (without_first_line(now) != without_first_line(before.explanation))
    std::cerr << "tumble: the judge has changed since. What " << escaped(seen.record.student)
              << " saw:\n"
              << before.explanation;
}

}  // namespace

std::vector<Unit> units_of_student(const Course& course, const CheckOptions& options) {
  const Seen seen(*options.student);
  std::vector<Unit> units;
  for (const Unit& unit : course.select(options.what.empty() ? "all" : options.what))
    if (seen.record.find(unit)) units.push_back(unit);
  return units;
}

int check_student(const Course& course, const CheckOptions& options) {
  const Seen seen(*options.student);
  const std::vector<Unit> units = units_of_student(course, options);
  if (!seen.record.refused.empty())
    std::cout << "The submission " << escaped(seen.record.refused) << ".\n";
  require(!units.empty() || !seen.record.refused.empty(), options.student->string(),
          " has no verdict on the exercises that you named");
  if (!may_judge(course, options.strict ? Strangers::strictly : Strangers::yes)) return 2;
  std::vector<Unit> kept;
  for (const Unit& unit : units)
    if (fs::exists(seen.source_of(unit)))
      kept.push_back(unit);
    else  // there was no file, or one that is no source
      std::cout << seen.record.find(unit)->explanation;
  Judgement judgement;
  judgement.seed = seen.record.seed;
  judgement.locate_crashes = false;  // as `grade` did
  bool judge_failed = false,
       all_passed = kept.size() == units.size() && seen.record.refused.empty();
  judge_all(
      course, kept, [&](const Unit& unit) { return seen.source_of(unit); }, judgement,
      [&](const UnitResult& result) {
        say_again(course, seen, result);
        all_passed = all_passed && result.passed();
        judge_failed = judge_failed || !result.judge_failure.empty();
      });
  return judge_failed ? 2 : all_passed ? 0 : 1;
}

}  // namespace tumble::judge
