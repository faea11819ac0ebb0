#pragma once
/// @file
/// The quoted #includes of the tree, and the files that they mean.

#include <algorithm>
#include <filesystem>
#include <fstream>
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

}  // namespace tumble::house
