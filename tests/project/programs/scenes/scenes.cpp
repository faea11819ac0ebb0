// ./tumble mass and ./tumble simulate from outside: results, and what they say to bad input.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "project/harness/refusal.hpp"
#include "project/harness/scanned_meshes.hpp"
#include "project/programs/scenes/run_scenes.hpp"
#include "support/wrapped.hpp"
#include "tumble/quaternion/exp_log.hpp"

using namespace tumble::test;
using nlohmann::json;

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
  for (const char* name :
       {"top", "pendulum", "thrown_box", "thrown_hammer", "on_a_spring", "two_on_a_spring"}) {
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
    if (std::string(name).starts_with("thrown")) {
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
  CHECK(mentions(refusal(scene), "bodies[0].density is -1; it must be positive"));
  scene["bodies"][0].erase("density");
  scene["bodies"][0]["mass"] = 0;
  CHECK(mentions(refusal(scene), "bodies[0].mass is 0; it must be positive"));
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
  CHECK(mentions(refusal(scene), "shape has \"ball\" and \"box\": a body has one shape"));
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
  write("scene.json",
        R"({"bodies": [1, {}, {"forces": [{}, {"drag": {"linear": 1, "linear": 2}}]}]})");
  CHECK(mentions(scenes("simulate scene.json").output,
                 "scene.json.bodies[2].forces[1].drag has \"linear\" twice"));
  write("scene.json", "{\"duration\": 1e999}");
  CHECK(mentions(scenes("simulate scene.json").output, "scene.json", "1e999"));
}

TEST_CASE("simulate: an empty { } is told what there is, and a body what it lacks") {
  json scene = thrown_ball();
  scene["stop_when"] = json::object();
  CHECK(mentions(refusal(scene), "stop_when is empty; there are: body, coordinate, passes"));
  scene = thrown_ball();
  scene["bodies"][0]["orientation"] = json::object();
  CHECK(mentions(refusal(scene), "orientation is empty; there are: axis, angle"));
  scene = thrown_ball();
  scene["bodies"][0]["forces"] = {{{"spring", json::object()}}};
  CHECK(mentions(refusal(scene), "forces[0].spring is empty; there are: at, anchor, stiffness"));
  scene["bodies"][0] = json::object();
  CHECK(mentions(refusal(scene), "bodies[0] is empty; there are: name, shape"));
  CHECK(mentions(refusal(json::object()), "scene.json is empty; there are: bodies"));
  scene["bodies"][0] = {{"mass", 1}};
  CHECK(mentions(refusal(scene), "bodies[0] has no shape, so it needs a mass and an inertia"));
}

TEST_CASE("simulate: a direction and an orientation may have any length") {
  json scene = thrown_ball();
  scene["bodies"][0]["omega"] = {0, 0, 1};
  const json usual = simulated(scene)["end"];
  scene["bodies"][0]["orientation"] = {1e-200, 0, 0, 0};
  CHECK(simulated(scene)["end"] == usual);
  scene["bodies"][0]["orientation"] = {{"axis", {0, 0, 1e-200}}, {"angle", 0}};
  CHECK(simulated(scene)["end"] == usual);
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
  CHECK(mentions(result.output, "the z of body 1 has not passed -3 m"));
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

TEST_CASE(
    "simulate: a slim held body has all digits of its omega, and its error is the stated one") {
  // L about the centre of a needle has no room for what turns it about itself; L about a point
  // beside its axis has.
  const json drag = {{"linear", 0.0023666899564547127}, {"angular", 0.09346521273186395}};
  const json push = {{"newton", {0.017107462333398143, -0.0527288593987771, 0.06173237711110883}},
                     {"at", {-6.570796343083296, -2.0068341040543653, -3.2797127578646967}}};
  json needle = {{"mass", 0.025333208200476787}};
  needle["inertia"] = {2.4910548260282663e-06, 0.2491054826028266, 0.24910779169934258};
  needle["held_at"] = {-0.10259419690104904, 0.27833226207664585, 1.338057815192881};
  needle["orientation"] = {0.6671015550856864, -0.5952965416336332, 0.2699366254248145,
                           0.36459458102973363};
  needle["omega"] = {7.854269673319896, -30.770337655318748, 51.692044416356474};
  needle["forces"] = {{{"drag", drag}}, {{"force", push}}};
  json scene = {{"duration", 1.5}, {"tolerance", 1e-11}};
  scene["gravity"] = {-7.454982199014583, 0.4875577039003415, 2.6404144755486665};
  scene["bodies"].push_back(needle);
  const json result = simulated(scene);
  // From an extrapolated midpoint rule with 19 digits.
  const Eigen::Quaterniond truth(0.008077653914327819, -0.8294036020556512, -0.540079688247538,
                                 -0.14261257569651226);
  const auto q = result["end"]["bodies"][0]["orientation"].get<std::array<double, 4>>();
  const Eigen::Quaterniond error = truth.conjugate() * Eigen::Quaterniond(q[0], q[1], q[2], q[3]);
  const double stated = result["chosen_and_spent"][0]["error_estimate"];
  CHECK(2 * error.vec().norm() <= 3 * stated);
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

TEST_CASE("simulate: a turned rod's stated error holds what rounding makes of its start") {
  // A symmetric top turns about L at L/J, and about its own axis at (1/J₁ − 1/J) L₁.
  using V = Eigen::Matrix<long double, 3, 1>;
  using Q = Eigen::Quaternion<long double>;
  const auto turn = [](const V& v) -> Q { return tumble::exp_quaternion<long double>(v); };
  const V J(1e-5, 1, 1), omega(0.3, -1.25, 2);
  const Q start = Q(1, 0.25, -0.5, 0.375).normalized();
  const V l = J.cwiseProduct(start.conjugate() * omega), L = start * l;
  json body = {{"mass", 1}};
  body["inertia"] = {1e-5, 1, 1};
  body["orientation"] = {1, 0.25, -0.5, 0.375};
  body["omega"] = {0.3, -1.25, 2};
  json scene = {{"duration", 100}, {"tolerance", 1e-6}};
  scene["bodies"].push_back(body);
  write("rod.json", scene.dump());
  const json result = json::parse(scenes("simulate rod.json --json").output);
  const double stated = result["chosen_and_spent"][0]["error_estimate"];
  CHECK(stated < 1e-7);
  for (const json& record : result["records"]) {
    const auto t = record["time"].get<long double>();
    const auto q = record["bodies"][0]["orientation"].get<std::array<long double, 4>>();
    const Q truth = turn(t * L) * start * turn(t * (1 / J[0] - 1) * l[0] * V::UnitX());
    CHECK(2 * (truth.conjugate() * Q(q[0], q[1], q[2], q[3])).vec().norm() <= stated);
  }
}

TEST_CASE("mass: a weighed mass, a unit, a point, principal axes") {
  write("tetrahedron.obj", tetrahedron);
  const json mass =
      json::parse(scenes("mass tetrahedron.obj --mass 5 --unit mm --about 0 0 0 --json").output);
  CHECK(mass["mass"] == 5);
  CHECK(std::abs(mass["volume"].get<double>() * 6e9 - 1) < 1e-15);
  CHECK(std::abs(mass["density"].get<double>() / 3e10 - 1) < 1e-15);
  CHECK(distance(mass["centre"], {0.25e-3, 0.25e-3, 0.25e-3}) < 1e-18);
  // About the corner: I_xx = ∫ y² + z² = 2/60 · 6, I_xy = −6/120, in units of m · mm².
  CHECK(distance(mass["about"]["inertia"], {1e-6, 1e-6, 1e-6, -0.25e-6, -0.25e-6, -0.25e-6}) <
        1e-20);
  CHECK(distance(mass["principal"]["moments"], {0.3125e-6, 0.3125e-6, 0.5e-6}) < 1e-20);
  const double inch =
      json::parse(scenes("mass tetrahedron.obj --unit in --json").output)["volume"].get<double>();
  CHECK(std::abs(inch / (0.0254 * 0.0254 * 0.0254 / 6) - 1) < 1e-14);
  CHECK(mentions(scenes("mass tetrahedron.obj --unit yd").output, "yd"));
  CHECK(scenes("mass tetrahedron.obj --mass 5 --density 2").status == 2);
  CHECK(mentions(scenes("mass tetrahedron.obj --density 0").output,
                 "the density 0 kg/m³ is not positive and finite"));
}

TEST_CASE("mass: bounds hold in every unit, far from the origin and of each part") {
  // 3 × 5 × 7, from (1000001, 2000003, −3000001) on: exact in the file, but in metres rounded.
  write(
      "far_box.obj",
      "g all\nv 1000001 2000003 -3000001\nv 1000004 2000003 -3000001\nv 1000001 2000008 -3000001\n"
      "v 1000004 2000008 -3000001\nv 1000001 2000003 -2999994\nv 1000004 2000003 -2999994\n"
      "v 1000001 2000008 -2999994\nv 1000004 2000008 -2999994\nf 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\n"
      "f 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n");
  constexpr double rounding = 0x1p-53;  // of what we compare with
  const auto is_right = [&](const json& mass, long double metre) {
    const long double volume = 105 * metre * metre * metre, xx = volume / 12 * 74 * metre * metre;
    const json& bounds = mass["bounds"];
    CHECK(bounds["mass"] < 1e-15);
    CHECK(std::abs(mass["mass"].get<double>() / volume - 1) <= bounds["mass"].get<double>());
    CHECK(std::abs(mass["inertia"][0].get<double>() / xx - 1) <= bounds["inertia"].get<double>());
    const long double x = mass["centre"][0].get<double>() - 1000002.5L * metre;
    CHECK(std::abs(x + mass["centre_rest"][0].get<double>()) <=
          rounding * 0x1p-10 * 1e6L * metre);  // long double's
  };
  const std::pair<const char*, long double> units[] = {
      {"m", 1}, {"cm", 0.01L}, {"mm", 0.001L}, {"in", 0.0254L}};
  for (const auto& each : units) {
    const std::string unit = each.first;
    const long double metre = each.second;
    CAPTURE(unit);
    const std::string command = "mass far_box.obj --json --unit " + unit;
    is_right(json::parse(scenes(command).output), metre);
    const json parts = json::parse(scenes(command + " --density all=1").output);
    is_right(parts, metre);
    is_right(parts["parts"][0], metre);
    const json shell = json::parse(scenes(command + " --shell 1").output);
    CHECK(std::abs(shell["area"].get<double>() / (142 * metre * metre) - 1) < 4 * rounding);
  }
}

TEST_CASE("mass: blocks for URDF, SDF and MJCF, with the centre and the products as they mean") {
  write("box.obj",  // [0, 1] × [0, 2] × [0, 3], and a small one at the far corner: no product is 0
        "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 1 2 0\nv 0 0 3\nv 1 0 3\nv 0 2 3\nv 1 2 3\n"
        "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"
        "v 1 2 3\nv 2 2 3\nv 1 3 3\nv 1 2 5\nf 9 11 10\nf 9 10 12\nf 9 12 11\nf 10 11 12\n");
  const json mass = json::parse(scenes("mass box.obj --mass 4 --json").output);
  const json &I = mass["inertia"], &c = mass["centre"];
  const auto numbers_in = [](const std::string& text) {
    std::vector<double> list;
    for (const char* at = text.c_str(); *at != 0;) {
      char* end = nullptr;
      const double x = std::strtod(at, &end);
      const bool is_number = end != at && (at == text.c_str() || std::strchr("\"> ", at[-1]));
      if (is_number) list.push_back(x);
      at = is_number ? end : at + 1;
    }
    return list;
  };
  const auto same = [](const std::vector<double>& list, const std::vector<json>& expected) {
    REQUIRE(list.size() == expected.size());
    for (std::size_t i = 0; i < list.size(); ++i) CHECK(list[i] == expected[i].get<double>());
  };
  same(numbers_in(scenes("mass box.obj --mass 4 --urdf").output),
       {c[0], c[1], c[2], 0, 0, 0, 4, I[0], I[3], I[5], I[1], I[4], I[2]});
  same(numbers_in(scenes("mass box.obj --mass 4 --sdf").output),
       {c[0], c[1], c[2], 0, 0, 0, 4, I[0], I[3], I[5], I[1], I[4], I[2]});
  same(numbers_in(scenes("mass box.obj --mass 4 --mjcf").output),
       {c[0], c[1], c[2], 4, I[0], I[1], I[2], I[3], I[5], I[4]});
  CHECK(I[3].get<double>() < 0);
}

TEST_CASE("mass: what cannot be answered together is refused, and nothing is dropped") {
  write("tetrahedron.obj", tetrahedron);
  const auto refused = [](const std::string& options) {
    const CommandResult result = scenes("mass tetrahedron.obj " + options);
    CHECK(result.status == 2);
    return result.output;
  };
  CHECK(mentions(refused("--urdf --sdf"), "--sdf", "excludes", "--urdf"));
  CHECK(mentions(refused("--mjcf --json"), "--mjcf", "excludes", "--json"));
  CHECK(mentions(refused("--urdf --about 0 0 0"), "--about", "excludes", "--urdf"));
  CHECK(mentions(refused("tetrahedron.obj --mass 3"), "one body", "2 files"));
  CHECK(mentions(refused("tetrahedron.obj --about 0 0 0"), "--about", "2 files", "--json"));
  CHECK(mentions(refused("--density a=1 b=2"), "no such file", "--density b=2"));
  const CommandResult both = scenes("mass tetrahedron.obj tetrahedron.obj --about 0 0 0 --json");
  CHECK(json::parse(both.output)[1]["about"]["inertia"].size() == 6);
}

TEST_CASE("mass: several files and folders are one table, or a list of JSON") {
  std::filesystem::create_directories(folder / "meshes");
  write("meshes/b.obj", tetrahedron);
  write("meshes/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\n");
  write("meshes/notes.txt", "no mesh");
  write("meshes/._b.obj", "what macOS puts beside b.obj");
  write("meshes/.DS_Store", "");
  write("tetrahedron.obj", tetrahedron);
  const CommandResult table = scenes("mass meshes tetrahedron.obj");
  CHECK(table.status == 1);
  CHECK(mentions(table.output, "refused: open_edge", "0.166667"));
  CHECK(table.output.find("a.obj") < table.output.find("b.obj"));
  CHECK(table.output.find("._b") == std::string::npos);
  const CommandResult both = scenes("mass meshes/b.obj tetrahedron.obj --json");
  REQUIRE(both.status == 0);
  CHECK(json::parse(both.output).size() == 2);
  std::filesystem::create_directories(folder / "empty");
  CHECK(
      mentions(scenes("mass empty").output, "empty: no .obj, .stl or .ply file in this folder\n"));
  std::filesystem::create_directories(folder / "outer/inner.stl");
  write("outer/.hidden.obj", tetrahedron);
  CHECK(mentions(scenes("mass outer").output, "outer: no .obj, .stl or .ply file",
                 "we don't look into the folders in it"));
}

TEST_CASE("mass: a file that cannot be read does not cost the others their numbers") {
  std::filesystem::create_directories(folder / "some/folder.stl");
  write("some/b.obj", tetrahedron);
  write("some/a.obj", "v 0 0 0\nv 1 0 zero\n");
  const CommandResult table = scenes("mass some nowhere.obj");
  CHECK(table.status == 2);
  CHECK(mentions(table.output, "refused", "0.166667", "a.obj, line 2", "zero",
                 "nowhere.obj: cannot be read (No such"));
  CHECK(table.output.find("folder.stl") == std::string::npos);
  const CommandResult list = scenes("mass some --json");
  CHECK(list.status == 2);
  const json all = json::parse(list.output.substr(0, list.output.rfind(']') + 1));
  CHECK(mentions(all[0]["error"].get<std::string>(), "line 2"));
  CHECK(all[0]["mass"].is_null());
  CHECK(all[1]["mass"].get<double>() > 0);
  CHECK(mentions(scenes("mass some --urdf").output, "<inertial>", "line 2"));
  CHECK(scenes("mass some --density none").output.find("a.obj") == std::string::npos);
}

TEST_CASE("mass: a crossing is refused above a tolerance, and is a note below") {
  const std::string second = "v 0.98 0.98 0.98\nv 2 1 1\nv 1 2 1\nv 1 1 2\n";
  write("crossing.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
        "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n" +
            second + "f 9 11 10\nf 9 10 12\nf 9 12 11\nf 10 11 12\n");
  const CommandResult refused = scenes("mass crossing.obj");
  CHECK(refused.status == 1);
  CHECK(mentions(refused.output, "self_crossing", "of the volume count wrongly"));
  for (const std::string option : {"", " --thorough"}) {
    const json noted =
        json::parse(scenes("mass crossing.obj --tolerance 1e-3 --json" + option).output);
    CHECK(noted["mass"].is_number());
    REQUIRE(noted["findings"].size() == 1);
    CHECK(noted["findings"][0]["refused"] == false);
    CHECK(noted["findings"][0]["share"].get<double>() < 1e-5);
    CHECK(noted["findings"][0]["share"].get<double>() > 1e-6);
  }
}

TEST_CASE(
    "mass, simulate: a crossing below the tolerance is a note in each output, with its share") {
  const std::string second = "v 0.999 0.999 0.999\nv 2 1 1\nv 1 2 1\nv 1 1 2\n";
  write("small_crossing.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n"
        "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n" +
            second + "f 9 11 10\nf 9 10 12\nf 9 12 11\nf 10 11 12\n");
  for (const std::string options : {"", " --urdf"}) {
    const CommandResult noted = scenes("mass small_crossing.obj" + options);
    CHECK(noted.status == 0);
    CHECK(mentions(noted.output, "self_crossing: the surface passes through itself", " ± ",
                   "of the volume count wrongly"));
  }
  write("tetrahedron.obj", tetrahedron);
  CHECK(
      mentions(scenes("mass small_crossing.obj tetrahedron.obj").output, "self_crossing: 8.5e-10"));
  const json body = {{"shape", {{"mesh", "small_crossing.obj"}}}, {"mass", 3}};
  write("scene.json", json({{"bodies", {body}}, {"duration", 1}}).dump());
  CHECK(mentions(scenes("simulate scene.json").output, "shape.mesh: self_crossing:"));
}

TEST_CASE("mass, simulate: faces with vertices of their own are joined where these are equal") {
  const std::string soup =
      "v 0 0 0\nv 0 1 0\nv 1 0 0\nf -3 -2 -1\nv 0 0 0\nv 1 0 0\nv 0 0 1\nf -3 -2 -1\n"
      "v 1 0 0\nv 0 1 0\nv 0 0 1\nf -3 -2 -1\n";
  write("soup.obj", soup + "v 0 0 0\nv 0 0 1\nv 0 1 0\nf -3 -2 -1\n");
  const CommandResult result = scenes("mass soup.obj");
  CHECK(result.status == 0);
  CHECK(mentions(result.output, "welded: we take 8 vertices", "0.16666"));
  CHECK(json::parse(scenes("mass soup.obj --json --unit mm").output)["welded"] == 8);
  CHECK(mentions(scenes("mass soup.obj soup.obj").output, "welded"));
  CHECK(mentions(scenes("mass soup.obj --urdf").output, "welded: we take 8", "<inertial>"));
  CHECK(json::parse(scenes("mass soup.obj --shell 1 --json").output)["welded"] == 0);
  write("tetrahedron.obj", tetrahedron);
  CHECK(json::parse(scenes("mass tetrahedron.obj --json").output)["welded"] == 0);
  const json body = {{"shape", {{"mesh", "soup.obj"}}}, {"mass", 3}, {"velocity", {0, 0, 1}}};
  write("scene.json", json({{"bodies", {body}}, {"duration", 1}}).dump());
  const CommandResult moved = scenes("simulate scene.json");
  CHECK(moved.status == 0);
  CHECK(mentions(moved.output, "shape.mesh: welded: we take 8 vertices", "until t = 1 s"));
  // What is still open is told by the vertices' numbers in the file.
  write("open_soup.obj", soup);
  const CommandResult open = scenes("mass open_soup.obj");
  CHECK(open.status == 1);
  CHECK(mentions(open.output, "welded: we take 5 vertices", "vertex #6 at (0, 0, 1)",
                 "(open edges in all: 3)"));
}

TEST_CASE("mass: what is accepted has no nan and no negative error") {
  write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n");
  const CommandResult flat = scenes("mass flat.obj --accept");
  CHECK(flat.status == 0);
  CHECK(flat.output.find("nan") == std::string::npos);
  write("inverted.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 2 3 1\nf 4 2 1\nf 3 4 1\nf 4 3 2\n");
  const CommandResult inverted = scenes("mass inverted.obj --accept");
  CHECK(mentions(inverted.output, "inverted", "-0.16666"));
  CHECK(inverted.output.find(" -2.") == std::string::npos);
}

TEST_CASE("mass: a shell has area and mass, open or not") {
  write("sheet.obj", "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n");
  const json sheet = json::parse(scenes("mass sheet.obj --shell 3 --json").output);
  CHECK(sheet["area"] == 2);
  CHECK(sheet["mass"] == 6);
  CHECK(distance(sheet["inertia"], {6 / 12.0, 6 * 4 / 12.0, 6 * 5 / 12.0, 0, 0, 0}) < 1e-15);
}

TEST_CASE("mass: a shell of a material has a thickness, in the unit of the file") {
  write("sheet.obj", "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n");
  const auto answer = [](const std::string& options) {
    return json::parse(scenes("mass sheet.obj --json " + options).output);
  };
  const json steel = answer("--density 8000 --thickness 2 --unit mm");
  CHECK(std::abs(steel["surface_density"].get<double>() - 16) < 1e-14);
  CHECK(std::abs(steel["mass"].get<double>() - 32e-6) < 1e-20);
  CHECK(answer("--density 4 --thickness 0.5")["mass"] == 4);
  const json weighed = answer("--mass 3 --thickness 0.5");
  CHECK(weighed["mass"] == 3);
  CHECK(std::abs(weighed["surface_density"].get<double>() - 1.5) < 1e-15);
  const auto said = [](const std::string& options) {
    return scenes("mass sheet.obj " + options).output;
  };
  CHECK(mentions(said("--thickness 1"), "--thickness needs a --density"));
  CHECK(mentions(said("--thickness 0 --density 1"), "the thickness 0 m is not positive"));
  CHECK(mentions(said("--thickness 1 --shell 1"), "excludes"));
  CHECK(mentions(said("--mass 3 --shell 1"), "a mass and a surface density", "--thickness"));
  CHECK(mentions(said("--thickness 1 --density a=1"), "without a name"));
}

TEST_CASE("mass: what is asked about a volume is not asked about a shell") {
  write("sheet.obj", "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n");
  for (const char* shell : {"--shell 1", "--density 1 --thickness 1"})
    for (const char* option : {"--accuracy fast", "--tolerance 1e-3", "--thorough"}) {
      const CommandResult result = scenes(std::string("mass sheet.obj ") + shell + ' ' + option);
      CHECK(result.status == 2);
      CHECK(mentions(result.output, "excludes"));
    }
}

TEST_CASE("mass: a shell whose faces are there twice would weigh twice as much") {
  const std::string square = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\n";
  write("both_sides.obj", square + "f 1 2 3 4\nf 4 3 2 1\n");
  write("two_squares.obj", square + square + "f 1 2 3 4\nf 5 8 7 6\n");
  for (const char* file : {"both_sides.obj", "two_squares.obj"}) {
    const CommandResult result = scenes(std::string("mass --shell 3 ") + file);
    CHECK(result.status == 1);
    CHECK(mentions(result.output, "face #2 has the same vertices as face #1", "count twice"));
    const json accepted =
        json::parse(scenes(std::string("mass --accept --json --shell 3 ") + file).output);
    CHECK(accepted["mass"] == 12);
  }
}

TEST_CASE("mass: what no double holds is refused, and so is a point that is none") {
  write("tetrahedron.obj", tetrahedron);
  write("speck.obj", "v 0 0 0\nv 1e-78 0 0\nv 0 1e-78 0\nf 1 2 3\n");
  const auto refused = [](const std::string& arguments) {
    const CommandResult result = scenes("mass " + arguments);
    CHECK_MESSAGE(result.status == 2, arguments);
    return result.output;
  };
  CHECK(mentions(refused("tetrahedron.obj --mass 1e-310"), "too small or too large for double"));
  CHECK(mentions(refused("tetrahedron.obj --mass 1e-300"), "too small or too large for double"));
  CHECK(mentions(refused("tetrahedron.obj --density 1e-310"), "the mass of the mesh"));
  CHECK(mentions(refused("tetrahedron.obj --density 1e308 --unit m --about 1e3 0 0"), "too large"));
  CHECK(mentions(refused("speck.obj --shell 1"), "shell is too small or too large"));
  CHECK(mentions(refused("speck.obj --shell 1e300"), "shell is too small or too large"));
  CHECK(mentions(refused("tetrahedron.obj --about nan 0 0"), "--about", "nan"));
  CHECK(mentions(refused("tetrahedron.obj --about 0 inf 0"), "--about", "inf"));
  CHECK(mentions(refused("tetrahedron.obj --about 0 0 1e300"), "--about", "too large"));
  CHECK(mentions(refused("tetrahedron.obj --tolerance nan"), "the tolerance nan"));
}

TEST_CASE("mass: touching parts are accepted whatever the unit of the file is") {
  // A peg on the side of a block, turned and written with six decimals: 7 digits.
  const tumble::Quat q = tumble::exp_quaternion<double>(tumble::Vec3(0.3, -0.5, 0.7));
  std::string obj;
  const auto add_box = [&](const tumble::Vec3& low, const tumble::Vec3& high) {
    for (int i = 0; i < 8; ++i) {
      const tumble::Vec3 p =
          q * tumble::Vec3(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(),
                           i & 4 ? high.z() : low.z());
      std::array<char, 100> line{};
      std::snprintf(line.data(), line.size(), "v %.6f %.6f %.6f\n", p.x(), p.y(), p.z());
      obj += line.data();
    }
    obj +=
        "f -8 -6 -5 -7\nf -4 -3 -1 -2\nf -8 -7 -3 -4\nf -6 -2 -1 -5\nf -8 -4 -2 -6\nf -7 -5 -1 "
        "-3\n";
  };
  add_box({0, 0, 0}, {10, 10, 10});
  add_box({10, 4, 3}, {15, 7, 6});
  write("touching.obj", obj);
  for (const char* unit : {"m", "cm", "mm", "in"}) {
    const CommandResult result =
        scenes(std::string("mass touching.obj --tolerance 1e-12 --unit ") + unit);
    CAPTURE(result.output);
    CHECK_MESSAGE(result.status == 0, unit);
  }
}

TEST_CASE("mass and simulate: wrong usage, a missing file and a full disk are status 2") {
  for (const char* arguments : {"mass", "mass nowhere.obj", "mass --densty 1 x.obj", "weigh x.obj"})
    CHECK_MESSAGE(scenes(arguments).status == 2, arguments);
  CHECK(mentions(scenes("mass --densty 1 x.obj").output, "did you mean --density?"));
  CHECK(mentions(scenes("mass --help").output, "Usage: ./tumble mass"));
  write("scene.json", thrown_ball().dump());
  CHECK(mentions(scenes("simulate .").output, "cannot read .: it is a folder"));
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
