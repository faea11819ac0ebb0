#include "book/tool/sidebar.hpp"

#include <algorithm>
#include <map>

#include "book/tool/addresses.hpp"
#include "book/tool/form.hpp"
#include "book/tool/html.hpp"
#include "book/tool/links.hpp"

namespace tumble::book {

namespace {

std::string page_title(const fs::path& file) {
  return heading_in(read_page(file).lines.at(0)).text;
}

/// Where a title alone does not say what a page is about.
std::string name_of(const fs::path& root, const fs::path& file) {
  static const std::map<std::string, std::string> names{
      {"chapters/README.md", "How the chapters are made"},
      {"tests/README.md", "How we test"},
      {"lib/README.md", "All names by topic"}};
  const auto name = names.find(fs::relative(file, root).string());
  return name == names.end() ? page_title(file) : name->second;
}

std::string section(const std::string& title, const std::string& items) {
  return items.empty() ? "" : "<h2>" + title + "</h2><ul>" + items + "</ul>";
}

class Sidebar {
 public:
  Sidebar(const fs::path& root, const SiteFiles& files) : root_(root), files_(files) {}

  std::string html() const {
    return section("Chapters", chapters()) + section("Beside them", pages("chapters")) +
           section("The library", item(root_ / "lib/README.md") + "<li>" +
                                      link_html("files.html", "All headers") + "</li>" + topics()) +
           section("The project", pages("tests") + pages(".github") + pages("CHANGELOG.md"));
  }

 private:
  std::string item(const fs::path& page) const {
    return "<li>" + link_html(address_of(root_, page), inline_html(name_of(root_, page))) + "</li>";
  }

  std::string chapters() const {
    std::string items;
    for (const fs::path& page : files_.pages) {
      if (!is_chapter(page)) continue;
      const bool first = page.filename() == "README.md";
      const std::string link = item(page).substr(4);
      const fs::path exercises = root_ / "exercises" / page.parent_path().filename();
      const bool has_exercises = std::find(files_.exercises.begin(), files_.exercises.end(),
                                           exercises) != files_.exercises.end();
      items += first ? "<li class=\"chapter\">" : "<li class=\"second\">";
      if (first && has_exercises)
        items += link_html(address_of(root_, exercises / "contract.hpp"), "exercises");
      items += link;
    }
    return items;
  }

  /// Those below a folder that are no chapters.
  std::string pages(const std::string& start) const {
    std::string items;
    for (const fs::path& page : files_.pages)
      if (*fs::relative(page, root_).begin() == start && !is_chapter(page)) items += item(page);
    return items;
  }

  /// "/// @defgroup free_body Free bodies" in a header that includes a topic.
  std::string topics() const {
    const std::string mark = "/// @defgroup ";
    std::map<std::string, std::string> titles;
    for (const auto& entry : fs::directory_iterator(root_ / "lib/include/tumble"))
      if (entry.is_regular_file())
        for (const std::string& line : read_page(entry.path()).lines)
          if (line.starts_with(mark)) {
            const auto space = line.find(' ', mark.size());
            titles[line.substr(mark.size(), space - mark.size())] = line.substr(space + 1);
          }
    std::string items;
    for (const auto& [name, title] : titles) {
      std::string file;  // as Doxygen writes it
      for (const char c : name) file += c == '_' ? "__" : std::string(1, c);
      items += "<li>" + link_html("group__" + file + ".html", title) + "</li>";
    }
    return items;
  }

  fs::path root_;
  const SiteFiles& files_;
};

}  // namespace

std::string sidebar_html(const fs::path& root, const SiteFiles& files) {
  return Sidebar(fs::canonical(root), files).html();
}

std::string folder_briefs(const fs::path& root) {
  std::string text;
  for (const std::string& line : read_page(root / "lib/README.md").lines) {
    const auto end = line.find("/` | ");
    if (!line.starts_with("| `") || end == std::string::npos) continue;
    const fs::path folder = root / "lib/include/tumble" / line.substr(3, end - 3);
    const std::string brief = line.substr(end + 5, line.size() - end - 7);
    if (fs::is_directory(folder))
      text += "/*! \\dir " + folder.string() + "\n\\brief " + brief + " */\n";
  }
  return text;
}

}  // namespace tumble::book
