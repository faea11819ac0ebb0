#include "judge/class/settings.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "judge/class/json_slips.hpp"
#include "judge/class/units_meant.hpp"
#include "judge/course/stable_hash.hpp"
#include "support/parsed_json.hpp"
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
      for (const Unit& unit : units_meant(course, each.text())) meant.insert(unit.id());
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

/// One entry of "weights".
struct Weight {
  std::string text;
  std::size_t meant;        ///< how many units, counted or not
  std::vector<Unit> units;  ///< those that count
  double points;
};

std::vector<Weight> weights_in(const Course& course, const Place& weights,
                               const CourseSettings& settings) {
  std::vector<Weight> all;
  for (const auto& [text, place] : weights.members()) {
    std::vector<Unit> units =
        place.refused_here([&, w = text] { return counted_units(course, settings.units, w); });
    all.push_back({text, units_meant(course, text).size(), std::move(units), weight(place)});
  }
  return all;
}

/// What is said of fewer units counts more: first of chapters, then of units.
void read_weights(const Course& course, const Place& place, CourseSettings& settings) {
  std::vector<Weight> weights = weights_in(course, place, settings);
  std::stable_sort(weights.begin(), weights.end(),
                   [](const Weight& a, const Weight& b) { return a.meant > b.meant; });
  std::map<std::string, const Weight*> last;  // that a unit has got its points from
  for (const Weight& each : weights)
    for (const Unit& unit : each.units) {
      const Weight*& before = last[unit.id()];
      require(!before || before->meant > each.meant, place.name(), " says twice what ", unit.number,
              " is worth: in \"", before ? before->text : "", "\" and in \"", each.text, "\"");
      before = &each;
      settings.weights[unit.id()] = each.points;
    }
}

void read_hidden(const Course& course, const Place& hidden, CourseSettings& settings) {
  require(!hidden.elements().empty(), hidden.name(), " is empty: leave it out if nothing is");
  for (const Place& each : hidden.elements())
    for (const Unit& unit :
         each.refused_here([&] { return counted_units(course, settings.units, each.text()); }))
      settings.hidden.insert(unit.id());
}

Credit read_credit(const Place& place) {
  const std::string credit = place.text();
  require(credit == "unit" || credit == "laws", place.name(), " is \"", credit,
          R"(", not "unit" (all laws or nothing) or "laws" (in proportion))");
  return credit == "unit" ? Credit::unit : Credit::laws;
}

std::uint64_t read_seed(const Place& place) {
  const double seed = place.number();
  require(seed >= 0 && seed <= 9e15 && seed == std::floor(seed), place.name(), " is ", seed,
          ", not a whole number in 0 … 9e15");
  return static_cast<std::uint64_t>(seed);
}

/// The value of a file's text; what is wrong with it is said in plain words, if we know it.
nlohmann::json json_in(const std::string& text, const std::string& name) {
  try {
    return support::parsed_json(text, name);
  } catch (const std::invalid_argument&) {
    const std::string slip = json_slip_in(text);
    if (slip.empty()) throw;
    throw std::invalid_argument(name + " is not valid JSON: " + slip);
  }
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
  if (place.has("hidden")) read_hidden(course, place["hidden"], settings);
  if (place.has("due")) settings.due = read_moment(place["due"]);
  if (place.has("seed")) settings.seed = read_seed(place["seed"]);
  if (place.has("curve")) settings.curve = place["curve"].yes();
  settings.rules = read_rules(course, settings.units, place);
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
  return settings_in(course, support::read_text(file), file.string());
}

CourseSettings settings_in(const Course& course, const std::string& text, const std::string& name) {
  const nlohmann::json json = json_in(text, name);
  return settings_of(course, Place(json, name));
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
