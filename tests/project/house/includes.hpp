#pragma once
/// @file
/// The law of the house, read from the #includes: every arrow points down to lib/, nothing that
/// ships includes what does not, and no folders include each other in a circle.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace tumble::house {

namespace fs = std::filesystem;

/// One `#include "…"` of a file.
struct Include {
  fs::path from;      ///< the file, from the root of the tree
  std::size_t line;   ///< where it stands
  std::string text;   ///< what stands between the quotes
  fs::path resolved;  ///< the file that is meant, from the root; empty if there is none
};

namespace detail {

/// Where the build looks for an include, after the folder of the file itself.
inline const std::vector<fs::path> include_roots = {"lib/include", "lib", "exercises", "tests",
                                                    "chapters"};

inline bool starts_with(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
         folder.end();
}

/// Submissions of students, and a project downstream: they are not built as part of this one.
inline bool is_foreign(const fs::path& path) {
  return starts_with(path, "tests/project/attacks") ||
         starts_with(path, "tests/project/install/downstream") ||
         starts_with(path, "tests/project/judge/course");  // a course with include roots of its own
}

inline bool is_source(const fs::path& path) {
  return path.extension() == ".hpp" || path.extension() == ".inl" || path.extension() == ".cpp";
}

/// Every file under lib/, chapters/, exercises/, solutions/ and tests/, from the root: listed once,
/// as to ask the disk for each candidate of each include takes long.
inline std::set<fs::path> files_of(const fs::path& root) {
  std::set<fs::path> files;
  for (const char* tree : {"lib", "chapters", "exercises", "solutions", "tests"}) {
    if (!fs::exists(root / tree)) continue;  // a hand-out has no solutions
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / tree))
      if (entry.is_regular_file()) files.insert(entry.path().lexically_relative(root));
  }
  return files;
}

/// From the root; empty if the include leads out of the trees, or to no file.
inline fs::path resolved(const std::set<fs::path>& files, const fs::path& from,
                         const std::string& text) {
  std::vector<fs::path> candidates{from.parent_path() / text};
  if (*from.begin() == "solutions")  // a contract lies beside the stub
    candidates.push_back("exercises" / from.parent_path().filename() / text);
  for (const fs::path& folder : include_roots) candidates.push_back(folder / text);
  for (const fs::path& candidate : candidates)
    if (const auto file = files.find(candidate.lexically_normal()); file != files.end())
      return *file;
  return {};
}

inline std::vector<Include> includes_in(const fs::path& root, const std::set<fs::path>& files,
                                        const fs::path& file) {
  static const std::regex quoted(R"re(\s*#\s*include\s*"([^"]+)".*)re");
  std::vector<Include> includes;
  std::ifstream in(root / file);
  std::size_t number = 0;
  std::smatch match;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.find("include") != std::string::npos && std::regex_match(line, match, quoted))
      includes.push_back({file, number, match[1], resolved(files, file, match[1])});
  }
  return includes;
}

inline std::string at(const Include& include) {
  return include.from.string() + ":" + std::to_string(include.line) + " includes \"" +
         include.text + "\"";
}

/// The tree that a file belongs to, as the law speaks of it.
enum class Tree { library, floor, exercises, solutions, judge, specs, chapters, project, other };

inline Tree tree_of(const fs::path& path) {
  if (starts_with(path, "lib/include")) return Tree::library;
  if (starts_with(path, "lib")) return Tree::floor;
  if (starts_with(path, "exercises")) return Tree::exercises;
  if (starts_with(path, "solutions")) return Tree::solutions;
  if (starts_with(path, "chapters")) return Tree::chapters;
  if (starts_with(path, "tests/judge")) return Tree::judge;
  if (starts_with(path, "tests/project")) return Tree::project;
  if (starts_with(path, "tests")) return Tree::specs;
  return Tree::other;
}

