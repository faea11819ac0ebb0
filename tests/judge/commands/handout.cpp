#include "judge/handout/handout.hpp"

#include <iostream>

#include "judge/commands/commands.hpp"

namespace tumble::judge {

int handout_command(const Course& course, const std::string& chapters, const fs::path& to) {
  const std::set<std::string> meant = chapters_meant(course, chapters);
  make_tree(course, {meant}, to);
  std::size_t units = 0;
  for (const Unit& unit : course.units) units += meant.count(unit.chapter);
  std::cerr << "tumble: " << meant.size() << " chapters, " << units << " exercises, no solutions: ";
  std::cout << to.string() << "\n";
  return 0;
}

}  // namespace tumble::judge
