#include "judge/verdict/names_from_source.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <iterator>
#include <optional>
#include <regex>
#include <set>
#include <string_view>

#include "judge/spec/demand.hpp"

namespace tumble::judge {

namespace {

/// The part of a source that contains a character.
enum class In { code, line, block, text, character };

bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

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

/// Where the raw text ends whose quote stands at `quote`, as in R"x(1/2)x"; `quote` if it is an
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

/// Blanks what stands between #if 0 and its #else or #endif.
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

/// Whether this text of code contains this word, not as a part of another.
bool has_word(const std::string& code, const std::string& word) {
  for (auto at = code.find(word); at != std::string::npos; at = code.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !is_of_word(code[at - 1])) && (end == code.size() || !is_of_word(code[end])))
      return true;
  }
  return false;
}

/// Whether this character makes a number next to it longer, or a part of a name.
bool is_of_number(char c) { return is_of_word(c) || c == '.' || c == '\''; }

/// A whole number in the code, and whether nothing makes it a part of more: 1 in "1/2", not in
/// "x1/2", "1./2" or "1e3/2".
struct WholeNumber {
  std::size_t begin = 0, end = 0;
  long value = 0;
};

std::optional<WholeNumber> whole_number_at(const std::string& code, std::size_t begin) {
  std::size_t end = begin;
  while (end < code.size() && std::isdigit(static_cast<unsigned char>(code[end]))) ++end;
  const bool starts = begin == 0 || !is_of_number(code[begin - 1]);
  const bool stops = end == code.size() || !is_of_number(code[end]);
  constexpr std::size_t most_digits = 9;
  if (end == begin || end - begin > most_digits || !starts || !stops) return std::nullopt;
  return WholeNumber{begin, end, std::stol(code.substr(begin, end - begin))};
}

std::size_t skip_blanks(const std::string& code, std::size_t at) {
  while (at < code.size() && std::isspace(static_cast<unsigned char>(code[at]))) ++at;
  return at;
}

/// Whether a number is the right operand of what stands before it: 1 in "h * 1/6" and 2 in
/// "x / 2 / 3". Then the quotient is of another number, which may be a double.
bool is_right_operand(const std::string& code, std::size_t begin) {
  while (begin > 0 && std::isspace(static_cast<unsigned char>(code[begin - 1]))) --begin;
  return begin > 0 && (code[begin - 1] == '*' || code[begin - 1] == '/' || code[begin - 1] == '%');
}

/// Whether a whole number is what is asked for: in "const int middle = 7 / 2;" or "a[7 / 2]".
bool is_meant_to_be_whole(const std::string& code, std::size_t at) {
  const std::size_t before = code.find_last_of(";{}", at);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  const std::string statement = code.substr(begin, at - begin);
  if (std::count(statement.begin(), statement.end(), '[') >
      std::count(statement.begin(), statement.end(), ']'))
    return true;
  constexpr std::array types = {"int", "long", "unsigned", "size_t", "ptrdiff_t", "Index"};
  return std::any_of(types.begin(), types.end(),
                     [&](const char* type) { return has_word(statement, type); });
}

/// "1/12 in line 7", the first quotient of two whole numbers that leaves a remainder; empty if
/// none.
std::string whole_quotient(const std::string& code) {
  for (std::size_t i = 0; i < code.size(); ++i) {
    const auto above = whole_number_at(code, i);
    if (!above) continue;
    const std::size_t slash = skip_blanks(code, above->end);
    if (slash >= code.size() || code[slash] != '/' || is_right_operand(code, i)) continue;
    const auto below = whole_number_at(code, skip_blanks(code, slash + 1));
    if (!below || below->value == 0 || above->value % below->value == 0) continue;
    if (is_meant_to_be_whole(code, i)) continue;
    const auto line =
        1 + std::count(code.begin(), code.begin() + static_cast<std::ptrdiff_t>(i), '\n');
    return std::to_string(above->value) + "/" + std::to_string(below->value) + " in line " +
           std::to_string(line);
  }
  return {};
}

/// Whether the code adds numbers up from a start of 0, not 0.0: then each sum is a whole number.
bool sums_whole_numbers(const std::string& code) {
  static const std::regex sum(R"(\b(?:accumulate|reduce)\s*\([^;]{0,200},\s*[+-]?\d{1,9}\s*[,)])");
  return std::regex_search(code, sum);
}

