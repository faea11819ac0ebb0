#include "book/tool/finish.hpp"

#include <string>

#include "book/tool/html.hpp"

namespace tumble::book {

namespace {

const std::string drawing_start = "<div data-figure=\"", drawing_end = "\"></div>";

std::string with_drawings(const fs::path& root, const std::string& text) {
  std::string filled;
  std::size_t at = 0;
  for (auto start = text.find(drawing_start); start != std::string::npos;
       start = text.find(drawing_start, at)) {
    const std::size_t name = start + drawing_start.size(), end = text.find(drawing_end, name);
    // The place keeps its name: a script finds it there, if the figure can be moved.
    filled += text.substr(at, end + 2 - at) + text_of(root / text.substr(name, end - name));
    at = end + 2;
  }
  return filled + text.substr(at);
}

/// Replaces the first `from` behind `start`, if both are there.
void replace_behind(std::string& text, const std::string& start, const std::string& from,
                    const std::string& to) {
  const auto begin = text.find(start);
  const auto at = begin == std::string::npos ? begin : text.find(from, begin + start.size());
  if (at != std::string::npos) text.replace(at, from.size(), to);
}

/// The list of pages is the same in all of them, but for the mark of the page that is read.
void mark_this_page(std::string& text, const std::string& name) {
  replace_behind(text, "<nav id=\"sidebar\"", "<a href=\"" + name + "\"",
                 "<a aria-current=\"page\" href=\"" + name + "\"");
}

void make_headings(std::string& text) {
  const std::string title = "<div class=\"title\">";
  const auto at = text.find(title);
  if (at == std::string::npos) return;
  text.replace(at, title.size(), "<h1 class=\"title\">");
  replace_behind(text, "<h1 class=\"title\">", "</div>", "</h1>");
}

/// Doxygen's links to the parts of a class, at its top: some lead to parts that it leaves out.
void drop_summary(std::string& text) {
  const std::string start = "<div class=\"summary\">";
  const auto at = text.find(start);
  if (at != std::string::npos) text.erase(at, text.find("</div>", at) + 6 - at);
}

/// Doxygen sets a blank before each formula that follows a tag.
void close_up_formulas(std::string& text) {
  for (const char* open : {"<span class=\"unbroken\">", "<span class=\"unbroken\">("}) {
    const std::string loose = open + std::string(" \\("), tight = open + std::string("\\(");
    for (auto at = text.find(loose); at != std::string::npos; at = text.find(loose, at))
      text.replace(at, loose.size(), tight);
  }
}

}  // namespace

void finish_site(const fs::path& root, const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".html") continue;
    std::string text = with_drawings(root, text_of(entry.path()));
    mark_this_page(text, entry.path().filename().string());
    make_headings(text);
    drop_summary(text);
    close_up_formulas(text);
    write_text(entry.path(), text);
  }
}

}  // namespace tumble::book
