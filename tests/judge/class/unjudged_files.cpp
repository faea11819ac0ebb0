#include "judge/class/unjudged_files.hpp"

#include <algorithm>
#include <optional>

#include "judge/class/file_kinds.hpp"
#include "judge/class/file_names.hpp"

namespace tumble::judge {

namespace {

std::string not_judged(const std::string& path) { return escaped(path) + " is not judged: "; }

/// The exercise that product.cc, product.txt or product would be with the right ending.
std::string exercise_without_ending(const std::string& path) {
  const std::string file = fs::path(path).filename().string();
  return exercise_named(file.substr(0, file.find('.')) + ".cpp");
}

/// ".work/, a hidden folder", "__MACOSX/, a folder of the operating system".
std::string unread_folder(const fs::path& path) {
  const auto of_system = std::find_if(
      path.begin(), path.end(), [](const fs::path& part) { return is_clutter(part.string()); });
  if (of_system != path.end())
    return escaped(of_system->string()) + "/, a folder of the operating system";
  const auto hidden = std::find_if(path.begin(), path.end(), [](const fs::path& part) {
    return part.string().starts_with(".");
  });
  return escaped((hidden == path.end() ? path.parent_path() : *hidden).string()) +
         "/, a hidden folder";
}

std::optional<std::string> note_on(const Unit& unit, const std::vector<fs::path>& sources,
                                   const std::vector<std::string>& others) {
  for (const fs::path& path : sources)
    if (exercise_named(path.filename().string()) == unit.name)
      if (const std::string folder = folder_of_the_course(path, sources); !folder.empty())
        return not_judged(path.string()) + "we look for no exercise in a folder " + folder + "/";
  for (const std::string& path : others)
    if (exercise_without_ending(path) == unit.name)
      return not_judged(path) + "it has to be called " + unit.name + ".cpp";
  return std::nullopt;
}

}  // namespace

std::vector<std::string> notes_on_unjudged(const std::vector<Unit>& without_file,
                                           const std::vector<fs::path>& sources,
                                           const std::vector<std::string>& others) {
  std::vector<std::string> notes;
  for (const Unit& unit : without_file)
    if (const auto note = note_on(unit, sources, others)) notes.push_back(*note);
  return notes;
}

std::vector<std::string> notes_on_hidden(const Course& course,
                                         const std::vector<Unit>& without_file,
                                         const std::vector<fs::path>& hidden) {
  const auto is_of = [&](const fs::path& path, const Unit& unit) {
    if (exercise_named(path.filename().string()) != unit.name) return false;
    const auto namesakes = std::count_if(course.units.begin(), course.units.end(),
                                         [&](const Unit& u) { return u.name == unit.name; });
    return namesakes == 1 || std::find(path.begin(), path.end(), unit.chapter) != path.end();
  };
  std::vector<std::string> notes;
  for (const Unit& unit : without_file) {
    const auto found = std::find_if(hidden.begin(), hidden.end(),
                                    [&](const fs::path& path) { return is_of(path, unit); });
    if (found != hidden.end())
      notes.push_back(not_judged(found->string()) + "it lies in " + unread_folder(*found));
  }
  return notes;
}

std::vector<fs::path> files_in_solutions(const Unit& unit, const std::vector<fs::path>& sources) {
  const auto has_part = [](const fs::path& path, const std::string& name) {
    return std::any_of(path.begin(), path.end(),
                       [&](const fs::path& part) { return lower_case(part.string()) == name; });
  };
  std::vector<fs::path> found;
  if (std::none_of(sources.begin(), sources.end(),
                   [&](const fs::path& path) { return has_part(path, "exercises"); }))
    return found;
  for (const fs::path& path : sources)
    if (has_part(path, "solutions") && has_part(path, unit.chapter) &&
        exercise_named(path.filename().string()) == unit.name)
      found.push_back(path);
  return found;
}

std::string note_on_solutions(const fs::path& path) {
  return not_judged(path.string()) +
         "beside a folder exercises/ we look for no exercise in a folder solutions/";
}

}  // namespace tumble::judge
