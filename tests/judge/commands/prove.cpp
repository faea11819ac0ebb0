/// @file
/// Proofs that the course is sound: the misconceptions and the stubs.
#include <iostream>
#include <memory>

#include "judge/build/object_cache.hpp"
#include "judge/commands/commands.hpp"
#include "judge/commands/matrix.hpp"
#include "judge/commands/misconceptions_page.hpp"
#include "judge/course/contract.hpp"
#include "judge/course/derivation.hpp"
#include "judge/course/hints.hpp"
#include "judge/verdict/judge_all.hpp"
#include "support/text_file.hpp"

namespace tumble::judge {

int matrix(const Course& course, const std::string& what, std::uint64_t seed) {
  return print_kill_matrix(std::cout, course, course.select(what), seed) ? 0 : 1;
}

int misconceptions_page(const Course& course, const std::string& what) {
  print_misconceptions(std::cout, course, course.select(what));
  return 0;
}

namespace {

bool is_stub(const Course& course, const Unit& unit) {
  return support::read_text(course.exercise(unit)) == stub_of(course, unit);
}

}  // namespace

int stubs(const Course& course) {
  bool sound = true;
  const auto complain = [&](const Unit& unit, const std::string& what) {
    std::cout << unit.number << " " << unit.name << ": " << what << "\n";
    sound = false;
  };
  for (const Unit& unit : course.units) {
    if (!is_stub(course, unit)) complain(unit, "is not the stub that its contract gives");
    read_hints(course, unit);
    if (fs::exists(course.page(unit)) && derivation_of(course, unit).empty())
      complain(unit, "is not written anywhere in " + course.page(unit).string());
  }
  const std::unique_ptr<const ObjectCache> earlier = objects_of_earlier(course);
  Judgement judgement;
  judgement.compiled = earlier.get();
  judge_all(
      course, course.units, [&](const Unit& unit) { return course.exercise(unit); }, judgement,
      [&](const UnitResult& result) {
        if (!result.untouched()) complain(result.unit, "its stub is judged " + result.summary());
      });
  std::cout << course.units.size() << " stubs, " << (sound ? "each fails every case" : "not sound")
            << "\n";
  return sound ? 0 : 1;
}

}  // namespace tumble::judge
