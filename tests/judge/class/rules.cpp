#include "judge/class/rules.hpp"

#include <cmath>

#include "judge/class/moment.hpp"
#include "judge/class/units_meant.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

using support::Place;

double number_between(const Place& place, double least, double most) {
  const double number = place.number();
  require(number >= least && number <= most, place.name(), " is ", number, ", not in ", least,
          " … ", most);
  return number;
}

LateRule read_late(const Place& place) {
  place.require_only({"grace", "per_day", "days"});
  LateRule rule;
  if (place.has("grace")) rule.grace = number_between(place["grace"], 0, 1e5);
  if (place.has("per_day")) rule.per_day = number_between(place["per_day"], 0, 100);
  if (place.has("days")) {
    const double days = number_between(place["days"], 0, 1e4);
    require(days == std::floor(days), place.name(), ".days is ", days, ", not a whole number");
    rule.days = static_cast<int>(days);
  }
  return rule;
}

Override read_override(const Course& course, const std::vector<Unit>& counted, const Place& place) {
  Override by_hand;
  for (const auto& [key, value] : place.members()) {
    if (key == "reason") {
      by_hand.reason = value.text();
    } else if (key == "points") {
      by_hand.points = number_between(value, 0, 1e6);
    } else {
      const auto units =
          value.refused_here([&, what = key] { return counted_units(course, counted, what); });
      require(units.size() == 1, value.name(), " is more than one exercise");
      by_hand.units[units.front().id()] = number_between(value, 0, 1e6);
    }
  }
  require(!by_hand.reason.empty(), place.name(), " has no \"reason\": the student will ask");
  require(by_hand.points || !by_hand.units.empty(), place.name(),
          R"( gives no points: {"points": 3, …} or {"1.3": 1, …})");
  return by_hand;
}

Several read_several(const Place& place) {
  const std::string which = place.text();
  require(which == "last" || which == "best", place.name(), " is \"", which,
          R"(", not "last" or "best")");
  return which == "last" ? Several::last : Several::best;
}

}  // namespace

std::string read_moment(const Place& place) {
  require(exact_moment_of(place.text()).has_value(), place.name(), " is \"", place.text(),
          R"(", not a time such as "2026-12-01T23:59:00Z" or "2026-12-01T23:59:00+01:00")");
  return place.text();
}

ClassRules read_rules(const Course& course, const std::vector<Unit>& counted,
                      const Place& settings) {
  ClassRules rules;
  if (settings.has("late")) {
    require(settings.has("due"), settings.name(), ".late means nothing without \"due\"");
    rules.late = read_late(settings["late"]);
  }
  if (settings.has("extensions"))
    for (const auto& [student, place] : settings["extensions"].members())
      rules.extensions[student] = read_moment(place);
  if (settings.has("overrides"))
    for (const auto& [student, place] : settings["overrides"].members())
      rules.overrides[student] = read_override(course, counted, place);
  if (settings.has("several")) rules.several = read_several(settings["several"]);
  if (settings.has("extra"))
    for (const Place& each : settings["extra"].elements())
      for (const Unit& unit :
           each.refused_here([&] { return counted_units(course, counted, each.text()); }))
        rules.extra.insert(unit.id());
  return rules;
}

}  // namespace tumble::judge
