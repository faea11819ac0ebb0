// What ./tumble mass --urdf prints, read back by the parser that robots' programs use.
#include <doctest/doctest.h>
#include <urdf_parser/urdf_parser.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "project/harness/command.hpp"

using tumble::test::CommandResult;
using tumble::test::run_command;

TEST_CASE("mass --urdf: urdfdom reads the mass, the centre and the tensor of a tetrahedron") {
  const auto file = std::filesystem::temp_directory_path() / "tumble_urdf_tetrahedron.obj";
  std::ofstream(file) << "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  const CommandResult block = run_command(std::string(std::getenv("TUMBLE_SCENES")) + " mass " +
                                          file.string() + " --density 3 --urdf");
  std::filesystem::remove(file);
  REQUIRE(block.status == 0);
  const auto robot =
      urdf::parseURDF("<robot name=\"r\"><link name=\"a\">" + block.output + "</link></robot>");
  REQUIRE(robot);
  const auto& inertial = robot->getLink("a")->inertial;
  REQUIRE(inertial);
  CHECK(inertial->mass == doctest::Approx(1).epsilon(1e-15));
  CHECK(inertial->origin.position.x == doctest::Approx(0.5).epsilon(1e-15));
  CHECK(inertial->origin.position.y == doctest::Approx(0.25).epsilon(1e-15));
  CHECK(inertial->origin.rotation.w == 1);
  // About the corner ∫ x² dm = m a²/10, ∫ x y dm = m a b/20; then to the centre of mass.
  CHECK(inertial->ixx == doctest::Approx(0.2 - 2 / 16.0).epsilon(1e-14));
  CHECK(inertial->iyy == doctest::Approx(0.4 + 0.1 - 0.25 - 1 / 16.0).epsilon(1e-14));
  CHECK(inertial->ixy == doctest::Approx(-0.1 + 0.125).epsilon(1e-14));
  CHECK(inertial->iyz == doctest::Approx(-0.05 + 1 / 16.0).epsilon(1e-14));
}
