#include "judge/verdict/names_from_source.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <regex>
#include <set>
#include <string_view>

#include "judge/build/source_code.hpp"
#include "judge/spec/demand.hpp"
#include "judge/verdict/rounded_constant.hpp"

namespace tumble::judge {

namespace {

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

/// The number that a text begins with; 0 if none.
std::size_t first_number_in(const std::string& text) {
  std::size_t number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

/// Whether a number is the right operand of what is before it: 1 in "h * 1/6" and 2 in
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
    return std::to_string(above->value) + "/" + std::to_string(below->value) + " in line " +
           std::to_string(line_of(code, i));
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

/// What the code reads that nobody types: "std::cin"; empty if nothing.
std::string read_from_keyboard(const std::string& code) {
  static const std::regex from_cin(R"(\bcin\s{0,20}>>|\bgetline\s{0,20}\(\s{0,20}(std::)?cin\b)"),
      from_c(R"(\b(scanf|getchar|fgets)\s{0,20}\()");
  std::smatch found;
  if (std::regex_search(code, from_cin)) return "std::cin";
  return std::regex_search(code, found, from_c) ? found[1].str() : "";
}

/// Whether the numbers alone have given this name, or none: what the source shows says more.
bool is_of_numbers_that_are_none(const Finding& finding) {
  return finding.misconceptions.empty() || finding.misconceptions.front().name == "never set" ||
         finding.misconceptions.front().name == "not a number";
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

/// Right to 12 digits of the largest number at most, and wrong by less than this fraction of it.
bool is_wrong_by_less_than(const Finding& finding, double most) {
  if (!finding.answer || !finding.demanded) return false;
  const double apart = largest_difference(*finding.answer, *finding.demanded);
  const double fraction = apart / largest_number(*finding.demanded);
  return fraction > 1e-12 && fraction < most;
}

/// Right to 6 digits or more.
bool is_right_as_float(const Finding& finding) { return is_wrong_by_less_than(finding, 2e-6); }

/// A constant with few digits, if the answer is off by about as much. The digits may stand for
/// something else, and then another mistake would be hidden.
std::optional<Misconception> name_of_rounded(const Finding& finding, const std::string& code) {
  constexpr double most_magnified = 3, least = 1e-3;  // on the way from the constant to the answer
  const std::optional<RoundedConstant> found = rounded_constant_in(code);
  if (!found || !is_wrong_by_less_than(finding, most_magnified * found->error) ||
      is_wrong_by_less_than(finding, least * found->error))
    return std::nullopt;
  return Misconception{rounded_constant_name,
                       "There is " + found->digits + " in line " + std::to_string(found->line) +
                           ", which has only a few digits of " + found->meant + ". Write " +
                           found->instead + ".",
                       ""};
}

}  // namespace

std::vector<KeptExpression> kept_expressions(const std::string& source) {
  const std::string code = code_of(source), word = "auto ";
  std::vector<KeptExpression> kept;
  for (auto at = code.find(word); at != std::string::npos; at = code.find(word, at + 1)) {
    if (at > 0 && is_of_word(code[at - 1])) continue;
    const std::size_t begin = skip_blanks(code, at + word.size());
    std::size_t next = begin;
    while (next < code.size() && is_of_word(code[next])) ++next;
    const std::string name = code.substr(begin, next - begin);
    next = skip_blanks(code, next);
    if (next >= code.size() || code[next] != '=') continue;
    const std::size_t value = skip_blanks(code, next + 1);
    if (value < code.size() && code[value] != '[') kept.push_back({line_of(code, at), name});
  }
  return kept;
}

bool keeps_an_expression(const std::string& source) { return !kept_expressions(source).empty(); }

std::optional<Misconception> expression_that_outlives(const std::string& source,
                                                      const std::string& place) {
  constexpr std::array gone = {"use-after-scope", "use-after-return", "heap-use-after-free"};
  if (std::none_of(gone.begin(), gone.end(),
                   [&](const char* words) { return place.find(words) != std::string::npos; }))
    return std::nullopt;
  const std::size_t used = first_number_in(place.substr(place.find(':') + 1));
  const std::string there = code_line(code_of(source), used);
  const std::vector<KeptExpression> all = kept_expressions(source);
  const auto kept = std::find_if(all.rbegin(), all.rend(), [&](const KeptExpression& each) {
    return each.line <= used && has_word(there, each.name);
  });
  if (kept == all.rend()) return std::nullopt;
  return Misconception{
      "an auto that holds an expression",
      "The auto in line " + std::to_string(kept->line) +
          " may hold an expression of Eigen, not its value, and what it is made of is gone where "
          "you use it. Write the type instead of auto.",
      ""};
}

void name_from_source(Finding& finding, const std::string& source) {
  if (finding.outcome != Outcome::wrong || !finding.answer) return;
  if (const std::string quotient = whole_quotient(code_of(source)); !quotient.empty())
    finding.misconceptions = {{"whole-number division",
                               "There is " + quotient +
                                   ": in C++ the quotient of two whole numbers is "
                                   "a whole number, and what is left over is lost. Write 1. for 1.",
                               ""}};
  else if (const std::string input = read_from_keyboard(code_of(source));
           !input.empty() && is_of_numbers_that_are_none(finding))
    finding.misconceptions = {
        {"input that is not there",
         "Your code reads from " + input +
             ", and there is no input here: what you read is never set. All that a function needs "
             "are its arguments.",
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

void name_rounded_constant(Finding& finding, const std::string& source) {
  const bool is_explained = !finding.misconceptions.empty() || !finding.place.empty();
  if (finding.outcome != Outcome::wrong || is_explained) return;
  if (const auto rounded = name_of_rounded(finding, code_of(source)))
    finding.misconceptions = {*rounded};
}

}  // namespace tumble::judge
