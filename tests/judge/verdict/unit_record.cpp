#include "judge/verdict/unit_record.hpp"

#include <sstream>

#include "judge/course/progress.hpp"
#include "judge/verdict/console.hpp"

namespace tumble::judge {

namespace {

CaseRecord record_of(const CaseResult& result) {
  CaseRecord record{result.number, result.law, name_of(Outcome::passed), "", "", {}};
  if (result.passed()) return record;
  record.outcome = name_of(result.finding->outcome);
  record.detail = result.finding->detail;
  record.place = result.finding->place;
  for (const Misconception& misconception : result.finding->misconceptions)
    record.misconceptions.push_back(misconception.name);
  return record;
}

}  // namespace

UnitRecord record_of(const Course& course, const UnitResult& result) {
  UnitRecord record;
  record.unit = result.unit.id();
  record.number = result.unit.number;
  record.passed = result.passed();
  record.summary = result.summary();
  record.seed = result.seed;
  record.laws = result.cases.size();
  record.laws_that_hold = result.passed_cases();
  record.seconds = result.seconds;
  record.source = fingerprint(result.source);
  record.detail = result.build_detail;
  record.judge_failure = result.judge_failure;
  std::ostringstream text;
  print_result(text, course, result, {});
  record.explanation = text.str();
  for (const CaseResult& each : result.cases) record.cases.push_back(record_of(each));
  return record;
}

}  // namespace tumble::judge
