// ./tumble mass FILE and ./tumble simulate scene.json: the library without writing C++.
#include "scenes/commands.hpp"
#include "support/command_line.hpp"

int main(int argc, char** argv) {
  using namespace tumble::scenes;
  CLI::App app("Mass properties of meshes, and the motion of bodies.", "./tumble");
  app.require_subcommand(1);
  MassCommand mass;
  CLI::App* mass_app = app.add_subcommand("mass", "mass, centre of mass and inertia of a mesh");
  mass_app
      ->add_option("file", mass.file, "a closed mesh in an OBJ, STL or PLY file, lengths in metres")
      ->required();
  mass_app->add_option("--density", mass.density, "[kg/m³]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  mass_app->add_option("--accuracy", mass.accuracy, "fast, tight or textbook")
      ->capture_default_str()
      ->check(CLI::IsMember({"fast", "tight", "textbook"}));
  mass_app->add_flag("--accept", mass.accept, "compute what can be computed from a bad mesh too");
  mass_app->add_flag("--json", mass.json, "all digits, and everything that was found, as JSON");

  SimulateCommand simulate;
  CLI::App* simulate_app = app.add_subcommand("simulate", "the motion of a scene file's bodies");
  simulate_app->add_option("scene", simulate.file, "see chapters/scenes/README.md")->required();
  simulate_app->add_option("--csv", simulate.csv, "write the recorded states into this file");
  simulate_app->add_option("--svg", simulate.svg, "draw how the bodies turn into this file");
  simulate_app->add_flag("--json", simulate.json,
                         "all digits, and everything that was chosen and spent, as JSON");
  return tumble::support::run_command_line(
      app, argc, argv, [&] { return mass_app->parsed() ? run(mass) : run(simulate); });
}
