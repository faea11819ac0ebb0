#pragma once
/// @file
/// Who answers the questions of a spec: a student's worker, or a misconception.

#include <functional>
#include <string>

#include "judge/protocol/value.hpp"

namespace tumble::judge {

struct Call;

/// Evaluates function `id` of the one who asks, while an answer is being worked out.
using CallBack = std::function<Value(FunctionId id, const List& arguments)>;

class Answerer {
 public:
  Answerer() = default;
  Answerer(const Answerer&) = delete;
  Answerer& operator=(const Answerer&) = delete;
  virtual ~Answerer() = default;

  /// Called before each test case: what the case before has done must not reach the next one.
  virtual void start_case() = 0;
  /// The answer to one question.
  /// @throws NoAnswer if none comes
  virtual Value ask(const Call& question, const CallBack& call_back) = 0;
  /// What the answering program has printed in this case.
  virtual std::string printed() = 0;
};

}  // namespace tumble::judge
