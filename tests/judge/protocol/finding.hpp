#pragma once
/// @file
/// What came out of one test case, in a form that can be shown, stored and compared.

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "judge/protocol/value.hpp"

namespace tumble::judge {

enum class Outcome {
  passed,
  wrong,            ///< an answer came, and is not what the law demands
  not_implemented,  ///< the stub's NotImplemented came back
  threw,            ///< another exception
  crashed,          ///< ended by a signal
  hung,             ///< no answer within the limits of time
  out_of_memory,
  flooded,     ///< printed without end
  exited,      ///< ended the program instead of returning
  forbidden,   ///< asked the system for what an exercise may not do
  wrong_call,  ///< called a function that it was given with what that is not defined for
  malformed,   ///< wrote something else than an answer into the answers' pipe
  not_run,     ///< skipped: too many cases before it had no answer
};

/// The word for an outcome in tables, JSON and tests: "not implemented", "out of memory", …
std::string name_of(Outcome outcome);

/// One evaluation, by the student's code, of a function that it was given.
struct Evaluation {
  FunctionId function;
  List arguments;
  Value result;
};

/// A question as the student can read and repeat it.
struct Question {
  List arguments;
  std::size_t evaluations = 0;  ///< how often the student's code called the functions it was given
  std::vector<Evaluation> first_evaluations = {};  ///< a few of them, to be shown
};

/// A misconception whose numbers are those that came back.
struct Misconception {
  std::string name;      ///< "operands swapped"
  std::string sentence;  ///< what happened and what to look at
  std::string section;   ///< heading of the chapter's page that explains it
};

/// Why a test case did not pass.
struct Finding {
  Outcome outcome = Outcome::wrong;
  std::string detail;  ///< the signal, the exception's text, the system call, the failed law
  std::optional<Question> question;
  std::optional<Value> answer;
  std::optional<Value> demanded;  ///< absent when a law was tried, not a value
  double tolerance = 0;           ///< how far the answer may be from `demanded`, or from the law
  double missed = 0;              ///< how far it is from the law, where a law was tried
  std::vector<Misconception> misconceptions;
  std::string printed;  ///< what the student's code printed in this case
  std::string place;    ///< file:line of a crash, where it could be found
};

/// Thrown through a spec when no answer came: it ends the test case.
struct NoAnswer : std::runtime_error {
  NoAnswer(Outcome why, const std::string& what) : std::runtime_error(what), outcome(why) {}
  Outcome outcome;
};

struct CaseResult {
  std::size_t number = 0;  ///< in its unit, from 1
  std::string law;         ///< the test case's name
  std::optional<Finding> finding;
  bool passed() const { return !finding; }
};

}  // namespace tumble::judge
