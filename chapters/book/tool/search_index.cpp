#include "book/tool/search_index.hpp"

#include "book/tool/addresses.hpp"
#include "book/tool/contents.hpp"
#include "book/tool/exercise_pages.hpp"
#include "book/tool/fences.hpp"
#include "book/tool/html.hpp"
#include "book/tool/links.hpp"
#include "book/tool/maths.hpp"
#include "book/tool/prose.hpp"
#include "book/tool/site_files.hpp"
#include "book/tool/terms.hpp"

namespace tumble::book {

namespace {

/// What a reader sees of Markdown, roughly: words of links, letters of formulas.
std::string visible_text(const std::string& markdown) {
  std::string linked, text;
  std::size_t at = 0;
  for (const Link& link : links_in(markdown)) {
    linked += markdown.substr(at, link.begin - at) + link.text;
    at = link.end;
  }
  for (const char c : linked + markdown.substr(at))
    if (std::string("*`$\\{}").find(c) == std::string::npos) text += c;
  return text;
}

std::string string_of(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

/// The content of the first <tag> behind a place; `end` is set behind it.
std::string content_of_tag(const std::string& xml, const std::string& tag, std::size_t& end) {
  const auto start = xml.find("<" + tag + ">", end);
  if (start == std::string::npos) return {};
  const auto begin = start + tag.size() + 2, close = xml.find("</" + tag + ">", begin);
  end = close;
  return xml.substr(begin, close - begin);
}

/// A member of a namespace, or a class: those are what a reader looks for.
bool is_looked_for(const std::string& name, const std::string& parent) {
  return name.find('<') == std::string::npos && parent.find("detail") == std::string::npos &&
         name.find("detail") == std::string::npos;
}

void add_members(const std::string& compound, const std::string& parent,
                 std::vector<Entry>& entries) {
  for (auto at = compound.find("<member kind="); at != std::string::npos;
       at = compound.find("<member kind=", at)) {
    const std::string name = content_of_tag(compound, "name", at);
    const std::string file = content_of_tag(compound, "anchorfile", at);
    const std::string anchor = content_of_tag(compound, "anchor", at);
    const Entry entry{std::string(file).append("#").append(anchor), "Reference",
                      std::string(parent).append("::").append(name), "", ""};
    const bool again = !entries.empty() && entries.back().section == entry.section;  // overloads
    if (is_looked_for(name, parent) && !again) entries.push_back(entry);
  }
}

}  // namespace

std::vector<Entry> entries_of(const fs::path& root, const Page& page) {
  const std::string address = address_of(root, page.file);
  const std::string title = visible_text(heading_in(page.lines.at(0)).text);
  std::vector<Entry> entries{{address, title, "", "", ""}};
  for (std::size_t i = 1; i < page.lines.size(); ++i)
    if (const Heading heading = heading_in(page.lines[i]); heading.level > 1)
      if (!is_inside(fences_of(page), i))
        entries.push_back({address + "#" + heading_id(root, page, heading.text), title,
                           visible_text(heading.text), "", ""});
  const auto entry_of = [&](const std::string& section) -> Entry& {
    for (Entry& entry : entries)
      if (entry.section == visible_text(section)) return entry;
    return entries.front();
  };
  for (const Paragraph& paragraph : paragraphs_of(page))
    entry_of(paragraph.section).text += visible_text(paragraph.text) + " ";
  for (const Term& term : terms_of(page)) entry_of(term.section).terms += term.name + ", ";
  return entries;
}

std::vector<Entry> names_in(const std::string& tags) {
  std::vector<Entry> entries;
  for (auto at = tags.find("<compound kind="); at != std::string::npos;) {
    const auto next = tags.find("<compound kind=", at + 1);
    const std::string compound = tags.substr(at, next - at);
    at = next;
    const std::string kind = compound.substr(16, compound.find('"', 16) - 16);
    std::size_t end = 0;
    const std::string name = content_of_tag(compound, "name", end);
    const std::string file = content_of_tag(compound, "filename", end);
    if (kind == "namespace") add_members(compound, name, entries);
    if ((kind == "class" || kind == "struct" || kind == "concept") && is_looked_for(name, name))
      entries.push_back({file, "Reference", name, "", ""});
  }
  return entries;
}

std::string script_of(const std::vector<Entry>& entries) {
  std::string script =
      "// Written by the book's tool: [address, page, section, terms, text].\n"
      "const tumbleIndex = [\n";
  for (const Entry& entry : entries)
    script += "[" + string_of(entry.address) + "," + string_of(entry.page) + "," +
              string_of(entry.section) + "," + string_of(entry.terms) + "," +
              string_of(entry.text) + "],\n";
  return script + "];\n";
}

void write_search_index(const fs::path& any_root, const fs::path& tags, const fs::path& file) {
  const fs::path root = fs::canonical(any_root);
  const SiteFiles files = site_files(root);
  std::vector<Entry> entries;
  const auto add = [&entries](const std::vector<Entry>& more) {
    entries.insert(entries.end(), more.begin(), more.end());
  };
  for (const fs::path& page : files.pages) add(entries_of(root, read_page(page)));
  for (const fs::path& folder : files.exercises) add(entries_of(root, exercise_page(root, folder)));
  if (fs::exists(tags)) add(names_in(text_of(tags)));
  write_text(file, script_of(entries));
}

}  // namespace tumble::book
