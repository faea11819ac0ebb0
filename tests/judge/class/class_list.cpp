#include "judge/class/class_list.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "judge/verdict/json.hpp"
#include "support/text_file.hpp"

namespace tumble::judge {

using nlohmann::ordered_json;

void write_class_list(const std::filesystem::path& file, const ClassList& list) {
  ordered_json j{{"schema", "tumble/class/1"}, {"from", name_of(list.lms)}};
  j["students"] = ordered_json::array();
  for (const ListedStudent& each : list.students)
    j["students"].push_back(
        ordered_json::object({{"student", each.student}, {"absent", each.absent}}));
  support::write_text(file, text_of(j));
}

std::optional<ClassList> read_class_list(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return std::nullopt;
  try {
    const ordered_json j = ordered_json::parse(support::read_text(file));
    ClassList list{lms_named(j.at("from")), {}};
    for (const ordered_json& each : j.at("students"))
      list.students.push_back({each.at("student"), each.at("absent")});
    return list;
  } catch (const std::exception& error) {
    throw std::runtime_error(file.string() +
                             " cannot be understood (./tumble grade writes it): " + error.what());
  }
}

}  // namespace tumble::judge
