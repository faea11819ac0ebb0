#include "book/tool/finish.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <string>

#include "book/tool/html.hpp"

namespace tumble::book {

namespace {

const std::string drawing_start = "<div data-figure=\"", drawing_end = "\"></div>";

/// Drawings have the same styles, and those of the first hold for the page.
std::string without_known_style(std::string svg, std::set<std::string>& known) {
  const std::string end = "</style>";
  const auto begin = svg.find("<style>"), at = svg.find(end);
  if (begin == std::string::npos || at == std::string::npos) return svg;
  const std::string style = svg.substr(begin, at + end.size() - begin);
  if (!known.insert(style).second) svg.erase(begin, style.size());
  return svg;
}

std::string with_drawings(const fs::path& root, const std::string& text) {
  std::set<std::string> styles;
  std::string filled;
  std::size_t at = 0;
  for (auto start = text.find(drawing_start); start != std::string::npos;
       start = text.find(drawing_start, at)) {
    const std::size_t name = start + drawing_start.size(), end = text.find(drawing_end, name);
    // The place keeps its name: a script finds it there, if the figure can be moved.
    filled += text.substr(at, end + 2 - at) +
              without_known_style(text_of(root / text.substr(name, end - name)), styles);
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
                 R"(<a aria-current="page" href=")" + name + "\"");
}

/// In a list of tabs or bookmarks, the front page says what it is about.
void name_front_page(std::string& text) {
  const std::string twice = "<title>tumble – tumble</title>";
  if (const auto at = text.find(twice); at != std::string::npos)
    text.replace(at, twice.size(), "<title>tumble: rigid-body dynamics by building it</title>");
}

void make_headings(std::string& text) {
  const std::string title = "<div class=\"title\">";
  const auto at = text.find(title);
  if (at == std::string::npos) return;
  text.replace(at, title.size(), "<h1 class=\"title\">");
  replace_behind(text, "<h1 class=\"title\">", "</div>", "</h1>");
}

/// Doxygen's sections are <h1>, as the title is: one level down with them.
void lower_sections(std::string& text) {
  const auto begin = text.find("<div class=\"textblock\">");
  if (begin == std::string::npos || text.find("<h1>", begin) == std::string::npos) return;
  for (auto at = text.find("<h", begin); at != std::string::npos; at = text.find("<h", at + 1)) {
    char& level = text[at + 2];
    if (level < '1' || level > '5' || text[at + 3] != '>') continue;
    const auto end = text.find(std::string("</h") + level + ">", at);
    text[end + 3] = ++level;
  }
}

/// Tables of Markdown scroll in themselves, as those of numbers do.
void frame_tables(std::string& text) {
  const std::string start = "<table class=\"markdownTable\">", end = "</table>";
  const std::string frame = R"(<div class="scroll" tabindex="0">)";
  for (auto at = text.find(start); at != std::string::npos; at = text.find(start, at)) {
    text.insert(at, frame);
    at = text.find(end, at) + end.size();
    text.insert(at, "</div>");
  }
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

/// In a template's line Doxygen colours "id" in "solids", too.
void uncolour_parts_of_words(std::string& text) {
  const std::string start = "<span class=\"keywordtype\">", end = "</span>";
  const auto in_word = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  };
  for (auto at = text.find(start, 1); at != std::string::npos; at = text.find(start, at + 1)) {
    const auto stop = text.find(end, at);
    if (!in_word(text[at - 1]) && !in_word(text[stop + end.size()])) continue;
    text.erase(stop, end.size());
    text.erase(at, start.size());
  }
}

/// Text whose links of a kind are words.
std::string unlinked(std::string text, const std::string& link) {
  for (auto at = text.find(link); at != std::string::npos; at = text.find(link, at)) {
    text.erase(at, text.find('>', at) + 1 - at);
    text.erase(text.find("</a>", at), 4);
  }
  return text;
}

/// What a reader is to write has the name of something in the library now and then, and is not
/// that: Doxygen's link to it goes, its text stays.
void unlink_signatures(std::string& text) {
  const std::string box = "class=\"now-write\"", code = "<a class=\"code hl_";
  for (auto at = text.find(box); at != std::string::npos; at = text.find(box, at + 1)) {
    const auto begin = text.find("<div class=\"fragment\">", at);
    const auto end = std::min(text.find("<!-- fragment -->", begin), text.find(box, at + 1));
    if (begin < end)
      text.replace(begin, end - begin, unlinked(text.substr(begin, end - begin), code));
  }
  const bool only_exercises = text.find("<title>Exercises: ") != std::string::npos;
  if (only_exercises) text = unlinked(unlinked(text, code), "<a class=\"el\"");
}

}  // namespace

void finish_site(const fs::path& root, const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".html") continue;
    std::string text = with_drawings(root, text_of(entry.path()));
    mark_this_page(text, entry.path().filename().string());
    name_front_page(text);
    make_headings(text);
    drop_summary(text);
    lower_sections(text);
    frame_tables(text);
    close_up_formulas(text);
    uncolour_parts_of_words(text);
    unlink_signatures(text);
    write_text(entry.path(), text);
  }
}

}  // namespace tumble::book
