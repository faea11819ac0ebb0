#pragma once
/// @file
/// What is said of a worker that gives no answer: the same words wherever it runs, in a process or
/// in a page.

#include <cstdint>
#include <string>

#include "judge/protocol/finding.hpp"

namespace tumble::judge {

inline constexpr std::size_t most_printed = 1 << 16;  ///< kept to be shown
inline constexpr std::size_t most_detail = 500;       ///< of an exception's or an assertion's text
inline constexpr std::size_t flood = 1 << 20;         ///< printed in one case: enough

NoAnswer flooded();
NoAnswer computed_too_long(int seconds);
NoAnswer too_much_memory(std::uint64_t bytes_allowed);
/// Ended by an exception that nothing has caught.
NoAnswer threw(const std::string& what);
NoAnswer exited(int status);
/// Ended by a signal, or by what would be one in a process. `printed` may say why.
NoAnswer crashed(int signal, const std::string& printed);
/// Asked the system for what it may not do: "open a file", by "openat".
NoAnswer refused(const std::string& purpose, const std::string& call);

/// Whether a line of what a program has printed is the assertion that has ended it.
bool tells_an_assertion(const std::string& line);

}  // namespace tumble::judge
