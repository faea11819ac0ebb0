#include "judge/class/student_record.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "judge/verdict/json.hpp"
#include "support/text_file.hpp"

namespace tumble::judge {

using nlohmann::ordered_json;

const UnitRecord* StudentRecord::find(const Unit& unit) const {
  const auto found = std::find_if(units.begin(), units.end(), [&](const UnitRecord& record) {
    return record.unit == unit.id();
  });
  return found == units.end() ? nullptr : &*found;
}

double earned(const CourseSettings& settings, const StudentRecord& record) {
  double sum = 0;
  for (const UnitRecord& unit : record.units) sum += settings.earned(unit);
  return sum;
}

void write_record(const std::filesystem::path& file, const StudentRecord& record,
                  const CourseSettings& settings) {
  ordered_json j{{"schema", "tumble/student/1"},
                 {"student", record.student},
                 {"points", earned(settings, record)},
                 {"of", settings.most()},
                 {"seed", record.seed},
                 {"judge", record.judge}};
  if (!record.refused.empty()) j["refused"] = record.refused;
  if (record.out_of_time) j["out_of_time"] = true;
  j["units"] = ordered_json::array();
  for (const UnitRecord& unit : record.units) j["units"].push_back(json_of(unit));
  support::write_text(file, text_of(j));
}

std::optional<StudentRecord> read_record(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return std::nullopt;
  try {
    const ordered_json j = ordered_json::parse(support::read_text(file));
    StudentRecord record{j.at("student"),        j.at("seed"), j.at("judge"),
                         j.value("refused", ""), {},           j.value("out_of_time", false)};
    for (const ordered_json& unit : j.at("units")) record.units.push_back(unit_record_of(unit));
    return record;
  } catch (const ordered_json::exception& error) {
    throw std::runtime_error(file.string() +
                             " cannot be understood (delete it to grade anew): " + error.what());
  }
}

}  // namespace tumble::judge
