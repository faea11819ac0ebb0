#include "judge/platforms/fitted.hpp"

#include <algorithm>
#include <sstream>

namespace tumble::judge {

namespace {

/// At most so many bytes from the beginning, in whole UTF-8 characters.
std::string beginning(const std::string& text, std::size_t most) {
  if (text.size() <= most) return text;
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xc0) == 0x80) --most;
  return text.substr(0, most);
}

std::string with_short_lines(const std::string& text) {
  std::istringstream in(text);
  std::string result;
  for (std::string line; std::getline(in, line);) {
    result += beginning(line, most_of_line);
    result += line.size() > most_of_line ? "…\n" : "\n";
  }
  return result;
}

std::string shortened(const std::string& text, std::size_t most) {
  std::string all = with_short_lines(text);
  const std::string end = "\n  … the rest is left out.\n";
  if (all.size() <= most) return all;
  return beginning(all, most - std::min(most, end.size())) + end;
}

}  // namespace

StudentRecord fitted(StudentRecord record) {
  record.refused = beginning(record.refused, most_of_line);
  std::size_t room = most_in_all, units = record.units.size();
  for (UnitRecord& unit : record.units) {
    unit.explanation = shortened(unit.explanation, std::min(most_of_unit, room / units--));
    room -= std::min(room, unit.explanation.size());
  }
  return record;
}

StudentRecord without_hidden(const CourseSettings& settings, StudentRecord record) {
  for (UnitRecord& unit : record.units) {
    if (!settings.is_hidden(unit) || !unit.judge_failure.empty()) continue;
    unit.explanation.clear();
    unit.summary = "hidden";
  }
  return record;
}

}  // namespace tumble::judge
