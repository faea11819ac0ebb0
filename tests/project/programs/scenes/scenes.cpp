// ./tumble mass and ./tumble simulate from outside: results, and what they say to bad input.
#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "project/harness/command.hpp"
#include "project/harness/refusal.hpp"
#include "project/harness/scanned_meshes.hpp"
#include "support/wrapped.hpp"

using namespace tumble::test;
using nlohmann::json;

namespace {

const std::filesystem::path folder = std::filesystem::temp_directory_path() / "tumble_test_scenes";

CommandResult scenes(const std::string& arguments) {
  return run_command("cd " + folder.string() + " && " + std::getenv("TUMBLE_SCENES") + " " +
                     arguments);
}

void write(const std::string& name, const std::string& text) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder / name) << text;
}

std::string content(const std::string& file) {
  std::ifstream stream(folder / file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The result of a scene, as --json gives it.
json simulated(const json& scene) {
  write("scene.json", scene.dump());
  const CommandResult result = scenes("simulate scene.json --json");
  CAPTURE(result.output);
  REQUIRE(result.status == 0);
  return json::parse(result.output);
}

/// What is said to a scene that is refused.
std::string refusal(const json& scene) {
  write("scene.json", scene.dump());
  const CommandResult result = scenes("simulate scene.json");
  CHECK(result.status == 2);
  return result.output;
}

json thrown_ball() {
  return {{"bodies", {{{"shape", {{"ball", 0.5}}}, {"density", 2}, {"velocity", {1, 0, 10}}}}},
          {"gravity", {0, 0, -10}},
          {"duration", 1}};
}

double distance(const json& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < b.size(); ++i) sum += std::pow(a.at(i).get<double>() - b[i], 2);
  return std::sqrt(sum);
}

const std::string tetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

}  // namespace

TEST_CASE("simulate: a thrown ball, with its momenta") {
  const json result = simulated(thrown_ball());
  const json ball = result["end"]["bodies"][0];
  CHECK(result["end"]["time"] == 1);
  CHECK(distance(ball["position"], {1, 0, 5}) < 1e-14);
  CHECK(distance(ball["velocity"], {1, 0, 0}) < 1e-14);
  const double mass = 2 * 4 / 3.0 * std::acos(-1.0) * 0.125;
  CHECK(distance(ball["linear_momentum"], {mass, 0, 0}) < 1e-14);
  CHECK(result["records"].size() == 101);
  const json chosen = result["chosen_and_spent"][0];
  CHECK(chosen["model"] == "ball");
  CHECK(chosen["reached"] == true);
  CHECK(chosen["runs"] == 0);
}

TEST_CASE("simulate: the examples run, and stop where they should") {
  for (const char* name : {"top", "pendulum", "thrown_box", "on_a_spring"}) {
    CAPTURE(std::string(name));
    const std::string file =
        std::string(std::getenv("TUMBLE_ROOT")) + "/chapters/scenes/examples/" + name + ".json";
    std::filesystem::create_directories(folder);
    const CommandResult result =
        scenes("simulate " + file + " --json --csv motion.csv --svg motion.svg");
    REQUIRE(result.status == 0);
    const json parsed = json::parse(result.output);
    CHECK(content("motion.csv").rfind("time,body,x,y,z,qw", 0) == 0);
    CHECK(mentions(content("motion.svg"), "<svg ", "</svg>", "time [s]"));
    if (name == std::string("thrown_box")) {
      CHECK(parsed["stopped"] == true);
      CHECK(std::abs(parsed["end"]["bodies"][0]["position"][2].get<double>()) < 1e-12);
    }
    CHECK(scenes("simulate " + file).status == 0);
  }
}

TEST_CASE("simulate: a mesh beside the scene, pushed at a point of the file's coordinates") {
  write("tetrahedron.obj", tetrahedron);
  json scene = {{"bodies", {{{"shape", {{"mesh", "tetrahedron.obj"}}}, {"mass", 3}}}},
                {"duration", 0.01}};
  // At the centre of mass: no torque.
  scene["bodies"][0]["forces"] = {{{"force", {{"newton", {0, 6, 0}}, {"at", {0.25, 0.25, 0.25}}}}}};
  json body = simulated(scene)["end"]["bodies"][0];
  CHECK(distance(body["linear_momentum"], {0, 0.06, 0}) < 1e-15);
  CHECK(distance(body["angular_momentum"], {0, 0, 0}) < 1e-15);
  scene["bodies"][0]["forces"][0]["force"]["at"] = {1.25, 0.25, 0.25};
  body = simulated(scene)["end"]["bodies"][0];
  CHECK(std::abs(body["angular_momentum"][2].get<double>() - 0.06) < 1e-4);
}

