#include "book/tool/printed.hpp"

#include <algorithm>

#include "book/tool/addresses.hpp"
#include "book/tool/contents.hpp"
#include "book/tool/fences.hpp"
#include "book/tool/form.hpp"
#include "book/tool/html.hpp"
#include "book/tool/links.hpp"
#include "book/tool/terms.hpp"

namespace tumble::book {

namespace {

/// Text between two marks, without them.
std::string between(const std::string& text, const std::string& start, const std::string& end) {
  const auto begin = text.find(start);
  if (begin == std::string::npos) return {};
  const auto at = begin + start.size();
  return text.substr(at, text.find(end, at) - at);
}

void erase_all(std::string& text, const std::string& start, const std::string& end) {
  for (auto at = text.find(start); at != std::string::npos; at = text.find(start, at))
    text.erase(at, text.find(end, at) + end.size() - at);
}

void unfold(std::string& text) {
  const std::string folded = "<details>";
  for (auto at = text.find(folded); at != std::string::npos; at = text.find(folded, at))
    text.replace(at, folded.size(), "<details open=\"open\">");
}

/// Where a link leads in the printed book: "#place"; empty if nowhere.
std::string printed_address(const std::string& address, const std::vector<std::string>& pages) {
  if (address.starts_with("#") || address.find("://") != std::string::npos) return address;
  const auto hash = address.find('#');
  const std::string file = address.substr(0, hash);
  for (const std::string& page : pages)
    if (file == page + ".html")
      return hash == std::string::npos ? "#" + page : address.substr(hash);
  return {};
}

std::string relinked(const std::string& text, const std::vector<std::string>& pages) {
  const std::string start = "href=\"";
  std::string result;
  std::size_t at = 0;
  for (auto link = text.find(start); link != std::string::npos; link = text.find(start, at)) {
    const auto begin = link + start.size(), end = text.find('"', begin);
    const std::string address = printed_address(text.substr(begin, end - begin), pages);
    result += text.substr(at, link - at);
    if (!address.empty()) result += start + address + "\"";
    at = end + 1;
  }
  return result + text.substr(at);
}

/// A link of the contents, and room for the number of its page.
std::string entry(const std::string& id, const std::string& title) {
  return link_html("#" + id, inline_html(title)) + "<span>000</span>";
}

/// The entry of a page in the contents: its title, and those of its sections, also where they are
/// in parts.
std::string contents_of(const fs::path& root, const Page& page) {
  const std::vector<Fence> fences = fences_of(page);
  std::string sections;
  bool in_part = false;
  for (std::size_t i = 1; i < page.lines.size(); ++i) {
    const Heading heading = heading_in(page.lines[i]);
    if (is_inside(fences, i) || heading.level < 2) continue;
    if (heading.level == 2) in_part = heading.text.starts_with("Part ");
    if (heading.level == 2 || (heading.level == 3 && in_part))
      sections += "<li>" + entry(heading_id(root, page, heading.text), heading.text) + "</li>";
  }
  return "<li>" + entry(page_id(root, page.file), heading_in(page.lines[0]).text) +
         (sections.empty() ? "" : "<ul>" + sections + "</ul>") + "</li>";
}

const std::string top = R"(<!DOCTYPE html>
<html lang="en" class="light-mode">
<head>
<meta charset="utf-8"/>
<title>tumble</title>
<link href="doxygen.css" rel="stylesheet"/>
<link href="katex/katex.min.css" rel="stylesheet"/>
<link href="doxygen-awesome.css" rel="stylesheet"/>
<link href="book.css" rel="stylesheet"/>
<link href="print.css" rel="stylesheet"/>
</head>
<body>
<main id="text">
)";

const std::string bottom = R"(</main>
<script src="katex/katex.min.js"></script>
<script>function openDetails() {}</script>
<script src="formulas.js"></script>
</body>
</html>
)";

}  // namespace

std::string printed_article(const std::string& page, const std::string& id,
                            const std::vector<std::string>& others) {
  std::string text = between(page, "<div class=\"contents\">", "</div><!-- contents -->");
  erase_all(text, "<nav class=\"neighbours\"", "</nav>");
  erase_all(text, "<nav class=\"page-contents\"", "</nav>");
  unfold(text);
  return "<article id=\"" + id + "\"><h1>" + between(page, "<h1 class=\"title\">", "</h1>") +
         "</h1>\n<div class=\"contents\">" + relinked(text, others) + "</div></article>\n";
}

void write_printed_book(const fs::path& root, const SiteFiles& files, const fs::path& folder) {
  std::vector<fs::path> pages;
  for (const fs::path& page : files.pages)
    if (is_chapter(page)) pages.push_back(page);
  if (std::find(files.pages.begin(), files.pages.end(), place_of_terms(root)) != files.pages.end())
    pages.push_back(place_of_terms(root));
  std::vector<std::string> ids;
  ids.reserve(pages.size());
  for (const fs::path& page : pages) ids.push_back(page_id(root, page));
  std::string contents, articles;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    contents += contents_of(root, read_page(pages[i]));
    articles += printed_article(text_of(folder / (ids[i] + ".html")), ids[i], ids);
  }
  write_text(
      folder / "print.html",
      top +
          "<header><h1>tumble</h1><p>Rigid-body dynamics, built chapter by chapter</p></header>\n" +
          "<nav><h2>Contents</h2><ul>" + contents + "</ul></nav>\n" + articles + bottom);
}

}  // namespace tumble::book
