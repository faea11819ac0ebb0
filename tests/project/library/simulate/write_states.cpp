#include "tumble/simulate/write_states.hpp"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

using namespace tumble;
using nlohmann::json;

namespace {

const std::vector<RigidBody<>> written_bodies = {RigidBody<>(2, Mat3(Vec3(1, 2, 2.5).asDiagonal())),
                                                 RigidBody<>(1, Mat3::Identity())};
const std::vector<RigidBodyState<>> written_starts = {
    {Vec3(0, 0, 1), Quat(1, 0.2, 0.3, 0.1), Vec3(1, 2, 3), Vec3(1, 2.1, 0.4)}, {Vec3(1, 0, 0)}};
const std::vector<double> three_times = {0, 1 / 3., 2};

std::vector<std::vector<std::string>> cells(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

}  // namespace

TEST_CASE("write_csv: reading gives the same doubles back, and the stream is as it was") {
  const Trajectory motion = simulate(written_bodies[0], written_starts[0], {0, 2, 1e-9}, Weight{});
  std::ostringstream out;
  out.precision(3);
  output::write_csv(out, written_bodies[0], motion, three_times);
  const auto rows = cells(out.str());
  REQUIRE(rows.size() == 4);
  for (const auto& row : rows) CHECK(row.size() == 20);
  CHECK(rows[0][0] == "time");
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(std::stod(rows[i + 1][0]) == three_times[i]);
    const RigidBodyState<> state = motion.at(three_times[i]);
    const Vec3 omega = derived(written_bodies[0], state).omega;
    CHECK(std::stod(rows[i + 1][3]) == state.x.z());
    CHECK(std::stod(rows[i + 1][4]) == state.q.w());
    CHECK(std::stod(rows[i + 1][13]) == omega.z());
    CHECK(std::stod(rows[i + 1][19]) == state.L.z());
  }
  CHECK(out.precision() == 3);
  CHECK_THROWS_AS(output::write_csv(out, written_bodies[0], motion, std::vector{3.0}),
                  std::invalid_argument);
}

TEST_CASE("write_csv and write_json of several bodies") {
  const SceneTrajectory motion = simulate(written_bodies, written_starts, {0, 2, 1e-9}, Weight{});
  std::ostringstream csv, text;
  output::write_csv(csv, written_bodies, motion, three_times);
  const auto rows = cells(csv.str());
  REQUIRE(rows.size() == 7);
  CHECK(rows[4][1] == "1");
  CHECK(std::stod(rows[4][4]) == motion.at(three_times[1])[1].x.z());
  output::write_json(text, written_bodies, motion, three_times);
  const json parsed = json::parse(text.str());
  REQUIRE(parsed.size() == 3);
  CHECK(parsed[2]["time"] == 2);
  CHECK(parsed[1]["bodies"][0]["angular_momentum"][1] == motion.at(three_times[1])[0].L.y());
}

TEST_CASE("write_csv and write_json: the shortest digits that give the same double back") {
  const RigidBodyState<> still{Vec3(0.1, -0.3, 1e-7)};
  const Trajectory motion = simulate(written_bodies[1], still, {0, 2, 1e-9}, SteadyForces{});
  std::ostringstream csv, text;
  csv.precision(2);
  text.precision(2);
  output::write_csv(csv, written_bodies[1], motion, std::vector{0.1});
  output::write_json(text, written_bodies[1], motion, std::vector{0.1});
  CHECK(csv.str().ends_with("\n0.1,0.1,-0.3,1e-07,1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0\n"));
  CHECK(text.str().find("{\"time\":0.1,\"position\":[0.1,-0.3,1e-07],") != std::string::npos);
}

TEST_CASE("write_json: a list that any reader takes, of no time too") {
  const Trajectory motion = simulate(written_bodies[0], written_starts[0], {0, 2, 1e-9}, Weight{});
  std::ostringstream none, some;
  output::write_json(none, written_bodies[0], motion, {});
  CHECK(json::parse(none.str()) == json::array());
  output::write_json(some, written_bodies[0], motion, three_times);
  const json parsed = json::parse(some.str());
  CHECK(parsed[1]["position"][2] == motion.at(three_times[1]).x.z());
  CHECK(parsed[1]["orientation"].size() == 4);
}
