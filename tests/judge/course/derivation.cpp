#include "judge/course/derivation.hpp"

#include <fstream>

namespace tumble::judge {

std::string derivation_of(const Course& course, const Unit& unit) {
  std::ifstream in(course.page(unit));
  std::string heading;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("##")) heading = line.substr(line.find_first_not_of("# "));
    if (line == "<!-- exercise: " + unit.number + " -->") return heading;
  }
  return {};
}

}  // namespace tumble::judge