/// Whether a word of the code is the name of what has 7 digits: a type of C++ or of Eigen, or a
/// function of C for them.
bool is_name_of_float(std::string_view word) {
  constexpr std::array names = {"float",       "float_t",       "float32_t",   "_Float16",
                                "_Float32",    "float16_t",     "Quaternionf", "AngleAxisf",
                                "Rotation2Df", "QuaternionMapf"};
  static const std::set<std::string_view> functions = {
      "sqrt",  "cbrt",  "hypot",    "pow",       "exp",   "exp2",  "expm1",    "log",  "log2",
      "log10", "log1p", "sin",      "cos",       "tan",   "asin",  "acos",     "atan", "atan2",
      "sinh",  "cosh",  "tanh",     "asinh",     "acosh", "atanh", "fabs",     "fmod", "fmax",
      "fmin",  "fdim",  "fma",      "floor",     "ceil",  "trunc", "round",    "rint", "ldexp",
      "modf",  "frexp", "copysign", "remainder", "erf",   "erfc",  "nearbyint"};
  if (std::find(names.begin(), names.end(), word) != names.end()) return true;
  if (!word.ends_with('f')) return false;
  word.remove_suffix(1);
  if (functions.contains(word)) return true;
  for (const std::string_view kind : {"Vector", "RowVector", "Matrix", "Array", "Affine",
                                      "Isometry", "Projective", "Translation", "AlignedBox"})
    if (word.size() > kind.size() && word.starts_with(kind))
      return word.find_first_not_of("234X", kind.size()) == std::string_view::npos;  // 3, 23, X
  return false;
}

/// Whether a word of the code is a number with the ending of a float: 0.5f, 1e-3F.
bool is_float_literal(std::string_view word) {
  const bool is_number = word.front() == '.' || (word.front() >= '0' && word.front() <= '9');
  const bool is_hexadecimal = word.starts_with("0x") || word.starts_with("0X");
  return word.size() > 1 && is_number && !is_hexadecimal &&
         (word.ends_with('f') || word.ends_with('F'));
}

/// A float, 0.5f or sqrtf().
bool uses_float(const std::string& source) {
  const std::string code = code_of(source);
  for (std::size_t i = 0; i < code.size(); ++i) {
    std::size_t end = i;
    const bool is_number = std::isdigit(static_cast<unsigned char>(code[i])) || code[i] == '.';
    while (end < code.size() && (is_of_word(code[end]) || (is_number && is_of_number(code[end]))))
      ++end;
    if (end == i) continue;
    const std::string_view word = std::string_view(code).substr(i, end - i);
    if (is_name_of_float(word) || is_float_literal(word)) return true;
    i = end;
  }
  return false;
}

double largest_number(const Value& value) {
  if (const double* x = value.as<double>()) return std::abs(*x);
  double largest = 0;
  if (const List* list = value.as<List>())
    for (const Value& each : *list) largest = worse(largest, largest_number(each));
  return largest;
}

/// Right to 6 digits of the largest number or more, and not to 12.
bool is_right_as_float(const Finding& finding) {
  if (!finding.answer || !finding.demanded) return false;
  const double apart = largest_difference(*finding.answer, *finding.demanded);
  const double fraction = apart / largest_number(*finding.demanded);
  return fraction > 1e-12 && fraction < 2e-6;
}

}  // namespace

std::string code_of(const std::string& source) {
  std::string code = without_comments_and_texts(source);
  skip_what_is_switched_off(code);
  return code;
}

bool mentions(const std::string& source, const std::string& word) {
  return has_word(code_of(source), word);
}

bool keeps_an_expression(const std::string& source) {
  const std::string code = code_of(source), word = "auto ";
  for (auto at = code.find(word); at != std::string::npos; at = code.find(word, at + 1)) {
    if (at > 0 && is_of_word(code[at - 1])) continue;
    std::size_t next = skip_blanks(code, at + word.size());
    while (next < code.size() && is_of_word(code[next])) ++next;
    next = skip_blanks(code, next);
    if (next >= code.size() || code[next] != '=') continue;
    const std::size_t value = skip_blanks(code, next + 1);
    if (value < code.size() && code[value] != '[') return true;
  }
  return false;
}

void name_from_source(Finding& finding, const std::string& source) {
  if (finding.outcome != Outcome::wrong || !finding.answer) return;
  if (const std::string quotient = whole_quotient(code_of(source)); !quotient.empty())
    finding.misconceptions = {{"whole-number division",
                               "There is " + quotient +
                                   ": in C++ the quotient of two whole numbers is "
                                   "a whole number, and what is left over is lost. Write 1. for 1.",
                               ""}};
  else if (finding.misconceptions.empty() && sums_whole_numbers(code_of(source)))
    finding.misconceptions = {
        {"whole-number sum",
         "Your sum starts from 0, a whole number: then each sum on the way is "
         "cut to a whole number too. Start from 0.0.",
         ""}};
  else if (finding.misconceptions.empty() && is_right_as_float(finding) && uses_float(source))
    finding.misconceptions = {
        {"float",
         "Some 7 digits are right, as many as a float has. Compute with double "
         "from the beginning to the end.",
         ""}};
}

}  // namespace tumble::judge
