#include "judge/class/units_meant.hpp"

#include <algorithm>

#include "tumble/core/require.hpp"

namespace tumble::judge {

std::vector<Unit> units_meant(const Course& course, const std::string& text) {
  const std::size_t hyphen = text.find('-');
  if (hyphen == std::string::npos) return course.select(text);
  const std::string from = course.select(text.substr(0, hyphen)).front().id(),
                    to = course.select(text.substr(hyphen + 1)).back().id();
  const auto at = [&](const std::string& id) {
    return std::find_if(course.units.begin(), course.units.end(),
                        [&](const Unit& unit) { return unit.id() == id; });
  };
  require(at(from) <= at(to), "'", text, "' is a range that ends before it begins");
  return {at(from), at(to) + 1};
}

}  // namespace tumble::judge
