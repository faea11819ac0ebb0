/// @file
/// course.json: what it says, and what it cannot say.
#include "judge/class/settings.hpp"

#include <doctest/doctest.h>

#include <fstream>

#include "judge/build/work_folder.hpp"
#include "judge/class/moment.hpp"
#include "project/harness/refusal.hpp"

using namespace tumble::judge;

namespace {

Course course_of_three() {
  Course course;
  course.units = {{"1.1", "01_particles", "flatten", "", {}, {}},
                  {"4.1", "04_quaternions", "product", "", {}, {}},
                  {"4.2", "04_quaternions", "inverse", "", {}, {}}};
  return course;
}

CourseSettings settings(const std::string& json) {
  const WorkFolder folder;
  std::ofstream(folder.path() / "course.json") << json;
  return read_settings(course_of_three(), folder.path() / "course.json");
}

UnitRecord verdict(const std::string& unit, std::size_t laws, std::size_t hold) {
  UnitRecord record;
  record.unit = unit, record.laws = laws, record.laws_that_hold = hold;
  record.passed = laws > 0 && laws == hold;
  return record;
}

}  // namespace

TEST_CASE("settings: nothing said is one point a unit") {
  const CourseSettings all = settings("{}");
  CHECK(all.units.size() == 3);
  CHECK(all.most() == 3);
  CHECK(all.earned(verdict("04_quaternions/product", 5, 5)) == 1);
  CHECK(all.earned(verdict("04_quaternions/product", 5, 4)) == 0);
  CHECK_FALSE(all.seed.has_value());
}

TEST_CASE("settings: units, weights of chapters and of units, credit, hidden, due, seed") {
  const CourseSettings some = settings(R"({"title": "D", "units": ["4"], "credit": "laws",
    "weights": {"4.2": 5, "4": 2}, "hidden": ["inverse"], "due": "2026-12-01T23:59:00+01:00",
    "seed": 8231})");
  REQUIRE(some.units.size() == 2);
  CHECK(some.most() == 7);
  CHECK(some.earned(verdict("04_quaternions/inverse", 5, 4)) == 4);
  CHECK(some.earned(verdict("04_quaternions/product", 4, 4)) == 2);
  CHECK(some.earned(verdict("04_quaternions/product", 0, 0)) == 0);  // not built
  CHECK(some.earned(verdict("01_particles/flatten", 4, 4)) == 0);    // not asked for
  CHECK(some.is_hidden(verdict("04_quaternions/inverse", 1, 1)));
  CHECK_FALSE(some.is_hidden(verdict("04_quaternions/product", 1, 1)));
  CHECK(some.due == "2026-12-01T23:59:00+01:00");
  CHECK(some.seed == 8231);
}

TEST_CASE("settings: what means nothing is refused, and where it stands is said") {
  CHECK_REFUSED(settings("{"), "is not valid JSON");
  CHECK_REFUSED(settings(R"({"weight": {}})"), R"(has "weight", which means nothing here)");
  CHECK_REFUSED(settings(R"({"units": ["7"]})"),
                "course.json.units[0]: there is no exercise or chapter");
  CHECK_REFUSED(settings(R"({"units": []})"), "units is empty");
  CHECK_REFUSED(settings(R"({"units": "4"})"), "units is not a list");
  CHECK_REFUSED(settings(R"({"weights": {"4.1": -1}})"), "weights.4.1 is -1");
  CHECK_REFUSED(settings(R"({"weights": {"4.1": "two"}})"), "weights.4.1 is not a number");
  CHECK_REFUSED(settings(R"({"weights": {"9": 1}})"), "weights.9: there is no exercise or chapter");
  CHECK_REFUSED(settings(R"({"weights": {"all": 0}})"), "no exercise is worth any points");
  CHECK_REFUSED(settings(R"({"credit": "some"})"), "\"some\", not \"unit\"");
  CHECK_REFUSED(settings(R"({"due": "tomorrow"})"), "\"tomorrow\", not a time such as");
  CHECK_REFUSED(settings(R"({"due": "2026-12-01T23:59"})"), "not a time");  // in which zone?
  CHECK_REFUSED(settings(R"({"seed": 1.5})"), "not a whole number");
}

