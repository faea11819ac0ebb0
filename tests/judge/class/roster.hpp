#pragma once
/// @file
/// Who is in the class: a table of one's own, Moodle's grading worksheet, Canvas's gradebook, or
/// Gradescope's roster. Its columns are known by their names.

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "judge/class/csv_table.hpp"
#include "judge/class/lms.hpp"
#include "judge/class/submissions.hpp"

namespace tumble::judge {

struct Member {
  Identity who;
  std::string login;      ///< or another name that a folder could have
  std::string handed_in;  ///< when, if the table says so
  std::size_t row = 0;    ///< in the table
};

struct Roster {
  CsvTable table;
  Lms lms = Lms::none;  ///< whose table it is
  std::vector<Member> members;
};

/// Finds members by what submissions are called; in a class of thousands, too.
class MemberFinder {
 public:
  /// @param roster it stays where it is, and as it is
  explicit MemberFinder(const Roster& roster);

  /// Who has handed this in; null if nobody in the class, or not one alone.
  const Member* find(const Submission& submission) const;
  /// Everybody who is called like this submission.
  std::set<const Member*> all_named(const Submission& submission) const;

 private:
  std::map<std::string, const Member*> by_id_;
  std::map<std::string, std::set<const Member*>> by_name_;  ///< letters and digits of each name
};

/// @throws std::invalid_argument if the file is no table, has no column with names, or gives two
///         students one number
Roster read_roster(const std::filesystem::path& file);
/// The same of a file's text, called by this name in messages.
Roster roster_in(const std::string& text, const std::string& name);

struct RosterMatch {
  std::vector<Member> missing;         ///< those of the class who have handed in nothing
  std::vector<std::string> strangers;  ///< who has handed in and is not in the class
};

/// Gives each submission its student's name, number and time from the roster.
/// @throws std::invalid_argument if two rows would be of one student: which of them counts?
RosterMatch match(const Roster& roster, std::vector<Submission>& submissions);

}  // namespace tumble::judge
