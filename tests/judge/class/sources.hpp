#pragma once
/// @file
/// The source files of one submission, where the judge can read them: taken out of archives, and
/// as UTF-8.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "judge/build/work_folder.hpp"
#include "judge/class/submissions.hpp"

namespace tumble::judge {

/// Where a copy of a unit's file is kept.
inline fs::path kept_source(const fs::path& folder, const Unit& unit) {
  return folder / unit.chapter / (unit.name + ".cpp");
}

class Sources {
 public:
  /// Looks through a submission for the units that count.
  Sources(const Course& course, const std::vector<Unit>& counted, const Submission& submission);

  /// Why it is not looked at; empty if it is.
  const std::string& refused() const { return refused_; }
  /// What one should know: which of two files counted, what was found where no exercise is.
  const std::vector<std::string>& notes() const { return notes_; }

  /// The file of a unit; where it should be, if it was not handed in.
  fs::path of(const Unit& unit) const;
  /// The path of a unit's file as it was handed in; nothing if it was not.
  std::optional<std::string> handed_in(const Unit& unit) const;
  /// A text for the student, in which their files are called as in their submission.
  std::string as_handed_in(std::string text) const;

  /// Keeps a copy of each unit's file in a folder; of a unit without one, none is there then.
  void keep(const fs::path& folder, const std::vector<Unit>& units) const;

 private:
  void add(const Part& part);
  void add_folder(const std::string& within, const fs::path& folder);
  void add_archive(const std::string& within, const fs::path& archive);
  void add_file(const fs::path& name, const fs::path& file);
  void choose(const Course& course, const std::vector<Unit>& counted);
  void note_ties(const Unit& unit, const ChosenFile& chosen);
  void note_nothing_found();
  /// Of a unit without a file, or with the untouched one.
  void note_work_in_solutions(const Unit& unit);
  /// A file that no exercise is called is not judged: does its student know?
  void note_other_names(const Course& course, const std::vector<fs::path>& others);
  std::vector<std::string> spellings(const fs::path& path) const;
  /// Makes UTF-8 of a file that is in another encoding.
  void convert(const std::string& unit);

  const Course* course_;
  WorkFolder own_;  ///< for what is unpacked or converted
  fs::path folder_;
  std::string refused_;
  std::vector<std::string> notes_, refused_archives_;
  std::map<fs::path, fs::path> files_;    ///< where each is that was handed in, by its path there
  std::vector<std::string> others_;       ///< paths of what can be no source
  std::vector<std::string> passed_over_;  ///< paths of what is hidden or an operating system's own
  std::vector<fs::path> hidden_;          ///< paths of sources in hidden folders
  std::map<std::string, fs::path> handed_in_, of_unit_;
  std::size_t archives_ = 0;
};

}  // namespace tumble::judge