TEST_CASE("settings: ranges of chapters and of exercises") {
  CHECK(settings(R"({"units": ["1-4"]})").units.size() == 3);
  CHECK(settings(R"({"units": ["4.1-4.2"]})").units.size() == 2);
  CHECK(settings(R"({"units": ["flatten-product"]})").units.size() == 2);
  CHECK(settings(R"({"weights": {"1-4": 2, "4": 3, "4.2": 4}})").most() == 2 + 3 + 4);
  CHECK_REFUSED(settings(R"({"units": ["4-1"]})"), "units[0]: '4-1' is a range that ends before");
  CHECK_REFUSED(settings(R"({"units": ["1-7"]})"), "there is no exercise or chapter '7'");
  CHECK_REFUSED(settings(R"({"units": ["1-"]})"), "'1-' is half of a range");
  CHECK_REFUSED(settings(R"({"units": [" – 4"]})"), "is half of a range");
}

TEST_CASE("settings: what does not count has no weight and hides nothing") {
  CHECK_REFUSED(settings(R"({"units": ["4"], "weights": {"1.1": 2}})"),
                "weights.1.1: 1.1 does not count");
  CHECK_REFUSED(settings(R"({"units": ["4"], "hidden": ["4.1", "flatten"]})"),
                "hidden[1]: flatten does not count");
  CHECK(settings(R"({"units": ["4.1"], "weights": {"4": 2}, "hidden": ["4"]})").most() == 2);
  CHECK_REFUSED(settings(R"({"hidden": []})"), "hidden is empty");
}

TEST_CASE("settings: no points by hand, and none on top, for what does not count") {
  CHECK_REFUSED(settings(R"({"units": ["1.1"], "overrides": {"ben": {"4.1": 1, "reason": "x"}}})"),
                "overrides.ben.4.1: 4.1 does not count");
  CHECK_REFUSED(settings(R"({"units": ["4"], "extra": ["1.1"]})"), "extra[0]: 1.1 does not count");
}

