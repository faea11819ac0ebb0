#include "book/tool/source_pages.hpp"

#include <algorithm>
#include <vector>

#include "book/tool/html.hpp"
#include "book/tool/links.hpp"

namespace tumble::book {

namespace {

/// A fence that Doxygen colours as C++; any other text stays plain.
std::string fence_of(const fs::path& file) {
  const bool cpp = file.extension() == ".cpp" || file.extension() == ".hpp";
  const std::string text = text_of(file);
  return std::string("```") + (cpp ? "cpp" : "text") + "\n" + text +
         (text.ends_with("\n") ? "" : "\n") + "```\n";
}

/// The first sentence of a source file's comment: "1.3 euler_step: its laws, and what goes wrong."
std::string about(const fs::path& file) {
  const std::vector<std::string> lines = read_page(file).lines;
  for (std::size_t i = 0; i + 1 < std::min<std::size_t>(lines.size(), 4); ++i)
    if (lines[i] == "/// @file" && lines[i + 1].starts_with("/// ")) return lines[i + 1].substr(4);
  return {};
}

/// What the folders of a chapter hold, as a title.
std::string folder_title(const fs::path& path) {
  const std::string chapter = path.filename().string();
  if (*path.begin() == "solutions") return "Solutions: " + chapter;
  if (*path.begin() == "tests" && path.string().find('/') == path.string().rfind('/'))
    return "Specifications: " + chapter;
  return path.string();
}

Page folder_page(const fs::path& root, const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::string text = "# " + folder_title(fs::relative(folder, root)) + "\n\nThe files of `" +
                     fs::relative(folder, root).string() + "`.\n\n";
  for (const fs::path& file : files)
    text += "## " + file.filename().string() + "\n\n" + about(file) +
            "\n\n<details><summary>Show it</summary>\n\n" + fence_of(file) + "\n</details>\n\n";
  return page_of(folder / "README.md", text);
}

/// A drawing that is too large for the page that tells of it.
Page drawing_page(const fs::path& svg) {
  const std::string text = text_of(svg), start = "<title>";
  const auto begin = text.find(start) + start.size();
  const std::string title = text.substr(begin, text.find("</title>", begin) - begin);
  return page_of(svg, "# " + title + "\n\n![" + title + "](" + svg.filename().string() + ")\n");
}

}  // namespace

Page source_page(const fs::path& root, const fs::path& what) {
  if (fs::is_directory(what)) return folder_page(root, what);
  if (what.extension() == ".svg") return drawing_page(what);
  return page_of(what, "# " + fs::relative(what, root).string() + "\n\n" + fence_of(what));
}

}  // namespace tumble::book
