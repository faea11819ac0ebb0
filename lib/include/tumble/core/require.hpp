#pragma once
/// @file
/// How the library refuses bad input: at the door, saying what was wrong and where.
///
/// Compiled with -fno-exceptions a refusal prints its message to stderr and aborts.

#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>

namespace tumble {

/// @addtogroup core
/// @{

namespace detail {

/// The one place where the library throws.
/// @throws Error with that message
template <class Error>
[[noreturn]] void throw_error(const std::string& message) {
#ifdef __cpp_exceptions
  throw Error(message);
#else
  std::fprintf(stderr, "tumble: %s\n", message.c_str());
  std::abort();
#endif
}

/// Streams the parts, one after the other.
template <class... Parts>
std::string text_of(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

/// Refuses bad input, for what is streamed into the message.
/// @throws std::invalid_argument with that message
template <class... Parts>
[[noreturn]] void refuse(const Parts&... message) {
  throw_error<std::invalid_argument>(text_of(message...));
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

namespace detail {

/// Runs a check; what it refuses is refused with `where` before its message. Without exceptions the
/// check has the last word, and says only what is wrong.
/// @throws std::invalid_argument as the check does
template <class Check, class... Parts>
void require_at(const Check& check, [[maybe_unused]] const Parts&... where) {
#ifdef __cpp_exceptions
  try {
    check();
  } catch (const std::invalid_argument& error) {
    require(false, where..., error.what());
  }
#else
  check();
#endif
}

}  // namespace detail

/// @}

}  // namespace tumble
