#include "judge/course/course.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "support/nearest.hpp"

namespace tumble::judge {

namespace {

using nlohmann::json;

Unit read_unit(const json& j) {
  Unit unit{j.at("number"),
            j.at("chapter"),
            j.at("name"),
            j.at("worker").get<std::string>(),
            {},
            j.at("solution").get<std::string>(),
            j.at("spec").get<std::string>()};
  for (const json& object : j.at("earlier")) unit.earlier.emplace_back(object.get<std::string>());
  return unit;
}

Toolchain read_toolchain(const json& j) {
  return {j.at("compiler"),
          j.at("compiler_id"),
          j.at("flags"),
          j.at("sanitizer_flags"),
          j.at("precompiled").get<std::string>(),
          j.at("precompiled_sanitized").get<std::string>(),
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

/// "quaternions"
std::string title_of(const std::string& chapter) { return chapter.substr(chapter.find('_') + 1); }

/// The units of each chapter.
std::vector<std::vector<Unit>> chapters_of(const Course& course) {
  std::vector<std::vector<Unit>> chapters;
  for (const Unit& unit : course.units) {
    if (chapters.empty() || chapters.back().front().chapter != unit.chapter)
      chapters.emplace_back();
    chapters.back().push_back(unit);
  }
  return chapters;
}

/// The exercise that a file is named after, as select() knows it: "01_particles/flatten" of
/// "exercises/01_particles/flatten.cpp". Other words stay as they are.
std::string without_file_name(const Course& course, const std::string& what) {
  const fs::path path = what;
  if (path.extension() != ".cpp") return what;
  const std::string folder = path.parent_path().filename().string(), name = path.stem().string();
  const bool is_chapter = std::any_of(course.units.begin(), course.units.end(),
                                      [&](const Unit& unit) { return unit.chapter == folder; });
  return is_chapter ? folder + "/" + name : name;
}

/// The number of a unit that was written with another sign than its dot, or with none: "1.3" of
/// "1,3" and of "13".
std::optional<std::string> number_meant(const Course& course, const std::string& what) {
  const auto digits_of = [](const std::string& text) {
    std::string digits;
    for (const char c : text)
      if (c >= '0' && c <= '9') digits += c;
    return digits;
  };
  const std::string digits = digits_of(what);
  if (what.find('.') != std::string::npos || digits.empty() || what.size() > digits.size() + 1 ||
      what.find_first_not_of("0123456789,;:-_/ ") != std::string::npos)
    return std::nullopt;
  for (const Unit& unit : course.units)
    if (digits_of(unit.number) == digits) return unit.number;
  return std::nullopt;
}

/// "product (4.1)", "chapter 4 (quaternions)"
std::string with_numbers(const Course& course, const std::string& name) {
  for (const Unit& unit : course.units)
    if (title_of(unit.chapter) == name)
      return "chapter " + unit.chapter_number() + " (" + name + ")";
  return name + " (" + numbers_of(course.select(name)) + ")";
}

/// What was probably meant, or what there is.
std::string suggestion(const Course& course, const std::string& what) {
  if (const auto number = number_meant(course, what)) return "did you mean " + *number + "?";
  std::vector<std::string> names;
  for (const Unit& unit : course.units) names.push_back(unit.name);
  std::string known;
  for (const std::vector<Unit>& chapter : chapters_of(course)) {
    const Unit& first = chapter.front();
    if (what.starts_with(first.chapter_number() + "."))
      return "chapter " + first.chapter_number() + " has " + numbers_of(chapter);
    names.push_back(title_of(first.chapter));
    known += (known.empty() ? "" : ", ") + first.chapter_number() + " " + title_of(first.chapter);
  }
  if (const std::optional<std::string> name = support::nearest(what, names))
    return "did you mean " + with_numbers(course, *name) + "?";
  return "the chapters are " + known + "; all exercises: ./tumble list";
}

}  // namespace

std::string numbers_of(const std::vector<Unit>& units) {
  const std::string &first = units.front().number, &last = units.back().number;
  if (units.size() == 1) return first;
  return first + (units.size() == 2 ? " and " : " to ") + last;
}

std::vector<Unit> Course::select(const std::string& what) const {
  const std::string meant = without_file_name(*this, what);
  std::vector<Unit> chosen;
  std::copy_if(units.begin(), units.end(), std::back_inserter(chosen),
               [&](const Unit& unit) { return means(meant, unit); });
  if (chosen.empty())
    throw std::invalid_argument("there is no exercise or chapter '" + what + "'; " +
                                suggestion(*this, meant));
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
                  j.at("die").get<std::string>(),
                  j.at("mine").get<std::string>(),
                  j.at("grading").get<std::string>(),
                  {}};
    for (const json& unit : j.at("units")) course.units.push_back(read_unit(unit));
    return course;
  } catch (const json::exception& e) {
    throw std::runtime_error(file.string() + " is not a course: " + e.what());
  }
}

}  // namespace tumble::judge
