#include "book/tool/wording.hpp"

#include <algorithm>
#include <regex>
#include <string>
#include <vector>

#include "book/tool/maths.hpp"

namespace tumble::book {

namespace {

/// A blank at which a line doesn't break.
constexpr const char* unbroken = "\u00a0";
/// Nothing to see, but a line doesn't break here.
constexpr const char* joiner = "\u2060";

/// The text with unbroken blanks at all places of this kind: $1 and $2 stay together.
std::string joined(std::string text, const std::regex& pair) {
  for (std::string before; before != text;) {
    before = text;
    text = std::regex_replace(before, pair, std::string("$1") + unbroken + "$2");
  }
  return text;
}

/// What stays in one line, as two groups with the blank between them.
const std::vector<std::regex>& pairs_in_words() {
  static const std::string
      unit =
          "(?:%|°|(?:k|c|m|µ|n)?(?:m|s|g|N|J|W|Hz)(?:²|³)?|Pa|rad|min|AU|kB|MB|GB)(?![A-Za-z0-9])",
      component = "(?:−)?(?:[0-9.]+|½|¼|¾|[a-z])", letter = "(?:[b-hj-zB-HJ-Z]|ω)",
      sign = "(?:−|\\+|×|=|/|±|∓|≤|≥)", sum = "(?:−∫|∫|∬|Σ)", blank = "(?: |\u00a0)",
      opens = "(?:^| |\u00a0|[(])", ends = "(?![A-Za-z0-9'_])";
  const auto pair = [](const std::string& first, const std::string& second) {
    return std::regex("(" + first + ") (" + second + ")");
  };
  static const std::vector<std::regex> all{
      pair("[0-9]|½|¼|¾|⁰|¹|²|³|⁴|⁵|⁶|⁷|⁸|⁹", unit),                    // 5 kg
      pair("N|kg|Pa", "(?:m|s)(?:²|³)?(?![A-Za-z0-9])"),                // N m
      pair("Figure|Table|chapter|Chapter|order|DP|<=", "(?:−)?[0-9]"),  // Figure 4.1
      pair("^", sign + "|" + unit),                                     // a formula, then its unit
      pair("→", "[^ ]"),
      pair("[^ ]", "→"),  // 1 → 2
      pair("\\((?:" + component + "," + blank + ")*" + component + ",",
           component + "[,)]"),                               // (0, 0, 1)
      pair(opens + "(?:" + sign + "|" + sum + ")", "[^ |]"),  // = b, Σ m
      pair("[^ |]", sign + blank),                            // a =
      pair("[0-9] ·", "[0-9(]"),                              // 8 · 0.6
      pair("½", "[A-Z|]|ω"),                                  // ½ |v|²
      pair("\\)|¹|ᵀ|[A-Za-z][|]",
           "\\(|[|][A-Za-z]|[A-Z](?:<sub>[a-z]</sub>)?\\("),  // (a) (b), a⁻¹ R(b), |t| (a)
      pair("sin|cos|tan", "[a-z]" + std::string(ends)),       // sin t
      pair("±…", "i" + std::string(ends)),                    // ±… i
      pair(opens + letter, letter + ends)};                   // m v
  return all;
}

/// Words between code and formulas, with numbers that stay with what they count, with the others of
/// a vector and with their exponents, and with formulas of a few letters in one line.
std::string with_units(const std::string& words) {
  static const std::regex without_blank("([0-9]e-(?=[0-9])|[0-9]–(?=[0-9])|[|](?=²|³)|[)](?=[(]))");
  std::string text = std::regex_replace(words, without_blank, std::string("$1") + joiner);
  for (const std::regex& pair : pairs_in_words()) text = joined(text, pair);
  // Behind a bar a line may break, even before an unbroken blank.
  static const std::regex behind_bar(std::string("[|](?=") + unbroken + ")");
  return std::regex_replace(text, behind_bar, std::string("|") + joiner);
}

/// @param before the character before the words
std::string with_round_quotes(const std::string& words, char before) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); before = words[i++]) {
    const bool opens = std::string(" ([*_").find(before) != std::string::npos &&
                       (i + 1 == words.size() || words[i + 1] != ' ');
    if (words[i] == '"')
      text += opens ? "“" : "”";
    else
      text += words[i];
  }
  return text;
}

/// "a < b" in one line. As a letter '<' before an unbroken blank would be a tag for Doxygen.
std::string with_whole_comparisons(const std::string& words) {
  static const std::regex less("([^ |]) < ([^ ])");
  return std::regex_replace(words, less, std::string("$1") + unbroken + "&lt;" + unbroken + "$2");
}

}  // namespace

std::string with_indices(const std::string& words) {
  static const std::regex index(
      "(^|[^A-Za-z0-9_])([A-Za-z]|ω)_([a-z]{1,4}|α|β|γ)(?![A-Za-z0-9_]|[.][a-z])");
  // Doxygen sees no italics around a tag.
  static const std::regex italics(R"((^|[^*])\*([^* ][^*]*<sub>[^*]*)\*(?!\*))");
  static const std::regex cross_matrix("\\]×");  // [ω]×
  std::string text = std::regex_replace(words, index, "$1$2<sub>$3</sub>");
  text = std::regex_replace(text, cross_matrix, "]<sub>×</sub>");
  return std::regex_replace(text, italics, "$1<em>$2</em>");
}

std::string with_whole_formulas(const std::string& words) {
  static const std::regex behind("(−|·) ([^ ])"), ahead("([^ ]) (−|\\+|×|·|=|/|±)"),
      times("((?:^| |\u00a0|[(]|−)(?:[A-HJ-Za-z]|[0-9]+)) (\\(|[a-z]+\\()"),
      bracketed(R"((\[[^\]]{0,20}|\([^)]{0,20}) ([^\])]{0,20}[\])]))");
  std::string text = with_units(words);
  for (const std::regex& pair : {behind, ahead, times, bracketed}) text = joined(text, pair);
  return text;
}

std::string on_the_site(const std::string& text) {
  static const std::regex tag("<[A-Za-z/!]");
  const bool has_tags = std::regex_search(text, tag);  // with quotes of their own
  std::string result, words;
  const auto finish_words = [&] {
    const char before = result.empty() ? ' ' : result.back();
    result += with_whole_comparisons(
        with_units(has_tags ? words : with_indices(with_round_quotes(words, before))));
    words.clear();
  };
  const auto formulas = formulas_in(text);
  auto formula = formulas.begin();
  for (std::size_t i = 0; i < text.size();) {
    while (formula != formulas.end() && formula->begin < i) ++formula;
    std::size_t end = i;  // of what stays as it is
    if (formula != formulas.end() && formula->begin == i) end = formula->end;
    if (end == i && text[i] == '`') end = std::min(text.find('`', i + 1), text.size() - 1) + 1;
    if (end == i) {
      words += text[i++];
      continue;
    }
    finish_words();
    result += text.substr(i, end - i);
    i = end;
  }
  finish_words();
  return result;
}

}  // namespace tumble::book
