#include "judge/course/course.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

using nlohmann::json;

Unit read_unit(const json& j) {
  Unit unit{j.at("number"),
            j.at("chapter"),
            j.at("name"),
            j.at("worker").get<std::string>(),
            {},
            j.at("solution").get<std::string>()};
  for (const json& object : j.at("earlier")) unit.earlier.emplace_back(object.get<std::string>());
  return unit;
}

Toolchain read_toolchain(const json& j) {
  return {j.at("compiler"),
          j.at("compiler_id"),
          j.at("flags"),
          j.at("precompiled").get<std::string>(),
          j.at("linker"),
          j.at("link"),
          j.at("link_confined"),
          j.at("link_first_counts"),
          j.at("runtime").get<std::string>()};
}

bool means(const std::string& what, const Unit& unit) {
  const std::string padded = what.size() == 1 ? "0" + what : what;
  return what == "all" || what == unit.number || what == unit.name || what == unit.id() ||
         what == unit.chapter || what == unit.chapter_number() ||
         unit.chapter.starts_with(padded + "_");
}

}  // namespace

std::vector<Unit> Course::select(const std::string& what) const {
  std::vector<Unit> chosen;
  std::copy_if(units.begin(), units.end(), std::back_inserter(chosen),
               [&](const Unit& unit) { return means(what, unit); });
  std::string known;
  for (const Unit& unit : units) known += " " + unit.number + " " + unit.name;
  require(!chosen.empty(), "there is no unit or chapter '", what, "'; there are:", known);
  return chosen;
}

Course read_course(const fs::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("the course is not built: cannot read " + file.string());
  try {
    const json j = json::parse(in);
    Course course{j.at("root").get<std::string>(),
                  j.at("state").get<std::string>(),
                  read_toolchain(j),
                  j.at("engine").get<std::string>(),
                  {}};
    for (const json& unit : j.at("units")) course.units.push_back(read_unit(unit));
    return course;
  } catch (const json::exception& e) {
    throw std::runtime_error(file.string() + " is no course: " + e.what());
  }
}

}  // namespace tumble::judge
