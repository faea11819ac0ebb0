#include "judge/verdict/result_message.hpp"

#include <nlohmann/json.hpp>

#include "judge/protocol/message.hpp"
#include "support/json_bytes.hpp"

namespace tumble::judge {

namespace {

using nlohmann::json;
using support::bytes_of, support::text_in;

/// Values travel as in the messages between judge and worker.
json message_of(const List& values) { return bytes_of(encode({Kind::answer, 0, values})); }

List values_in(const json& bytes) { return decode(text_in(bytes)).content; }

json message_of(const std::optional<Value>& value) {
  return value ? message_of(List{*value}) : json(nullptr);
}

std::optional<Value> value_in(const json& j) {
  if (j.is_null()) return std::nullopt;
  return values_in(j).at(0);
}

json message_of(const std::vector<Evaluation>& evaluations) {
  List all;
  for (const Evaluation& each : evaluations)
    all.push_back(List{each.function, each.arguments, each.result});
  return message_of(all);
}

std::vector<Evaluation> evaluations_in(const json& bytes) {
  std::vector<Evaluation> all;
  for (const Value& value : values_in(bytes)) {
    const List& parts = std::get<List>(value.data);
    all.push_back(
        {std::get<FunctionId>(parts.at(0).data), std::get<List>(parts.at(1).data), parts.at(2)});
  }
  return all;
}

json json_of(const Misconception& each) {
  return {bytes_of(each.name), bytes_of(each.sentence), bytes_of(each.section)};
}

json json_of(const Finding& finding) {
  json misconceptions = json::array();
  for (const Misconception& each : finding.misconceptions) misconceptions.push_back(json_of(each));
  json question = nullptr;
  if (finding.question)
    question = {message_of(finding.question->arguments), finding.question->evaluations,
                message_of(finding.question->first_evaluations)};
  return {{"outcome", static_cast<int>(finding.outcome)},
          {"detail", bytes_of(finding.detail)},
          {"question", question},
          {"answer", message_of(finding.answer)},
          {"demanded", message_of(finding.demanded)},
          {"tolerance", finding.tolerance},
          {"missed", finding.missed},
          {"misconceptions", misconceptions},
          {"printed", bytes_of(finding.printed)},
          {"place", bytes_of(finding.place)}};
}

Finding finding_of(const json& j) {
  Finding finding;
  finding.outcome = static_cast<Outcome>(j.at("outcome").get<int>());
  finding.detail = text_in(j.at("detail"));
  if (const json& question = j.at("question"); !question.is_null())
    finding.question =
        Question{values_in(question.at(0)), question.at(1), evaluations_in(question.at(2))};
  finding.answer = value_in(j.at("answer"));
  finding.demanded = value_in(j.at("demanded"));
  finding.tolerance = j.at("tolerance");
  finding.missed = j.at("missed");
  for (const json& each : j.at("misconceptions"))
    finding.misconceptions.push_back(
        {text_in(each.at(0)), text_in(each.at(1)), text_in(each.at(2))});
  finding.printed = text_in(j.at("printed"));
  finding.place = text_in(j.at("place"));
  return finding;
}

json json_of(const CaseResult& result) {
  return {result.number, bytes_of(result.law),
          result.finding ? json_of(*result.finding) : json(nullptr)};
}

CaseResult case_of(const json& j) {
  CaseResult result{j.at(0), text_in(j.at(1)), std::nullopt};
  if (!j.at(2).is_null()) result.finding = finding_of(j.at(2));
  return result;
}

}  // namespace

std::string encode_result(const UnitResult& result) {
  json cases = json::array();
  for (const CaseResult& each : result.cases) cases.push_back(json_of(each));
  const json j{{"seed", result.seed},
               {"build", static_cast<int>(result.build)},
               {"build_detail", bytes_of(result.build_detail)},
               {"warnings", bytes_of(result.warnings)},
               {"lucky_place", bytes_of(result.lucky_place)},
               {"lucky_variable", bytes_of(result.lucky_variable)},
               {"why_no_place", bytes_of(result.why_no_place)},
               {"cases", cases},
               {"seconds", result.seconds}};
  std::string message;
  json::to_msgpack(j, message);
  return message;
}

UnitResult decode_result(const std::string& message, const Job& job) {
  UnitResult result;
  result.unit = job.unit;
  result.source = job.source;
  const json j = json::from_msgpack(message);
  result.seed = j.at("seed");
  result.build = static_cast<BuildOutcome>(j.at("build").get<int>());
  result.build_detail = text_in(j.at("build_detail"));
  result.warnings = text_in(j.at("warnings"));
  result.lucky_place = text_in(j.at("lucky_place"));
  result.lucky_variable = text_in(j.at("lucky_variable"));
  result.why_no_place = text_in(j.at("why_no_place"));
  for (const json& each : j.at("cases")) result.cases.push_back(case_of(each));
  result.seconds = j.at("seconds");
  return result;
}

}  // namespace tumble::judge
