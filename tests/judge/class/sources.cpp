#include "judge/class/sources.hpp"

#include <algorithm>
#include <stdexcept>

#include "judge/build/source_code.hpp"
#include "judge/build/submission.hpp"
#include "judge/build/text_encoding.hpp"
#include "judge/class/archive.hpp"
#include "judge/class/file_kinds.hpp"
#include "judge/class/file_names.hpp"
#include "judge/class/unjudged_files.hpp"
#include "judge/course/progress.hpp"
#include "support/entry.hpp"
#include "support/nearest.hpp"
#include "support/text_file.hpp"

namespace tumble::judge {

namespace {

constexpr std::size_t most_archives = 20;  // in a student's folder

/// Is any folder of the path, or the file, hidden or an operating system's own?
bool is_nobodys(const fs::path& path) {
  return std::any_of(path.begin(), path.end(), [](const fs::path& part) {
    return part.string().starts_with(".") || is_clutter(part.string());
  });
}

/// "a.docx, main.cpp and 12 more"
std::string some_of(const std::vector<std::string>& names) {
  constexpr std::size_t most = 6;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i)
    text += (i == 0 ? "" : ", ") + escaped(names[i]);
  if (names.size() > most) text += " and " + std::to_string(names.size() - most) + " more";
  return text;
}

/// "hidden folders", or those that an operating system puts beside the files.
const char* kind_of_folders(const std::vector<fs::path>& files) {
  const bool of_system = std::all_of(files.begin(), files.end(), [](const fs::path& path) {
    return std::any_of(path.begin(), path.end(),
                       [](const fs::path& part) { return is_clutter(part.string()); });
  });
  return of_system ? "folders of the operating system" : "hidden folders";
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

/// What is said to the student of a file whose name no exercise has, or more than one; empty if
/// nothing is near.
std::string probably_meant(const Course& course, const std::string& file) {
  const std::string name = exercise_named(file);
  std::vector<std::string> names, chapters;
  for (const Unit& unit : course.units) {
    names.push_back(unit.name);
    if (unit.name == name) chapters.push_back(unit.chapter + "/");
  }
  if (chapters.size() > 1)
    return "it may be in " + chapters[0] + " or in " + chapters[1] + ", and lies in neither";
  if (chapters.size() == 1) return "it lies in a folder where no exercise of its name is";
  const std::optional<std::string> near = support::nearest(name, names);
  return near ? "it is not an exercise's name; did you mean " + *near + ".cpp?" : "";
}

/// A file that is read for being small and no link; else nothing.
std::optional<std::string> small_text(const fs::path& file) {
  constexpr std::uintmax_t most = 4 * largest_submission;
  std::error_code unreadable;
  if (!support::is_file(file)) return std::nullopt;
  if (const auto size = fs::file_size(file, unreadable); unreadable || size > most)
    return std::nullopt;
  try {
    return support::read_text(file);
  } catch (const std::runtime_error&) {
    return std::nullopt;  // the judge will say so
  }
}

/// Does a file still throw what the exercise throws as it was handed out?
bool is_unwritten(const fs::path& file) {
  const std::optional<std::string> text = small_text(file);
  return text && mentions(decoded(*text).text, "NotImplemented");
}

}  // namespace

Sources::Sources(const Course& course, const std::vector<Unit>& counted,
                 const Submission& submission)
    : course_(&course), refused_(submission.refused), notes_(submission.notes) {
  const fs::path whole = fs::absolute(submission.path).lexically_normal();
  folder_ = fs::is_directory(whole) ? whole : own_.path();
  if (!refused_.empty() || !submission.incomplete.empty()) return;
  for (Part part : parts_of(submission)) {
    part.path = fs::absolute(part.path).lexically_normal();
    add(part);
    if (!refused_.empty()) return;
  }
  choose(course, counted);
}

fs::path Sources::of(const Unit& unit) const {
  const auto found = of_unit_.find(unit.id());
  return found == of_unit_.end() ? folder_ / unit.chapter / (unit.name + ".cpp") : found->second;
}

std::optional<std::string> Sources::handed_in(const Unit& unit) const {
  const auto found = handed_in_.find(unit.id());
  if (found == handed_in_.end()) return std::nullopt;
  return found->second.string();
}

std::string Sources::as_handed_in(std::string text) const {
  for (const auto& [unit, name] : handed_in_)
    for (const std::string& file : spellings(of_unit_.at(unit)))
      text = replaced(std::move(text), file, escaped(name.string()));
  for (const fs::path& folder : {own_.path(), folder_})
    for (const std::string& start : spellings(folder / ""))
      text = replaced(std::move(text), start, "");
  return text;
}

/// A path as the console says it: it shortens what lies in the course's own tree.
std::vector<std::string> Sources::spellings(const fs::path& path) const {
  const fs::path inside = path.lexically_relative(fs::absolute(course_->root).lexically_normal());
  if (inside.empty() || *inside.begin() == ".." || *inside.begin() == ".") return {path.string()};
  return {path.string(), inside.string()};
}

void Sources::keep(const fs::path& folder, const std::vector<Unit>& units) const {
  for (const Unit& unit : units) {
    const fs::path kept = kept_source(folder, unit);
    const auto text = handed_in(unit) ? small_text(of(unit)) : std::nullopt;
    if (text)
      support::write_text_and_folders(kept, *text);
    else
      fs::remove(kept);
  }
}

void Sources::add(const Part& part) {
  if (!support::is_there(part.path))  // it was when the class was collected
    throw std::runtime_error(part.path.string() + " is gone since this grading began");
  if (fs::is_directory(fs::symlink_status(part.path)))
    add_folder(part.name, part.path);
  else if (!archive_stem(part.path.filename().string()).empty())
    add_archive(part.name, part.path);
  else
    add_file(part.name, part.path);
}

void Sources::add_folder(const std::string& within, const fs::path& folder) {
  std::error_code unreadable;
  const fs::directory_iterator first(folder, unreadable);
  if (unreadable) {
    require_working_machine(folder, unreadable.value());
    refused_ = "cannot be read: " + unreadable.message();
    return;
  }
  for (const fs::path& path : files_below(folder)) {
    const fs::path name = fs::path(within) / path;
    const bool is_archive = !archive_stem(path.filename().string()).empty();
    if (is_archive && !is_nobodys(path))
      add_archive(name.string(), folder / path);
    else
      add_file(name, folder / path);
  }
  for (const fs::path& path : hidden_sources_below(folder))
    hidden_.push_back(fs::path(within) / path);
}

/// @param within its name where it is one of several things; empty if it is all that was handed in
void Sources::add_archive(const std::string& within, const fs::path& archive) {
  if (++archives_ > most_archives) {
    if (archives_ == most_archives + 1)
      notes_.push_back("more than " + std::to_string(most_archives) +
                       " archives in it: the others were not read");
    return;
  }
  Unpacked unpacked = unpack(archive);
  if (!unpacked.refused.empty()) {
    if (within.empty())
      refused_ = unpacked.refused;
    else
      refused_archives_.push_back(within + " in it, which " + unpacked.refused);
    return;
  }
  for (const auto& [path, text] : unpacked.files) {
    const fs::path name = (fs::path(within) / path).lexically_normal();
    if (!is_nobodys(name)) support::write_text_and_folders(own_.path() / name, text);
    add_file(name, own_.path() / name);
  }
  for (const std::string& path : unpacked.others)
    if (!path.ends_with("/")) add_file((fs::path(within) / path).lexically_normal(), "");
  const std::string before = within.empty() ? "" : within + "/";
  for (const std::string& note : unpacked.notes) notes_.push_back(before + note);
}

void Sources::add_file(const fs::path& name, const fs::path& file) {
  const bool is_source = !source_stem(name.filename().string()).empty();
  if (is_nobodys(name.parent_path()) && is_source && !is_clutter(name.filename().string()))
    hidden_.push_back(name);
  else if (is_nobodys(name))
    passed_over_.push_back(name.string());
  else if (is_source)
    files_[name] = file;
  else
    others_.push_back(name.string());
}

void Sources::choose(const Course& course, const std::vector<Unit>& counted) {
  std::vector<fs::path> names;
  for (const auto& [name, file] : files_) names.push_back(name);
  const auto chosen = choose_files(course, counted, names);
  for (const auto& [unit, file] : chosen) {
    handed_in_[unit] = file.path;
    of_unit_[unit] = files_.at(file.path);
  }
  std::vector<Unit> without_file;
  for (const Unit& unit : counted) {
    if (!chosen.contains(unit.id())) {
      without_file.push_back(unit);
      continue;
    }
    note_ties(unit, chosen.at(unit.id()));
    convert(unit.id());
  }
  for (const Unit& unit : counted) note_work_in_solutions(unit);
  const bool any = without_file.size() < counted.size();
  if (any || refused_archives_.empty()) {
    for (const std::string& archive : refused_archives_) notes_.push_back("not read: " + archive);
    if (any) {
      note_other_names(course, not_exercises(chosen, names));
      for (std::string& note : notes_on_unjudged(without_file, names, others_))
        notes_.push_back(std::move(note));
    } else {
      note_nothing_found();
    }
    for (std::string& note : notes_on_hidden(course, without_file, hidden_))
      notes_.push_back(std::move(note));
  } else {
    refused_ = "has " + refused_archives_.front();
  }
}

void Sources::note_ties(const Unit& unit, const ChosenFile& chosen) {
  const std::uint64_t counted = fingerprint(files_.at(chosen.path));
  const bool differ =
      std::any_of(chosen.others.begin(), chosen.others.end(),
                  [&](const fs::path& other) { return fingerprint(files_.at(other)) != counted; });
  if (differ)
    notes_.push_back(std::to_string(chosen.others.size() + 1) + " files for " + unit.number +
                     ": counted " + escaped(chosen.path.string()));
}

void Sources::note_other_names(const Course& course, const std::vector<fs::path>& others) {
  constexpr std::size_t most_notes = 6;
  std::size_t said = 0;
  std::vector<std::string> strange;
  for (const fs::path& path : others) {
    const std::string meant = probably_meant(course, path.filename().string());
    if (meant.empty() || said == most_notes) {
      strange.push_back(path.string());
      continue;
    }
    ++said;
    notes_.push_back(escaped(path.string()) + " is not judged: " + meant);
  }
  if (!strange.empty())
    notes_.push_back("not judged, as no exercise has such a name: " + some_of(strange));
}

void Sources::note_work_in_solutions(const Unit& unit) {
  std::vector<fs::path> names;
  for (const auto& [name, file] : files_) names.push_back(name);
  const std::vector<fs::path> found = files_in_solutions(unit, names);
  const auto theirs = std::find_if(found.begin(), found.end(), [&](const fs::path& name) {
    return fingerprint(files_.at(name)) != fingerprint(course_->solution(unit));
  });
  if (theirs != found.end() && (!handed_in(unit) || is_unwritten(of(unit))))
    notes_.push_back(note_on_solutions(*theirs));
}

void Sources::note_nothing_found() {
  std::vector<std::string> found = others_;
  for (const auto& [name, file] : files_) found.push_back(name.string());
  std::sort(found.begin(), found.end(), [](const std::string& a, const std::string& b) {
    return natural_less(fs::path(a), fs::path(b));
  });
  std::string holds = "is empty";
  if (!found.empty())
    holds = "holds " + some_of(found);
  else if (!hidden_.empty())
    holds = std::string("holds ") + kind_of_folders(hidden_) + " only";
  else if (!passed_over_.empty())
    holds = "holds what is hidden or an operating system's own: " + some_of(passed_over_);
  notes_.push_back("no exercise found in it; it " + holds);
}

void Sources::convert(const std::string& unit) {
  const std::optional<std::string> bytes = small_text(of_unit_.at(unit));
  if (!bytes) return;
  const DecodedText text = decoded(*bytes);
  if (text.was.empty()) return;
  const fs::path name = handed_in_.at(unit), file = own_.path() / name;
  support::write_text_and_folders(file, text.text);
  of_unit_[unit] = file;
  notes_.push_back(escaped(name.string()) + " is " + text.was + ": converted to UTF-8");
}

}  // namespace tumble::judge
