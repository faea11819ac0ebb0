#pragma once
/// @file
/// How much of one text stands word for word in another: runs of six tokens of C++.

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <vector>

namespace tumble::test {

/// Six tokens one after the other.
using TokenRun = std::vector<std::string>;

namespace detail {

/// Without comments and preprocessor lines.
inline std::string code_only(const std::string& text) {
  std::string code;
  bool line_begins = true;
  for (std::size_t i = 0; i < text.size();) {
    const auto skip_to = [&](const char* end, std::size_t more) {
      const std::size_t found = text.find(end, i + more);
      i = found == std::string::npos ? text.size() : found + more;
    };
    if (text.compare(i, 2, "//") == 0 || (text[i] == '#' && line_begins)) {
      skip_to("\n", 0);
    } else if (text.compare(i, 2, "/*") == 0) {
      skip_to("*/", 2);
    } else {
      line_begins = text[i] == '\n' || (line_begins && text[i] == ' ');
      code += text[i++];
    }
  }
  return code;
}

/// What changes nothing about how a function works.
inline bool is_common(const std::string& token) {
  static const std::set<std::string> common = {
      "const", "constexpr", "inline",   "static",   "double",   "int",       "auto",     "bool",
      "std",   "Eigen",     "VectorXd", "MatrixXd", "Vector3d", "Matrix3d",  "Vector4d", "Vec3",
      "Mat3",  "Quat",      "::",       "return",   "tumble",   "Quaternion"};
  return common.contains(token);
}

}  // namespace detail

/// Names, numbers and signs, without comments and common type names.
inline std::vector<std::string> tokens_of(const std::string& text) {
  const std::string code = detail::code_only(text);
  std::vector<std::string> tokens;
  for (std::size_t i = 0; i < code.size();) {
    const auto in_word = [&](std::size_t k) {
      return k < code.size() && (std::isalnum(static_cast<unsigned char>(code[k])) != 0 ||
                                 code[k] == '_' || (code[k] == '.' && code[i] <= '9'));
    };
    std::size_t end = i + 1;
    if (in_word(i) && code[i] != '.')
      while (in_word(end)) ++end;
    else if (code.compare(i, 2, "::") == 0)
      ++end;
    std::string token = code.substr(i, end - i);
    i = end;
    if (std::isspace(static_cast<unsigned char>(token[0])) == 0 && !detail::is_common(token))
      tokens.push_back(std::move(token));
  }
  return tokens;
}

/// All runs, as often as they stand there.
inline std::vector<TokenRun> runs_of(const std::string& text) {
  constexpr std::ptrdiff_t length = 6;
  const std::vector<std::string> tokens = tokens_of(text);
  std::vector<TokenRun> runs;
  for (auto from = tokens.begin(); tokens.end() - from >= length; ++from)
    runs.emplace_back(from, from + length);
  return runs;
}

/// The share of these runs that is among others.
inline double share_in(const std::vector<TokenRun>& runs, const std::set<TokenRun>& others) {
  if (runs.empty()) return 0;
  const auto found = std::count_if(runs.begin(), runs.end(),
                                   [&](const TokenRun& run) { return others.contains(run); });
  return static_cast<double>(found) / static_cast<double>(runs.size());
}

}  // namespace tumble::test
