#include "judge/build/header_errors.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "judge/build/source_code.hpp"

namespace tumble::judge {

namespace {

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

const std::string error_mark = ": error: ";

bool has(const std::string& line, const std::string& words) {
  return line.find(words) != std::string::npos;
}

/// What Eigen's words mean for who wrote the line; empty if they are rare.
std::string meaning_of(const std::string& assertion) {
  constexpr std::array<std::pair<const char*, const char*>, 6> meanings{
      {{"YOU_MIXED_MATRICES_OF_DIFFERENT_SIZES",
        "vectors or matrices of different sizes are added, compared, assigned or returned"},
       {"INVALID_VECTOR_VECTOR_PRODUCT",
        "a vector times a vector: write a.dot(b) for the dot product, a.cwiseProduct(b) for entry "
        "by entry"},
       {"INVALID_MATRIX_PRODUCT",
        "a product needs as many columns on its left as rows on its right"},
       {"THE_BRACKET_OPERATOR_IS_ONLY_FOR_VECTORS", "m[i] is for vectors: write m(i, j)"},
       {"YOU_TRIED_CALLING_A_VECTOR_METHOD_ON_A_MATRIX",
        "this function is for vectors, and is called on a matrix"},
       {"THIS_METHOD_IS_ONLY_FOR_VECTORS_OF_A_SPECIFIC_SIZE",
        "this function is for vectors of another size"}}};
  for (const auto& [start, meaning] : meanings)
    if (assertion.starts_with(start)) return meaning;
  return {};
}

/// The text of the assertion that an error tells of: gcc's last words, or clang's in quotes.
std::optional<std::string> static_assertion_in(const std::string& line) {
  if (!has(line, ": error: static assertion failed") && !has(line, ": error: static_assert failed"))
    return std::nullopt;
  if (line.ends_with('"')) {
    const std::size_t open = line.rfind('"', line.size() - 2);
    if (open != std::string::npos) return line.substr(open + 1, line.size() - open - 2);
  }
  return line.substr(line.rfind(": ") + 2);
}

/// What an error in a header says, for who did not write the header.
std::string words_of(const std::string& line) {
  if (const auto assertion = static_assertion_in(line)) {
    const std::string meaning = meaning_of(*assertion);
    return meaning.empty() ? *assertion : meaning + " (" + *assertion + ")";
  }
  if (has(line, "_init2"))  // Eigen's constructor from two things
    return "a vector is given its numbers one by one: {0, p[0], p[1], p[2]}, not {0, p}";
  return line.substr(line.find(error_mark) + error_mark.size());
}

/// Characters that look like those of C++, and what to type instead: text that was copied from a
/// page or a PDF has them.
constexpr std::array<std::array<const char*, 3>, 9> lookalikes{
    {{"\u00a0", "a non-breaking space", "a plain space"},
     {"\u202f", "a narrow non-breaking space", "a plain space"},
     {"\u201c", "a typographic quote, “", "a plain one, \""},
     {"\u201d", "a typographic quote, ”", "a plain one, \""},
     {"\u2018", "a typographic quote, ‘", "a plain one, '"},
     {"\u2019", "a typographic quote, ’", "a plain one, '"},
     {"\u2212", "a mathematical minus, −", "a plain one, -"},
     {"\u2013", "a dash, –", "a plain minus, -"},
     {"\u2014", "a dash, —", "a plain minus, -"}}};

/// What is said of a line of code that has such a character; empty if it has none.
std::string words_about_lookalike(const std::string& code_line) {
  for (const auto& [character, name, instead] : lookalikes)
    if (has(code_line, character))
      return std::string("this line contains ") + name + ": type " + instead;
  return {};
}

/// The word that ends before a column, or holds it; columns count from 1.
std::string word_at(const std::string& code_line, std::size_t column) {
  std::size_t end = std::min(column, code_line.size());
  if (end > 0 && !is_of_word(code_line[end - 1])) --end;
  while (end < code_line.size() && is_of_word(code_line[end])) ++end;
  std::size_t begin = end;
  while (begin > 0 && is_of_word(code_line[begin - 1])) --begin;
  return code_line.substr(begin, end - begin);
}

/// Whether an error is about an assignment, also one as +=.
bool is_about_assignment(const std::string& error) {
  if (has(error, "operand types are") && !has(error, "operand types are 'const")) return false;
  if (has(error, "assignment of read-only") || has(error, "cannot assign to return value"))
    return true;
  constexpr std::array operations = {"=", "+=", "-=", "*=", "/="};
  return std::any_of(operations.begin(), operations.end(), [&](const std::string& operation) {
    return has(error, "no match for 'operator" + operation + "'") ||
           has(error, "no viable overloaded '" + operation + "'");
  });
}

/// The parameter that the statement before a column assigns to and that is const: "y" of
/// "y[0] = 1;"; empty if it is none.
std::string const_parameter(const std::string& code, const std::string& code_line,
                            std::size_t column) {
  const std::string before = code_line.substr(0, column);
  const auto boundary = before.find_last_of(";{})", before.find('='));
  std::size_t begin = boundary == std::string::npos || before[boundary] == ')' ? 0 : boundary + 1;
  while (begin < before.size() && !is_of_word(before[begin])) ++begin;
  const std::string name = word_at(before, begin + 1);
  constexpr std::size_t longest = 100;  // a regular expression takes stack for each character
  if (name.empty() || name.size() > longest) return {};
  const std::regex parameter(R"(\bconst\b[^,;(){}]{0,200}&\s{0,50})" + name + R"(\s{0,50}[,)])");
  return std::regex_search(code, parameter) ? name : "";
}

/// What the compiler's words and the line together show; empty if nothing.
std::string words_about_line(const std::string& error, const std::string& code,
                             const std::string& code_line, std::size_t column) {
  if (std::string words = words_about_lookalike(code_line); !words.empty()) return words;
  // The sum before it may be what fails: ^ binds more weakly than + does.
  const bool is_operation = has(error, "'operator") || has(error, "to binary expression");
  if (is_operation && has(code_line, "^"))
    return "in C++ ^ is no power: write x * x for x², or std::pow(x, n)";
  const bool is_call = has(error, "no match for call to") ||
                       has(error, "no matching function for call to object of type");
  if (is_call && (has(error, "const Rhs") || has(error, "::Rhs")))
    return word_at(code_line, column) + " takes (t, y): first the time, then the state";
  if (!is_about_assignment(error)) return {};
  const std::string name = const_parameter(code, code_line, column);
  if (name.empty()) return {};
  return name + " is const, which you can't change: copy it first (Eigen::VectorXd next = " + name +
         ";), and change the copy";
}

/// What an error in a student's own line says, where the compiler's words are about templates or
/// leave out what to do; empty if they are good.
std::string plain_words_of(const std::string& line) {
  const bool has_number = has(line, "'int'") || has(line, "'double'");
  const bool has_matrix = has(line, "Matrix") || has(line, "Eigen::") || has(line, "Cwise");
  if (has_number && has_matrix &&
      (has(line, "no match for 'operator") || has(line, "invalid operands to binary expression")))
    return "a number can't be added to a matrix, or divided by one: the 1 of a formula for "
           "matrices is Eigen::Matrix3d::Identity()";
  if (has(line, "'this' argument") &&
      (has(line, "discards qualifiers") || has(line, "not marked const")))
    return "this function changes the object that it is called on, and yours is const: copy it, or "
           "call what returns a new one, as v.normalized() does";
  for (const std::string name : {"cout", "cerr", "endl"})
    if (has(line, "no member named '" + name + "' in namespace 'std'"))
      return "std::" + name + " needs #include <iostream>";
  return {};
}

struct SourcePlace {
  std::size_t line = 0, column = 0;
};

/// The place in `source` that a line of the compiler's begins with.
std::optional<SourcePlace> place_at(const std::string& line, const std::string& source) {
  if (!line.starts_with(source + ":")) return std::nullopt;
  SourcePlace place;
  const char* end = line.data() + line.size();
  const auto number = std::from_chars(line.data() + source.size() + 1, end, place.line);
  if (number.ec != std::errc{} || number.ptr == end || *number.ptr != ':') return std::nullopt;
  const auto column = std::from_chars(number.ptr + 1, end, place.column);
  return column.ec == std::errc{} ? std::optional(place) : std::nullopt;
}

/// "required from here" of gcc is before its error, "requested here" of clang behind it.
bool leads_to_header(const std::string& line) {
  return has(line, "required from") || has(line, "note: in instantiation of");
}

class Rewriting {
 public:
  Rewriting(std::string source, const std::string& text, const std::string& output)
      : source_(std::move(source)),
        text_(split_lines(text)),
        code_(code_of(text)),
        code_lines_(split_lines(code_)),
        output_(split_lines(output)) {}

