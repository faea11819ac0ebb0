/// @file
/// The judge's command line; ./tumble calls it.
#include <CLI/CLI.hpp>
#include <iostream>

#include "judge/commands/matrix.hpp"
#include "judge/course/course.hpp"

using namespace tumble::judge;

int main(int argc, char** argv) {
  CLI::App app("tumble's judge");
  app.require_subcommand(1);
  std::string what = "all";
  std::uint64_t seed = 1;
  CLI::App* matrix = app.add_subcommand("matrix", "every spec against every misconception");
  matrix->add_option("what", what, "unit, chapter or all");
  matrix->add_option("--seed", seed);
  CLI11_PARSE(app, argc, argv);
  try {
    const Course course = read_course(TUMBLE_COURSE);
    if (*matrix) return print_kill_matrix(std::cout, course.select(what), seed) ? 0 : 1;
  } catch (const std::exception& e) {
    std::cerr << "tumble: " << e.what() << "\n";
    return 2;
  }
}
