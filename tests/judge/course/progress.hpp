#pragma once
/// @file
/// What the student has done so far, kept in the build folder between two commands.

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "judge/course/course.hpp"

namespace tumble::judge {

struct UnitProgress {
  int tries = 0;             ///< judgements of a file that somebody has written in
  std::string last;          ///< summary of the last verdict: "passed", "wrong", "crashed", …
  std::uint64_t source = 0;  ///< fingerprint of the file that it was about
  int hints = 0;             ///< how many were shown
};

class Progress {
 public:
  /// Reads what was kept; nothing is there the first time.
  /// @throws std::runtime_error if the file is there and cannot be understood
  explicit Progress(const Course& course);
  UnitProgress& of(const Unit& unit) { return units_[unit.id()]; }
  /// Passed, and the file has not changed since.
  bool is_done(const Unit& unit) const;
  /// The first unit that is not done.
  std::optional<Unit> next_open() const;
  /// What to write once `passed` has passed: an open unit of its chapter, else of a later one, else
  /// of an earlier one.
  std::optional<Unit> next_open_after(const Unit& passed) const;
  void save() const;

 private:
  const Course& course_;
  std::filesystem::path file_;
  std::map<std::string, UnitProgress> units_;
};

/// A number that changes with the text of a file; 0 if it is not a file (a link is none), huge, or
/// cannot be read.
std::uint64_t fingerprint(const std::filesystem::path& file);

}  // namespace tumble::judge
