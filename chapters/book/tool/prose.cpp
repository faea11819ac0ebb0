#include "book/tool/prose.hpp"

#include <algorithm>
#include <cctype>

#include "book/tool/fences.hpp"
#include "book/tool/links.hpp"
#include "book/tool/maths.hpp"

namespace tumble::book {

namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// "- text" or "12. text".
bool is_item(const std::string& line) {
  const auto digits = std::find_if_not(line.begin(), line.end(), is_digit);
  const std::string rest(digits, line.end());
  return line.starts_with("- ") || (digits != line.begin() && rest.starts_with(". "));
}

bool is_prose(const std::string& line) {
  return !line.empty() && line[0] != '|' && line[0] != '<' && !line.starts_with("![");
}

}  // namespace

std::vector<Paragraph> paragraphs_of(const Page& page) {
  std::vector<Paragraph> paragraphs;
  const std::vector<Fence> fences = fences_of(page);
  std::string section;
  bool goes_on = false, excused = false;
  for (std::size_t i = 0; i < page.lines.size(); ++i) {
    const std::string line = unquoted(page.lines[i]);
    const Heading heading = heading_in(line);
    const bool prose = !is_inside(fences, i) && heading.level == 0 && is_prose(line);
    if (!is_inside(fences, i) && heading.level > 0) section = heading.text;
    if (prose && goes_on && !is_item(line)) {
      paragraphs.back().text += " " + line.substr(line.find_first_not_of(' '));
    } else if (prose) {
      paragraphs.push_back({i, section, line, excused});
    }
    goes_on = prose;
    excused = line.starts_with("<!-- voice: ");
  }
  return paragraphs;
}

namespace {

/// The text with each formula replaced by a dollar, so that nothing in it is taken for a word.
std::string without_formulas(const std::string& text) {
  std::string result;
  std::size_t at = 0;
  for (const InlineFormula& formula : formulas_in(text)) {
    result += text.substr(at, formula.begin - at) + "$";
    at = formula.end;
  }
  return result + text.substr(at);
}

std::string words_of_links(const std::string& text) {
  std::string result;
  std::size_t at = 0;
  for (const Link& link : links_in(text)) {
    result += text.substr(at, link.begin - at) + link.text;
    at = link.end;
  }
  return result + text.substr(at);
}

}  // namespace

std::string spoken(const std::string& text) {
  std::string plain = without_code_spans(without_formulas(words_of_links(text)));
  std::erase(plain, '*');
  return plain;
}

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace tumble::book