  std::string result() {
    std::string kept;
    for (std::size_t i = 0; i < output_.size(); ++i) kept += rewritten(i);
    return kept;
  }

 private:
  std::string rewritten(std::size_t i) {
    const std::string& line = output_[i];
    const std::optional<SourcePlace> here = place_at(line, source_);
    if (here && leads_to_header(line)) {
      is_dropped_ = true;  // and the lines that it points at
      return {};
    }
    is_dropped_ = is_dropped_ && line.starts_with(' ');
    if (!has(line, error_mark)) return is_dropped_ ? "" : line + "\n";
    const std::string plain = here ? plain_words(line, *here) : words_of(line);
    const std::optional<SourcePlace> place = here ? here : place_of_error(i);
    if (!place || plain.empty()) return line + "\n";
    is_dropped_ = true;
    return told_.insert(place->line).second ? error_at(*place, plain) : "";
  }

  std::string plain_words(const std::string& error, const SourcePlace& place) const {
    const bool is_there = place.line > 0 && place.line <= code_lines_.size();
    const std::string words =
        is_there ? words_about_line(error, code_, code_lines_[place.line - 1], place.column) : "";
    return words.empty() ? plain_words_of(error) : words;
  }

  /// The place in the source that led to the error in line i.
  std::optional<SourcePlace> place_of_error(std::size_t i) const {
    const auto place = [&](std::size_t k) {
      return leads_to_header(output_[k]) ? place_at(output_[k], source_) : std::nullopt;
    };
    for (std::size_t k = i; k-- > 0 && !has(output_[k], error_mark);)
      if (has(output_[k], "required from") && place(k)) return place(k);
    for (std::size_t k = i + 1; k < output_.size() && !has(output_[k], error_mark); ++k)
      if (has(output_[k], "note: in instantiation of") && place(k)) return place(k);
    return std::nullopt;
  }

  std::string error_at(const SourcePlace& place, const std::string& words) const {
    const std::string line = std::to_string(place.line);
    std::string error =
        source_ + ":" + line + ":" + std::to_string(place.column) + error_mark + words + "\n";
    if (place.line == 0 || place.line > text_.size() || place.column == 0) return error;
    constexpr std::size_t width = 5;  // as gcc's
    const std::string quoted =
        std::string(width - std::min(width, line.size()), ' ') + line + " | ";
    error += quoted + text_[place.line - 1] + "\n";
    return error + std::string(quoted.size() - 2, ' ') + "| " + std::string(place.column - 1, ' ') +
           "^\n";
  }

  std::string source_;
  std::vector<std::string> text_;
  std::string code_;  ///< of the text
  std::vector<std::string> code_lines_, output_;
  std::set<std::size_t> told_;  ///< lines of the source
  bool is_dropped_ = false;
};

}  // namespace

std::string header_errors_at(const std::filesystem::path& source, const std::string& text,
                             const std::string& compiler_output) {
  return Rewriting(source.string(), text, compiler_output).result();
}

}  // namespace tumble::judge
