#include <algorithm>
#include <charconv>
#include <iostream>
#include <memory>
#include <random>
#include <utility>

#include "judge/build/object_cache.hpp"
#include "judge/build/submission.hpp"
#include "judge/commands/commands.hpp"
#include "judge/commands/given_files.hpp"
#include "judge/commands/sandbox.hpp"
#include "judge/course/progress.hpp"
#include "judge/spec/load_spec.hpp"
#include "judge/spec/run.hpp"
#include "judge/verdict/console.hpp"
#include "judge/verdict/json.hpp"
#include "judge/verdict/judge_all.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

/// What is to be judged: "4.1.3" is the third case of 4.1.
struct Selection {
  std::vector<Unit> units;
  std::size_t only_case = 0;
};

std::size_t number_of(const std::string& text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  require(error == std::errc() && end == text.data() + text.size() && number > 0, "'", text,
          "' is not the number of a case");
  return number;
}

/// The exercise whose file has this path, or this name.
/// @throws std::invalid_argument of a file in another folder: we would judge the course's
std::vector<Unit> course_files_named(const Course& course, const std::string& path) {
  std::vector<Unit> units = course.select(path);
  std::error_code missing;
  const bool is_elsewhere = fs::path(path).has_parent_path() && fs::exists(path, missing) &&
                            std::none_of(units.begin(), units.end(), [&](const Unit& unit) {
                              return fs::equivalent(path, course.exercise(unit), missing);
                            });
  require(!is_elsewhere, path, " is not the file that we judge, which is ",
          fs::relative(course.exercise(units.front()), course.root).string(),
          ". To judge files in another folder: check ", units.front().number, " --from FOLDER");
  return units;
}

Selection select(const Course& course, const Progress& progress, const std::string& what) {
  if (what.empty()) {
    const std::optional<Unit> open = progress.next_open();
    return open ? Selection{{*open}, 0} : Selection{};
  }
  if (what.ends_with(".cpp")) return {course_files_named(course, what), 0};
  const auto first_dot = what.find('.');
  const auto second_dot = what.find('.', first_dot + 1);
  if (first_dot == std::string::npos || second_dot == std::string::npos)
    return {course.select(what), 0};
  return {course.select(what.substr(0, second_dot)), number_of(what.substr(second_dot + 1))};
}

/// @throws std::invalid_argument if a unit has no case of the number that was asked for
void require_case(const Selection& selection) {
  if (selection.only_case == 0) return;
  for (const Unit& unit : selection.units) {
    load_spec(unit);
    const std::size_t cases = count_cases(unit.id());
    require(selection.only_case <= cases, unit.number, " has cases 1 to ", cases, ", and no case ",
            selection.only_case);
  }
}

fs::path source_of(const Course& course, const CheckOptions& options,
                   const std::optional<GivenFiles>& given, const Unit& unit) {
  if (given) return given->of(unit);
  return options.solutions ? course.solution(unit) : course.exercise(unit);
}

std::uint64_t fresh_seed() { return std::random_device{}() % 1000000 + 1; }

void remember(Progress& progress, const Course& course, const UnitResult& result) {
  if (!result.judge_failure.empty()) return;
  UnitProgress& unit = progress.of(result.unit);
  unit.last = result.untouched() ? "" : result.summary();
  unit.source = fingerprint(course.exercise(result.unit));
  if (!result.untouched()) ++unit.tries;
  progress.save();
}

void print_totals(const std::vector<UnitResult>& results) {
  std::size_t passed = 0;
  for (const UnitResult& result : results) passed += result.passed() ? 1u : 0u;
  std::cout << passed << " of " << results.size() << " exercises pass\n";
}

void print_next(const Course& course, const std::optional<Unit>& unit) {
  if (unit)
    std::cout << "  Next: " << unit->number << " " << unit->name << ", in "
              << fs::relative(course.exercise(*unit), course.root).string() << "\n";
  else
    std::cout << "  Every exercise passes. Well done.\n";
}

/// Two chapters may have a function of the same name.
void print_namesakes(const std::vector<Unit>& units, const std::string& what) {
  if (units.size() > 1 && units.front().name == what)
    std::cerr << "tumble: " << what << " means " << numbers_of(units) << "\n";
}

