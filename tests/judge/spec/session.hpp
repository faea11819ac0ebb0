#pragma once
/// @file
/// The state behind a running spec: who answers, which questions were asked, what was found. A
/// doctest case is a plain function, so there is one current session.

#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "judge/protocol/finding.hpp"
#include "judge/spec/answerer.hpp"
#include "judge/spec/demand.hpp"
#include "judge/spec/misconception.hpp"
#include "support/random.hpp"

namespace tumble::judge {

/// A question, and what came back.
struct Call {
  List arguments;
  Value answer;
  std::vector<Evaluation> evaluations;
  /// What misconception k answers to the same question; its evaluations of the functions among the
  /// arguments go through `functions`.
  std::function<Value(std::size_t k, const CallBack& functions)> misconception;
  /// The functions among the arguments. They are called after their case has ended as well, so
  /// they capture by value.
  CallBack functions;
  /// What its demand calls equal; replaced when a demand is made.
  Metric metric = largest_difference;
  double tolerance = 0;
  /// How often the functions may be evaluated, all together, for one answer.
  std::size_t most_evaluations = 0;
};

class Session {
 public:
  /// A run of the spec of `unit` (as "04_quaternions/product") with the inputs of `seed`.
  Session(std::string unit, Answerer& answerer, std::uint64_t seed);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  ~Session();

  /// The session that runs now.
  static Session& current();

  // ── For the runner ──
  const std::string& unit() const { return unit_; }
  void start_case(std::size_t number);
  /// What ended the case that ran last; the first finding counts.
  std::optional<Finding> take_finding();
  void found(Finding finding);
  /// Whether the question that case `number` was ended by gets another answer than this one, or one
  /// at all, where it is the first of a program. Asks it once more; false where it was the first.
  bool answers_otherwise_alone(std::size_t number, const std::optional<Value>& answer);
  /// Whether misconception k gives the same to every question of case `number`.
  bool gives_the_same_in_case(std::size_t number, std::size_t misconception) const;
  /// The questions of case `number` before the one with its first wrong answer.
  std::span<const Call> asked_before_the_wrong_answer(std::size_t number) const;
  /// How many questions of case `number` follow the one with its first wrong answer: they
  /// were asked before any was judged. 0 if all answers of the case are the same.
  std::size_t asked_behind_the_wrong_answer(std::size_t number) const;
  /// Whether all answers of the run are the same one of their arguments, unchanged: so many that it
  /// is not by chance.
  bool answers_with_an_argument() const;
  /// Throws again what went wrong on the judge's side, if anything did: it is nobody's wrong
  /// answer.
  void rethrow_judge_failure() const;

  // ── For a spec ──
  /// The inputs of this case: they depend on the seed, the unit and the case, nothing else.
  support::Random& random() { return *random_; }
  /// Asks, records, and gives the number of the call.
  /// @throws NoAnswer
  std::size_t ask(Call call);
  const Call& call(std::size_t number) const { return calls_[number]; }
  /// Does the answer of call `number` come close enough? Files a finding if not.
  bool demand(std::size_t number, const CloseTo& demand);
  bool demand(std::size_t number, const Obeys& demand);
  /// Files that the answer of call `number` has the wrong shape.
  void malformed(std::size_t number, const std::string& why);
  /// Files that a case of the spec threw, which the answers before it made it do.
  void unusable(const std::string& why);

 private:
  /// That the case is over, by this call, if it is not over yet.
  void end_case_by(const Call& call, bool is_first);
  Finding wrong_answer(std::size_t number, const CloseTo* unmet = nullptr);
  /// The misconceptions that give the same numbers everywhere, and do not meet `unmet`.
  std::vector<Misconception> matching_misconceptions(std::size_t number,
                                                     const CloseTo* unmet) const;
  bool gives_the_same(std::size_t misconception, std::size_t first, std::size_t last) const;
  std::size_t end_of_case(std::size_t number) const;

  std::string unit_;
  Answerer& answerer_;
  std::uint64_t seed_;
  std::optional<support::Random> random_;
  std::vector<Call> calls_;
  struct Case {
    std::size_t number, first_call;
    std::optional<Call> ended_by = {};  ///< a question behind the first
    std::size_t asked_before = 0;       ///< questions before the one with the first wrong answer
    std::size_t asked_behind = 0;       ///< and behind it
  };
  /// @throws std::logic_error if it has not begun
  std::vector<Case>::const_iterator case_with(std::size_t number) const;

  std::vector<Case> cases_;   ///< that have begun
  std::size_t recorded_ = 0;  ///< numbers that are kept of answers and evaluations
  std::size_t wasted_ = 0;    ///< evaluations for answers that never came
  std::optional<Finding> finding_;
  std::exception_ptr judge_failure_;
  Session* previous_;
};

}  // namespace tumble::judge
