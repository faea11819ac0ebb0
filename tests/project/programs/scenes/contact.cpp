// ./tumble simulate on scenes in which bodies touch things.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "objects/objects.hpp"
#include "project/harness/refusal.hpp"
#include "project/programs/scenes/run_scenes.hpp"
#include "tumble/mesh/read_mesh.hpp"

using namespace tumble::test;
using nlohmann::json;

namespace {

constexpr double g = 10;

/// A ball 0.1 m in radius whose lowest point is 1 m above the floor z = 0.
json dropped_ball(double restitution) {
  return {
      {"bodies",
       {{{"name", "ball"}, {"shape", {{"ball", 0.1}}}, {"mass", 2}, {"position", {0, 0, 1.1}}}}},
      {"gravity", {0, 0, -g}},
      {"floor", 0},
      {"restitution", restitution},
      {"friction", 0},
      {"duration", 10}};
}

const double fall = std::sqrt(2 / g);  // [s]

std::string example(const std::string& name) {
  return std::string(std::getenv("TUMBLE_ROOT")) + "/chapters/scenes/examples/" + name;
}

long lines_of(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

/// What a scene without a result says, and its status.
CommandResult said(const json& scene) {
  write("scene.json", scene.dump());
  return scenes("simulate scene.json");
}

}  // namespace

TEST_CASE("simulate: a dropped ball bounces at its times, loses its energy, and comes to rest") {
  json scene = dropped_ball(0.5);
  scene["from"] = 100;
  const json result = simulated(scene);
  const json& impacts = result["impacts"];
  CHECK(result["ending"] == "all_at_rest");
  CHECK(result["undecided"].is_null());
  CHECK(result["can_touch"] == true);
  CHECK(result["queries"].get<int>() > 0);
  // The k-th flight takes e times as long as the one before. Times carry the rounding of 100.
  double t = 100 + fall, flight = 2 * fall, e_lost = 2 * g * 1 * (1 - 0.25), lost = 0;
  for (std::size_t k = 0; k < 8; ++k) {
    CHECK(std::abs(impacts[k]["time"].get<double>() - t) < 1e-12);
    CHECK(std::abs(impacts[k]["energy_lost"].get<double>() / e_lost - 1) < 1e-9);
    flight *= 0.5;
    t += flight;
    e_lost *= 0.25;
  }
  CHECK(impacts[0]["body"] == "ball");
  CHECK(impacts[0]["other"] == "floor");
  CHECK(distance(impacts[0]["normal"], {0, 0, 1}) == 0);
  CHECK(distance(impacts[0]["point"], {0, 0, 0}) < 1e-9);
  CHECK(std::abs(impacts[0]["impulse"][2].get<double>() - 2 * 1.5 * g * fall) < 1e-8);
  CHECK(std::abs(result["rest_since"]["ball"].get<double>() - (100 + 3 * fall)) < 1e-9);
  const json& energy = result["energy"];
  for (const json& impact : impacts) lost += impact["energy_lost"].get<double>();
  CHECK(std::abs(lost - energy["lost_in_impacts"].get<double>()) < 1e-12);
  CHECK(std::abs(energy["start"].get<double>() - 2 * g * 1.1) < 1e-12);
  CHECK(std::abs(energy["end"].get<double>() - 2 * g * 0.1) < 1e-9);
  CHECK(std::abs(energy["start"].get<double>() - energy["end"].get<double>() - lost -
                 energy["lost_when_put_to_rest"].get<double>()) < 1e-12);
  CHECK(result["to"] == 110);
  CHECK(result["records"].size() == 101);
  CHECK(distance(result["end"]["bodies"][0]["position"], {0, 0, 0.1}) < 1e-9);
  CHECK(mentions(result["chosen_and_spent"][0]["at_the_end"].get<std::string>(), "at rest since"));
}

TEST_CASE("simulate: tables of impacts and energies, the first and the last of many, and CSV") {
  write("scene.json", dropped_ball(0.9).dump());
  const CommandResult result =
      scenes("simulate scene.json --csv states.csv --impacts impacts.csv --svg film.svg");
  CHECK(result.status == 0);
  CHECK(mentions(result.output, "method: flights in closed form, from impact to impact",
                 "collides as a ball",
                 "at the end: at rest since t =", "here are the first 12 and the last 4",
                 "lost in impacts", "each impact makes earlier errors larger"));
  const std::string impacts = content("impacts.csv");
  CHECK(impacts.starts_with("time,body,other,x,y,z,nx,ny,nz,jx,jy,jz,energy_lost\n"));
  const json parsed = json::parse(scenes("simulate scene.json --json").output);
  CHECK(lines_of(impacts) == static_cast<long>(parsed["impacts"].size()) + 1);
  CHECK(lines_of(content("states.csv")) == 102);
  CHECK(mentions(content("film.svg"), "<svg ", "</svg>", "ball", "a picture every"));
}

TEST_CASE("simulate: by how much an error grows per bounce, and when the motion means nothing") {
  // A ball goes to and fro between a floor and a ball of 10¹² times its mass. Where it meets the
  // other ball both centres are 1 m apart, and the way down is 1 m as well. An offset x and a slope
  // s become x + 2 s on the way to the floor and back, and s + 2 (x + 2 s) at the ball: two bounces
  // multiply the error by 3 + √8 = (1 + √2)².
  const auto ball = [](const char* name, double radius, double mass, double z) {
    return json{
        {"name", name}, {"shape", {{"ball", radius}}}, {"mass", mass}, {"position", {0, 0, z}}};
  };
  json scene = {{"bodies", {ball("small", 0.1, 1, 0.6), ball("large", 0.9, 1e12, 2.1)}},
                {"gravity", {0, 0, 0}},
                {"floor", 0},
                {"restitution", 1},
                {"friction", 0},
                {"duration", 50}};
  scene["bodies"][0]["velocity"] = {0, 0, -1};
  const json growth = simulated(scene)["error_growth"];
  const json& small = growth["bodies"][0];
  CHECK(growth["start_differs_by"] == 1e-9);
  CHECK(small["name"] == "small");
  CHECK(std::abs(small["factor_per_bounce"].get<double>() / (1 + std::sqrt(2)) - 1) < 0.05);
  // From 10⁻⁹ to 0.1 it takes some 20 bounces, one per second.
  CHECK(small["means_nothing_after"].get<double>() > 15);
  CHECK(small["means_nothing_after"].get<double>() < 30);
  CHECK(growth["bodies"][1]["means_nothing_after"].is_null());
  const CommandResult text = scenes("simulate scene.json");
  CHECK(mentions(text.output, "an error grows per bounce", " times", "means nothing after",
                 "not before the end"));
}

TEST_CASE("simulate: each body of a scene is disturbed, and so its error is known") {
  const CommandResult table = scenes("simulate " + example("on_the_table.json") + " --json");
  REQUIRE(table.status == 0);
  const json result = json::parse(table.output);
  const json& bodies = result["error_growth"]["bodies"];
  REQUIRE(bodies.size() == 3);
  for (const json& body : bodies) {
    CHECK(body["bounces"].get<std::size_t>() >= 3);
    CHECK(body["bounces"].get<std::size_t>() <= result["impacts"].size());
    CHECK(body["factor_per_bounce"].get<double>() > 1);
    CHECK(body["factor_per_bounce"].get<double>() < 10);
  }
}

TEST_CASE("simulate: without enough bounces no factor is told, and a dropped ball stays foretold") {
  json scene = dropped_ball(0.5);
  scene["duration"] = 0.6;  // one bounce
  json small = simulated(scene)["error_growth"]["bodies"][0];
  CHECK(small["bounces"] == 1);
  CHECK(small["factor_per_bounce"].is_null());
  CHECK(small["means_nothing_after"].is_null());
  scene["duration"] = 10;
  small = simulated(scene)["error_growth"]["bodies"][0];
  CHECK(small["bounces"].get<int>() >= 3);
  CHECK(small["factor_per_bounce"].get<double>() < 2);
  CHECK(small["means_nothing_after"].is_null());
}

TEST_CASE("simulate: the thrown things come to rest, and the ball rolls away from the wall") {
  const CommandResult table =
      scenes("simulate " + example("on_the_table.json") + " --json --svg table.svg");
  REQUIRE(table.status == 0);
  const json thrown = json::parse(table.output);
  CHECK(thrown["ending"] == "all_at_rest");
  for (const json& since : thrown["rest_since"]) CHECK(since.is_number());
  CHECK(mentions(content("table.svg"), "T-handle", "mug", "die"));
  CHECK(mentions(thrown["chosen_and_spent"][1]["collides_as"].get<std::string>(),
                 "is not convex: its hollows collide as if they were filled"));
  const CommandResult ball = scenes("simulate " + example("bouncing_ball.json") + " --json");
  REQUIRE(ball.status == 0);
  const json bounced = json::parse(ball.output);
  CHECK(std::any_of(bounced["impacts"].begin(), bounced["impacts"].end(),
                    [](const json& impact) { return impact["other"] == "wall"; }));
  CHECK(mentions(bounced["chosen_and_spent"][0]["at_the_end"].get<std::string>(),
                 "rolling on the floor since"));
  CHECK(bounced["rest_since"]["ball"].is_null());
}

TEST_CASE("simulate: the examples' meshes are the objects of the chapters") {
  for (const tumble::objects::Object& object : tumble::objects::all) {
    const std::string name = object.name;
    if (name != "mug" && name != "t_handle") continue;
    const tumble::PolygonMesh kept = tumble::read_mesh(example(name + ".obj"));
    const tumble::PolygonMesh made = object.mesh(1);
    REQUIRE(kept.vertices.size() == made.vertices.size());
    CHECK(kept.face_count() == made.face_count());
    for (const tumble::Vec3& vertex : made.vertices)  // written with nine decimals
      CHECK(std::any_of(kept.vertices.begin(), kept.vertices.end(), [&](const tumble::Vec3& v) {
        return (v - vertex).cwiseAbs().maxCoeff() < 0.51e-9;
      }));
  }
}

TEST_CASE("simulate: stop_when finds the first crossing on a flight, and leaves out what follows") {
  json scene = dropped_ball(1);
  scene["stop_when"] = {{"coordinate", "z"}, {"passes", 0.6}};
  json result = simulated(scene);
  CHECK(result["stopped"] == true);
  CHECK(std::abs(result["to"].get<double>() - std::sqrt(2 * 0.5 / g)) < 1e-14);
  CHECK(result["impacts"].empty());
  // Sideways it passes only after the wall has sent it back.
  scene["bodies"][0]["velocity"] = {1, 0, 0};
  scene["walls"] = {{{"point", {2.1, 0, 0}}, {"normal", {-3, 0, 0}}}};
  scene["stop_when"] = {{"coordinate", "x"}, {"passes", -1}};
  result = simulated(scene);
  CHECK(std::abs(result["to"].get<double>() - 5) < 1e-9);
  CHECK(std::abs(result["end"]["bodies"][0]["position"][0].get<double>() + 1) < 1e-9);
  CHECK(result["ending"] == "time");
  for (const json& impact : result["impacts"]) CHECK(impact["time"].get<double>() <= 5);
  scene["stop_when"]["passes"] = -100;
  write("scene.json", scene.dump());
  CHECK(mentions(scenes("simulate scene.json").output, "has not passed -100 m"));
}

TEST_CASE("simulate: where nothing can touch, each body goes the old way") {
  json scene = dropped_ball(0.5);
  scene["duration"] = 0.99 * fall;
  const json result = simulated(scene);
  CHECK(result["can_touch"] == false);
  CHECK(result["impacts"].empty());
  CHECK(result["chosen_and_spent"][0]["runs"] == 0);
  CHECK(result["chosen_and_spent"][0].contains("error_estimate"));
  write("scene.json", scene.dump());
  const CommandResult text = scenes("simulate scene.json --impacts impacts.csv --svg film.svg");
  CHECK(mentions(text.output, "nothing can touch: no collision code ran"));
  CHECK(lines_of(content("impacts.csv")) == 1);
  CHECK(mentions(content("film.svg"), "a picture every"));
}

TEST_CASE("simulate: without floor, walls, restitution and friction bodies still don't touch") {
  json scene = {{"bodies",
                 {{{"shape", {{"ball", 1}}}, {"mass", 1}},
                  {{"shape", {{"ball", 1}}}, {"mass", 1}, {"position", {0.5, 0, 0}}}}},
                {"duration", 1}};
  const json result = simulated(scene);
  for (const char* key : {"impacts", "rest_since", "energy", "ending", "can_touch"})
    CHECK_FALSE(result.contains(key));
  write("scene.json", scene.dump());
  CHECK(mentions(scenes("simulate scene.json --impacts i.csv").output, "no impacts without contact",
                 "floor"));
  CHECK(scenes("simulate scene.json --impacts i.csv").status == 2);
  scene["restitution"] = 0.5;
  CHECK(mentions(refusal(scene), "body 1 and body 2 overlap by 1.5 m"));
}

TEST_CASE("simulate: balls that meet, by name") {
  const json scene = {
      {"bodies",
       {{{"name", "cue"}, {"shape", {{"ball", 1}}}, {"mass", 1}, {"velocity", {1, 0, 0}}},
        {{"name", "eight"}, {"shape", {{"ball", 1}}}, {"mass", 1}, {"position", {5, 0, 0}}}}},
      {"restitution", 1},
      {"duration", 6}};
  const json result = simulated(scene);
  REQUIRE(result["impacts"].size() == 1);
  CHECK(result["impacts"][0]["body"] == "cue");
  CHECK(result["impacts"][0]["other"] == "eight");
  CHECK(std::abs(result["impacts"][0]["time"].get<double>() - 3) < 1e-8);
  CHECK(distance(result["end"]["bodies"][1]["velocity"], {1, 0, 0}) < 1e-12);
  CHECK(result["ending"] == "time");
}

TEST_CASE("simulate: contact that lasts, and too many impacts, are said, with exit status 1") {
  json scene = dropped_ball(0.5);
  const json low = {
      {"name", "low"}, {"shape", {{"ball", 0.1}}}, {"mass", 1}, {"position", {0, 0, 0.1}}};
  scene["bodies"].push_back(low);
  const CommandResult stack = said(scene);
  CHECK(stack.status == 1);
  CHECK(mentions(stack.output, " stays in touch, and we can't tell how it goes on",
                 "at the end: in contact that lasts, undecided"));
  scene = dropped_ball(1);
  scene["duration"] = 1e7;
  scene["record_every"] = 1e6;
  const CommandResult endless = said(scene);
  CHECK(endless.status == 1);
  CHECK(mentions(endless.output, "there are 100000 impacts, the most that we allow"));
}

TEST_CASE("simulate: a box that slides on its face, to the digit; on another one, it is said") {
  json scene = dropped_ball(0.5);
  const double mu = 0.3, pull = 9.81, v = 0.5, stops = v / (mu * pull);
  scene["gravity"] = {0, 0, -pull};
  scene["friction"] = mu;
  scene["bodies"][0] = {{"name", "box"},
                        {"shape", {{"box", {0.2, 0.2, 0.1}}}},
                        {"mass", 1},
                        {"position", {0, 0, 0.05}},
                        {"velocity", {v, 0, 0}}};
  scene["duration"] = 1;
  const json result = simulated(scene);
  CHECK(std::abs(result["end"]["bodies"][0]["position"][0].get<double>() - v * stops / 2) < 1e-9);
  CHECK(std::abs(result["rest_since"]["box"].get<double>() - stops) < 1e-9);
  CHECK(std::abs(result["energy"]["lost_in_sliding"].get<double>() - v * v / 2) < 1e-9);
  json above = scene["bodies"][0];
  above["name"] = "above";
  above["position"] = {0, 0, 0.15};
  scene["bodies"].push_back(above);
  for (const double e : {0., 0.5, 0.8}) {
    scene["restitution"] = e;
    const CommandResult stack = said(scene);
    CHECK(stack.status == 1);
    CHECK(mentions(stack.output, " stays in touch, and we can't tell how it goes on"));
  }
}

TEST_CASE("simulate: what is round collides as a polyhedron, and how far it is off is said") {
  const double pi = std::acos(-1.0);
  const auto missing = [](const json& shape) {
    json scene = dropped_ball(0.5);
    scene["bodies"][0]["shape"] = shape;
    scene["duration"] = 0.5;
    return simulated(scene)["chosen_and_spent"][0]["missing"].get<double>();
  };
  const json round = {{"radius", 0.1}, {"height", 0.2}};
  const double fine = 0.1 * (1 - std::cos(pi / 128)), coarse = 1 - std::cos(pi / 64);
  CHECK(std::abs(missing({{"cylinder", round}}) - fine) < 1e-15);
  CHECK(std::abs(missing({{"cone", round}}) - fine) < 1e-15);
  CHECK(std::abs(missing({{"capsule", round}}) - 2 * 0.1 * coarse) < 1e-15);
  CHECK(std::abs(missing({{"ellipsoid", {0.1, 0.2, 0.3}}}) - 2 * 0.3 * coarse) < 1e-15);
  CHECK(missing({{"box", {0.1, 0.1, 0.1}}}) == 0);
}

TEST_CASE("simulate: a polyhedron stands where its solid does") {
  // A capsule that stands upright on its cap, a cone on its base: the first impact of a fall of 1
  // m.
  const auto lands = [](const json& shape, double lowest) {
    json scene = dropped_ball(0.5);
    scene["bodies"][0]["shape"] = shape;
    scene["bodies"][0]["position"] = {0, 0, 1 + lowest};
    scene["duration"] = 0.5;
    return simulated(scene)["impacts"][0]["time"].get<double>();
  };
  const json round = {{"radius", 0.1}, {"height", 0.2}};
  CHECK(std::abs(lands({{"capsule", round}}, 0.2) - fall) < 1e-8);
  CHECK(std::abs(lands({{"cylinder", round}}, 0.1) - fall) < 1e-8);
  CHECK(std::abs(lands({{"cone", round}}, 0.05) - fall) < 1e-8);
  CHECK(std::abs(lands({{"ellipsoid", {0.1, 0.2, 0.3}}}, 0.3) - fall) < 1e-8);
  write("tetrahedron.obj", tetrahedron);
  CHECK(std::abs(lands({{"mesh", "tetrahedron.obj"}}, 0.25) - fall) < 1e-8);
}

TEST_CASE("simulate: says what is wrong with a scene of contact, and where") {
  const json good = dropped_ball(0.5);
  const auto refused = [&](const json& change) {
    json scene = good;
    scene.merge_patch(change);
    return refusal(scene);
  };
  CHECK(mentions(refused({{"restitution", 1.5}}), "scene.json.restitution is 1.5", "0 and 1"));
  CHECK(mentions(refused({{"restitution", -0.1}}), "scene.json.restitution is -0.1"));
  CHECK(mentions(refused({{"friction", -1}}), "scene.json.friction is -1", "0 or more"));
  CHECK(mentions(refused({{"floor", {{"point", {0, 0, 0}}, {"normal", {0, 0, 0}}}}}),
                 "scene.json.floor.normal is zero"));
  CHECK(mentions(refused({{"floor", {{"height", 0}}}}), "scene.json.floor has \"height\""));
  CHECK(mentions(refused({{"walls", {{{"point", {0, 0, 0}}, {"normal", {0, 0}}}}}}),
                 "scene.json.walls[0].normal has 2 numbers"));
  CHECK(mentions(refused({{"frictoin", 1}}), "frictoin", "did you mean friction?"));
  CHECK(mentions(refused({{"floor", 1.05}}), "scene.json.bodies[0]: ball starts 0.05 m deep",
                 "in the floor"));
  const json wall = {{"point", {1, 0, 0}}, {"normal", {-1, 0, 0}}, {"name", "ball"}};
  CHECK(mentions(refused({{"walls", {wall}}}), "walls[0] is called \"ball\""));
  const auto refused_body = [&](const char* key, const json& value) {
    json scene = good;
    scene["bodies"][0][key] = value;
    return refusal(scene);
  };
  CHECK(mentions(refused_body("forces", {{{"drag", {{"linear", 1}}}}}),
                 "scene.json.bodies[0].forces", "gravity alone"));
  CHECK(mentions(refused_body("held_at", {0, 0, 0}), "scene.json.bodies[0].held_at"));
  json bare = good;
  bare["bodies"][0].erase("shape");
  bare["bodies"][0]["inertia"] = {1, 1, 1};
  CHECK(mentions(refusal(bare), "scene.json.bodies[0] has no shape"));
}
