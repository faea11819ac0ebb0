#include "judge/class/submissions.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "judge/build/submission.hpp"
#include "judge/class/file_kinds.hpp"
#include "judge/class/file_names.hpp"

namespace tumble::judge {

namespace {

bool is_hidden(const fs::path& name) { return name.string().starts_with("."); }

bool has_part(const fs::path& path, const std::string& name) {
  return std::any_of(path.begin(), path.end(),
                     [&](const fs::path& part) { return lower_case(part.string()) == name; });
}

/// Is it a checkout of the course, not some files of it?
bool is_whole_tree(const std::vector<fs::path>& paths) {
  return std::any_of(paths.begin(), paths.end(),
                     [](const fs::path& path) { return has_part(path, "exercises"); });
}

/// Which folders are the course's, not the student's. Where there is no exercises/, what lies in a
/// folder solutions/ is what was handed in.
std::vector<const char*> folders_of_the_course(const std::vector<fs::path>& paths) {
  std::vector<const char*> folders{"tests", "build", "__macosx"};
  if (is_whole_tree(paths)) folders.push_back("solutions");
  return folders;
}

/// How well a path fits a unit: 3 in exercises/, 2 in a folder of the chapter, 1 by its name alone,
/// 0 not at all.
int fit(const fs::path& path, const Unit& unit, bool only_one_of_that_name,
        const std::vector<const char*>& not_theirs) {
  std::vector<std::string> parts;
  for (const fs::path& part : path) parts.push_back(lower_case(part.string()));
  if (parts.empty() || exercise_named(parts.back()) != unit.name) return 0;
  for (const char* folder : not_theirs)
    if (std::find(parts.begin(), parts.end(), folder) != parts.end()) return 0;
  const std::size_t n = parts.size();
  if (n < 2 || parts[n - 2] != unit.chapter) return only_one_of_that_name ? 1 : 0;
  return n >= 3 && parts[n - 3] == "exercises" ? 3 : 2;
}

/// A file that could be meant.
struct Candidate {
  fs::path path;
  int fit;
  std::ptrdiff_t depth;
};

/// Does `a` count rather than `b`? The same on every machine: times of modification do not survive
/// archives.
bool counts_rather(const Candidate& a, const Candidate& b) {
  if (a.fit != b.fit) return a.fit > b.fit;
  if (a.depth != b.depth) return a.depth < b.depth;
  return natural_less(b.path, a.path);
}

/// The best of them first.
std::vector<Candidate> candidates(const Unit& unit, bool only_one_of_that_name,
                                  const std::vector<fs::path>& paths) {
  const std::vector<const char*> not_theirs = folders_of_the_course(paths);
  std::vector<Candidate> found;
  for (const fs::path& path : paths)
    if (const int how = fit(path, unit, only_one_of_that_name, not_theirs); how > 0)
      found.push_back({path, how, std::distance(path.begin(), path.end())});
  std::sort(found.begin(), found.end(), counts_rather);
  return found;
}

}  // namespace

std::vector<Part> parts_of(const Submission& submission) {
  return submission.parts.empty() ? std::vector<Part>{{"", submission.path}} : submission.parts;
}

std::vector<fs::path> files_below(const fs::path& folder) {
  constexpr std::size_t most = 100'000;
  std::vector<fs::path> paths;
  std::error_code unreadable;
  auto it = fs::recursive_directory_iterator(folder, unreadable);
  for (; it != fs::recursive_directory_iterator() && paths.size() < most;
       it.increment(unreadable)) {
    std::error_code gone;
    const bool is_folder = !it->is_symlink(gone) && it->is_directory(gone);
    if (is_folder && is_hidden(it->path().filename())) it.disable_recursion_pending();
    if (!is_folder) paths.push_back(it->path().lexically_relative(folder));
  }
  require_working_machine(folder, unreadable.value());  // the files behind it may be all there
  std::sort(paths.begin(), paths.end(),
            [](const fs::path& a, const fs::path& b) { return natural_less(a, b); });
  return paths;
}

std::vector<fs::path> hidden_sources_below(const fs::path& folder) {
  constexpr std::size_t most = 20'000;
  std::vector<fs::path> paths;
  std::error_code ignored;
  std::size_t seen = 0;
  auto it = fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied,
                                             ignored);
  for (; it != fs::recursive_directory_iterator() && ++seen < most; it.increment(ignored)) {
    const fs::path name = it->path().filename(), path = it->path().lexically_relative(folder);
    if (name == ".git") it.disable_recursion_pending();
    const fs::path within = path.parent_path();
    if (std::any_of(within.begin(), within.end(), is_hidden) && !is_clutter(name.string()) &&
        !source_stem(name.string()).empty() && it->is_regular_file(ignored))
      paths.push_back(path);
  }
  return paths;
}

std::map<std::string, ChosenFile> choose_files(const Course& course,
                                               const std::vector<Unit>& counted,
                                               const std::vector<fs::path>& paths) {
  std::map<std::string, int> names, names_counted;
  for (const Unit& unit : course.units) ++names[unit.name];
  for (const Unit& unit : counted) ++names_counted[unit.name];
  const auto has_name_alone = [&](const Unit& unit) {
    if (names_counted[unit.name] == 0) return names[unit.name] == 1;
    return names_counted[unit.name] == 1 &&
           std::any_of(counted.begin(), counted.end(),
                       [&](const Unit& each) { return each.id() == unit.id(); });
  };
  std::map<std::string, ChosenFile> chosen;
  for (const Unit& unit : course.units) {
    const std::vector<Candidate> found = candidates(unit, has_name_alone(unit), paths);
    if (found.empty()) continue;
    ChosenFile& file = chosen[unit.id()];
    file.path = found.front().path;
    for (std::size_t i = 1; i < found.size(); ++i) file.others.push_back(found[i].path);
  }
  return chosen;
}

std::vector<fs::path> not_exercises(const std::map<std::string, ChosenFile>& chosen,
                                    const std::vector<fs::path>& paths) {
  std::set<fs::path> known;
  for (const auto& [unit, file] : chosen) {
    known.insert(file.path);
    known.insert(file.others.begin(), file.others.end());
  }
  std::vector<const char*> not_theirs = folders_of_the_course(paths);
  if (is_whole_tree(paths)) not_theirs.insert(not_theirs.end(), {"chapters", "lib"});
  std::vector<fs::path> others;
  for (const fs::path& path : paths) {
    const bool of_course = std::any_of(not_theirs.begin(), not_theirs.end(),
                                       [&](const char* folder) { return has_part(path, folder); });
    const bool hidden =
        std::any_of(path.begin(), path.end(), [](const fs::path& part) { return is_hidden(part); });
    if (!of_course && !hidden && !known.contains(path)) others.push_back(path);
  }
  return others;
}

std::string folder_of_the_course(const fs::path& path, const std::vector<fs::path>& paths) {
  if (is_whole_tree(paths)) return "";
  const std::vector<const char*> folders = folders_of_the_course(paths);
  const auto found = std::find_if(folders.begin(), folders.end(),
                                  [&](const char* folder) { return has_part(path, folder); });
  return found == folders.end() ? "" : *found;
}

std::map<std::string, fs::path> files_of_units(const Course& course,
                                               const std::vector<Unit>& counted,
                                               const std::vector<fs::path>& paths) {
  std::map<std::string, fs::path> files;
  for (const auto& [unit, chosen] : choose_files(course, counted, paths)) files[unit] = chosen.path;
  return files;
}

}  // namespace tumble::judge
