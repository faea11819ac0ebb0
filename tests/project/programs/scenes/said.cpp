// What ./tumble mass and ./tumble simulate say, and which files they leave alone.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "project/harness/refusal.hpp"
#include "project/programs/scenes/run_scenes.hpp"

using namespace tumble::test;
using nlohmann::json;

namespace {

bool is_there(const std::string& file) { return std::filesystem::exists(folder / file); }

/// A unit cube's faces, and behind them the same ones turned round: a mesh without a volume.
std::string cube_and_its_reverse() {
  const std::string faces[] = {"1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"};
  std::string text;
  for (int i = 0; i < 8; ++i)
    text += "v " + std::to_string(i & 1) + " " + std::to_string(i / 2 & 1) + " " +
            std::to_string(i / 4) + "\n";
  for (const std::string& face : faces)
    text += "f " + face + "\nf " + std::string(face.rbegin(), face.rend()) + "\n";
  return text;
}

json spinning(const json& inertia) {
  return {{"bodies", {{{"mass", 1}, {"inertia", inertia}, {"omega", {1, 2, 3}}}}}, {"duration", 1}};
}

/// What is said to a scene file of this text.
std::string said_to(const std::string& text) {
  write("text.json", text);
  const CommandResult result = scenes("simulate text.json");
  CHECK(result.status == 2);
  return result.output;
}

}  // namespace

TEST_CASE("simulate: no output is the scene, its mesh or another output, and nothing is lost") {
  write("tetrahedron.obj", tetrahedron);
  const json scene = {{"bodies", {{{"shape", {{"mesh", "tetrahedron.obj"}}}, {"mass", 3}}}},
                      {"floor", -9},
                      {"duration", 0.01}};
  write("own.json", scene.dump());
  std::filesystem::create_symlink("own.json", folder / "link.csv");
  const auto said = [](const std::string& options) {
    const CommandResult result = scenes("simulate own.json " + options);
    CHECK(result.status == 2);
    return result.output;
  };
  CHECK(mentions(said("--csv own.json"), "--csv own.json: this file is your scene"));
  CHECK(mentions(said("--svg ./own.json"), "--svg", "this file is your scene"));
  CHECK(mentions(said("--impacts link.csv"), "--impacts", "this file is your scene"));
  CHECK(mentions(said("--csv tetrahedron.obj"), "this file is the mesh of body 1"));
  CHECK(mentions(said("--csv same --svg ./same"), "--csv and --svg name the same file"));
  CHECK(mentions(said("--svg same --impacts same"), "--svg and --impacts name the same file"));
  CHECK_FALSE(is_there("same"));
  CHECK(content("own.json") == scene.dump());
  CHECK(content("tetrahedron.obj") == tetrahedron);
  CHECK(scenes("simulate own.json --csv a.csv --svg b.svg").status == 0);
}

TEST_CASE("mass: no block without finite numbers") {
  write("flat.obj", cube_and_its_reverse());
  write("tetrahedron.obj", tetrahedron);
  for (const std::string block : {"--urdf", "--sdf", "--mjcf"}) {
    const CommandResult alone = scenes("mass flat.obj --accept " + block);
    CAPTURE(alone.output);
    CHECK(alone.status == 1);
    CHECK(mentions(alone.output, "flat.obj: the mesh encloses no volume", "no " + block));
    CHECK_FALSE(mentions(alone.output, "nan"));
    CHECK_FALSE(mentions(alone.output, "inertial>"));
    const CommandResult both = scenes("mass flat.obj tetrahedron.obj --accept " + block);
    CHECK(both.status == 1);
    CHECK(mentions(both.output, "<inertial", "no " + block));
  }
}

TEST_CASE("mass: no block of a body that cannot be, and what was found stands beside the numbers") {
  write("inside_out.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n");
  write("open--.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n");
  for (const std::string block : {"--urdf", "--sdf", "--mjcf"}) {
    const CommandResult turned = scenes("mass inside_out.obj --accept " + block);
    CHECK(turned.status == 1);
    CHECK(mentions(turned.output, "the mass is negative: the faces are inside out", "no " + block));
    CHECK_FALSE(mentions(turned.output, "inertial>"));
    const CommandResult open = scenes("mass open--.obj open--.obj --accept " + block);
    CHECK(mentions(open.output, "<!-- open- -.obj -->", "<!-- open_edge: the edge", "<inertial"));
  }
}

