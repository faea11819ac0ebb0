#include <nlohmann/json.hpp>

#include "judge/mine/report.hpp"

namespace tumble::judge::mine {

namespace {

using nlohmann::ordered_json;

ordered_json json_of(const Part& part) {
  ordered_json j{{"unit", part.unit.id()},
                 {"number", part.unit.number},
                 {"from", part.own() ? "student" : "solution"}};
  if (!part.own()) j["missing"] = part.missing;
  return j;
}

ordered_json json_of(const Curve& curve) {
  ordered_json points = ordered_json::array();
  for (const Point& p : curve.points)
    points.push_back({{"steps", p.steps},
                      {"evaluations", p.evaluations},
                      {"seconds", p.seconds},
                      {"error", p.error}});
  return {{"name", curve.name}, {"from", curve.own ? "student" : "library"}, {"points", points}};
}

ordered_json json_of(const OwnCurve& own) {
  ordered_json j = json_of(own.curve);
  j["order"] = own.order;
  j["right"] = own.right();
  j["error_of_the_method"] = own.twin_error;
  if (!own.failure.empty()) j["failure"] = own.failure;
  return j;
}

ordered_json json_of(const ProblemResult& result) {
  ordered_json j{{"name", result.problem.name},
                 {"sentence", result.problem.sentence},
                 {"duration", result.problem.duration},
                 {"curves", ordered_json::array()}};
  if (result.mass.own)
    j["mass"] = {{"error", result.mass.error}, {"seconds", result.mass.own->seconds}};
  if (!result.mass.failure.empty()) j["mass"]["failure"] = result.mass.failure;
  j["model_chosen_rightly"] = result.chosen.right;
  for (const OwnCurve& own : result.own) j["curves"].push_back(json_of(own));
  if (result.closed_form) j["curves"].push_back(json_of(*result.closed_form));
  for (const Curve& curve : result.library) j["curves"].push_back(json_of(curve));
  if (result.laws)
    j["broken_by"] = {{"energy", result.laws->energy},
                      {"length_of_q", result.laws->length},
                      {"angular_momentum", result.laws->momentum}};
  if (result.turning) j["turns_with_omega"] = result.turning->right();
  return j;
}

ordered_json json_of(const DieResult& die) {
  ordered_json j{{"right", die.right()}, {"impacts", ordered_json::array()}};
  if (!die.own) {
    j["failure"] = die.failure;
    return j;
  }
  for (std::size_t i = 0; i < die.common(); ++i)
    j["impacts"].push_back({{"t", die.own->impacts[i].t},
                            {"late", die.late(i)},
                            {"an_error_of_the_tolerance_grows_to", die.truth.impacts[i].grown},
                            {"energy_left", die.energy_left(i)}});
  const DieLaws laws = die.laws();
  j["broken_by"] = {{"height", laws.height}, {"sideways", laws.sideways}, {"energy", laws.energy}};
  j["distances"] = die.own->queries;
  return j;
}

}  // namespace

std::string json_of(const EngineBuild& build, const Measurement* measurement,
                    const std::vector<Part>& waiting, const std::vector<std::string>& findings) {
  ordered_json j{{"schema", "tumble/mine/1"},
                 {"right", measurement != nullptr && findings.empty()},
                 {"parts", ordered_json::array()},
                 {"findings", findings},
                 {"problems", ordered_json::array()}};
  for (const Part& part : build.parts) j["parts"].push_back(json_of(part));
  if (measurement)
    for (const ProblemResult& result : measurement->problems)
      j["problems"].push_back(json_of(result));
  if (measurement && measurement->die) j["die"] = json_of(*measurement->die);
  for (const Part& part : waiting) j["die"]["waits_for"].push_back(json_of(part));
  // What a student's code says need not be UTF-8.
  return j.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace tumble::judge::mine
