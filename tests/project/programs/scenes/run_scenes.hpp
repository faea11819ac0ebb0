#pragma once
/// @file
/// ./tumble mass and ./tumble simulate in a folder of their own.

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "project/harness/command.hpp"
#include "project/harness/temporary_folder.hpp"

namespace tumble::test {

using nlohmann::json;

inline const TemporaryFolder own_folder;
inline const std::filesystem::path& folder = own_folder.path();

inline CommandResult scenes(const std::string& arguments) {
  return run_command("cd " + folder.string() + " && " + std::getenv("TUMBLE_SCENES") + " " +
                     arguments);
}

inline void write(const std::string& name, const std::string& text) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder / name) << text;
}

inline std::string content(const std::string& file) {
  std::ifstream stream(folder / file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The result of a scene, as --json gives it.
inline json simulated(const json& scene) {
  write("scene.json", scene.dump());
  const CommandResult result = scenes("simulate scene.json --json");
  CAPTURE(result.output);
  REQUIRE(result.status == 0);
  return json::parse(result.output);
}

/// What is said to a scene that is refused.
inline std::string refusal(const json& scene) {
  write("scene.json", scene.dump());
  const CommandResult result = scenes("simulate scene.json");
  CHECK(result.status == 2);
  return result.output;
}

inline json thrown_ball() {
  return {{"bodies", {{{"shape", {{"ball", 0.5}}}, {"density", 2}, {"velocity", {1, 0, 10}}}}},
          {"gravity", {0, 0, -10}},
          {"duration", 1}};
}

inline double distance(const json& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < b.size(); ++i) sum += std::pow(a.at(i).get<double>() - b[i], 2);
  return std::sqrt(sum);
}

inline const std::string tetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

}  // namespace tumble::test
