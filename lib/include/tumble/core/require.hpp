#pragma once
/// @file
/// How the library refuses bad input: at the door, saying what was wrong and where.

#include <sstream>
#include <stdexcept>

namespace tumble {
namespace detail {

/// Throws what is streamed into the message.
template <class... Parts>
[[noreturn]] void refuse(const Parts&... message) {
  std::ostringstream text;
  (text << ... << message);
  throw std::invalid_argument(text.str());
}

}  // namespace detail

/// Throws unless `condition` holds.
/// @param condition what must be true of the input
/// @param message   streamed one after the other into the message, only when it is needed
/// @throws std::invalid_argument with that message
template <class... Parts>
void require(bool condition, const Parts&... message) {
  if (!condition) detail::refuse(message...);
}

}  // namespace tumble
