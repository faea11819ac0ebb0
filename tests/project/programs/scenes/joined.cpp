// ./tumble simulate with springs between bodies.
#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "project/harness/refusal.hpp"
#include "project/programs/scenes/run_scenes.hpp"

using namespace tumble::test;
using nlohmann::json;

namespace {

/// Two balls that a spring of 12 N/m pulls together from 1.5 m to 1 m, and one beside them.
json balls_on_a_spring() {
  json scene = {{"duration", 2}, {"tolerance", 1e-9}};
  const auto ball = [](const char* name, double mass, double x) {
    return json{
        {"name", name}, {"shape", {{"ball", 0.1}}}, {"mass", mass}, {"position", {x, 0, 0}}};
  };
  scene["bodies"] = {ball("light", 1, 0), ball("alone", 1, 7), ball("heavy", 3, 1.5)};
  scene["bodies"][1]["velocity"] = {0, 1, 0};
  scene["springs"] = {{{"from", {{"body", "heavy"}}},
                       {"to", {{"body", "light"}}},
                       {"stiffness", 12},
                       {"length", 1}}};
  return scene;
}

}  // namespace

TEST_CASE("simulate: two balls on a spring swing, and the third flies by itself") {
  const json result = simulated(balls_on_a_spring());
  const json bodies = result["end"]["bodies"];
  const double length = 1 + 0.5 * std::cos(4 * 2.0);
  CHECK(distance(bodies[0]["position"], {1.125 - 0.75 * length, 0, 0}) < 1e-9);
  CHECK(distance(bodies[1]["position"], {7, 2, 0}) < 1e-14);
  CHECK(distance(bodies[2]["position"], {1.125 + 0.25 * length, 0, 0}) < 1e-9);
  CHECK(result["chosen_and_spent"][1]["runs"] == 0);
  CHECK(result["chosen_and_spent"][0]["runs"] == result["chosen_and_spent"][2]["runs"]);
}

TEST_CASE("simulate: springs between bodies that mean nothing are refused, saying where") {
  json scene = balls_on_a_spring();
  scene["springs"][0]["to"]["body"] = "nobody";
  CHECK(mentions(refusal(scene), ".springs[0].to.body", "there is no body \"nobody\""));
  scene = balls_on_a_spring();
  scene["springs"][0]["to"]["body"] = "heavy";
  CHECK(mentions(refusal(scene), ".springs[0]", "joins heavy to itself"));
  scene = balls_on_a_spring();
  scene["springs"][0]["stiffness"] = -1;
  CHECK(mentions(refusal(scene), ".springs[0]", "-1 is not a finite number ≥ 0"));
  scene = balls_on_a_spring();
  scene["bodies"][0]["held_at"] = {0, 0, 0.1};
  CHECK(mentions(refusal(scene), ".springs[0].to.body", "light is held at a point"));
  scene = balls_on_a_spring();
  scene["floor"] = -1;
  CHECK(mentions(refusal(scene), ".springs", "in a scene with contact"));
  scene = balls_on_a_spring();
  scene["springs"][0]["from"]["anchor"] = {0, 0, 0};
  CHECK(mentions(refusal(scene), ".springs[0].from", "anchor"));
}
