#pragma once
/// @file
/// The worker: asks the student's function what the judge asks, and sends back what it says. It
/// runs in the student's process, so nothing it says is believed but the numbers, and those are
/// judged elsewhere.

#include <functional>
#include <type_traits>
#include <utility>

#include "judge/protocol/convert.hpp"
#include "judge/protocol/value.hpp"

namespace tumble::judge {

/// Evaluates function `id` of the judge.
Value call_back(FunctionId id, const List& arguments);

/// Answers questions until the judge hangs up.
/// @return the status for main
int serve_questions(const std::function<Value(const List&)>& answer);

/// One argument of a question as the student's function takes it.
template <class T>
struct Argument {
  static T of(const Value& value) { return from_value<T>(value); }
};
template <class Result, class... Arguments>
struct Argument<std::function<Result(Arguments...)>> {
  static std::function<Result(Arguments...)> of(const Value& value) {
    const FunctionId* id = value.as<FunctionId>();
    if (!id) throw Malformed("a function was expected");
    return [id = *id](Arguments... arguments) {
      return from_value<std::decay_t<Result>>(call_back(id, List{to_value(arguments)...}));
    };
  }
};

/// Fills the stack that the next call will use with the mark of what is never set. A result that is
/// built where the caller wants it has no other one: the compiler fills a function's own variables
/// only.
void mark_stack();

template <class Result, class... Arguments, std::size_t... i>
[[gnu::noinline]] Value answer_of_marked(Result (*function)(Arguments...), const List& list,
                                         std::index_sequence<i...>) {
  return to_value<std::decay_t<Result>>(
      function(Argument<std::decay_t<Arguments>>::of(list[i])...));
}

template <class Result, class... Arguments, std::size_t... i>
Value answer_with(Result (*function)(Arguments...), const List& list,
                  std::index_sequence<i...> places) {
  require_size(list.size(), sizeof...(Arguments));
  mark_stack();
  return answer_of_marked(function, list, places);
}

template <class Result, class... Arguments>
int serve(Result (*function)(Arguments...)) {
  return serve_questions([function](const List& list) {
    return answer_with(function, list, std::index_sequence_for<Arguments...>{});
  });
}

}  // namespace tumble::judge
