// ./tumble simulate with very many records, or bodies: files are complete, pictures stay pictures.
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "project/harness/refusal.hpp"
#include "project/programs/scenes/run_scenes.hpp"

using namespace tumble::test;
using nlohmann::json;

namespace {

json tumbling() {
  return {{"bodies", {{{"shape", {{"box", {1, 2, 3}}}}, {"mass", 1}, {"omega", {0.1, 20, 0.1}}}}},
          {"duration", 100}};
}

}  // namespace

TEST_CASE("simulate: of very many records the files have each one, the picture what can be seen") {
  constexpr std::size_t records = 50'000;
  json scene = tumbling();
  scene["record_every"] = 100. / records;
  write("records.json", scene.dump());
  const CommandResult result =
      scenes("simulate records.json --csv records.csv --svg records.svg --json");
  CHECK(result.status == 0);
  CHECK(json::parse(result.output)["records"].size() == records + 1);
  const std::string csv = content("records.csv"), svg = content("records.svg");
  CHECK(std::count(csv.begin(), csv.end(), '\n') == records + 2);
  CHECK(svg.size() < 100'000);
  CHECK(svg.size() > 20'000);
}

TEST_CASE("simulate: JSON with records written one by one is what a writer of the whole writes") {
  for (const char* more : {"{}", R"({"floor": -9})", R"({"floor": -2, "gravity": [0, 0, -9]})"}) {
    json scene = tumbling();
    scene.update(json::parse(more));
    scene["duration"] = 1;
    scene["record_every"] = 0.25;
    write("whole.json", scene.dump());
    const std::string text = scenes("simulate whole.json --json").output;
    CHECK(nlohmann::ordered_json::parse(text).dump(2) + "\n" == text);
  }
}

TEST_CASE("simulate: of very many bodies the picture shows the first ones, and says so") {
  json scene = tumbling();
  for (int i = 1; i < 300; ++i) scene["bodies"].push_back(scene["bodies"][0]);
  write("bodies.json", scene.dump());
  CHECK(scenes("simulate bodies.json --svg bodies.svg").status == 0);
  const std::string svg = content("bodies.svg");
  CHECK(mentions(svg, "the first 20 of 300 bodies", "body 20 z"));
  CHECK(!mentions(svg, "body 21 "));
}
