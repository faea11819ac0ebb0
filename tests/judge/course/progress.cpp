#include "judge/course/progress.hpp"

#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace tumble::judge {

using nlohmann::json;

std::uint64_t fingerprint(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return 0;
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
  for (auto it = std::istreambuf_iterator<char>(in); it != std::istreambuf_iterator<char>(); ++it)
    hash = (hash ^ static_cast<unsigned char>(*it)) * 0x100000001b3;
  return hash;
}

Progress::Progress(const Course& course) : course_(course), file_(course.state / "progress.json") {
  std::ifstream in(file_);
  if (!in) return;
  try {
    const json all = json::parse(in);
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
  const fs::path beside = file_.string() + ".new";
  std::ofstream(beside) << j.dump(2) << "\n";
  fs::rename(beside, file_);
}

}  // namespace tumble::judge
