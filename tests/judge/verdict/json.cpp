#include "judge/verdict/json.hpp"

#include <nlohmann/json.hpp>

#include "judge/course/text_file.hpp"

namespace tumble::judge {

namespace {

using nlohmann::ordered_json;

ordered_json json_of(const CaseResult& result) {
  ordered_json j{{"number", result.number}, {"law", result.law}, {"passed", result.passed()}};
  if (result.passed()) return j;
  j["outcome"] = name_of(result.finding->outcome);
  j["detail"] = result.finding->detail;
  if (!result.finding->place.empty()) j["place"] = result.finding->place;
  j["misconceptions"] = ordered_json::array();
  for (const NamedMistake& mistake : result.finding->mistakes)
    j["misconceptions"].push_back(mistake.name);
  return j;
}

ordered_json json_of(const UnitResult& result) {
  ordered_json j{{"unit", result.unit.id()},
                 {"number", result.unit.number},
                 {"passed", result.passed()},
                 {"summary", result.summary()},
                 {"seed", result.seed},
                 {"laws", result.cases.size()},
                 {"laws_that_hold", result.passed_cases()},
                 {"seconds", result.seconds},
                 {"cases", ordered_json::array()}};
  if (!result.build_detail.empty()) j["detail"] = result.build_detail;
  for (const CaseResult& each : result.cases) j["cases"].push_back(json_of(each));
  return j;
}

}  // namespace

void write_json(const std::filesystem::path& file, const std::vector<UnitResult>& results) {
  ordered_json j{{"schema", "tumble/results/1"}, {"units", ordered_json::array()}};
  for (const UnitResult& result : results) j["units"].push_back(json_of(result));
  // What a student's code prints need not be UTF-8.
  write_text(file, j.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n");
}

}  // namespace tumble::judge