/// Says which file is not UTF-8: an editor that does not know it would show other characters.
void print_encoding(const Course& course, const fs::path& file) {
  try {
    const std::string was = read_decoded_submission(file).was;
    if (was.empty()) return;
    const fs::path inside = file.lexically_relative(course.root);
    const bool is_ours = !inside.empty() && *inside.begin() != "..";
    std::cerr << "tumble: " << (is_ours ? inside : file).string() << " is " << was
              << ", not UTF-8: we judge it converted, and leave your file as it is\n";
  } catch (const std::runtime_error&) {
    // the verdict says so
  }
}

/// How the units are judged, and with which inputs.
Judgement judgement_for(const CheckOptions& options, std::size_t only_case,
                        const ObjectCache* earlier) {
  Judgement judgement;
  judgement.seed = options.seed.value_or(fresh_seed());
  judgement.seeds = options.seeds;
  judgement.only_case = only_case;
  judgement.only_sanitized = options.sanitized;
  judgement.compiled = earlier;
  // With sanitizers the walls are lower: not for a class's submissions.
  judgement.locate_crashes = !options.strict && !options.sanitized && !options.once;
  return judgement;
}

/// Judges what is selected, and says what becomes of it.
class CheckRun {
 public:
  CheckRun(const Course& course, const CheckOptions& options, Progress& progress,
           Selection selection)
      : course_(course),
        options_(options),
        progress_(progress),
        selection_(std::move(selection)),
        own_work_(!options.from && !options.solutions && selection_.only_case == 0) {
    if (options.from) given_.emplace(course, *options.from);
    style_.every_case = options.every_case;
  }

  /// @return the exit status
  int run() {
    for (const Unit& unit : selection_.units) print_encoding(course_, source(unit));
    const std::unique_ptr<const ObjectCache> earlier = objects_of_earlier(course_);
    judge_all(
        course_, selection_.units, [this](const Unit& unit) { return source(unit); },
        judgement_for(options_, selection_.only_case, earlier.get()),
        [this](const UnitResult& result) { take(result); });
    return end();
  }

 private:
  fs::path source(const Unit& unit) const { return source_of(course_, options_, given_, unit); }

  void take(const UnitResult& result) {
    if (selection_.units.size() > 1 && result.untouched())
      print_line(std::cout, result, style_);
    else
      print_result(std::cout, course_, result, style_);
    std::cout << std::flush;
    results_.push_back(result);
    if (options_.json) records_.push_back(record_of(course_, result));
    if (options_.json) write_json(*options_.json, records_);
    if (own_work_) remember(progress_, course_, result);
  }

  int end() const {
    const bool all_passed = std::all_of(results_.begin(), results_.end(),
                                        [](const UnitResult& result) { return result.passed(); });
    const bool judge_failed =
        std::any_of(results_.begin(), results_.end(),
                    [](const UnitResult& result) { return !result.judge_failure.empty(); });
    if (results_.size() > 1) print_totals(results_);
    if (own_work_ && all_passed)
      print_next(course_, progress_.next_open_after(results_.back().unit));
    return judge_failed ? 2 : all_passed ? 0 : 1;
  }

  const Course& course_;
  const CheckOptions& options_;
  Progress& progress_;
  Selection selection_;
  bool own_work_;  ///< then it counts for the student's progress
  std::optional<GivenFiles> given_;
  ConsoleStyle style_ = style_of_terminal();
  std::vector<UnitResult> results_;
  std::vector<UnitRecord> records_;
};

}  // namespace

std::vector<Unit> units_to_check(const Course& course, const std::string& what) {
  return select(course, Progress(course), what).units;
}

int check(const Course& course, const CheckOptions& options) {
  Progress progress(course);
  Selection selection = select(course, progress, options.what);
  if (selection.units.empty()) {
    print_next(course, progress.next_open());
    return 0;
  }
  require_case(selection);
  print_namesakes(selection.units, options.what);
  if (!may_judge(course, options.strict ? Strangers::strictly : Strangers::no)) return 2;
  return CheckRun(course, options, progress, std::move(selection)).run();
}

}  // namespace tumble::judge
