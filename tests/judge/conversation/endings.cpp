#include "judge/conversation/endings.hpp"

#include <signal.h>
#include <string.h>

#include <sstream>

namespace tumble::judge {

namespace {

std::string signal_text(int number) {
  switch (number) {
    case SIGSEGV:
      return "SIGSEGV: it used memory that is not its own (an index out of range, endless "
             "recursion, or arrays too large for its memory)";
    case SIGFPE:
      return "SIGFPE: an integer was divided by zero";
    case SIGABRT:
      return "SIGABRT: an assertion failed, or an exception was never caught";
    case SIGBUS:
      return "SIGBUS: it used memory that is not there";
    case SIGILL:
      return "SIGILL: it reached code that must never run (a function that ends without return, a "
             "null "
             "pointer)";
    case SIGTRAP:
      return "SIGTRAP: it ran into a trap (a function without return?)";
    default:
      return std::string("signal ") + std::to_string(number) + ": " + strsignal(number);
  }
}

/// What stands between two texts of a line; empty if one of them is missing.
std::string between(const std::string& line, const std::string& before, std::size_t end) {
  const auto start = line.rfind(before, end);
  if (start == std::string::npos || end == std::string::npos) return {};
  const auto text = start + before.size();
  return text < end ? line.substr(text, end - text) : std::string();
}

/// The assertion that a line tells: as glibc and libstdc++ print it, "Assertion `i < n' failed.",
/// with one quote or the other; as wasi-libc does, "Assertion failed: i < n (file: function: 7)";
/// and as libc++ does, "libc++ Hardening assertion i < n failed: index out of bounds".
std::string assertion_in(const std::string& line) {
  if (const std::string quoted = between(line, "Assertion ", line.find("' failed"));
      quoted.size() > 1)
    return quoted.substr(1);
  if (std::string named = between(line, "Assertion failed: ", line.rfind(" (")); !named.empty())
    return named;
  return between(line, "Hardening assertion ", line.find(" failed: "));
}

std::string failed_assertion(const std::string& printed) {
  std::istringstream in(printed);
  std::string last;
  for (std::string line; std::getline(in, line);)
    if (std::string assertion = assertion_in(line); !assertion.empty()) last = std::move(assertion);
  return last;
}

/// Of an assertion, or of what at() throws: libc++ says only "vector".
bool is_about_index(const std::string& text) {
  return text == "vector" || text.find("index") != std::string::npos ||
         text.find("_M_range_check") != std::string::npos ||
         text.find("__n < this->size()") != std::string::npos ||
         text.find("__n < size()") != std::string::npos;
}

std::string with_what_it_is_about(const std::string& text) {
  return text.substr(0, most_detail) + (is_about_index(text) ? " (an index out of range)" : "");
}

std::string abort_text(const std::string& printed) {
  const std::string assertion = failed_assertion(printed);
  if (assertion.empty()) return signal_text(SIGABRT);
  return "an assertion failed, " + with_what_it_is_about(assertion);
}

}  // namespace

NoAnswer flooded() { return {Outcome::flooded, "more than a megabyte of text"}; }

NoAnswer computed_too_long(int seconds) {
  return {Outcome::hung, "no answer after " + std::to_string(seconds) + " s of computing"};
}

NoAnswer too_much_memory(std::uint64_t bytes_allowed) {
  return {Outcome::out_of_memory, "more than " + std::to_string(bytes_allowed >> 20) + " MB"};
}

NoAnswer threw(const std::string& what) { return {Outcome::threw, with_what_it_is_about(what)}; }

NoAnswer exited(int status) { return {Outcome::exited, "with status " + std::to_string(status)}; }

NoAnswer crashed(int signal, const std::string& printed) {
  return {Outcome::crashed, signal == SIGABRT ? abort_text(printed) : signal_text(signal)};
}

NoAnswer refused(const std::string& purpose, const std::string& call) {
  return {Outcome::forbidden, "tried to " + purpose + " (" + call + ")"};
}

bool tells_an_assertion(const std::string& line) { return !assertion_in(line).empty(); }

}  // namespace tumble::judge
