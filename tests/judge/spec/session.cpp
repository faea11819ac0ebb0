#include "judge/spec/session.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <new>
#include <stdexcept>
#include <utility>

#include "judge/course/stable_hash.hpp"
#include "judge/spec/likeness.hpp"
#include "judge/spec/places.hpp"
#include "tumble/core/rounding.hpp"

namespace tumble::judge {

namespace {

Session* current_session = nullptr;

bool is_finite(const Value& value) {
  if (const double* x = value.as<double>()) return std::isfinite(*x);
  const List* list = value.as<List>();
  return !list || std::all_of(list->begin(), list->end(), is_finite);
}

}  // namespace

std::vector<Misconception>& misconceptions_of(const std::string& unit) {
  static std::map<std::string, std::vector<Misconception>> registry;
  return registry[unit];
}

Session::Session(std::string unit, Answerer& answerer, std::uint64_t seed)
    : unit_(std::move(unit)),
      answerer_(answerer),
      seed_(seed),
      previous_(std::exchange(current_session, this)) {}

Session::~Session() { current_session = previous_; }

Session& Session::current() {
  if (!current_session) throw std::logic_error("a spec runs inside a session only");
  return *current_session;
}

void Session::start_case(std::size_t number) {
  finding_.reset();
  cases_.push_back({number, calls_.size()});
  random_.emplace(stable_hash(unit_, seed_ * 0x9e3779b97f4a7c15 + number));
  answerer_.start_case();
}

std::optional<Finding> Session::take_finding() { return std::exchange(finding_, std::nullopt); }

void Session::found(Finding finding) {
  if (finding_) return;
  finding.printed = answerer_.printed();
  finding_ = std::move(finding);
}

void Session::rethrow_judge_failure() const {
  if (judge_failure_) std::rethrow_exception(judge_failure_);
}

namespace {

constexpr std::size_t max_recorded = 3'000'000;  // numbers, in one run of a spec: some 200 MB
constexpr std::size_t max_wasted = 40'000;       // evaluations: a second or two

/// The longest list of numbers in a value.
std::size_t longest_list(const List& list) {
  std::size_t longest = list.size();
  for (const Value& value : list)
    if (const List* inner = value.as<List>()) longest = std::max(longest, longest_list(*inner));
  return longest;
}

std::size_t count_numbers(const Value& value) {
  const List* list = value.as<List>();
  if (!list) return 1;
  std::size_t count = 1;  // the list itself takes room too
  for (const Value& each : *list) count += count_numbers(each);
  return count;
}

/// What a function gives that is called with these arguments.
/// @throws NoAnswer if it is not defined for them
Value evaluated(const Call& call, FunctionId id, const List& arguments) {
  constexpr std::size_t always_allowed = 16;
  const std::size_t longest = longest_list(arguments);
  if (longest > always_allowed && longest > longest_list(call.arguments))
    throw NoAnswer(Outcome::wrong_call, "with a list of " + std::to_string(longest) +
                                            " numbers, longer than any in "
                                            "the question");
  try {
    return call.functions(id, arguments);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& why) {
    throw NoAnswer(Outcome::wrong_call, why.what());
  }
}

/// Evaluates the functions among the arguments of a call, as often as one answer may.
CallBack evaluator(const Call& call) {
  return [&call, count = std::size_t{0}](FunctionId id, const List& arguments) mutable {
    if (++count > call.most_evaluations)
      throw NoAnswer(Outcome::wrong_call,
                     std::to_string(call.most_evaluations) +
                         " times for one answer, and then once more. No answer "
                         "needs that: look for a loop that never ends");
    return evaluated(call, id, arguments);
  };
}

Question question_of(const Call& call) {
  constexpr std::ptrdiff_t most_shown = 4;
  const auto begin = call.evaluations.begin(), end = call.evaluations.end();
  return {
      call.arguments, call.evaluations.size(), {begin, begin + std::min(most_shown, end - begin)}};
}

}  // namespace

std::size_t Session::ask(Call call) {
  const auto record = [this, &call, evaluate = evaluator(call)](FunctionId id,
                                                                const List& arguments) {
    Value result = evaluate(id, arguments);
    recorded_ += count_numbers(arguments) + count_numbers(result);
    if (recorded_ > max_recorded)
      throw NoAnswer(Outcome::wrong_call, "so often that the judge cannot keep what it was told");
    call.evaluations.push_back({id, arguments, result});
    return result;
  };
  const std::size_t recorded_before = recorded_;
  try {
    if (wasted_ >= max_wasted)
      throw NoAnswer(Outcome::not_run,
                     "cases before this one called the functions that they were "
                     "given without end");
    call.answer = answerer_.ask(call, record);
  } catch (const NoAnswer& why) {
    Finding finding;
    finding.outcome = why.outcome;
    finding.detail = why.what();
    finding.question = question_of(call);
    if (call.evaluations.size() == call.most_evaluations) wasted_ += call.most_evaluations;
    recorded_ = recorded_before;
    call.evaluations.clear();
    end_case_by(call, calls_.size() == cases_.back().first_call);
    found(std::move(finding));
    throw;
  } catch (...) {
    judge_failure_ = std::current_exception();
    throw;
  }
  recorded_ += count_numbers(call.answer);
  calls_.push_back(std::move(call));
  return calls_.size() - 1;
}

void Session::unusable(const std::string& why) {
  if (finding_ || judge_failure_) return;  // which is why the case threw
  if (calls_.size() == cases_.back().first_call) {
    judge_failure_ = std::make_exception_ptr(std::runtime_error("its spec threw: " + why));
    return;
  }
  Finding finding = wrong_answer(calls_.size() - 1);
  finding.misconceptions.clear();
  finding.detail = "an answer that the judge can compute with; it refuses yours: " + why;
  found(std::move(finding));
}

Finding Session::wrong_answer(std::size_t number, const CloseTo* unmet) {
  const Call& call = calls_[number];
  end_case_by(call, number == cases_.back().first_call);
  if (!finding_) {
    cases_.back().asked_before = number - cases_.back().first_call;
    cases_.back().asked_behind = calls_.size() - 1 - number;
  }
  Finding finding;
  finding.question = question_of(call);
  finding.answer = call.answer;
  finding.misconceptions = matching_misconceptions(number, unmet);
  return finding;
}

bool Session::demand(std::size_t number, const CloseTo& demand) {
  Call& call = calls_[number];
  call.metric = demand.metric;
  call.tolerance = demand.tolerance;
  if (demand.metric(call.answer, demand.expected) <= demand.tolerance) return true;
  Finding finding = wrong_answer(number, &demand);
  finding.demanded = demand.restate(demand.expected, call.answer);
  finding.tolerance = demand.tolerance;
  found(std::move(finding));
  return false;
}

namespace {

std::string short_size(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", x);
  return text;
}

/// "your answer misses it by 0.3 (allowed: 1e-12)". A law without a measure is kept or not.
std::string how_it_misses(const Obeys& demand) {
  if (demand.is_count)
    return "here it is " + short_size(demand.error) + " (allowed: " + short_size(demand.bound) +
           ")";
  const bool has_measure = std::isfinite(demand.error) && (demand.error != 1 || demand.bound != 0);
  if (!has_measure) return "your answer does not keep to it";
  return "your answer misses it by " + short_size(demand.error) +
         (demand.bound > 0 ? " (allowed: " + short_size(demand.bound) + ")" : std::string());
}

}  // namespace

bool Session::demand(std::size_t number, const Obeys& demand) {
  if (demand.error <= demand.bound) return true;
  Finding finding = wrong_answer(number);
  finding.detail = demand.law + "; " + how_it_misses(demand);
  finding.tolerance = demand.bound;
  finding.missed = demand.error;
  found(std::move(finding));
  return false;
}

void Session::malformed(std::size_t number, const std::string& why) {
  Finding finding = wrong_answer(number);
  finding.detail = "the answer has the wrong shape: " + why;
  found(std::move(finding));
}

std::vector<Misconception> Session::matching_misconceptions(std::size_t number,
                                                            const CloseTo* unmet) const {
  const Call& call = calls_[number];
  if (!is_finite(call.answer)) return {};  // NaN equals NaN, whatever has led there
  const auto meets = [&](std::size_t k) {
    const Value other = call.misconception(k, call.functions);
    return unmet->metric(other, unmet->expected) <= unmet->tolerance;
  };
  const std::vector<Misconception>& all = misconceptions_of(unit_);
  std::vector<Misconception> matching;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (gives_the_same(k, 0, calls_.size()) && !(unmet && meets(k))) matching.push_back(all[k]);
  return matching;
}

std::vector<Session::Case>::const_iterator Session::case_with(std::size_t number) const {
  const auto begun = std::find_if(cases_.begin(), cases_.end(),
                                  [&](const Case& each) { return each.number == number; });
  if (begun == cases_.end()) throw std::logic_error("that case has not begun");
  return begun;
}

void Session::end_case_by(const Call& call, bool is_first) {
  if (!finding_ && !is_first) cases_.back().ended_by = call;
}

bool Session::answers_otherwise_alone(std::size_t number, const std::optional<Value>& answer) {
  const std::optional<Call>& call = case_with(number)->ended_by;
  if (!call) return false;
  try {
    answerer_.start_case();
    const Value alone = answerer_.ask(*call, evaluator(*call));
    return !answer || largest_difference(alone, *answer) != 0;
  } catch (const std::exception&) {
    return false;  // no answer at all says nothing about the one that came
  }
}

std::size_t Session::end_of_case(std::size_t number) const {
  const auto next = std::next(case_with(number));
  return next == cases_.end() ? calls_.size() : next->first_call;
}

bool Session::gives_the_same_in_case(std::size_t number, std::size_t misconception) const {
  return gives_the_same(misconception, case_with(number)->first_call, end_of_case(number));
}

std::span<const Call> Session::asked_before_the_wrong_answer(std::size_t number) const {
  const Case& asked = *case_with(number);
  return std::span(calls_).subspan(asked.first_call, asked.asked_before);
}

std::size_t Session::asked_behind_the_wrong_answer(std::size_t number) const {
  const Case& asked = *case_with(number);
  for (std::size_t i = asked.first_call; i < end_of_case(number); ++i)
    if (largest_difference(calls_[i].answer, calls_[asked.first_call].answer) != 0)
      return asked.asked_behind;
  return 0;
}

bool Session::answers_with_an_argument() const {
  constexpr std::size_t enough = 4;  // numbers, in two answers at least
  std::size_t numbers = 0;
  for (const Call& call : calls_) numbers += count_nonzero(call.answer);
  if (calls_.size() < 2 || numbers < enough) return false;
  for (std::size_t i = 0; i < calls_.front().arguments.size(); ++i)
    if (std::all_of(calls_.begin(), calls_.end(), [i](const Call& call) {
          return i < call.arguments.size() && is_unchanged(call.arguments[i], call.answer);
        }))
      return true;
  return false;
}

namespace {

/// Whether an answer and a misconception's are the same, and come of as many evaluations: if what
/// the functions gave has left no trace in the numbers, these have to be as many; else none is like
/// none, since some are more wasteful than others.
bool is_same(const Call& call, std::size_t misconception, bool has_no_trace) {
  std::size_t evaluations = 0;
  const auto counted = [&](FunctionId id, const List& arguments) {
    ++evaluations;
    return call.functions(id, arguments);
  };
  try {
    const Value other = call.misconception(misconception, counted);
    const std::size_t asked = call.evaluations.size();
    if (has_no_trace ? evaluations != asked : (evaluations == 0) != (asked == 0)) return false;
    // The student's arithmetic may take another way to the same wrong number.
    const double rounding = 64 * detail::unit_roundoff * largest_magnitude(other);
    return call.metric(call.answer, other) <= std::fmax(call.tolerance, rounding);
  } catch (const std::exception&) {
    return false;  // it has no answer here, and the student has one
  }
}

}  // namespace

bool Session::gives_the_same(std::size_t misconception, std::size_t first, std::size_t last) const {
  const auto asked = std::span(calls_).subspan(first, last - first);
  const bool has_no_trace = std::all_of(asked.begin(), asked.end(), [](const Call& call) {
    return equals_argument(call.arguments, call.answer);
  });
  return std::all_of(asked.begin(), asked.end(),
                     [&](const Call& call) { return is_same(call, misconception, has_no_trace); });
}

}  // namespace tumble::judge
