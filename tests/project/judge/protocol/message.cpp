/// @file
/// Messages cross the pipe bit for bit, and bytes that are none are refused.
#include "judge/protocol/message.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <limits>
#include <string>

using namespace tumble::judge;

namespace {

Message with(List content) { return {Kind::answer, 0x0123456789abcdef, std::move(content)}; }

std::uint64_t bits_after_crossing(double x) {
  const Message back = decode(encode(with({x})));
  return std::bit_cast<std::uint64_t>(*back.content.at(0).as<double>());
}

}  // namespace

TEST_CASE("every double keeps its bits, NaN and infinities and signed zeros included") {
  using limits = std::numeric_limits<double>;
  for (const double x : {0.0, -0.0, 0.1, limits::denorm_min(), limits::max(), limits::infinity(),
                         -limits::infinity(), limits::quiet_NaN()})
    CHECK(bits_after_crossing(x) == std::bit_cast<std::uint64_t>(x));
}

TEST_CASE("kind, token, texts, functions and nested lists come back as they went") {
  const Message back = decode(encode(with({std::string("a\0b\n\xff", 5), FunctionId{7},
                                           std::int64_t{-3}, List{List{1.0, 2.0}, List{}}})));
  CHECK(back.kind == Kind::answer);
  CHECK(back.token == 0x0123456789abcdef);
  CHECK(*back.content.at(0).as<std::string>() == std::string("a\0b\n\xff", 5));
  CHECK(back.content.at(1).as<FunctionId>()->number == 7);
  CHECK(*back.content.at(2).as<std::int64_t>() == -3);
  const List& nested = *back.content.at(3).as<List>();
  CHECK(*nested.at(0).as<List>()->at(1).as<double>() == 2);
  CHECK(nested.at(1).as<List>()->empty());
}

TEST_CASE("bytes that are no message are refused") {
  const std::string message = encode(with({1.0}));
  CHECK_THROWS_AS(decode(""), BadMessage);
  CHECK_THROWS_AS(decode("{\"json\": 1}"), BadMessage);
  for (std::size_t size = 0; size < message.size(); ++size)
    CHECK_THROWS_AS(decode(message.substr(0, size)), BadMessage);
  CHECK_THROWS_AS(decode(message + "x"), BadMessage);
  CHECK_THROWS_AS(decode(encode({static_cast<Kind>(99), 1, {}})), BadMessage);
}

TEST_CASE("a list may not be nested without end, nor claim more than it holds") {
  const std::string endless(100000, '\x91');  // an array of one that holds an array of one that …
  CHECK_THROWS_AS(decode(endless), BadMessage);
  const std::string boast("\x93\x01\x02\xdd\xff\xff\xff\xff", 8);  // an array of 2³² − 1 entries
  CHECK_THROWS_AS(decode(boast), BadMessage);
}

TEST_CASE("a frame's length is read as it was written, and a giant is refused") {
  for (const std::size_t size : {std::size_t{0}, std::size_t{258}, max_frame}) {
    const std::string head = frame_head(size);
    CHECK(frame_size(reinterpret_cast<const unsigned char*>(head.data())) == size);
  }
  const unsigned char giant[4] = {0xff, 0xff, 0xff, 0xff};
  CHECK_THROWS_AS(frame_size(giant), BadMessage);
  CHECK_THROWS_AS(frame_head(max_frame + 1), BadMessage);
}
