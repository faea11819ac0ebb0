#include "judge/class/settings.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "judge/course/stable_hash.hpp"
#include "support/place.hpp"
#include "support/text_file.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

using support::Place;

/// The units that the elements of a list mean, in the course's order.
std::vector<Unit> units_in(const Course& course, const Place& list) {
  std::set<std::string> meant;
  for (const Place& each : list.elements())
    each.refused_here([&] {
      for (const Unit& unit : course.select(each.text())) meant.insert(unit.id());
    });
  std::vector<Unit> units;
  for (const Unit& unit : course.units)
    if (meant.contains(unit.id())) units.push_back(unit);
  require(!units.empty(), list.name(), " is empty: leave it out for all exercises");
  return units;
}

double weight(const Place& place) {
  const double points = place.number();
  require(points >= 0 && points <= 1e6, place.name(), " is ", points, ", not in 0 … 1e6 points");
  return points;
}

/// Weights of chapters first: those of units count more.
void read_weights(const Course& course, const Place& weights, CourseSettings& settings) {
  for (const bool of_units : {false, true})
    for (const auto& [what, place] : weights.members()) {
      const std::vector<Unit> units =
          place.refused_here([&, w = what] { return course.select(w); });
      if ((units.size() == 1) != of_units) continue;
      for (const Unit& unit : units)
        if (settings.weights.contains(unit.id())) settings.weights[unit.id()] = weight(place);
    }
}

Credit read_credit(const Place& place) {
  const std::string credit = place.text();
  require(credit == "unit" || credit == "laws", place.name(), " is \"", credit,
          R"(", not "unit" (all laws or nothing) or "laws" (in proportion))");
  return credit == "unit" ? Credit::unit : Credit::laws;
}

std::string read_time(const Place& place) {
  static const std::regex iso(
      R"(\d{4}-\d{2}-\d{2}T\d{2}:\d{2}(:\d{2}(\.\d+)?)?(Z|[+-]\d{2}:\d{2}))");
  require(std::regex_match(place.text(), iso), place.name(), " is \"", place.text(),
          R"(", not a time such as "2026-12-01T23:59:00Z" or "2026-12-01T23:59:00+01:00")");
  return place.text();
}

std::uint64_t read_seed(const Place& place) {
  const double seed = place.number();
  require(seed >= 0 && seed <= 9e15 && seed == std::floor(seed), place.name(), " is ", seed,
          ", not a whole number in 0 … 9e15");
  return static_cast<std::uint64_t>(seed);
}

CourseSettings settings_of(const Course& course, const Place& place) {
  place.require_only({"$schema", "title", "units", "weights", "credit", "hidden", "due", "seed",
                      "curve", "late", "extensions", "overrides", "several", "extra"});
  CourseSettings settings = default_settings(course);
  if (place.has("title")) settings.title = place["title"].text();
  if (place.has("units")) {
    settings.units = units_in(course, place["units"]);
    settings.weights.clear();
    for (const Unit& unit : settings.units) settings.weights[unit.id()] = 1;
  }
  if (place.has("weights")) read_weights(course, place["weights"], settings);
  if (place.has("credit")) settings.credit = read_credit(place["credit"]);
  if (place.has("hidden"))
    for (const Unit& unit : units_in(course, place["hidden"])) settings.hidden.insert(unit.id());
  if (place.has("due")) settings.due = read_time(place["due"]);
  if (place.has("seed")) settings.seed = read_seed(place["seed"]);
  if (place.has("curve")) settings.curve = place["curve"].yes();
  settings.rules = read_rules(course, place);
  require(settings.most() > 0, place.name(), ": no exercise is worth any points");
  return settings;
}

}  // namespace

double CourseSettings::most() const {
  double sum = 0;
  for (const Unit& unit : units)
    if (!rules.extra.contains(unit.id())) sum += points(unit);
  return sum;
}

bool CourseSettings::wants_curve(const Course& course) const {
  const auto counts = [&](const Unit& unit) {
    return std::any_of(units.begin(), units.end(),
                       [&](const Unit& each) { return each.chapter == unit.chapter; });
  };
  return curve.value_or(std::all_of(course.units.begin(), course.units.end(), counts));
}

double CourseSettings::earned(const UnitRecord& record) const {
  const auto of_unit = weights.find(record.unit);
  if (of_unit == weights.end()) return 0;
  if (record.passed) return of_unit->second;
  if (credit == Credit::unit || record.laws == 0) return 0;
  return of_unit->second * static_cast<double>(record.laws_that_hold) /
         static_cast<double>(record.laws);
}

CourseSettings default_settings(const Course& course) {
  CourseSettings settings;
  settings.units = course.units;
  for (const Unit& unit : course.units) settings.weights[unit.id()] = 1;
  return settings;
}

CourseSettings read_settings(const Course& course, const std::filesystem::path& file) {
  nlohmann::json json;
  try {
    json = nlohmann::json::parse(support::read_text(file));
  } catch (const nlohmann::json::exception& error) {
    throw std::invalid_argument(file.string() + " is no JSON: " + error.what());
  }
  return settings_of(course, Place(json, file.string()));
}

CourseSettings settings_or_default(const Course& course,
                                   const std::optional<std::filesystem::path>& file) {
  return file ? read_settings(course, *file) : default_settings(course);
}

std::uint64_t seed_of(std::uint64_t course_seed, const std::string& student) {
  const std::uint64_t h = stable_hash(student, stable_hash(std::to_string(course_seed)));
  return (h ^ (h >> 29)) % 1'000'000'000 + 1;
}

}  // namespace tumble::judge
