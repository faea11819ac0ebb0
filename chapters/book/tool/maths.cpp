#include "book/tool/maths.hpp"

#include <cctype>

namespace tumble::book {

std::vector<InlineFormula> formulas_in(const std::string& line) {
  std::vector<InlineFormula> formulas;
  bool in_code = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '`') in_code = !in_code;
    if (line[i] == '\\' && !in_code) ++i;
    if (in_code || i >= line.size() || line[i] != '$' || i + 1 >= line.size()) continue;
    const bool quoted = line[i + 1] == '`';
    if (line[i + 1] == ' ') continue;
    const std::string closing = quoted ? "`$" : "$";
    const auto end = line.find(closing, i + closing.size());
    if (end == std::string::npos) continue;
    if (!quoted &&
        (line[end - 1] == ' ' ||
         (end + 1 < line.size() && std::isdigit(static_cast<unsigned char>(line[end + 1])))))
      continue;
    const std::size_t start = i + closing.size();
    formulas.push_back({i, end + closing.size(), line.substr(start, end - start)});
    i = end + closing.size() - 1;
  }
  return formulas;
}

namespace {

/// Where the text ends that stays in the formula's line: the comma behind it, or "-axis".
std::size_t attached_behind(const std::string& text, std::size_t at) {
  const auto end = text.find_first_of(" *_[]<|`$\\\"", at);
  return end == std::string::npos ? text.size() : end;
}

}  // namespace

std::string with_formulas(const std::string& text) {
  const bool in_table = text.starts_with("|");  // Doxygen tears other elements there
  std::string result;
  std::size_t at = 0;
  for (const InlineFormula& formula : formulas_in(text)) {
    if (formula.begin < at) continue;
    result += text.substr(at, formula.begin - at);
    at = in_table ? formula.end : attached_behind(text, formula.end);
    const bool opened = !in_table && result.ends_with("(") && !result.ends_with("](");
    if (opened) result.pop_back();
    const bool alone = at == formula.end && !opened;
    result += std::string(alone ? "" : "<span class='unbroken'>") + (opened ? "(" : "") + "\\f$" +
              formula.tex + "\\f$" + text.substr(formula.end, at - formula.end) +
              (alone ? "" : "</span>");
  }
  return result + text.substr(at);
}

std::string markdown_trap_in(const std::string& tex) {
  const auto is_punctuation = [&tex](std::size_t i) {
    return std::ispunct(static_cast<unsigned char>(tex[i])) != 0;
  };
  for (std::size_t i = 0; i + 1 < tex.size(); ++i) {
    if (tex[i] == '\\' && is_punctuation(i + 1)) return tex.substr(i, 2);  // an escape
    if (tex[i + 1] == '_' && is_punctuation(i)) return tex.substr(i, 2);   // emphasis
    if (tex[i] == '*') return "*";
  }
  return {};
}

}  // namespace tumble::book
