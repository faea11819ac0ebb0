#include <algorithm>
#include <iostream>

#include "judge/commands/commands.hpp"
#include "judge/course/contract.hpp"
#include "judge/course/progress.hpp"
#include "support/terminal.hpp"

namespace tumble::judge {

namespace {

using support::padded;

std::string state_of(const Course& course, Progress& progress, const Unit& unit) {
  if (progress.is_done(unit)) return "passed";
  const UnitProgress& known = progress.of(unit);
  const std::uint64_t now = fingerprint(course.exercise(unit));
  if (now == 0) return "the file is missing";
  if (known.tries > 0 && known.source == now) return known.last;
  if (known.tries > 0) return "changed since the last check";
  return "";
}

struct Line {
  std::string chapter, mark, number, name, title, state;
};

Line line_of(const Course& course, Progress& progress, const Unit& unit) {
  const int tries = progress.of(unit).tries;
  std::string state = state_of(course, progress, unit);
  if (tries > 0) state += ", " + std::to_string(tries) + (tries == 1 ? " try" : " tries");
  return {unit.chapter, progress.is_done(unit) ? "✓" : "·",   unit.number,
          unit.name,    read_declaration(course, unit).title, state};
}

std::string in_one_line(const Line& line) {
  return "  " + line.mark + " " + padded(line.number, 6) + padded(line.name, 24) +
         padded(line.title, 46) + "  " + line.state;
}

/// For narrow terminals: the title below the name.
std::string in_two_lines(const Line& line, std::size_t width) {
  const std::string name = "  " + line.mark + " " + padded(line.number, 6) + padded(line.name, 24);
  return name + "  " + support::wrapped(line.state, width - 36, 36) + "\n" + std::string(10, ' ') +
         support::wrapped(line.title, width - 10, 10);
}

}  // namespace

int list(const Course& course) {
  Progress progress(course);
  std::vector<Line> lines;
  std::size_t widest = 0, done = 0;
  for (const Unit& unit : course.units) {
    lines.push_back(line_of(course, progress, unit));
    widest = std::max(widest, support::characters(in_one_line(lines.back())));
    done += progress.is_done(unit) ? 1u : 0u;
  }
  const std::size_t width = support::terminal_width().value_or(widest);
  std::string chapter;
  for (const Line& line : lines) {
    if (line.chapter != chapter) std::cout << (chapter.empty() ? "" : "\n") << line.chapter << "\n";
    chapter = line.chapter;
    std::cout << (widest <= width ? in_one_line(line) : in_two_lines(line, width)) << "\n";
  }
  std::cout << "\n" << done << " of " << course.units.size() << " exercises pass\n";
  return 0;
}

}  // namespace tumble::judge
