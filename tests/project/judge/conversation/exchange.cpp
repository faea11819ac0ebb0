/// @file
/// What the judge makes of messages that a worker sends, right and wrong ones.
#include "judge/conversation/exchange.hpp"

#include <doctest/doctest.h>

#include "judge/spec/session.hpp"

using namespace tumble::judge;

namespace {

/// The question that a frame asks.
Message message_in(std::string frame) { return take_message(frame).value(); }

Value twice(FunctionId, const List& arguments) { return 2 * *arguments[0].as<double>(); }

/// How the question ends for which `step` is run.
template <class Step>
NoAnswer ending_of(Exchange& exchange, Step&& step) {
  try {
    try {
      step();
    } catch (...) {
      exchange.rethrow();
    }
  } catch (const NoAnswer& why) {
    return why;
  }
  throw std::logic_error("there was an answer");
}

}  // namespace

TEST_CASE("a question, a call back, and the answer") {
  Exchange exchange(1 << 20);
  const Message question = message_in(exchange.question({1.5}));
  CHECK(question.kind == Kind::question);
  const List call{FunctionId{0}, List{3.0}};
  const auto result = exchange.result_for({Kind::call_back, question.token, call}, twice);
  REQUIRE(result.has_value());
  CHECK(*message_in(*result).content[0].as<double>() == 6);
  const Message answer{Kind::answer, question.token, {7.0}};
  CHECK_FALSE(exchange.result_for(answer, twice).has_value());
  CHECK(*exchange.answer_of(answer).as<double>() == 7);
}

TEST_CASE("a message of another question is malformed") {
  Exchange exchange(1 << 20);
  const Message before = message_in(exchange.question({}));
  const Message now = message_in(exchange.question({}));
  REQUIRE(before.token != now.token);
  const NoAnswer ending = ending_of(exchange, [&] {
    exchange.result_for({Kind::answer, before.token, {1.0}}, twice);
  });
  CHECK(ending.outcome == Outcome::malformed);
  CHECK(std::string(ending.what()) == "a message that belongs to no question");
}

TEST_CASE("what a worker does not send is malformed; what it lacks is named") {
  Exchange exchange(512ull << 20);
  const auto ended = [&](Kind kind, const List& content) {
    return ending_of(exchange, [&] { exchange.answer_of({kind, 0, content}); });
  };
  CHECK(ended(Kind::result, {1.0}).outcome == Outcome::malformed);
  CHECK(ended(Kind::answer, {}).outcome == Outcome::malformed);
  CHECK(ended(Kind::not_implemented, {}).outcome == Outcome::not_implemented);
  CHECK(std::string(ended(Kind::threw, {std::string("no")}).what()) == "no");
  CHECK(std::string(ended(Kind::out_of_memory, {}).what()) == "more than 512 MB");
}

TEST_CASE("after two questions that had no answer in time none is asked") {
  Exchange exchange(1 << 20);
  const auto hang = [] { throw NoAnswer(Outcome::hung, "no answer"); };
  CHECK(ending_of(exchange, hang).outcome == Outcome::hung);
  CHECK_FALSE(exchange.question({}).empty());
  CHECK(ending_of(exchange, hang).outcome == Outcome::hung);
  CHECK(ending_of(exchange, [&] { exchange.question({}); }).outcome == Outcome::not_run);
}

TEST_CASE("a message is taken when all its bytes are there") {
  const std::string frame = frame_of({Kind::answer, 5, {1.0}});
  std::string received = frame.substr(0, frame.size() - 1);
  CHECK_FALSE(take_message(received).has_value());
  received += frame.back() + frame.substr(0, 2);
  CHECK(take_message(received).value().token == 5);
  CHECK(received == frame.substr(0, 2));
}