TEST_CASE("simulate: conventions of orientation and inertia") {
  json scene = {{"bodies",
                 {{{"mass", 1},
                   {"inertia", {2, 3, 4, -0.5, 0.25, 0.1}},
                   {"orientation", {{"axis", {0, 0, 2}}, {"angle", std::acos(-1.0) / 2}}},
                   {"omega", {0, 1, 0}}}}},
                {"duration", 0}};
  const json body = simulated(scene)["end"]["bodies"][0];
  CHECK(distance(body["orientation"], {std::sqrt(0.5), 0, 0, std::sqrt(0.5)}) < 1e-15);
  // ω is (1, 0, 0) in the body; L there is (2, −0.5, 0.1), turned by 90° about z.
  CHECK(distance(body["angular_momentum"], {0.5, 2, 0.1}) < 1e-15);
}

TEST_CASE("simulate: says where a scene is wrong, and what") {
  json scene = thrown_ball();
  scene["bodies"][0]["velocity"] = {1, 2};
  CHECK(mentions(refusal(scene), "scene.json.bodies[0].velocity", "2 numbers, not 3"));
  scene = thrown_ball();
  scene["bodies"][0]["omgea"] = {1, 2, 3};
  CHECK(mentions(refusal(scene), "bodies[0]", "omgea", "omega"));
  scene = thrown_ball();
  scene["bodies"][0]["density"] = -1;
  CHECK(mentions(refusal(scene), "bodies[0]", "mass"));
  scene = thrown_ball();
  scene["bodies"][0]["shape"] = {{"ball", -1}};
  CHECK(mentions(refusal(scene), "shape", "radius", "-1"));
  scene = thrown_ball();
  scene["bodies"][0]["forces"] = {{{"spring", {{"at", {0, 0, 0}}, {"anchor", {0, 0, 1}}}}}};
  CHECK(mentions(refusal(scene), "forces[0].spring", "stiffness"));
  scene = thrown_ball();
  scene["tolerance"] = 0;
  CHECK(mentions(refusal(scene), "tolerance is 0; it must be positive"));
  scene = thrown_ball();
  scene["record_every"] = -5;
  CHECK(mentions(refusal(scene), "record_every is -5; it must be between"));
  scene = thrown_ball();
  scene["stop_when"] = {{"coordinate", "w"}, {"passes", 0}};
  CHECK(mentions(refusal(scene), "stop_when.coordinate", "\"w\""));
  scene = thrown_ball();
  scene.erase("duration");
  CHECK(mentions(refusal(scene), "duration"));
  scene = {{"bodies", {{{"mass", 1}, {"inertia", {1, 1, 5}}}}}, {"duration", 1}};
  CHECK(mentions(refusal(scene), "bodies[0]", "triangle inequality"));
  write("scene.json", "{\"bodies\": [}");
  const CommandResult result = scenes("simulate scene.json");
  CHECK(result.status == 2);
  CHECK(mentions(result.output, "scene.json", "line 1", "column"));
  CHECK(mentions(scenes("simulate nowhere.json").output, "nowhere.json"));
}

TEST_CASE("simulate: one thing twice, nothing at all, and numbers of no world are refused") {
  json scene = thrown_ball();
  const auto with_force = [&](const json& force) {
    scene["bodies"][0]["forces"] = json::array({force});
    return refusal(scene);
  };
  const json push = {{"newton", {1, 0, 0}}}, drag = {{"linear", 1}};
  CHECK(mentions(with_force({{"force", push}, {"drag", drag}}),
                 "forces[0] has \"drag\" and \"force\""));
  CHECK(
      mentions(with_force(json::object()), "forces[0] is empty: give one of force, drag, spring"));
  scene = thrown_ball();
  scene["bodies"][0]["shape"] = {{"ball", 1}, {"box", {1, 1, 1}}};
  CHECK(mentions(refusal(scene), "shape has \"ball\" and \"box\""));
  scene["bodies"][0]["shape"] = json::object();
  CHECK(mentions(refusal(scene), "shape is empty: give one of ball, box"));
  scene = thrown_ball();
  scene["bodies"].push_back(scene["bodies"][0]);
  scene["bodies"][0]["name"] = "body 2";
  CHECK(mentions(refusal(scene), "bodies[1] is called \"body 2\", and so is one before it"));
  scene = thrown_ball();
  scene["bodies"][0]["velocity"] = {0, -1e300, 0};
  CHECK(mentions(refusal(scene), "bodies[0].velocity[1] is -1e+300"));
  write("scene.json", "{\"duration\": 1,\n \"duration\": 2}");
  CHECK(mentions(scenes("simulate scene.json").output, "scene.json has \"duration\" twice"));
  write("scene.json", "{\"duration\": 1e999}");
  CHECK(mentions(scenes("simulate scene.json").output, "scene.json", "1e999"));
}

