#include "judge/handout/handout.hpp"

#include <iostream>

#include "judge/class/settings.hpp"
#include "judge/commands/grading/grading.hpp"
#include "support/how_many.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

/// The chapters of the exercises that count.
std::set<std::string> chapters_that_count(const Course& course, const fs::path& settings) {
  std::set<std::string> chapters;
  for (const Unit& unit : read_settings(course, settings).units) chapters.insert(unit.chapter);
  return chapters;
}

}  // namespace

int hand_out(const Course& course, const HandoutOptions& options) {
  require(options.chapters.empty() == options.settings.has_value(),
          "hand out which chapters? Either --chapters 1-4 or --course course.json");
  const std::set<std::string> meant = options.settings
                                          ? chapters_that_count(course, *options.settings)
                                          : chapters_meant(course, options.chapters);
  make_tree(course, {meant}, options.to);
  std::size_t units = 0;
  for (const Unit& unit : course.units) units += meant.count(unit.chapter);
  std::cerr << "tumble: " << support::how_many(meant.size(), "chapter") << ", "
            << support::how_many(units, "exercise") << ", no solutions: ";
  std::cout << options.to.string() << "\n";
  return 0;
}

}  // namespace tumble::judge
