#pragma once
/// @file
/// student::product(a, b): a call that asks the student's worker, and an answer that a law can be
/// held against. A spec defines, for its one function,
///
///     namespace student { const Function<decltype(quaternions::product)> product{TUMBLE_UNIT}; }

#include <cstddef>
#include <functional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "judge/protocol/convert.hpp"
#include "judge/spec/demand.hpp"
#include "judge/spec/misconception.hpp"
#include "judge/spec/session.hpp"

namespace tumble::judge {

/// The value that came back, and the question that it answers. It goes where the value can go.
template <class T>
class Answer {
 public:
  Answer(T value, std::size_t call) : value_(std::move(value)), call_(call) {}
  operator const T&() const { return value_; }
  const T& value() const { return value_; }
  const T* operator->() const { return &value_; }
  /// The evaluations of functions that were among the arguments, in order.
  const std::vector<Evaluation>& evaluations() const {
    return Session::current().call(call_).evaluations;
  }
  template <class Demand>
  bool meets(const Demand& demand) const {
    return Session::current().demand(call_, demand);
  }

 private:
  T value_;
  std::size_t call_;
};

/// REQUIRE(student::f(x) == close_to(y, 4 * eps)): files a finding where the demand is not met.
template <class T>
bool operator==(const Answer<T>& answer, const CloseTo& demand) {
  return answer.meets(demand);
}
template <class T>
bool operator==(const Answer<T>& answer, const Obeys& demand) {
  return answer.meets(demand);
}

/// The functions among the arguments of one question, by number.
class FunctionTable {
 public:
  template <class T>
  Value add(const T& argument) {
    return to_value(argument);
  }
  template <class Result, class... Arguments>
  Value add(const std::function<Result(Arguments...)>& f) {
    functions_.push_back(
        [f](const List& list) { return call(f, list, std::index_sequence_for<Arguments...>{}); });
    return FunctionId{static_cast<std::int64_t>(functions_.size()) - 1};
  }
  /// @throws Malformed if there is no such function or its arguments have the wrong shape
  Value operator()(FunctionId id, const List& arguments) const {
    if (id.number < 0 || static_cast<std::size_t>(id.number) >= functions_.size())
      throw Malformed("there is no such function");
    return functions_[static_cast<std::size_t>(id.number)](arguments);
  }

 private:
  template <class Result, class... Arguments, std::size_t... i>
  static Value call(const std::function<Result(Arguments...)>& f, const List& list,
                    std::index_sequence<i...>) {
    require_size(list.size(), sizeof...(Arguments));
    return to_value(f(from_value<std::decay_t<Arguments>>(list[i])...));
  }
  std::vector<std::function<Value(const List&)>> functions_;
};

/// The argument as a misconception is given it: a function's evaluations go through `functions`.
template <class T>
const T& routed(const T& argument, const CallBack&, std::int64_t&) {
  return argument;
}
template <class Result, class... Arguments>
std::function<Result(Arguments...)> routed(const std::function<Result(Arguments...)>&,
                                           const CallBack& functions, std::int64_t& next_function) {
  return [functions, id = FunctionId{next_function++}](Arguments... arguments) {
    return from_value<std::decay_t<Result>>(functions(id, List{to_value(arguments)...}));
  };
}

template <class Signature>
class Function;

template <class Result, class... Arguments>
class Function<Result(Arguments...)> {
 public:
  /// @param most_evaluations of the functions among its arguments, for one answer: far more than a
  ///        wasteful one takes
  explicit Function(std::string unit, std::size_t most_evaluations = 20'000)
      : unit_(std::move(unit)), most_evaluations_(most_evaluations) {}

  /// @throws NoAnswer if the student's code gives none
  Answer<Result> operator()(const std::decay_t<Arguments>&... arguments) const {
    Session& session = Session::current();
    FunctionTable functions;
    Call call;
    call.arguments = List{functions.add(arguments)...};
    call.functions = functions;
    call.most_evaluations = most_evaluations_;
    call.misconception = [unit = unit_, ... copy = arguments](std::size_t k,
                                                              const CallBack& route) {
      std::int64_t next_function = 0;
      // Braces fix the order in which the arguments are taken, and with it the functions' numbers.
      const std::tuple<std::decay_t<Arguments>...> routes{routed(copy, route, next_function)...};
      return to_value(std::apply(Misconceptions<Result(Arguments...)>::of(unit)[k].body, routes));
    };
    const std::size_t number = session.ask(std::move(call));
    try {
      return {from_value<std::decay_t<Result>>(session.call(number).answer), number};
    } catch (const Malformed& why) {
      session.malformed(number, why.what());
      throw NoAnswer(Outcome::wrong, why.what());
    }
  }

 private:
  std::string unit_;
  std::size_t most_evaluations_;
};

}  // namespace tumble::judge