TEST_CASE("settings: dashes and blanks as editors write them") {
  for (const char* dash : {"-", "\u2013", "\u2014", "\u2212", " \u2013 "})
    CHECK(settings(std::string(R"({"units": ["1.1)") + dash + R"(4.1"]})").units.size() == 2);
  CHECK(settings(R"({"units": [" 1.1 ", "product "]})").units.size() == 2);
}

TEST_CASE("settings: slips that other formats allow are said in plain words") {
  CHECK_REFUSED(settings("{\n  \u201cunits\u201d: [\"4\"]}"),
                "course.json is not valid JSON: line 2, column 3: the quote \u201c has to be the "
                "straight one, \"");
  CHECK_REFUSED(settings("{'units': [\"4\"]}"),
                "line 1, column 2: the quote ' has to be the double");
  CHECK_REFUSED(settings("{\"units\": [\"4\",\n]}"),
                "line 1, column 15: this comma has nothing behind it: delete it");
  CHECK_REFUSED(settings("{ // all\n}"), "line 1, column 3: a comment begins here");
  CHECK_REFUSED(settings("{\"title\": \"a // b, \u201cc\u201d\" \"seed\": 1}"), "line 1, column");
  CHECK(settings("{\"title\": \"a // b,] \u201cc\u201d\"}").units.size() == 3);
}

TEST_CASE("settings: what is said twice is refused") {
  CHECK_REFUSED(settings(R"({"seed": 1, "seed": 2})"), R"(course.json has "seed" twice)");
  CHECK_REFUSED(settings(R"({"weights": {"4.1": 1, "4.1": 2}})"),
                R"(course.json.weights has "4.1" twice)");
  CHECK_REFUSED(settings(R"({"weights": {"4.1": 1, "product": 2}})"),
                "says twice what 4.1 is worth", "product");
  CHECK(settings(R"({"weights": {"4.1": 1}, "title": "weights"})").most() == 3);
}

TEST_CASE("settings: the key that was probably meant is named") {
  CHECK_REFUSED(settings(R"({"weight": {}})"), "did you mean weights?");
  CHECK_REFUSED(settings(R"({"teams": {}})"), "there are: $schema, title, units");
  CHECK_REFUSED(settings(R"({"units": ["prodct"]})"), "did you mean product (4.1)?");
}

TEST_CASE("moments: only those that there are") {
  CHECK(exact_moment_of("1970-01-01T00:00:00Z") == 0);
  CHECK(exact_moment_of("2026-12-01T23:59:00+01:00") == 1'796'165'940);
  CHECK(exact_moment_of("2026-12-01T22:59Z") == 1'796'165'940);
  CHECK(exact_moment_of("2024-02-29T12:00:00.5-11:30") == 1'709'249'400);
  for (const char* none :
       {"2026-13-45T99:99:00Z", "2026-02-29T00:00:00Z", "2026-00-10T00:00:00Z",
        "2026-04-31T00:00:00Z", "2026-12-01T24:00:00Z", "2026-12-01T23:60:00Z",
        "2026-12-01T23:59:60Z", "2026-12-01T23:59:00+25:00", "2026-12-01T23:59:00+01:70",
        "2026-12-01T23:59:00", "2026-12-01", "", "tomorrow"})
    CHECK_MESSAGE(!exact_moment_of(none).has_value(), none);
  CHECK_REFUSED(settings(R"({"due": "2026-13-45T99:99:00Z"})"), "due is \"2026-13-45T99:99:00Z\"");
}

TEST_CASE("seeds: another one for each student, and the same each time") {
  CHECK(seed_of(7, "ann") == seed_of(7, "ann"));
  CHECK(seed_of(7, "ann") != seed_of(7, "bob"));
  CHECK(seed_of(7, "ann") != seed_of(8, "ann"));
}

TEST_CASE("settings: late work, extensions, overrides, several, extra") {
  const CourseSettings some = settings(R"({"due": "2026-12-01T12:00Z",
    "late": {"grace": 15, "per_day": 10, "days": 3}, "extensions": {"ben": "2026-12-08T12:00Z"},
    "overrides": {"cleo": {"4.1": 2, "reason": "r"}, "dan": {"points": 0, "reason": "s"}},
    "several": "best", "extra": ["4.2"]})");
  CHECK(some.rules.late->days == 3);
  CHECK(some.rules.extensions.at("ben") == "2026-12-08T12:00Z");
  CHECK(some.rules.overrides.at("cleo").units.at("04_quaternions/product") == 2);
  CHECK(some.rules.overrides.at("dan").points == 0);
  CHECK(some.rules.several == Several::best);
  CHECK(some.most() == 2);  // what is extra is not asked for
  CHECK_REFUSED(settings(R"({"late": {"per_day": 10}})"), ".late means nothing without \"due\"");
  CHECK_REFUSED(settings(R"({"due": "2026-12-01T12:00Z", "late": {"per_day": 101}})"),
                "late.per_day is 101, not in 0 … 100");
  CHECK_REFUSED(settings(R"({"extensions": {"ben": "tomorrow"}})"),
                "extensions.ben is \"tomorrow\", not a time");
  CHECK_REFUSED(settings(R"({"overrides": {"ben": {"points": 3}}})"), "ben has no \"reason\"");
  CHECK_REFUSED(settings(R"({"overrides": {"ben": {"4": 3, "reason": "r"}}})"),
                "overrides.ben.4 is more than one exercise");
  CHECK_REFUSED(settings(R"({"several": "first"})"), "not \"last\" or \"best\"");
}
