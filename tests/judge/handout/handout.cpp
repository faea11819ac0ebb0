#include "judge/handout/handout.hpp"

#include <regex>

#include "judge/course/contract.hpp"
#include "judge/course/dashes.hpp"
#include "judge/handout/dead_links.hpp"
#include "support/text_file.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

using Paths = std::set<fs::path>;

/// The folder of a path's tree ("chapters") and the one below it ("support"); empty if it is less
/// deep.
std::pair<std::string, std::string> upper_folders(const fs::path& path) {
  auto part = path.begin();
  const std::string tree = part->string();
  return {tree, ++part == path.end() ? "" : part->string()};
}

bool is_chapter(const std::string& folder) {
  return folder.size() > 3 && std::isdigit(static_cast<unsigned char>(folder[0])) &&
         folder[2] == '_';
}

/// What students must not see, and what only watches over the project; beside these, everything of
/// the chosen chapters is handed out.
bool is_kept_back(const fs::path& path, const TreeParts& parts) {
  const auto [tree, folder] = upper_folders(path);
  if (is_chapter(folder) && !parts.chapters.contains(folder))  // contracts speak of each other
    return path.filename() != "contract.hpp";
  if (tree == "solutions") return !parts.solutions;
  if (tree == "exercises")  // whatever has been tried in this tree: stubs are written anew
    return path.extension() != ".hpp" && path.extension() != ".md";
  return (tree == "tests" && folder == "project") || folder == "for_instructors";
}

/// Whether a file, from the root, belongs into the tree. At the top only what the project has there
/// is taken: a class's submissions, grades or settings may lie beside it.
bool belongs(const fs::path& path, const TreeParts& parts) {
  static const std::set<std::string> files = {"CMakeLists.txt", "CMakePresets.json", "LICENSE",
                                              "tumble",         ".clang-format",     ".clang-tidy",
                                              ".gitattributes", ".gitignore"};
  static const std::set<std::string> trees = {"chapters",  "lib",   "exercises",
                                              "solutions", "tests", ".devcontainer"};
  const std::string top = path.begin()->string();
  if (std::next(path.begin()) == path.end()) return files.contains(top);
  return trees.contains(top) && !is_kept_back(path, parts);
}

/// All files of the tree to be made, from the root.
Paths files_of(const fs::path& root, const TreeParts& parts) {
  Paths paths;
  for (auto it = fs::recursive_directory_iterator(root); it != fs::recursive_directory_iterator();
       ++it) {
    const fs::path path = it->path().lexically_relative(root);
    if (path == "build" || path == ".git") it.disable_recursion_pending();
    if (it->is_regular_file() && belongs(path, parts)) paths.insert(path);
  }
  return paths;
}

/// The page that greets students, with the chapters that they have.
std::string readme(const Course& course, const std::set<std::string>& chapters) {
  std::string list;
  for (const std::string& chapter : chapters) {
    const std::string page = support::read_text(course.root / "chapters" / chapter / "README.md");
    const std::string title = page.substr(2, page.find('\n') - 2);  // "# 4 Quaternions"
    list.append("- [" + title + "](chapters/").append(chapter);
    list.append("/README.md): exercises/").append(chapter).append("\n");
  }
  std::string text =
      support::read_text(course.root / "tests" / "judge" / "handout" / "students.md");
  const std::string place = "<!-- chapters -->\n";
  return text.replace(text.find(place), place.size(), list);
}

}  // namespace

std::set<std::string> chapters_meant(const Course& course, const std::string& text) {
  static const std::regex range(R"(\s*(\d{1,3})\s*(?:-\s*(\d{1,3})\s*)?)");
  const std::string plain = with_hyphens(text);
  std::set<std::string> chapters;
  std::size_t begin = 0;
  while (begin <= plain.size()) {
    const std::size_t end = std::min(plain.find(',', begin), plain.size());
    const std::string part = plain.substr(begin, end - begin);
    std::smatch match;
    require(std::regex_match(part, match, range), "'", part,
            "' is neither a chapter nor a range of chapters, such as 1-4 or 1-4,6");
    const int first = std::stoi(match[1]), last = match[2].matched ? std::stoi(match[2]) : first;
    require(first <= last, "'", part, "' is a range that ends before it begins");
    for (int number = first; number <= last; ++number)
      chapters.insert(course.select(std::to_string(number)).front().chapter);
    begin = end + 1;
  }
  return chapters;
}

void make_tree(const Course& course, const TreeParts& parts, const fs::path& to) {
  require(!fs::exists(to) || (fs::is_directory(to) && fs::is_empty(to)), to.string(),
          " exists already: nothing is overwritten");
  require(course.has_solutions(), "this tree is a hand-out itself");
  Paths paths = files_of(course.root, parts);
  paths.insert("README.md");
  for (const fs::path& path : paths) {
    if (path == "README.md") continue;
    const std::string text = support::read_text(course.root / path);
    support::write_text_and_folders(
        to / path, path.extension() == ".md" ? without_dead_links(text, path, paths) : text);
    fs::permissions(to / path, fs::status(course.root / path).permissions());
  }
  support::write_text_and_folders(to / "README.md", readme(course, parts.chapters));
  for (const Unit& unit : course.units)
    if (parts.chapters.contains(unit.chapter))
      support::write_text_and_folders(to / "exercises" / unit.chapter / (unit.name + ".cpp"),
                                      stub_of(course, unit));
}

}  // namespace tumble::judge
