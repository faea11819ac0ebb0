#pragma once
/// @file
/// A question, the calls back that it leads to, and what the messages of a worker mean: the judge's
/// side of the conversation, whatever carries the frames.

#include <cstdint>
#include <optional>
#include <random>
#include <string>

#include "judge/protocol/message.hpp"
#include "judge/spec/answerer.hpp"

namespace tumble::judge {

/// The frame of a message.
std::string frame_of(const Message& message);

/// The first message of what has been received, once all its bytes are there; it is taken out.
/// @throws BadMessage
std::optional<Message> take_message(std::string& received);

class Exchange {
 public:
  /// @param memory_bytes what a worker is given
  explicit Exchange(std::uint64_t memory_bytes) : memory_bytes_(memory_bytes) {}

  /// The frame that asks. From here on, messages about the question before are malformed.
  /// @throws NoAnswer after two questions that had no answer in time
  std::string question(const List& arguments);
  /// The frame that goes back if the message asks for an evaluation, nothing if it does not.
  /// @throws NoAnswer, BadMessage, Malformed
  std::optional<std::string> result_for(const Message& message, const CallBack& call_back);
  /// The answer that any other message is.
  /// @throws NoAnswer if it says that there is none
  Value answer_of(const Message& message) const;
  /// For a handler: throws again what has ended the question. What cannot be understood is no
  /// answer either.
  [[noreturn]] void rethrow();

 private:
  std::uint64_t memory_bytes_;
  std::mt19937_64 tokens_{std::random_device{}()};
  std::int64_t token_ = 0;
  int hung_cases_ = 0;
};

}  // namespace tumble::judge
