#include "judge/spec/session.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <stdexcept>
#include <utility>

#include "judge/course/stable_hash.hpp"
#include "tumble/core/rounding.hpp"

namespace tumble::judge {

namespace {

Session* current_session = nullptr;

double largest_magnitude(const Value& value) {
  if (const double* x = value.as<double>()) return std::isfinite(*x) ? std::abs(*x) : 0;
  double largest = 0;
  if (const List* list = value.as<List>())
    for (const Value& element : *list) largest = std::fmax(largest, largest_magnitude(element));
  return largest;
}

}  // namespace

std::vector<NamedMistake>& mistakes_of(const std::string& unit) {
  static std::map<std::string, std::vector<NamedMistake>> registry;
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

std::size_t Session::ask(Call call) {
  const auto record = [&call](FunctionId id, const List& arguments) {
    Value result = call.functions(id, arguments);
    call.evaluations.push_back({id, arguments, result});
    return result;
  };
  try {
    call.answer = answerer_.ask(call, record);
  } catch (const NoAnswer& why) {
    Finding finding;
    finding.outcome = why.outcome;
    finding.detail = why.what();
    finding.question = Question{call.arguments, call.evaluations.size()};
    found(std::move(finding));
    throw;
  } catch (...) {
    judge_failure_ = std::current_exception();
    throw;
  }
  calls_.push_back(std::move(call));
  return calls_.size() - 1;
}

Finding Session::wrong_answer(std::size_t number, const CloseTo* unmet) const {
  const Call& call = calls_[number];
  Finding finding;
  finding.question = Question{call.arguments, call.evaluations.size()};
  finding.answer = call.answer;
  finding.mistakes = matching_mistakes(number, unmet);
  return finding;
}

bool Session::demand(std::size_t number, const CloseTo& demand) {
  Call& call = calls_[number];
  call.metric = demand.metric;
  call.tolerance = demand.tolerance;
  if (demand.metric(call.answer, demand.expected) <= demand.tolerance) return true;
  Finding finding = wrong_answer(number, &demand);
  finding.demanded = demand.expected;
  finding.tolerance = demand.tolerance;
  found(std::move(finding));
  return false;
}

bool Session::demand(std::size_t number, const Obeys& demand) {
  if (demand.error <= demand.bound) return true;
  Finding finding = wrong_answer(number);
  char missed[32];
  std::snprintf(missed, sizeof missed, "%.3g", demand.error);
  finding.detail = demand.law + ", and it is missed by " + missed;
  finding.tolerance = demand.bound;
  found(std::move(finding));
  return false;
}

void Session::malformed(std::size_t number, const std::string& why) {
  Finding finding = wrong_answer(number);
  finding.detail = "the answer has the wrong shape: " + why;
  found(std::move(finding));
}

std::vector<NamedMistake> Session::matching_mistakes(std::size_t number,
                                                     const CloseTo* unmet) const {
  const Call& call = calls_[number];
  const auto meets = [&](std::size_t k) {
    const Value other = call.misconception(k, call.functions);
    return unmet->metric(other, unmet->expected) <= unmet->tolerance;
  };
  const std::vector<NamedMistake>& all = mistakes_of(unit_);
  std::vector<NamedMistake> matching;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (gives_the_same(k) && !(unmet && meets(k))) matching.push_back(all[k]);
  return matching;
}

bool Session::gives_the_same(std::size_t misconception) const {
  return std::all_of(calls_.begin(), calls_.end(), [&](const Call& call) {
    try {
      const Value other = call.misconception(misconception, call.functions);
      // The student's arithmetic may take another way to the same wrong number.
      const double rounding = 64 * detail::unit_roundoff * largest_magnitude(other);
      return call.metric(call.answer, other) <= std::fmax(call.tolerance, rounding);
    } catch (const std::exception&) {
      return false;  // it has no answer here, and the student has one
    }
  });
}

}  // namespace tumble::judge
