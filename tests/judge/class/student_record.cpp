#include "judge/class/student_record.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "judge/class/final_grade.hpp"
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

namespace {

/// What is known besides the verdicts; what is not known is not written.
void add_circumstances(ordered_json& j, const StudentRecord& record) {
  if (!record.refused.empty()) j["refused"] = record.refused;
  const std::pair<const char*, const std::string*> texts[] = {
      {"name", &record.who.name},     {"id", &record.who.id},
      {"email", &record.who.email},   {"handed_in", &record.handed_in},
      {"together", &record.together}, {"incomplete", &record.incomplete}};
  for (const auto& [key, text] : texts)
    if (!text->empty()) j[key] = *text;
  if (record.marked_late) j["marked_late"] = true;
  if (record.out_of_time) j["out_of_time"] = true;
  if (!record.notes.empty()) j["notes"] = record.notes;
  if (!record.files.empty()) j["files"] = record.files;
}

void read_circumstances(const ordered_json& j, StudentRecord& record) {
  record.refused = j.value("refused", "");
  record.who = {j.value("name", ""), j.value("id", ""), j.value("email", "")};
  record.handed_in = j.value("handed_in", "");
  record.together = j.value("together", "");
  record.incomplete = j.value("incomplete", "");
  record.marked_late = j.value("marked_late", false);
  record.out_of_time = j.value("out_of_time", false);
  record.notes = j.value("notes", record.notes);
  record.files = j.value("files", record.files);
}

}  // namespace

std::size_t count_unreached(const CourseSettings& settings, const StudentRecord& record) {
  return record.out_of_time ? settings.units.size() - record.units.size() : 0;
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
                 {"points", final_grade(settings, record).points},
                 {"of", settings.most()},
                 {"seed", record.seed},
                 {"judge", record.judge}};
  add_circumstances(j, record);
  j["units"] = ordered_json::array();
  for (const UnitRecord& unit : record.units) j["units"].push_back(json_of(unit));
  support::write_text(file, text_of(j));
}

std::optional<StudentRecord> read_record(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return std::nullopt;
  try {
    const ordered_json j = ordered_json::parse(support::read_text(file));
    StudentRecord record{j.at("student"), j.at("seed"), j.at("judge"), "", {}};
    read_circumstances(j, record);
    for (const ordered_json& unit : j.at("units")) record.units.push_back(unit_record_of(unit));
    return record;
  } catch (const ordered_json::exception& error) {
    throw std::runtime_error(file.string() +
                             " cannot be understood (delete it to grade anew): " + error.what());
  }
}

}  // namespace tumble::judge