/// The trees that a file may include, beside its own.
inline bool may_include(Tree from, Tree to) {
  switch (from) {
    case Tree::library:
      return to == Tree::library;
    case Tree::floor:
      return to == Tree::library || to == Tree::floor;
    case Tree::exercises:
      return to == Tree::exercises;
    case Tree::solutions:
      return to == Tree::exercises || to == Tree::solutions;
    case Tree::judge:
      return to == Tree::judge || to == Tree::exercises || to == Tree::library || to == Tree::floor;
    case Tree::specs:
      return to == Tree::specs || may_include(Tree::judge, to);
    case Tree::chapters:
      return to == Tree::chapters || to == Tree::library || to == Tree::floor;
    case Tree::project:
      return true;
    case Tree::other:
      return false;
  }
  return false;
}

/// "tests/04_quaternions", "chapters/tour": what is handed out, or not, as a whole.
inline fs::path upper_folder(const fs::path& path) {
  auto part = path.begin();
  const fs::path tree = *part++;
  return part == path.end() ? tree : tree / *part;
}

/// Each chapter ships without the others, and each program is complete in its folder.
inline bool is_of_another_part(const Include& include) {
  const Tree tree = tree_of(include.from);
  return (tree == Tree::specs || tree == Tree::chapters || tree == Tree::solutions) &&
         tree_of(include.resolved) == tree &&
         upper_folder(include.from) != upper_folder(include.resolved);
}

/// "lib/include/tumble/mass", "tests/judge/spec", "chapters/tour": a folder with those in it.
inline std::string room_of(const fs::path& path) {
  const std::size_t depth = starts_with(path, "lib/include") ? 4 : starts_with(path, "lib") ? 2 : 3;
  fs::path room;
  std::size_t parts = 0;
  for (const fs::path& part : path.parent_path())
    if (parts++ < depth) room /= part;
  return room.string();
}

using Arrows = std::map<std::string, std::set<std::string>>;

inline Arrows arrows_between_folders(const std::vector<Include>& includes) {
  Arrows arrows;
  for (const Include& include : includes) {
    if (include.resolved.empty()) continue;
    const std::string from = room_of(include.from), to = room_of(include.resolved);
    if (from != to) arrows[from].insert(to);
  }
  return arrows;
}

}  // namespace detail

/// Every quoted include of the C++ files under lib/, chapters/, exercises/, solutions/ and tests/,
/// but for submissions that attack the judge and programs outside the project.
inline std::vector<Include> includes_of(const fs::path& root) {
  const std::set<fs::path> files = detail::files_of(root);
  std::vector<Include> includes;
  for (const fs::path& file : files)
    if (detail::is_source(file) && !detail::is_foreign(file))
      for (Include& include : detail::includes_in(root, files, file))
        includes.push_back(std::move(include));
  return includes;
}

/// What is against the law, a sentence per include: "lib/a.hpp:3 includes tests/b.hpp: …".
inline std::vector<std::string> broken_laws(const std::vector<Include>& includes) {
  std::vector<std::string> broken;
  for (const Include& include : includes) {
    if (include.resolved.empty())
      broken.push_back(detail::at(include) + ": there is no such file in this tree");
    else if (!detail::may_include(detail::tree_of(include.from), detail::tree_of(include.resolved)))
      broken.push_back(detail::at(include) + ": this arrow does not point down to lib/");
    else if (detail::is_of_another_part(include))
      broken.push_back(detail::at(include) + ": what two chapters share belongs below them");
  }
  return broken;
}

/// The folders that include each other in a circle, as "a → b → a"; empty if there are none.
inline std::vector<std::string> circles(const std::vector<Include>& includes) {
  const detail::Arrows arrows = detail::arrows_between_folders(includes);
  std::vector<std::string> found, way;
  std::set<std::string> done;
  const std::function<void(const std::string&)> visit = [&](const std::string& folder) {
    const auto seen = std::find(way.begin(), way.end(), folder);
    if (seen != way.end()) {
      std::string circle;
      for (auto it = seen; it != way.end(); ++it) circle += *it + " → ";
      found.push_back(circle + folder);
      return;
    }
    if (!done.insert(folder).second) return;
    way.push_back(folder);
    if (const auto next = arrows.find(folder); next != arrows.end())
      for (const std::string& to : next->second) visit(to);
    way.pop_back();
  };
  for (const auto& [folder, to] : arrows) visit(folder);
  return found;
}

}  // namespace tumble::house
