/// @file
/// Proof that the judge survives every answer and every evaluation: the solutions answer, and one
/// of their numbers or lists is put out of shape on the way.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <thread>

#include "judge/build/object_cache.hpp"
#include "judge/build/work_folder.hpp"
#include "judge/build/worker_build.hpp"
#include "judge/commands/commands.hpp"
#include "judge/conversation/student_worker.hpp"
#include "judge/sandbox/process_pool.hpp"
#include "judge/spec/load_spec.hpp"
#include "judge/spec/run.hpp"
#include "judge/verdict/judge_unit.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

/// A way to put a value out of shape.
struct Distortion {
  std::string name;
  std::function<Value(const Value&)> apply;
};

/// Every number of a value replaced.
Value with_numbers(const Value& value, double x) {
  if (value.as<double>()) return x;
  if (value.as<std::int64_t>())
    return std::isfinite(x) ? (x > 0 ? std::numeric_limits<std::int64_t>::max()
                                     : std::numeric_limits<std::int64_t>::min())
                            : std::int64_t{-1};
  const List* list = value.as<List>();
  if (!list) return value;
  List result;
  for (const Value& each : *list) result.push_back(with_numbers(each, x));
  return result;
}

/// One number of a value replaced, the others stay: number `which`, counted in order. Counts
/// `which` down on the way.
Value with_one_number(const Value& value, double x, std::size_t& which) {
  const List* list = value.as<List>();
  if (!list) return which-- == 0 ? with_numbers(value, x) : value;
  List result;
  for (const Value& each : *list) result.push_back(with_one_number(each, x, which));
  return result;
}

std::size_t count_numbers(const Value& value) {
  const List* list = value.as<List>();
  if (!list) return 1;
  std::size_t count = 0;
  for (const Value& each : *list) count += count_numbers(each);
  return count;
}

/// One number replaced, a fraction `place` of the way from the first to the last.
Value with_number_at(const Value& value, double x, double place) {
  const std::size_t count = count_numbers(value);
  if (count == 0) return value;
  auto which = static_cast<std::size_t>(place * static_cast<double>(count - 1));
  return with_one_number(value, x, which);
}

/// Every list at this depth changed in size.
Value with_lists(const Value& value, int depth, const std::function<void(List&)>& change) {
  const List* list = value.as<List>();
  if (!list) return value;
  List result = *list;
  if (depth == 0)
    change(result);
  else
    for (Value& each : result) each = with_lists(each, depth - 1, change);
  return result;
}

/// Every integer replaced by one that is as usual: a flag turned over, an index that is in range.
Value with_other_integers(const Value& value) {
  if (const std::int64_t* n = value.as<std::int64_t>()) return std::int64_t{*n == 0 ? 1 : 0};
  const List* list = value.as<List>();
  if (!list) return value;
  List result;
  for (const Value& each : *list) result.push_back(with_other_integers(each));
  return result;
}