TEST_CASE("mass: blocks have as few digits as give the same doubles back") {
  write("tetrahedron.obj", tetrahedron);
  const std::string block = scenes("mass tetrahedron.obj --density 6 --urdf").output;
  CHECK(mentions(block, "xyz=\"0.25 0.25 0.25\"", "<mass value=\"1\"/>", "ixy=\"0.0125\""));
}

TEST_CASE("simulate: no name reaches the terminal as a command") {
  json scene = thrown_ball();
  scene["bodies"][0]["name"] = "b\n\u001b[31mc";
  scene["floor"] = {{"point", {0, 0, -0.5}}, {"normal", {0, 0, 1}}};
  write("named.json", scene.dump());
  const CommandResult in_contact = scenes("simulate named.json");
  CHECK(mentions(in_contact.output, "b\\n\\x1B[31mc"));
  CHECK_FALSE(mentions(in_contact.output, "\x1b"));
  scene.erase("floor");
  scene["stop_when"] = {{"coordinate", "z"}, {"passes", 1000}};
  write("named.json", scene.dump());
  const CommandResult flown = scenes("simulate named.json --csv named.csv --svg named.svg");
  CHECK(mentions(flown.output, "the z of b\\n\\x1B[31mc has not passed"));
  CHECK_FALSE(mentions(flown.output, "\x1b"));
  CHECK(mentions(content("named.csv"), "\"b\n\x1b[31mc\""));  // other programs get the name
  scene["stop_when"]["body"] = "\u001b[2J";
  CHECK(mentions(refusal(scene), "there is no body \"\\x1B[2J\""));
  scene["stop_when"] = {{"\u001b[2J", 0}};
  CHECK(mentions(refusal(scene), "has \"\\x1B[2J\", which means nothing"));
}

TEST_CASE("mass: no name in a file, and of a file, reaches the terminal as a command") {
  write("\x1b[31mpart.obj", "usemtl \x1b[32m\n" + tetrahedron);
  for (const std::string options : {"", " --urdf", " --density steel=1", " --density 1"}) {
    const std::string quoted = "'\x1b[31mpart.obj'";
    CHECK_FALSE(mentions(scenes("mass " + quoted + options).output, "\x1b"));
    CHECK_FALSE(mentions(scenes("mass " + quoted + " " + quoted + options).output, "\x1b"));
  }
}

TEST_CASE("simulate: numbers for people have few digits, and no zero has a sign") {
  CHECK(mentions(refusal(spinning({1, 1, 2.0000001})), "1 + 1 are less than 2.0000001, by 1e-07"));
  CHECK(mentions(refusal(spinning({1, 1, 1, 0.9, 0, 0})), "0.1 + 1 are less than 1.9"));
  json scene = thrown_ball();
  scene["bodies"][0]["velocity"] = {0, -0.0, 0};
  scene["stop_when"] = {{"coordinate", "z"}, {"passes", -0.6116}};
  write("falls.json", scene.dump());
  const std::string text = scenes("simulate falls.json --csv falls.csv").output;
  CHECK(mentions(text, "stopped at t = 0.349742763 s"));
  CHECK_FALSE(mentions(text, " -0 "));
  CHECK(mentions(content("falls.csv"), "\n0.03,body 1,"));
}

TEST_CASE("simulate: what a file's text has wrong is said in plain words, with the line") {
  const std::string ball = R"({"bodies": [{"shape": {"ball": 1}, "mass": 1, "name": "1e999)";
  const std::string large = said_to(ball + "\"}],\n\"duration\": 1e999}");
  CHECK(mentions(large, "text.json, line 2, column ", "the number 1e999 is too large"));
  CHECK_FALSE(mentions(large, "not valid JSON"));
  CHECK(mentions(said_to("{\n\"duration\": -1e400}"), "line 2", "the number -1e400 is too large"));
  const auto plain = [&](const std::string& part, const std::string& words) {
    const std::string said = said_to("\n" + ball + part + "\"}], \"duration\": 1}");
    CHECK_MESSAGE(mentions(said, "text.json is not valid JSON: line 2, column", words), said);
    CHECK_FALSE(mentions(said, "last read"));
  };
  plain("\\ud800", "half of a character");
  plain("\\udc00", "half of a character");
  plain("\t", "a raw control character: write \\t for a tab");
  plain("\n", "a raw control character: write \\t for a tab");
  plain("\xff", "not UTF-8");
  plain("\\x", "a \\ before a character that needs none");
  plain("\\u12", "without four hexadecimal digits");
  plain("\", \"tolerance\": NaN, \"", "JSON has no such word");
}

