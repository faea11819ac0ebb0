#include "book/tool/html.hpp"

#include <fstream>
#include <iterator>

#include "book/tool/maths.hpp"
#include "book/tool/page.hpp"
#include "support/svg.hpp"

namespace tumble::book {

namespace {

/// `code` in HTML; the text has no other mark-up.
std::string with_code(const std::string& text) {
  std::string result;
  bool inside = false;
  for (const char c : support::svg_text(text)) {
    if (c != '`') {
      result += c;
      continue;
    }
    result += inside ? "</code>" : "<code>";
    inside = !inside;
  }
  return result;
}

}  // namespace

std::string html_block(const std::string& text) {
  return "\\htmlonly[block] " + text + " \\endhtmlonly";
}

std::string inline_html(const std::string& markdown) {
  std::string result;
  std::size_t at = 0;
  for (const InlineFormula& formula : formulas_in(markdown)) {
    result += with_code(markdown.substr(at, formula.begin - at)) + "\\(" +
              support::svg_text(formula.tex) + "\\)";
    at = formula.end;
  }
  return result + with_code(markdown.substr(at));
}

std::string link_html(const std::string& address, const std::string& text) {
  return "<a href=\"" + address + "\">" + text + "</a>";
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  if (!in) throw PageError(file.string() + ":1: cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_text(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw PageError(file.string() + ":1: cannot be written");
}

}  // namespace tumble::book
