#pragma once
/// @file
/// The law of the house, read from the #includes: every arrow points down to lib/, nothing that
/// ships includes what does not, and no folders include each other in a circle.

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "project/house/includes.hpp"

namespace tumble::house {

namespace detail {

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
