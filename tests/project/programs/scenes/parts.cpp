// Bodies made of several materials, in ./tumble mass and in scenes.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>

#include "project/harness/refusal.hpp"
#include "project/programs/scenes/run_scenes.hpp"

using namespace tumble::test;
using nlohmann::json;

namespace {

/// A head of 4 × 2 × 2 on a handle of 1 × 1 × 8, which touch at z = 0.
const std::string hammer =
    "o head\nusemtl steel\n"
    "v -2 -1 0\nv 2 -1 0\nv -2 1 0\nv 2 1 0\nv -2 -1 2\nv 2 -1 2\nv -2 1 2\nv 2 1 2\n"
    "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"
    "o handle\nusemtl wood\n"
    "v -.5 -.5 -8\nv .5 -.5 -8\nv -.5 .5 -8\nv .5 .5 -8\nv -.5 -.5 0\nv .5 -.5 0\nv -.5 .5 0\n"
    "v .5 .5 0\nf -8 -6 -5 -7\nf -4 -3 -1 -2\nf -8 -7 -3 -4\nf -6 -2 -1 -5\nf -8 -4 -2 -6\n"
    "f -7 -5 -1 -3\n";

json mass_of(const std::string& options) {
  write("hammer.obj", hammer);
  const CommandResult result = scenes("mass hammer.obj --json " + options);
  CAPTURE(result.output);
  REQUIRE(result.status == 0);
  return json::parse(result.output);
}

/// What is said to options that are refused.
std::string refused(const std::string& options) {
  write("hammer.obj", hammer);
  const CommandResult result = scenes("mass hammer.obj " + options);
  CHECK(result.status == 2);
  return result.output;
}

// With the densities 8 and 1/2: masses 128 and 4, centres 5 apart.
const std::string both = "--density steel=8 --density wood=0.5 ";
constexpr double head_xx = 128 * 8 / 12.0, head_yy = 128 * 20 / 12.0, handle_xx = 4 * 65 / 12.0,
                 handle_zz = 4 * 2 / 12.0, apart = 128 * 4 * 25 / 132.0;
const std::vector<double> inertia = {
    head_xx + handle_xx + apart, head_yy + handle_xx + apart, head_yy + handle_zz, 0, 0, 0};

}  // namespace

TEST_CASE("mass: a hammer of steel and wood, part by part and as a whole") {
  const json mass = mass_of(both + "--about 0 0 0");
  CHECK(mass["mass"] == 132);
  CHECK(mass["volume"] == 24);
  CHECK(mass["density"].is_null());
  const double z = (128 - 16) / 132.0;
  CHECK(distance(mass["centre"], {0, 0, z}) < 1e-15);
  CHECK(distance(mass["inertia"], inertia) < 1e-13);
  CHECK(std::abs(mass["about"]["inertia"][0].get<double>() - inertia[0] - 132 * z * z) < 1e-12);
  CHECK(mass["bounds"]["inertia"].get<double>() < 1e-15);
  const json& parts = mass["parts"];
  REQUIRE(parts.size() == 2);
  CHECK(parts[0]["name"] == "steel");
  CHECK(parts[0]["faces"] == 6);
  CHECK(parts[0]["density"] == 8);
  CHECK(parts[0]["volume"] == 16);
  CHECK(parts[0]["mass"] == 128);
  CHECK(distance(parts[0]["centre"], {0, 0, 1}) == 0);
  CHECK(distance(parts[0]["inertia"], {head_xx, head_yy, head_yy, 0, 0, 0}) < 1e-13);
  CHECK(parts[1]["name"] == "wood");
  CHECK(parts[1]["mass"] == 4);
  CHECK(distance(parts[1]["inertia"], {handle_xx, handle_xx, handle_zz, 0, 0, 0}) < 1e-14);
  CHECK(mass_of("--density head=8 --density handle=0.5")["inertia"] == mass["inertia"]);
}

TEST_CASE("mass: a weighed mass makes all densities larger alike") {
  const json light = mass_of(both), heavy = mass_of(both + "--mass 264");
  CHECK(heavy["mass"] == 264);
  CHECK(heavy["volume"] == 24);
  CHECK(heavy["parts"][0]["density"] == 16);
  CHECK(heavy["parts"][1]["density"] == 1);
  CHECK(heavy["parts"][1]["mass"] == 8);
  CHECK(heavy["centre"] == light["centre"]);
  for (std::size_t i = 0; i < 6; ++i)
    CHECK(heavy["inertia"][i] == 2 * light["inertia"][i].get<double>());
}

