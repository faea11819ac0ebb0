#pragma once
/// @file
/// What an instructor decides about a course, from a small file:
///
///     {"title": "Dynamics, winter 2026", "units": ["1", "2", "4.1"], "weights": {"4": 2, "4.7":
///     5},
///      "credit": "laws", "hidden": ["4.7"], "due": "2026-12-01T23:59:00Z", "seed": 8231,
///      "curve": true}
///
/// Everything may be left out.

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "judge/class/rules.hpp"
#include "judge/course/course.hpp"
#include "judge/verdict/unit_record.hpp"

namespace tumble::judge {

/// What earns the points of a unit.
enum class Credit {
  unit,  ///< all of them when every law holds, else none
  laws,  ///< as many as laws hold, in proportion
};

struct CourseSettings {
  std::string title = "tumble";
  std::vector<Unit> units;                ///< those that count, in the course's order
  std::map<std::string, double> weights;  ///< points of each of them, by id
  Credit credit = Credit::unit;
  std::set<std::string> hidden;    ///< ids: students see them after the due date
  std::optional<std::string> due;  ///< ISO 8601, with a time zone
  std::optional<std::uint64_t>
      seed;  ///< of all inputs; each student's follows from it and the name
  /// Whether the curves of a student's own engine come with the grade; if not said, where all
  /// chapters count.
  std::optional<bool> curve;
  ClassRules rules;  ///< about single students and late work

  double points(const Unit& unit) const { return weights.at(unit.id()); }
  /// Of all units but those that are extra.
  double most() const;
  bool wants_curve(const Course& course) const;
  bool is_hidden(const UnitRecord& record) const { return hidden.contains(record.unit); }
  /// What a verdict earns, of points(unit).
  double earned(const UnitRecord& record) const;
};

/// One point a unit, everything shown.
CourseSettings default_settings(const Course& course);

/// Reads what an instructor has written.
/// @throws std::invalid_argument naming the file and the place of what means nothing
CourseSettings read_settings(const Course& course, const std::filesystem::path& file);

/// The same of a file's text, called by this name in messages.
CourseSettings settings_in(const Course& course, const std::string& text, const std::string& name);

/// The one or the other.
CourseSettings settings_or_default(const Course& course,
                                   const std::optional<std::filesystem::path>& file);

/// The seed of one student's inputs: another one for each, the same each time.
std::uint64_t seed_of(std::uint64_t course_seed, const std::string& student);

}  // namespace tumble::judge
