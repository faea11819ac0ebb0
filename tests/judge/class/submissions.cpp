#include "judge/class/submissions.hpp"

#include <algorithm>
#include <iterator>

#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

/// "meyer" for meyer.tar.gz; empty for what is no archive.
std::string name_of_archive(const std::string& file) {
  for (const char* ending : {".zip", ".tar", ".tar.gz", ".tgz", ".tar.xz", ".tar.zst"})
    if (file.ends_with(ending) && file.size() > std::string(ending).size())
      return file.substr(0, file.size() - std::string(ending).size());
  return "";
}

/// A submission, or one without a name for what is none.
Submission submission_at(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  if (name.starts_with(".") || entry.is_symlink()) return {};
  if (entry.is_directory()) return {name, entry.path(), false};
  if (entry.is_regular_file()) return {name_of_archive(name), entry.path(), true};
  return {};
}

bool is_hidden(const fs::path& name) { return name.string().starts_with("."); }

bool has_part(const fs::path& path, const char* name) {
  return std::find(path.begin(), path.end(), name) != path.end();
}

/// Which folders are the course's, not the student's. Where there is no exercises/, what lies in a
/// folder solutions/ is what was handed in.
std::vector<const char*> folders_of_the_course(const std::vector<fs::path>& paths) {
  const bool whole = std::any_of(paths.begin(), paths.end(),
                                 [](const fs::path& path) { return has_part(path, "exercises"); });
  return whole ? std::vector{"solutions", "tests", "build"} : std::vector{"tests", "build"};
}

/// How well a path fits a unit: 3 in exercises/, 2 in a folder of the chapter, 1 by its name alone,
/// 0 not at all.
int fit(const fs::path& path, const Unit& unit, bool only_one_of_that_name,
        const std::vector<const char*>& not_theirs) {
  std::vector<std::string> parts;
  for (const fs::path& part : path) parts.push_back(part.string());
  if (parts.empty() || parts.back() != unit.name + ".cpp") return 0;
  for (const char* folder : not_theirs)
    if (has_part(path, folder)) return 0;
  const std::size_t n = parts.size();
  if (n < 2 || parts[n - 2] != unit.chapter) return only_one_of_that_name ? 1 : 0;
  return n >= 3 && parts[n - 3] == "exercises" ? 3 : 2;
}

}  // namespace

std::vector<Submission> submissions_in(const std::vector<fs::path>& folders) {
  std::vector<Submission> all;
  for (const fs::path& folder : folders) {
    require(fs::is_directory(folder), folder.string(), " is no folder");
    const std::size_t before = all.size();
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      Submission submission = submission_at(entry);
      if (!submission.student.empty()) all.push_back(std::move(submission));
    }
    require(all.size() > before, folder.string(),
            " holds no submissions: neither folders nor archives");
  }
  const auto by_name = [](const Submission& a, const Submission& b) {
    return a.student < b.student;
  };
  std::sort(all.begin(), all.end(), by_name);
  for (std::size_t i = 1; i < all.size(); ++i)
    require(all[i].student != all[i - 1].student, "two submissions have the name ", all[i].student,
            ": ", all[i - 1].path.string(), " and ", all[i].path.string());
  return all;
}

std::vector<fs::path> files_below(const fs::path& folder) {
  constexpr std::size_t most = 100'000;
  std::vector<fs::path> paths;
  std::error_code unreadable;  // what cannot be read was not handed in
  auto it = fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied,
                                             unreadable);
  for (; it != fs::recursive_directory_iterator() && paths.size() < most;
       it.increment(unreadable)) {
    if (it->is_directory() && is_hidden(it->path().filename())) it.disable_recursion_pending();
    if (!it->is_symlink() && it->is_directory()) continue;
    paths.push_back(it->path().lexically_relative(folder));
  }
  return paths;
}

std::map<std::string, fs::path> files_of_units(const Course& course,
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
  const std::vector<const char*> not_theirs = folders_of_the_course(paths);
  std::map<std::string, fs::path> found;
  for (const Unit& unit : course.units) {
    int best = 0;
    std::ptrdiff_t depth = 0;
    for (const fs::path& path : paths) {
      const int how = fit(path, unit, has_name_alone(unit), not_theirs);
      const std::ptrdiff_t deep = std::distance(path.begin(), path.end());
      if (how == 0 || how < best || (how == best && deep >= depth)) continue;
      best = how, depth = deep;
      found[unit.id()] = path;
    }
  }
  return found;
}

}  // namespace tumble::judge
