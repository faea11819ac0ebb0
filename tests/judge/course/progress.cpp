#include "judge/course/progress.hpp"

#include <functional>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "judge/course/text_file.hpp"

namespace tumble::judge {

using nlohmann::json;

std::uint64_t fingerprint(const fs::path& file) {
  return fs::is_regular_file(file) ? std::hash<std::string>{}(read_text(file)) : 0;
}

Progress::Progress(const Course& course) : course_(course), file_(course.state / "progress.json") {
  if (!fs::exists(file_)) return;
  try {
    const json all = json::parse(read_text(file_));
    for (const auto& [unit, j] : all.items())
      units_[unit] = {j.at("tries"), j.at("last"), j.at("source"), j.at("hints")};
  } catch (const json::exception& e) {
    throw std::runtime_error(file_.string() +
                             " cannot be understood (delete it to start anew): " + e.what());
  }
}

bool Progress::is_done(const Unit& unit) const {
  const auto found = units_.find(unit.id());
  return found != units_.end() && found->second.last == "passed" &&
         found->second.source == fingerprint(course_.exercise(unit));
}

void Progress::save() const {
  json j = json::object();
  for (const auto& [unit, p] : units_)
    j[unit] = {{"tries", p.tries}, {"last", p.last}, {"source", p.source}, {"hints", p.hints}};
  fs::create_directories(file_.parent_path());
  write_text(file_, j.dump(2) + "\n");
}

}  // namespace tumble::judge
