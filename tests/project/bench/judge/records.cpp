#include "project/bench/judge/records.hpp"

#include "support/text_file.hpp"

namespace tumble::bench {

namespace fs = std::filesystem;

namespace {

Verdicts verdicts_in(const json& units) {
  Verdicts verdicts;
  for (const json& unit : units) verdicts[unit.at("unit")] = unit;
  return verdicts;
}

/// The first line of an explanation ends with the time: "✓ 4.1 product  passed  (0.35 s)".
std::string without_time(const std::string& explanation) {
  const auto end = explanation.find('\n');
  const auto time = explanation.rfind("  (", end);
  if (time == std::string::npos || end == std::string::npos) return explanation;
  return explanation.substr(0, time) + explanation.substr(end);
}

void keep_only(json& verdict, Likeness likeness) {
  verdict.erase("seconds");
  verdict.erase("judge");  // what a record of a class keeps to know when it is out of date
  verdict["explanation"] = without_time(verdict.at("explanation"));
  if (likeness == Likeness::outcome)
    verdict = {{"passed", verdict.at("passed")}, {"summary", verdict.at("summary")}};
  if (likeness != Likeness::laws) return;
  for (const char* key : {"tries", "explanation", "detail"}) verdict.erase(key);
  for (json& each : verdict.at("cases")) each.erase("place");
}

}  // namespace

ClassVerdicts verdicts_of_class(const fs::path& grades) {
  ClassVerdicts all;
  std::error_code not_there_yet;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(grades / "students", not_there_yet))
    if (entry.path().extension() == ".json")
      all[entry.path().stem().string()] =
          verdicts_in(json::parse(support::read_text(entry.path())).at("units"));
  return all;
}

Verdicts verdicts_of_check(const fs::path& file) {
  return verdicts_in(json::parse(support::read_text(file)).at("units"));
}

std::size_t count(const ClassVerdicts& all) {
  std::size_t sum = 0;
  for (const auto& [student, verdicts] : all) sum += verdicts.size();
  return sum;
}

bool alike(json a, json b, Likeness likeness) {
  keep_only(a, likeness);
  keep_only(b, likeness);
  return a == b;
}

std::vector<std::string> differences(
    const ClassVerdicts& some, const ClassVerdicts& all,
    const std::function<Likeness(const std::string& student, const std::string& unit)>& likeness) {
  std::vector<std::string> found;
  for (const auto& [student, verdicts] : some)
    for (const auto& [unit, verdict] : verdicts) {
      const auto others = all.find(student);
      const auto other = others == all.end() ? verdicts.end() : others->second.find(unit);
      const bool there = others != all.end() && other != others->second.end();
      if (there && alike(verdict, other->second, likeness(student, unit))) continue;
      found.push_back(student + " " + unit + ": " + verdict.at("summary").get<std::string>() +
                      ", " + (there ? other->second.at("summary").get<std::string>() : "none"));
    }
  return found;
}

}  // namespace tumble::bench
