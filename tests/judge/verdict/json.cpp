#include "judge/verdict/json.hpp"

#include <nlohmann/json.hpp>

#include "support/text_file.hpp"

namespace tumble::judge {

using nlohmann::ordered_json;

namespace {

ordered_json json_of(const CaseRecord& record) {
  ordered_json j{{"number", record.number}, {"law", record.law}, {"passed", record.passed()}};
  if (record.passed()) return j;
  j["outcome"] = record.outcome;
  j["detail"] = record.detail;
  if (!record.place.empty()) j["place"] = record.place;
  j["misconceptions"] = record.misconceptions;
  return j;
}

CaseRecord case_record_of(const ordered_json& j) {
  CaseRecord record{j.at("number"), j.at("law"), name_of(Outcome::passed), "", "", {}};
  if (j.at("passed").get<bool>()) return record;
  record.outcome = j.at("outcome");
  record.detail = j.at("detail");
  record.place = j.value("place", "");
  record.misconceptions = j.at("misconceptions").get<std::vector<std::string>>();
  return record;
}

}  // namespace

ordered_json json_of(const UnitRecord& record) {
  ordered_json j{{"unit", record.unit},
                 {"number", record.number},
                 {"passed", record.passed},
                 {"summary", record.summary},
                 {"seed", record.seed},
                 {"laws", record.laws},
                 {"laws_that_hold", record.laws_that_hold},
                 {"tries", record.tries},
                 {"seconds", record.seconds},
                 {"source", record.source},
                 {"judge", record.judge},
                 {"cases", ordered_json::array()}};
  if (!record.detail.empty()) j["detail"] = record.detail;
  if (!record.judge_failure.empty()) j["judge_failure"] = record.judge_failure;
  j["explanation"] = record.explanation;
  for (const CaseRecord& each : record.cases) j["cases"].push_back(json_of(each));
  return j;
}

UnitRecord unit_record_of(const ordered_json& j) {
  UnitRecord record;
  record.unit = j.at("unit");
  record.number = j.at("number");
  record.passed = j.at("passed");
  record.summary = j.at("summary");
  record.seed = j.at("seed");
  record.laws = j.at("laws");
  record.laws_that_hold = j.at("laws_that_hold");
  record.tries = j.at("tries");
  record.seconds = j.at("seconds");
  record.source = j.at("source");
  record.judge = j.value("judge", record.judge);
  record.detail = j.value("detail", "");
  record.judge_failure = j.value("judge_failure", "");
  record.explanation = j.at("explanation");
  for (const ordered_json& each : j.at("cases")) record.cases.push_back(case_record_of(each));
  return record;
}

std::string text_of(const ordered_json& json) {
  return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

void write_json(const std::filesystem::path& file, const std::vector<UnitRecord>& records) {
  ordered_json j{{"schema", "tumble/results/1"}, {"units", ordered_json::array()}};
  for (const UnitRecord& record : records) j["units"].push_back(json_of(record));
  support::write_text(file, text_of(j));
}

}  // namespace tumble::judge
