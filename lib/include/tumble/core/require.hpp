#pragma once
/// @file
/// How the library refuses bad input: at the door, saying what was wrong and where.
///
/// Compiled with -fno-exceptions a refusal prints its message to stderr and aborts. With
/// -DTUMBLE_ON_REFUSAL=f it calls f(text, length) instead, which must not return: for programs that
/// have no room for streams. Then the message has its words, and … for its numbers.

#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "tumble/core/inline.hpp"

#ifdef TUMBLE_ON_REFUSAL
extern "C" [[noreturn]] void TUMBLE_ON_REFUSAL(const char* text, std::size_t length);
#endif

namespace tumble {

/// @addtogroup core
/// @{

namespace detail {

/// Streams the parts, one after the other.
template <class... Parts>
std::string text_of(const Parts&... parts) {
#ifdef TUMBLE_ON_REFUSAL
  const auto words = []<class Part>(const Part& part) -> std::string_view {
    if constexpr (std::is_convertible_v<Part, std::string_view>)
      return part;
    else
      return "…";
  };
  std::string text;
  (text.append(words(parts)), ...);
  return text;
#else
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
#endif
}

/// The one place where the library throws.
/// @throws Error with the message that the parts make
template <class Error, class... Parts>
[[noreturn]] TUMBLE_COLD void throw_error(const Parts&... parts) {
  const std::string message = text_of(parts...);
#if defined(TUMBLE_ON_REFUSAL)
  TUMBLE_ON_REFUSAL(message.data(), message.size());
#elif defined(__cpp_exceptions)
  throw Error(message);
#else
  std::fprintf(stderr, "tumble: %s\n", message.c_str());
  std::abort();
#endif
}

/// Refuses bad input, for what is streamed into the message.
/// @throws std::invalid_argument with that message
template <class... Parts>
[[noreturn]] TUMBLE_COLD void refuse(const Parts&... message) {
  throw_error<std::invalid_argument>(message...);
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
#if defined(__cpp_exceptions) && !defined(TUMBLE_ON_REFUSAL)
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