TEST_CASE("simulate: a file nested so deep that no program should follow it is refused") {
  for (const auto& [open, close] : {std::pair{"[", "]"}, {R"({"a":)", "}"}}) {
    std::string text;
    for (int i = 0; i < 100'000; ++i) text += open;
    text += "1";
    for (int i = 0; i < 100'000; ++i) text += close;
    CHECK(mentions(said_to(text),
                   "text.json is nested deeper than 64: it has too many [ or { in each other"));
  }
}

TEST_CASE("simulate: a mesh's name ends where its text does") {
  write("named.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  const json shape = {{"mesh", std::string("named.obj\0.old", 14)}};
  CHECK(mentions(refusal({{"bodies", {{{"shape", shape}, {"mass", 1}}}}, {"duration", 1}}),
                 "scene.json.bodies[0].shape.mesh is \"named.obj\\x00.old\": no file has"));
}

TEST_CASE("simulate: a figure of a motion however slow or fast") {
  for (const double omega : {1e-300, 1e30}) {
    json scene = spinning({1, 1, 1});
    scene["bodies"][0]["omega"] = {omega, 0, 0};
    write("scene.json", scene.dump());
    std::filesystem::remove(folder / "spin.svg");
    CHECK(scenes("simulate scene.json --svg spin.svg").status != 2);
    CHECK(is_there("spin.svg"));
  }
}

TEST_CASE("simulate: advice is such that a scene can follow it") {
  json still = spinning({1, 2, 3});
  still["duration"] = 0;
  write("still.json", still.dump());
  CHECK(mentions(scenes("simulate still.json").output, "method: none: the duration is 0"));
  json wild = spinning({1, 2, 3});
  wild["bodies"][0]["forces"] = {{{"drag", {{"angular", 1e9}}}},
                                 {{"force", {{"newton", {1, 1, 1}}, {"at", {0.1, 0, 0.3}}}}}};
  write("wild.json", wild.dump());
  const CommandResult result = scenes("simulate wild.json");
  CHECK(result.status == 2);
  CHECK(mentions(result.output, "body 1: the angular drag 1e+09 kg m²/s", "give about 1e+04"));
  CHECK_FALSE(mentions(result.output, "by series"));
}

TEST_CASE("simulate: a force too strong to be followed is named, with one that is not") {
  const auto said = [](const json& forces) {
    json scene = spinning({1, 2, 3});
    scene["bodies"][0]["forces"] = forces;
    return refusal(scene);
  };
  json spring = {{"at", {0, 0, 1}}, {"anchor", {0, 0, 3}}, {"stiffness", 1e60}};
  CHECK(mentions(said({{{"spring", spring}}}), "body 1: the stiffness 1e+60 N/m", "within",
                 "give about 1e+09 N/m"));
  spring["stiffness"] = 1;
  spring["damping"] = 1e60;
  CHECK(mentions(said({{{"spring", spring}}}), "body 1: the damping 1e+60 N s/m"));
  const json push = {{"newton", {0, 1e60, 0}}, {"at", {0, 0, 1}}};
  CHECK(mentions(said({{{"force", push}}}), "body 1: the force 1e+60 N"));
  CHECK(mentions(said({{{"force", push}}, {{"spring", spring}}}), "body 1: the damping 1e+60"));
  json two = spinning({1, 2, 3});
  two["bodies"].push_back(two["bodies"][0]);
  two["bodies"][1]["position"] = {1, 0, 0};
  two["springs"] = {
      {{"from", {{"body", "body 1"}}}, {"to", {{"body", "body 2"}}}, {"stiffness", 1e60}}};
  CHECK(mentions(refusal(two), "the bodies that springs join: the stiffness 1e+60 N/m"));
}
