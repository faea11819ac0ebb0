#include "judge/build/source_code.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <sstream>
#include <string_view>

namespace tumble::judge {

bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

namespace {

/// The part of a source that contains a character.
enum class In { code, line, block, text, character };

/// What begins between two characters of code, if anything but code.
In begun_at(char last, char c, char next) {
  if (c == '/' && next == '/') return In::line;
  if (c == '/' && next == '*') return In::block;
  if (c == '"') return In::text;
  const bool is_separator = std::isalnum(static_cast<unsigned char>(last)) != 0;  // of 1'000'000
  return c == '\'' && !is_separator ? In::character : In::code;
}

/// Whether this character ends the comment or the literal that contains it.
bool ends(In in, char last, char c) {
  switch (in) {
    case In::line:
      return c == '\n';
    case In::block:
      return last == '*' && c == '/';
    case In::text:
      return c == '"';
    case In::character:
      return c == '\'';
    case In::code:
      break;
  }
  return false;
}

/// Where the raw text ends whose quote is at `quote`, as in R"x(1/2)x"; `quote` if it is an
/// ordinary one.
std::size_t end_of_raw_text(const std::string& source, std::size_t quote) {
  std::size_t word = quote;
  while (word > 0 && is_of_word(source[word - 1])) --word;
  const std::string prefix = source.substr(word, quote - word);
  constexpr std::array<std::string_view, 5> prefixes = {"R", "u8R", "uR", "UR", "LR"};
  if (std::find(prefixes.begin(), prefixes.end(), prefix) == prefixes.end()) return quote;
  const std::size_t open = source.find('(', quote);
  if (open == std::string::npos) return source.size() - 1;
  const std::string close = ")" + source.substr(quote + 1, open - quote - 1) + "\"";
  const std::size_t end = source.find(close, open);
  return end == std::string::npos ? source.size() - 1 : end + close.size() - 1;
}

void make_blank(std::string& code, std::size_t begin, std::size_t end) {
  std::replace_if(
      code.begin() + static_cast<std::ptrdiff_t>(begin),
      code.begin() + static_cast<std::ptrdiff_t>(end), [](char c) { return c != '\n'; }, ' ');
}

std::string without_comments_and_texts(const std::string& source) {
  In in = In::code;
  std::string code = source;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const char last = i > 0 ? source[i - 1] : ' ', c = source[i];
    const In before = in;
    if (in == In::code)
      in = begun_at(last, c, i + 1 < source.size() ? source[i + 1] : ' ');
    else if (ends(in, last, c))
      in = In::code;
    if (before == In::code && in == In::text) {
      if (const std::size_t end = end_of_raw_text(source, i); end > i) {
        make_blank(code, i, end + 1);
        in = In::code;
        i = end;
        continue;
      }
    }
    if ((in != In::code || before != In::code) && c != '\n') code[i] = ' ';
    const bool is_escape = (in == In::text || in == In::character) && c == '\\';
    if (is_escape && i + 1 < source.size()) code[++i] = ' ';
  }
  return code;
}

/// The directive of a line, without its blanks: "#if0" of "  # if 0"; empty of any other line.
std::string directive_in(const std::string& line) {
  std::string words;
  std::copy_if(line.begin(), line.end(), std::back_inserter(words),
               [](unsigned char c) { return !std::isspace(c); });
  return words.starts_with("#") ? words : "";
}

/// Blanks what is between #if 0 and its #else or #endif.
void skip_what_is_switched_off(std::string& code) {
  std::size_t depth = 0, off_at = 0;  // how many #if are open; which of them is "#if 0"
  for (std::size_t begin = 0; begin < code.size();) {
    const std::size_t end = std::min(code.find('\n', begin), code.size());
    const std::string directive = directive_in(code.substr(begin, end - begin));
    if (directive.starts_with("#if")) {
      ++depth;
      if (off_at == 0 && (directive == "#if0" || directive == "#iffalse")) off_at = depth;
    }
    if (off_at == depth && directive.starts_with("#e")) off_at = 0;  // #else, #elif, #endif
    if (directive == "#endif" && depth > 0) --depth;
    if (off_at > 0) make_blank(code, begin, end);
    begin = end + 1;
  }
}

}  // namespace

std::string code_of(const std::string& source) {
  std::string code = without_comments_and_texts(source);
  skip_what_is_switched_off(code);
  return code;
}

bool has_word(const std::string& code, const std::string& word) {
  for (auto at = code.find(word); at != std::string::npos; at = code.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !is_of_word(code[at - 1])) && (end == code.size() || !is_of_word(code[end])))
      return true;
  }
  return false;
}

bool mentions(const std::string& source, const std::string& word) {
  return has_word(code_of(source), word);
}

std::string code_line(const std::string& code, std::size_t number) {
  std::istringstream in(code);
  std::string line;
  while (number > 0 && std::getline(in, line)) --number;
  return number == 0 ? line : "";
}

std::size_t line_of(const std::string& code, std::size_t at) {
  return 1 + static_cast<std::size_t>(
                 std::count(code.begin(), code.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

}  // namespace tumble::judge
