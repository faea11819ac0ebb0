#pragma once
/// @file
/// The messages between judge and worker, as MessagePack in frames. A conversation is a question,
/// any number of calls back with their results, and an answer or why there is none.
///
/// A frame is the length of its body (4 bytes, least significant first) and the body, at most
/// max_frame bytes. The judge decodes frames of a process that it does not trust.

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "judge/protocol/value.hpp"

namespace tumble::judge {

enum class Kind : std::int64_t {
  question,         ///< judge → worker: the arguments
  answer,           ///< worker → judge: one value
  call_back,        ///< worker → judge: evaluate function `function` with the arguments
  result,           ///< judge → worker: one value
  not_implemented,  ///< worker → judge: the stub has thrown
  threw,            ///< worker → judge: another exception; its text
  out_of_memory,    ///< worker → judge: std::bad_alloc
  forbidden,        ///< worker → judge: the number of a system call that was refused
};

struct Message {
  Kind kind = Kind::question;
  /// Chosen by the judge for each question and repeated in everything that belongs to it.
  std::int64_t token = 0;
  List content;
};

/// Limits on what is decoded: the deepest and the largest value that a contract can ask for.
inline constexpr std::size_t max_frame = 1 << 20;
inline constexpr int max_depth = 8;

/// Bytes that are no message, or one that breaks the limits.
struct BadMessage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The body of a frame.
std::string encode(const Message& message);
/// The message of a body. Never trusts a length that it has not seen the bytes of.
/// @throws BadMessage
Message decode(const std::string& body);

/// The 4 bytes before a body of this size.
std::string frame_head(std::size_t size);
/// The size that 4 bytes announce.
/// @throws BadMessage if it is more than max_frame
std::size_t frame_size(const unsigned char head[4]);

}  // namespace tumble::judge