TEST_CASE("simulate: messages name the place once, and speak no library's language") {
  json scene = thrown_ball();
  scene["bodies"][0]["shape"] = {{"cylinder", {{"radius", 1}}}};
  const std::string said = refusal(scene);
  CHECK(said.find("scene.json") == said.rfind("scene.json"));
  write("scene.json", "{\n  \"bodies\": [}");
  const std::string broken = scenes("simulate scene.json").output;
  CHECK(mentions(broken, "line 2, column 14"));
  CHECK(broken.find("json.exception") == std::string::npos);
}

TEST_CASE("simulate: an angle of many turns, and a level that is never passed, are said") {
  json scene = thrown_ball();
  scene["bodies"][0]["orientation"] = {{"axis", {0, 0, 1}}, {"angle", 90}};
  scene["stop_when"] = {{"coordinate", "z"}, {"passes", -3}};
  write("scene.json", scene.dump());
  const CommandResult result = scenes("simulate scene.json");
  CHECK(result.status == 0);
  CHECK(mentions(result.output, "bodies[0].orientation.angle is 90 rad", "1.5708 rad"));
  CHECK(mentions(result.output, "the z of body 1 did not pass -3 m"));
}

TEST_CASE("simulate: a held body turns about its point, which stays") {
  json rod = {{"shape", {{"box", {0.1, 0.1, 1}}}},
              {"mass", 2},
              {"held_at", {0, 0, 0.5}},
              {"position", {1, 2, 3}},
              {"orientation", {{"axis", {1, 0, 0}}, {"angle", 1}}}};
  const json scene = {{"bodies", {rod}}, {"gravity", {0, 0, -10}}, {"duration", 1}};
  const json result = simulated(scene);
  for (const json& record : result["records"])
    CHECK(std::abs(distance(record["bodies"][0]["position"], {1, 2, 3}) - 0.5) < 1e-12);
  CHECK(distance(result["end"]["bodies"][0]["position"], {1, 2, 3 - 0.5 * std::cos(1.)}) > 0.1);
  rod["velocity"] = {1, 0, 0};
  CHECK(mentions(refusal({{"bodies", {rod}}, {"duration", 1}}), "bodies[0] is held at a point",
                 "velocity"));
}

TEST_CASE("simulate: a name with a comma or a quote stays one field of the CSV") {
  json scene = thrown_ball();
  scene["bodies"][0]["name"] = "a,\"b\"";
  write("scene.json", scene.dump());
  REQUIRE(scenes("simulate scene.json --csv named.csv").status == 0);
  std::ifstream in(folder / "named.csv");
  std::string heading, row;
  std::getline(in, heading);
  std::getline(in, row);
  CHECK(mentions(row, ",\"a,\"\"b\"\"\","));
}

TEST_CASE("simulate: an unreachable tolerance is said, with exit status 1") {
  json scene = thrown_ball();
  scene["bodies"][0]["forces"] = {
      {{"spring", {{"at", {0.1, 0, 0}}, {"anchor", {0, 0, 1}}, {"stiffness", 5}}}}};
  scene["tolerance"] = 1e-18;
  write("scene.json", scene.dump());
  const CommandResult result = scenes("simulate scene.json");
  CHECK(result.status == 1);
  CHECK(mentions(result.output, "was not reached", "body 1"));
}

TEST_CASE("mass: a tetrahedron, in words and as JSON") {
  write("tetrahedron.obj", tetrahedron);
  CHECK(scenes("mass tetrahedron.obj").status == 0);
  const CommandResult result = scenes("mass tetrahedron.obj --density 12 --json");
  REQUIRE(result.status == 0);
  const json mass = json::parse(result.output);
  CHECK(std::abs(mass["volume"].get<double>() - 1.0 / 6) < 1e-16);
  CHECK(mass["mass"] == 2);
  CHECK(distance(mass["centre"], {0.25, 0.25, 0.25}) < 1e-16);
  // ∫ x² = 1/60 and ∫ x y = 1/120 of the unit tetrahedron, from its corner.
  const double moment = 12 * (2.0 / 60) - 2 * 2 * 0.0625, product = -12 / 120.0 + 2 * 0.0625;
  CHECK(distance(mass["inertia"], {moment, moment, moment, product, product, product}) < 1e-15);
  CHECK(mass["bounds"]["mass"].get<double>() < 1e-15);
  CHECK(mass["findings"].empty());
}

