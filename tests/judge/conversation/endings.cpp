#include "judge/conversation/endings.hpp"

#include <signal.h>
#include <string.h>

#include <algorithm>
#include <initializer_list>
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
      return "SIGABRT: abort() was called";
    case SIGBUS:
      return "SIGBUS: it used memory that is not there";
    case SIGILL:
      return "SIGILL: it reached code that must never run (a function that ends without return, a "
             "null pointer)";
    case SIGTRAP:
      return "SIGTRAP: it ran into a trap (a function without return?)";
    default:
      return std::string("signal ") + std::to_string(number) + ": " + strsignal(number);
  }
}

/// What is between two texts of a line; empty if one of them is missing.
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

bool has_any(const std::string& text, std::initializer_list<const char*> parts) {
  return std::any_of(parts.begin(), parts.end(),
                     [&](const char* part) { return text.find(part) != std::string::npos; });
}

/// What an assertion, or what at() throws, is about; empty if it is none that we know. libc++ says
/// only "vector".
std::string subject_of(const std::string& text) {
  if (text == "vector" || has_any(text, {"index", "_M_range_check", "__n < this->size()",
                                         "__n < size()", "row >= 0 && row < rows()"}))
    return " (an index out of range)";
  if (has_any(text, {"startRow >= 0", "(i>=0) && ("}))
    return " (a segment, a block, a row or a column that reaches past the end)";
  if (has_any(text, {"aLhs.rows() == aRhs.rows()", "rows() == other.rows()",
                     "dst.rows() == src.rows()", "size() == other.size()",
                     "lhs.rows() == rhs.rows()", "resize() does not actually allow",
                     "rows==RowsAtCompileTime", "rows == RowsAtCompileTime"}))
    return " (two vectors or matrices of different sizes)";
  return {};
}

/// What an assertion says in words, as Eigen's do: "invalid matrix product" of
/// `a == b && "invalid matrix product"`. The assertion itself if it has none.
std::string in_words(const std::string& assertion) {
  auto quote = assertion.find("&& \"");
  if (quote == std::string::npos) return assertion;
  std::string words;  // of literals side by side
  for (quote += 3; quote < assertion.size() && assertion[quote] == '"';) {
    const auto end = assertion.find('"', quote + 1);
    if (end == std::string::npos) return assertion;
    words += assertion.substr(quote + 1, end - quote - 1);
    quote = assertion.find_first_not_of(' ', end + 1);
  }
  return words;
}

std::string with_what_it_is_about(const std::string& text) {
  return in_words(text).substr(0, most_detail) + subject_of(text);
}

/// What the libraries print before they abort without an assertion.
std::string abort_text(const std::string& printed) {
  if (const std::string assertion = failed_assertion(printed); !assertion.empty())
    return "an assertion failed, " + with_what_it_is_about(assertion);
  if (has_any(printed, {"terminate called", "libc++abi: terminating"}))
    return "SIGABRT: an exception was never caught (in a thread, a destructor or what is noexcept)";
  if (has_any(printed, {"free(): ", "malloc(): ", "realloc(): ", "munmap_chunk(): ",
                        "double free or corruption", "corrupted size vs. prev_size",
                        "stack smashing detected"}))
    return "SIGABRT: its memory was damaged (a place outside of an array was written, or memory "
           "was given back twice)";
  return signal_text(SIGABRT);
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
