/// @file
/// What students read fits every platform, whatever their code has printed.
#include "judge/platforms/fitted.hpp"

#include <doctest/doctest.h>

#include "judge/platforms/results.hpp"
#include "project/judge/platforms/files.hpp"
#include "project/judge/platforms/schemas.hpp"

using namespace tumble::judge;
using tumble::test::contains;

namespace {

/// Units 1.1, 1.2, …, each with this explanation.
StudentRecord record_with(int units, const std::string& explanation) {
  StudentRecord record;
  for (int i = 1; i <= units; ++i) {
    UnitRecord unit;
    unit.unit = "01_particles/unit" + std::to_string(i);
    unit.number = "1." + std::to_string(i);
    unit.explanation = explanation;
    record.units.push_back(std::move(unit));
  }
  return record;
}

CourseSettings settings_for(const StudentRecord& record) {
  Course course;
  for (const UnitRecord& unit : record.units)
    course.units.push_back(
        {unit.number, "01_particles", unit.unit.substr(unit.unit.find('/') + 1), "", {}, {}});
  return default_settings(course);
}

std::size_t size_of(const StudentRecord& record) {
  std::size_t sum = 0;
  for (const UnitRecord& unit : record.units) sum += unit.explanation.size();
  return sum;
}

}  // namespace

TEST_CASE("fitted: what is short stays as it is") {
  const std::string words = "✗ 4.1 product\n\n  the law\n";
  CHECK(fitted(record_with(54, words)).units.back().explanation == words);
}

TEST_CASE("fitted: a line without end, and lines without end") {
  const std::string line = fitted(record_with(1, std::string(68'000, 'x'))).units[0].explanation;
  CHECK(line == std::string(most_of_line, 'x') + "…\n");
  std::string lines;
  for (int i = 0; i < 20'000; ++i) lines += "line\n";
  const std::string cut = fitted(record_with(1, lines)).units[0].explanation;
  CHECK(cut.size() <= most_of_unit);
  CHECK(contains(cut, "the rest is left out"));
}

TEST_CASE("fitted: all together have a bound, and what some do not need is the others'") {
  const std::string flood(60'000, '\n');
  CHECK(size_of(fitted(record_with(54, flood))) <= most_in_all);
  CHECK(size_of(fitted(record_with(2000, flood))) <= most_in_all + 2000 * 40);
  StudentRecord one_floods = record_with(54, "passed\n");
  one_floods.units.back().explanation = flood;
  CHECK(fitted(one_floods).units.back().explanation.size() > most_of_unit / 2);
}

TEST_CASE("fitted: no character is cut in two") {
  std::string umlauts;
  for (int i = 0; i < 1000; ++i) umlauts += "ü";
  for (const char* shift : {"", "a"}) {
    const std::string cut = fitted(record_with(1, shift + umlauts)).units[0].explanation;
    CHECK_NOTHROW(
        static_cast<void>(nlohmann::json(cut).dump()));  // dump() refuses text that is not UTF-8
  }
}

TEST_CASE("results of 54 floods are far below what platforms take") {
  std::string flood;
  for (int i = 0; i < 70'000; ++i) flood += i % 50 == 0 ? '\n' : '"';  // each takes two bytes
  const StudentRecord record = record_with(54, flood);
  const CourseSettings settings = settings_for(record);
  CHECK(prairielearn_results(settings, record, "").size() < 500'000);
  CHECK(gradescope_results(settings, record, "").size() < 500'000);
  CHECK(markdown_results(settings, record).size() < 125'000);
}

TEST_CASE("without hidden: neither words nor verdict") {
  StudentRecord record = record_with(2, "why");
  record.units[0].summary = record.units[1].summary = "wrong";
  CourseSettings settings = settings_for(record);
  settings.hidden = {record.units[1].unit};
  const StudentRecord shown = without_hidden(settings, record);
  CHECK(shown.units[0].explanation == "why");
  CHECK(shown.units[1].explanation.empty());
  CHECK(shown.units[1].summary == "hidden");
}
