#pragma once
/// @file
/// What an instructor decides about single students and late work, from the same course.json:
///
///     {"due": "2026-12-01T23:59:00+01:00",
///      "late": {"grace": 15, "per_day": 10, "days": 3},
///      "extensions": {"ben": "2026-12-08T23:59:00+01:00"},
///      "overrides": {"cleo": {"points": 3, "reason": "explained it in the tutorial"},
///                    "dan": {"1.3": 1, "reason": "the file was lost by us"}},
///      "several": "best", "extra": ["4.7"]}
///
/// Everything may be left out.

#include <map>
#include <optional>
#include <set>
#include <string>

#include "judge/course/course.hpp"
#include "support/place.hpp"

namespace tumble::judge {

/// What late work is worth.
struct LateRule {
  double grace = 0;         ///< minutes after the due date that are not late
  double per_day = 0;       ///< per cent of what was earned, for each day that has begun
  std::optional<int> days;  ///< later than that it is worth nothing
};

/// Which submission counts where a student has more than one.
enum class Several {
  refused,  ///< none: the instructor has to say
  last,     ///< that of the folder which was given last
  best,     ///< the one with the most points
};

/// Points that an instructor gives by hand.
struct Override {
  std::optional<double> points;         ///< of all
  std::map<std::string, double> units;  ///< of single units, by id
  std::string reason;
};

struct ClassRules {
  std::optional<LateRule> late;
  std::map<std::string, std::string> extensions;  ///< another due date, by student
  std::map<std::string, Override> overrides;      ///< by student
  Several several = Several::refused;
  std::set<std::string> extra;  ///< ids of units whose points come on top
};

/// @param counted the exercises that count: of others nothing can be said
/// @param settings the whole of course.json
/// @throws std::invalid_argument naming the place of what means nothing
ClassRules read_rules(const Course& course, const std::vector<Unit>& counted,
                      const support::Place& settings);

/// A moment that has to be exact.
/// @throws std::invalid_argument naming the place if it is none
std::string read_moment(const support::Place& place);

}  // namespace tumble::judge
