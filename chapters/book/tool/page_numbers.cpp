#include "book/tool/page_numbers.hpp"

#include <set>

#include "tumble/core/require.hpp"

namespace tumble::book {

namespace {

/// Text in which bytes are written as a mark and two digits.
std::string decoded(const std::string& text, char mark) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == mark && i + 2 < text.size()) {
      result += static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else {
      result += text[i];
    }
  return result;
}

/// The PDF's objects that are pages. Chromium writes them in their order.
std::set<int> page_objects(const std::string& pdf) {
  static const std::string kind = " 0 obj\n<</Type /Page\n";
  std::set<int> objects;
  for (auto at = pdf.find(kind); at != std::string::npos; at = pdf.find(kind, at + 1)) {
    const auto begin = pdf.rfind('\n', at) + 1;
    objects.insert(std::stoi(pdf.substr(begin, at - begin)));
  }
  return objects;
}

}  // namespace

std::map<std::string, int> pages_of_places(const std::string& pdf) {
  const std::set<int> objects = page_objects(pdf);
  std::map<std::string, int> pages;
  static const std::string there = " 0 R /XYZ ";
  for (auto at = pdf.find(there); at != std::string::npos; at = pdf.find(there, at + 1)) {
    const auto open = pdf.rfind('[', at), name = pdf.rfind('/', open);
    const auto found = objects.find(std::stoi(pdf.substr(open + 1, at - open)));
    if (found == objects.end()) continue;
    const auto before = std::distance(objects.begin(), found);
    pages[decoded(decoded(pdf.substr(name + 1, open - 1 - name - 1), '#'), '%')] =
        static_cast<int>(before) + 1;
  }
  return pages;
}

std::string with_page_numbers(const std::string& html, const std::map<std::string, int>& pages) {
  const std::string nav = "<nav>";
  std::size_t at = html.find(nav) + nav.size();
  const auto end = html.find("</nav>", at);
  std::string result = html.substr(0, at - nav.size()) + "<nav class=\"numbered\">";
  const std::string link = "<a href=\"#", number = "<span>000</span>";
  for (auto entry = html.find(link); entry < end; entry = html.find(link, at)) {
    const auto name = entry + link.size(), place = html.find(number, name);
    const auto page = pages.find(decoded(html.substr(name, html.find('"', name) - name), '%'));
    require(page != pages.end(),
            "the PDF has no place for an entry of the contents: ", html.substr(name, 60));
    result += html.substr(at, place - at) + "<span>" + std::to_string(page->second) + "</span>";
    at = place + number.size();
  }
  return result + html.substr(at);
}

}  // namespace tumble::book
