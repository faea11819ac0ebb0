#include <iomanip>
#include <iostream>

#include "judge/commands/commands.hpp"
#include "judge/course/contract.hpp"
#include "judge/course/progress.hpp"

namespace tumble::judge {

namespace {

std::string state_of(const Course& course, Progress& progress, const Unit& unit) {
  if (progress.is_done(unit)) return "passed";
  const UnitProgress& known = progress.of(unit);
  const std::uint64_t now = fingerprint(course.exercise(unit));
  if (now == 0) return "the file is missing";
  if (known.tries > 0 && known.source == now) return known.last;
  if (known.tries > 0) return "changed since the last check";
  return "";
}

}  // namespace

int list(const Course& course) {
  Progress progress(course);
  std::string chapter;
  std::size_t done = 0;
  for (const Unit& unit : course.units) {
    if (unit.chapter != chapter) std::cout << (chapter.empty() ? "" : "\n") << unit.chapter << "\n";
    chapter = unit.chapter;
    const bool passed = progress.is_done(unit);
    done += passed ? 1 : 0;
    std::cout << "  " << (passed ? "✓ " : "· ") << std::left << std::setw(6) << unit.number
              << std::setw(24) << unit.name << std::setw(46)
              << read_declaration(course, unit).title;
    const std::string state = state_of(course, progress, unit);
    const int tries = progress.of(unit).tries;
    std::cout << "  " << state;
    if (tries > 0) std::cout << ", " << tries << (tries == 1 ? " try" : " tries");
    std::cout << "\n";
  }
  std::cout << "\n" << done << " of " << course.units.size() << " units pass\n";
  return 0;
}

}  // namespace tumble::judge
