#include "judge/course/hints.hpp"

#include <fstream>
#include <stdexcept>

namespace tumble::judge {

std::vector<std::string> read_hints(const Course& course, const Unit& unit) {
  std::ifstream in(course.hints(unit));
  const std::string heading = "## " + unit.number + " " + unit.name;
  std::vector<std::string> hints;
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("## ")) {
      inside = line == heading;
    } else if (inside) {
      const std::string number = std::to_string(hints.size() + 1) + ". ";
      if (line.starts_with(number))
        hints.push_back(line.substr(number.size()) + "\n");
      else if (!hints.empty())
        hints.back() += line.starts_with("   ") ? line.substr(3) + "\n" : line + "\n";
    }
  }
  if (hints.size() != hints_per_unit)
    throw std::runtime_error(course.hints(unit).string() + ": \"" + heading + "\" should have " +
                             std::to_string(hints_per_unit) + " hints, and has " +
                             std::to_string(hints.size()));
  return hints;
}

}  // namespace tumble::judge
