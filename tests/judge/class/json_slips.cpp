#include "judge/class/json_slips.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

#include "support/parsed_json.hpp"

namespace tumble::judge {

namespace {

constexpr std::array<std::string_view, 9> other_quotes = {
    "\u201c", "\u201d", "\u201e", "\u201f", "\u00ab", "\u00bb", "\u2018", "\u2019", "\u201a"};

std::string_view rest(const std::string& text, std::size_t at) {
  return std::string_view(text).substr(at);
}

/// The place behind the text in quotes that begins at `at`.
std::size_t end_of_quoted(const std::string& text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"' && text[at] != '\n'; ++at)
    if (text[at] == '\\') ++at;
  return at + 1;
}

/// Is a comma at `at` before the end of a list or of { … }?
bool is_last_comma(const std::string& text, std::size_t at) {
  if (text[at] != ',') return false;
  const std::size_t next = text.find_first_not_of(" \t\r\n", at + 1);
  return next != std::string::npos && (text[next] == ']' || text[next] == '}');
}

/// What is wrong at `at`; empty if nothing is.
std::string slip_at(const std::string& text, std::size_t at) {
  for (const std::string_view quote : other_quotes)
    if (rest(text, at).starts_with(quote))
      return "the quote " + std::string(quote) + " has to be the straight one, \"";
  if (text[at] == '\'') return "the quote ' has to be the double one, \"";
  for (const std::string_view comment : {"//", "/*", "#"})
    if (rest(text, at).starts_with(comment))
      return "a comment begins here, and JSON has none: delete it";
  return is_last_comma(text, at) ? "this comma has nothing behind it: delete it" : "";
}

}  // namespace

std::string json_slip_in(const std::string& text) {
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '"') {
      i = end_of_quoted(text, i);
      continue;
    }
    if (const std::string slip = slip_at(text, i); !slip.empty())
      return support::line_and_column(text, i + 1) + ": " + slip;
    ++i;
  }
  return "";
}

}  // namespace tumble::judge
