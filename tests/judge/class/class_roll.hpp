#pragma once
/// @file
/// Who is in a class, and what a platform and a roster say about them: all that its tables need
/// besides the records.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "judge/class/collect.hpp"
#include "judge/class/roster.hpp"

namespace tumble::judge {

struct ClassRoll {
  std::vector<Submission> submissions;  ///< by the students' names
  std::vector<LeftOut> left_out;        ///< entries that are nobody's work
  Lms lms = Lms::none;                  ///< whose download it is
  std::optional<Roster> roster;
  std::string roster_text;  ///< the file's, if there is one
  RosterMatch match;        ///< who has handed in nothing, and who is not on the roster
};

/// What shards of one class have to agree about: all of it but what was left out, which is called
/// by the path that each of them was given.
nlohmann::ordered_json json_of(const ClassRoll& roll);

/// The inverse. A submission has no path and no parts then: it is judged, or is somebody else's to
/// judge.
/// @throws nlohmann::json::exception if something is missing or of another type
ClassRoll class_roll_of(const nlohmann::ordered_json& json);

}  // namespace tumble::judge
