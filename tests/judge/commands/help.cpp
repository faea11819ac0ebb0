/// @file
/// What helps a student on: hint, reset, solution.
#include <algorithm>
#include <chrono>
#include <ctime>
#include <iostream>

#include "judge/commands/commands.hpp"
#include "judge/course/contract.hpp"
#include "judge/course/hints.hpp"
#include "judge/course/progress.hpp"
#include "support/text_file.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

Unit one_unit(const Course& course, const std::string& what) {
  const std::vector<Unit> units = course.select(what);
  require(units.size() == 1, "'", what, "' means ", numbers_of(units),
          "; this command takes one of them");
  return units.front();
}

Unit next_open(const Progress& progress) {
  const std::optional<Unit> unit = progress.next_open();
  require(unit.has_value(),
          "every exercise passes; name one for a hint, for example: ./tumble hint 4.1");
  return *unit;
}

/// "2026-11-21-083055"
std::string time_stamp() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d-%H%M%S", std::localtime(&now));
  return text;
}

}  // namespace

int hint(const Course& course, const std::string& what, int number) {
  Progress progress(course);
  const Unit unit = what.empty() ? next_open(progress) : one_unit(course, what);
  const std::vector<std::string> hints = read_hints(course, unit);
  int& shown = progress.of(unit).hints;
  if (number == 0) number = std::min(shown + 1, static_cast<int>(hints.size()));
  require(number >= 1 && number <= static_cast<int>(hints.size()), "there are hints 1 to ",
          hints.size(), ", not ", number);
  shown = std::max(shown, number);
  progress.save();
  std::cout << unit.number << " " << unit.name << ", hint " << number << " of " << hints.size()
            << "\n\n"
            << hints[static_cast<std::size_t>(number) - 1];
  if (number < static_cast<int>(hints.size()))
    std::cout << "\nNext hint: ./tumble hint " << unit.number << "\n";
  return 0;
}

int reset(const Course& course, const std::string& what) {
  const Unit unit = one_unit(course, what);
  const fs::path file = course.exercise(unit);
  const std::string stub = stub_of(course, unit);
  std::error_code nowhere;  // a link that leads to no file is put right
  if (fs::exists(file, nowhere) && support::read_text(file) != stub) {
    const fs::path attempts = course.state / "attempts" / unit.chapter;
    fs::create_directories(attempts);
    const fs::path kept = attempts / (unit.name + "." + time_stamp() + ".cpp");
    fs::copy_file(file, kept, fs::copy_options::overwrite_existing);
    std::cout << "Your file is kept: " << fs::relative(kept).string() << "\n";
  }
  support::write_text(file, stub);
  std::cout << unit.number << " " << unit.name << " is as it was handed out.\n";
  return 0;
}

int solution(const Course& course, const std::string& what, bool anyway) {
  const Unit unit = one_unit(course, what);
  const Progress progress(course);
  if (!anyway && !progress.is_done(unit)) {
    std::cerr << "tumble: " << unit.number << " " << unit.name
              << " does not pass yet. A hint: ./tumble hint " << unit.number
              << "   The solution all the same: ./tumble solution " << unit.number << " --anyway\n";
    return 1;
  }
  if (!fs::exists(course.solution(unit))) {
    std::cout << "This tree has no solutions: it was handed out without them.\n";
    return 1;
  }
  std::cout << support::read_text(course.solution(unit));
  return 0;
}

}  // namespace tumble::judge
