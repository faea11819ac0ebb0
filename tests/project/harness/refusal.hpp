#pragma once
/// @file
/// Checks that bad input is refused, and that the message says what was wrong.

#include <doctest/doctest.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace tumble::test {

/// The message with which `action` throws an Exception; "(nothing thrown)" if it does not.
template <class Exception = std::invalid_argument, class Action>
std::string message_of(Action&& action) {
  try {
    std::forward<Action>(action)();
  } catch (const Exception& error) {
    return error.what();
  }
  return "(nothing thrown)";
}

/// Whether `text` contains every one of the parts.
template <class... Parts>
bool mentions(const std::string& text, const Parts&... parts) {
  return ((text.find(parts) != std::string::npos) && ...);
}

}  // namespace tumble::test

/// The action (an expression) must throw std::invalid_argument with a message that has
/// all the parts.
#define CHECK_REFUSED(expression, ...)                                      \
  do {                                                                      \
    const std::string refusal =                                             \
        ::tumble::test::message_of([&] { static_cast<void>(expression); }); \
    CAPTURE(refusal);                                                       \
    CHECK(::tumble::test::mentions(refusal, __VA_ARGS__));                  \
  } while (false)