TEST_CASE("mass: parts in a table, in a unit, as a block, and of several files") {
  write("hammer.obj", hammer);
  const std::string table = scenes("mass hammer.obj " + both).output;
  CHECK(
      mentions(table, "density [kg/m³]", "steel", "wood", "the whole", "132", "principal axis 3"));
  CHECK(table.find("steel") < table.find("the whole"));
  CHECK(table.find(" -0 ") == std::string::npos);
  CHECK(mentions(scenes("mass hammer.obj hammer.obj " + both).output, "hammer.obj, wood"));
  CHECK(mentions(scenes("mass hammer.obj --urdf " + both).output, "<mass value=\"132\"/>"));
  CHECK(std::abs(mass_of(both + "--unit cm")["mass"].get<double>() / 132e-6 - 1) < 1e-15);
}

TEST_CASE("mass: without names, a file with names is what it was") {
  const json mass = mass_of("--density 2");
  CHECK(mass["mass"] == 48);
  CHECK(mass["density"] == 2);
  CHECK(!mass.contains("parts"));
}

TEST_CASE("mass: densities that are not there, too many, or no numbers") {
  CHECK(mentions(refused("--density steel=8"), "hammer.obj: faces #7 to #12", "wood",
                 "have no density"));
  CHECK(mentions(refused(both + "--density iron=1"), "no face is in \"iron\"", "\"steel\""));
  CHECK(mentions(refused(both + "--density handle=1"), "faces #7 to #12", "two densities"));
  CHECK(mentions(refused(both + "--density wood=1"), "\"wood\" has two densities"));
  CHECK(mentions(refused(both + "--density 5"), "density for all", "NAME=NUMBER"));
  CHECK(mentions(refused("--density 5 --density 6"), "two densities"));
  for (const char* bad : {"steel", "steel=", "=5", "steel=5x", "5x", "\"\""})
    CHECK_MESSAGE(mentions(refused(std::string("--density ") + bad), "NAME=NUMBER"), bad);
  CHECK(mentions(refused("--density steel=8 --density wood=-1"), "\"wood\": the density -1"));
  CHECK(mentions(refused("--density 3 --mass 4"), "a mass and a density"));
  CHECK(mentions(refused(both + "--shell 4"), "excludes"));
  write("tetrahedron.obj", tetrahedron);
  CHECK(mentions(scenes("mass tetrahedron.obj --density steel=8").output, "no face has a name"));
}

TEST_CASE("mass: a part that is open, and parts that overlap, by name") {
  const std::size_t last = hammer.rfind("f ");
  write("open.obj", hammer.substr(0, last));
  const CommandResult open = scenes("mass open.obj " + both);
  CHECK(open.status == 1);
  CHECK(mentions(open.output, "open_edge: \"wood\": the edge", "vertex #10", "--accept"));
  std::string deep = hammer;
  for (const char* top : {"v -.5 -.5 0", "v .5 -.5 0", "v -.5 .5 0", "v .5 .5 0"})
    deep.replace(deep.find(top), std::strlen(top), std::string(top).substr(0, 9) + " 1");
  write("deep.obj", deep);
  const CommandResult overlap = scenes("mass deep.obj " + both);
  CHECK(overlap.status == 1);
  CHECK(mentions(overlap.output, "parts overlap", "of \"steel\""));
}

TEST_CASE("simulate: a body of two materials") {
  write("hammer.obj", hammer);
  const json body = {{"shape", {{"mesh", "hammer.obj"}}},
                     {"density", {{"steel", 8}, {"wood", 0.5}}},
                     {"omega", {1, 2, 3}},
                     {"velocity", {1, 0, 0}}};
  json scene = {{"bodies", {body}}, {"duration", 1}};
  const json start = simulated(scene)["records"][0]["bodies"][0];
  CHECK(distance(start["angular_momentum"], {inertia[0], 2 * inertia[1], 3 * inertia[2]}) < 1e-12);
  CHECK(distance(start["linear_momentum"], {132, 0, 0}) < 1e-13);
  scene["bodies"][0]["mass"] = 264;
  CHECK(distance(simulated(scene)["records"][0]["bodies"][0]["linear_momentum"], {264, 0, 0}) <
        1e-13);
  scene["floor"] = -50;
  scene["bodies"][0].erase("mass");
  CHECK(simulated(scene)["can_touch"] == false);
}

TEST_CASE("simulate: densities of parts that are not there, or of no mesh") {
  write("hammer.obj", hammer);
  json scene = {{"bodies", {{{"shape", {{"mesh", "hammer.obj"}}}, {"density", {{"steel", 8}}}}}},
                {"duration", 1}};
  CHECK(mentions(refusal(scene), "bodies[0].shape.mesh: ", "faces #7 to #12", "have no density"));
  scene["bodies"][0]["density"] = json::object();
  CHECK(mentions(refusal(scene), "bodies[0].density is empty"));
  scene["bodies"][0]["density"] = {{"steel", "8"}};
  CHECK(mentions(refusal(scene), "bodies[0].density.steel is not a number"));
  scene["bodies"][0] = {{"shape", {{"ball", 1}}}, {"density", {{"steel", 8}}}};
  CHECK(mentions(refusal(scene), "only a mesh has parts"));
}
