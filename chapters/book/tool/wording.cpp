#include "book/tool/wording.hpp"

#include <algorithm>
#include <cctype>
#include <regex>

#include "book/tool/maths.hpp"

namespace tumble::book {

namespace {

/// A blank at which a line doesn't break.
constexpr const char* unbroken = "\u00a0";

/// Words between code and formulas, with numbers that stay with what they count.
std::string with_units(const std::string& words) {
  static const std::string unit =
      "(?:%|°|(?:k|c|m|µ|n)?(?:m|s|g|N|J|W|Hz)(?:²|³)?|Pa|rad|AU|kB|MB|GB)(?![A-Za-z0-9])";
  static const std::regex number("([0-9]) (" + unit + ")"),
      product("(N|kg|Pa) ((?:m|s)(?:²|³)?(?![A-Za-z0-9]))"),
      counted("(Figure|Table|chapter|Chapter|order|DP) ([0-9])");
  std::string text = words;
  for (const std::regex& pair : {number, product, counted})
    text = std::regex_replace(text, pair, std::string("$1") + unbroken + "$2");
  return text;
}

/// Without "In the site that `./tumble book` opens, ".
std::string without_invitation(const std::string& line) {
  static const std::string invitation = "In the site that `./tumble book` opens, ";
  const auto at = line.find(invitation);
  if (at == std::string::npos) return line;
  std::string rest = line.substr(at + invitation.size());
  if (!rest.empty()) rest[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(rest[0])));
  return line.substr(0, at) + rest;
}

}  // namespace

std::string on_the_site(const std::string& line) {
  const std::string text = without_invitation(line);
  std::string result, words;
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
    result += with_units(words) + text.substr(i, end - i);
    words.clear();
    i = end;
  }
  return result + with_units(words);
}

}  // namespace tumble::book
