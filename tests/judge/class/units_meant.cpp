#include "judge/class/units_meant.hpp"

#include <algorithm>

#include "judge/course/dashes.hpp"
#include "support/trimmed.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

std::vector<Unit> units_meant(const Course& course, const std::string& text) {
  if (text.ends_with(".cpp")) return course.select(text);  // a path may have hyphens
  const std::string plain = with_hyphens(text);
  const std::size_t hyphen = plain.find('-');
  if (hyphen == std::string::npos) return course.select(support::trimmed(plain));
  const std::string first = support::trimmed(plain.substr(0, hyphen)),
                    last = support::trimmed(plain.substr(hyphen + 1));
  require(!first.empty() && !last.empty(), "'", text,
          "' is half of a range; write both ends, as in 1-4 or 1.1-1.3");
  const std::string from = course.select(first).front().id(), to = course.select(last).back().id();
  const auto at = [&](const std::string& id) {
    return std::find_if(course.units.begin(), course.units.end(),
                        [&](const Unit& unit) { return unit.id() == id; });
  };
  require(at(from) <= at(to), "'", text, "' is a range that ends before it begins");
  return {at(from), at(to) + 1};
}

std::vector<Unit> counted_units(const Course& course, const std::vector<Unit>& counted,
                                const std::string& text) {
  std::vector<Unit> units = units_meant(course, text);
  std::erase_if(units, [&](const Unit& unit) {
    return std::none_of(counted.begin(), counted.end(),
                        [&](const Unit& each) { return each.id() == unit.id(); });
  });
  require(!units.empty(), text, " does not count: it is not in \"units\"");
  return units;
}

}  // namespace tumble::judge