TEST_CASE("mass, simulate: the same tetrahedron as STL and PLY, whatever the name") {
  std::string stl = "solid tetrahedron\n";
  for (const char* facet : {"0 0 0 vertex 0 1 0 vertex 1 0 0", "0 0 0 vertex 1 0 0 vertex 0 0 1",
                            "0 0 0 vertex 0 0 1 vertex 0 1 0", "1 0 0 vertex 0 1 0 vertex 0 0 1"})
    stl += std::string("facet normal 0 0 0 outer loop vertex ") + facet + " endloop endfacet\n";
  write("tetrahedron.stl", stl + "endsolid\n");
  write("tetrahedron.mesh",
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
        "float z\n"
        "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  for (const std::string file : {"tetrahedron.stl", "tetrahedron.mesh"}) {
    const CommandResult result = scenes("mass " + file + " --json");
    REQUIRE(result.status == 0);
    CHECK(std::abs(json::parse(result.output)["volume"].get<double>() - 1.0 / 6) < 1e-16);
    const json body = {{"shape", {{"mesh", file}}}, {"mass", 3}, {"velocity", {0, 0, 1}}};
    const json end = simulated({{"bodies", {body}}, {"duration", 1}})["end"];
    CHECK(distance(end["bodies"][0]["linear_momentum"], {0, 0, 3}) < 1e-15);
  }
  write("torn.stl", stl);
  CHECK(mentions(scenes("mass torn.stl").output, "torn.stl, line 6", "endsolid"));
}

TEST_CASE("mass: a mesh that is not closed gives findings, no numbers, and exit status 1") {
  write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\n");
  const std::string program = std::getenv("TUMBLE_SCENES");
  const CommandResult json_only = run_command("(cd " + folder.string() + " && " + program +
                                              " mass open.obj --json 2>/dev/null)");
  CHECK(json_only.status == 1);
  const json refused = json::parse(json_only.output);
  CHECK(refused["mass"].is_null());
  CHECK(refused["findings"].size() == 3);
  CHECK(refused["findings"][0]["kind"] == "open_edge");
  CHECK(refused["findings"][0]["edge"].size() == 2);
  const CommandResult accepted = scenes("mass open.obj --accept --json");
  CHECK(accepted.status == 0);
  CHECK(json::parse(accepted.output)["mass"].is_number());
  CHECK(mentions(scenes("mass open.obj").output, "open_edge", "--accept"));
  CHECK(scenes("mass open.obj --density -1").status == 2);
  CHECK(mentions(scenes("mass none.obj").output, "none.obj"));
}

TEST_CASE("mass and simulate: wrong usage, a missing file and a full disk are status 2") {
  for (const char* arguments : {"mass", "mass nowhere.obj", "mass --densty 1 x.obj", "weigh x.obj"})
    CHECK_MESSAGE(scenes(arguments).status == 2, arguments);
  CHECK(mentions(scenes("mass --densty 1 x.obj").output, "did you mean --density?"));
  CHECK(mentions(scenes("mass --help").output, "Usage: ./tumble mass"));
  write("scene.json", thrown_ball().dump());
  CHECK(scenes("simulate scene.json --csv /dev/full").status == 2);
  CHECK(scenes("simulate scene.json --svg no/such/folder/a.svg").status == 2);
  const std::string program = std::getenv("TUMBLE_SCENES");
  for (const char* arguments : {"", "--json"})
    CHECK(run_command("(cd " + folder.string() + " && " + program + " simulate scene.json " +
                      arguments + " >/dev/full)")
              .status == 2);
}

TEST_CASE("simulate: in a narrow terminal no line is longer than it, and no word is broken") {
  write("scene.json", thrown_ball().dump());
  const CommandResult narrow =
      run_command("cd " + folder.string() + " && COLUMNS=40 script -qec '" +
                  std::getenv("TUMBLE_SCENES") + " simulate scene.json' /dev/null");
  std::istringstream lines(narrow.output);
  for (std::string line; std::getline(lines, line);)
    CHECK(tumble::support::characters(line) <= 41);  // and a carriage return
  CHECK(mentions(narrow.output, "    at the end: "));
}