std::vector<Distortion> distortions() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<std::string, double>> numbers = {
      {"NaN", nan},
      {"infinity", infinity},
      {"-infinity", -infinity},
      {"the largest number", std::numeric_limits<double>::max()}};
  const std::vector<std::pair<std::string, std::function<void(List&)>>> sizes = {
      {"empty", [](List& list) { list.clear(); }},
      {"one too short", [](List& list) { list.resize(std::max<std::size_t>(list.size(), 1) - 1); }},
      {"one too long", [](List& list) { list.push_back(list.empty() ? Value(1.) : list.back()); }},
      {"huge", [](List& list) { list.resize(30'000, list.empty() ? Value(1.) : list.back()); }}};
  std::vector<Distortion> all;
  all.reserve(20);
  for (const auto& [name, x] : numbers)
    all.push_back({name, [number = x](const Value& v) { return with_numbers(v, number); }});
  all.push_back({"other integers", with_other_integers});
  for (const double place : {0., 0.5, 1.})
    all.push_back({"NaN once", [=](const Value& v) { return with_number_at(v, nan, place); }});
  for (const auto& [name, change] : sizes)
    for (const int depth : {0, 1})
      all.push_back(
          {name + " at depth " + std::to_string(depth),
           [depth, resize = change](const Value& v) { return with_lists(v, depth, resize); }});
  return all;
}

/// Which answer, or which evaluation, of a case is put out of shape.
struct Place {
  enum class Of { answers, evaluations } of;
  enum class Which { first, last } which;
};

/// Answers as a worker does, but for what is put out of shape.
class OddAnswerer : public Answerer {
 public:
  explicit OddAnswerer(StudentWorker& worker) : worker_(worker) {}

  void distort(const Distortion& distortion, Place place) {
    distortion_ = &distortion;
    place_ = place;
    case_ = 0;
    changed_ = false;
  }
  bool changed() const { return changed_; }

  /// Places that are there, and no two the same: a spec that hands out no function gets no
  /// evaluation, and where a case asks once, the first answer is the last. To be asked after a run
  /// without distortion.
  std::vector<Place> places() const {
    std::vector<Place> there{{Place::Of::answers, Place::Which::first}};
    const auto some = [this](std::size_t Counts::*of, std::size_t than) {
      return std::any_of(counts_.begin(), counts_.end(),
                         [=](const auto& each) { return each.second.*of > than; });
    };
    if (some(&Counts::answers, 1)) there.push_back({Place::Of::answers, Place::Which::last});
    if (some(&Counts::evaluations, 0))
      there.push_back({Place::Of::evaluations, Place::Which::first});
    return there;
  }

  void start_case() override {
    ++case_;
    asked_ = evaluated_ = 0;
    worker_.start_case();
  }

  Value ask(const Call& question, const CallBack& call_back) override {
    const Value answer = worker_.ask(question, [&](FunctionId id, const List& arguments) {
      if (is_place(Place::Of::evaluations, ++evaluated_))
        call_back(id, list_of(distorted(arguments)));  // as a student would call it as well
      return call_back(id, arguments);
    });
    ++asked_;
    if (!distortion_) counts_[case_] = {asked_, evaluated_};
    return is_place(Place::Of::answers, asked_) ? distorted(answer) : answer;
  }
  std::string printed() override { return {}; }

 private:
  bool is_place(Place::Of of, std::size_t number) const {
    if (!distortion_ || place_.of != of) return false;
    if (place_.which == Place::Which::first) return number == 1;
    const auto all = counts_.find(case_);
    return all != counts_.end() && number == all->second.answers;
  }
  Value distorted(const Value& value) {
    Value other = distortion_->apply(value);
    const double apart = largest_difference(value, other);
    if (!(apart == 0)) changed_ = true;
    return other;
  }

  /// How many there are in a case whose answers are all right.
  struct Counts {
    std::size_t answers = 0, evaluations = 0;
  };

  StudentWorker& worker_;
  std::map<std::size_t, Counts> counts_;
  const Distortion* distortion_ = nullptr;
  Place place_{};
  std::size_t case_ = 0, asked_ = 0, evaluated_ = 0;
  bool changed_ = false;
};

std::string name_of(Place place) {
  const char* which = place.which == Place::Which::first ? "first" : "last";
  return std::string(which) + (place.of == Place::Of::answers ? " answer" : " evaluation");
}

/// Tries all on one unit. Sends what is tried next, so that a crash has a name.
void try_unit(const Job& job, std::uint64_t seed, const SendBytes& send) {
  const std::unique_ptr<const ObjectCache> earlier = objects_of_earlier(job.course);
  const WorkerBuild build = build_worker(job, Instrumentation::none, earlier.get());
  require(build.outcome == BuildOutcome::built, "the solution is ", name_of(build.outcome));
  StudentWorker worker(build.worker);
  OddAnswerer answerer(worker);
  const SpecRun run{job.unit.id(), seed};
  run_spec(run, answerer);
  const std::vector<Distortion> all = distortions();
  for (const Place place : answerer.places())
    for (const Distortion& distortion : all) {
      send(name_of(place) + ", " + distortion.name + "\n");
      answerer.distort(distortion, place);
      const std::vector<CaseResult> cases = run_spec(run, answerer);
      const bool unseen = std::all_of(cases.begin(), cases.end(),
                                      [](const CaseResult& each) { return each.passed(); });
      if (place.of == Place::Of::answers && answerer.changed() && unseen)
        throw std::runtime_error("passes");
    }
}

std::string last_line(const std::string& text) {
  if (text.empty()) return "no distortion";
  const auto start = text.rfind('\n', text.size() - 2);
  return text.substr(start == std::string::npos ? 0 : start + 1,
                     text.size() - 1 - (start == std::string::npos ? 0 : start + 1));
}

}  // namespace

int odd_answers(const Course& course, const std::string& what, std::uint64_t seed) {
  const std::vector<Unit> units = course.select(what);
  for (const Unit& unit : units) load_spec(unit);
  const WorkFolder work;
  std::vector<std::string> tried(units.size());
  std::size_t failures = 0, count = 0;
  ProcessPool pool;
  pool.at_once = std::max(1u, std::thread::hardware_concurrency());
  pool.received = [&](std::size_t i, const std::string& bytes) { tried[i] += bytes; };
  pool.finished = [&](const FinishedJob& ended) {
    count += static_cast<std::size_t>(
        std::count(tried[ended.number].begin(), tried[ended.number].end(), '\n'));
    if (ended.failure.empty()) return;
    ++failures;
    std::cout << units[ended.number].number << " " << units[ended.number].name << ": "
              << last_line(tried[ended.number]) << ": " << ended.failure << "\n";
  };
  run_in_processes(units.size(), pool, [&](std::size_t i, const SendBytes& send) {
    try_unit({course, units[i], course.solution(units[i]), work.path() / units[i].name}, seed,
             send);
  });
  std::cout << units.size() << " units, " << count << " distortions, " << failures
            << " units fail\n";
  return failures == 0 ? 0 : 1;
}

}  // namespace tumble::judge
