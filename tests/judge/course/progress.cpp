#include "judge/course/progress.hpp"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "judge/course/stable_hash.hpp"
#include "support/entry.hpp"
#include "support/text_file.hpp"

namespace tumble::judge {

using nlohmann::json;

std::uint64_t fingerprint(const fs::path& file) {
  constexpr std::uintmax_t most = 1 << 20;  // no source file is so long
  std::error_code unreadable;
  if (!support::is_file(file) || fs::file_size(file, unreadable) > most) return 0;
  try {
    return stable_hash(support::read_text(file));
  } catch (const std::runtime_error&) {
    return 0;  // the verdict on it says why
  }
}

Progress::Progress(const Course& course) : course_(course), file_(course.state / "progress.json") {
  if (!fs::exists(file_)) return;
  try {
    const json all = json::parse(support::read_text(file_));
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

std::optional<Unit> Progress::next_open() const {
  for (const Unit& unit : course_.units)
    if (!is_done(unit)) return unit;
  return {};
}

std::optional<Unit> Progress::next_open_after(const Unit& passed) const {
  enum Rank { of_its_chapter, behind_it, before_it, none };
  std::optional<Unit> next;
  Rank best = none;
  bool is_behind = false;
  for (const Unit& unit : course_.units) {
    is_behind = is_behind || unit.id() == passed.id();
    const Rank rank = unit.chapter == passed.chapter ? of_its_chapter
                      : is_behind                    ? behind_it
                                                     : before_it;
    if (rank >= best || is_done(unit)) continue;
    next = unit;
    best = rank;
  }
  return next;
}

void Progress::save() const {
  json j = json::object();
  for (const auto& [unit, p] : units_)
    j[unit] = {{"tries", p.tries}, {"last", p.last}, {"source", p.source}, {"hints", p.hints}};
  fs::create_directories(file_.parent_path());
  support::write_text(file_, j.dump(2) + "\n");
}

}  // namespace tumble::judge
