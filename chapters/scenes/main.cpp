// ./tumble mass FILE and ./tumble simulate scene.json: the library without writing C++.
#include <initializer_list>
#include <string>
#include <vector>

#include "scenes/commands.hpp"
#include "support/command_line.hpp"

namespace {

/// How integrals over a volume are computed, which nobody asks about a shell.
void add_options_of_volumes(CLI::App& app, tumble::scenes::MassCommand& mass,
                            std::initializer_list<CLI::Option*> of_shells) {
  CLI::Option* const of_volumes[] = {
      app.add_option("--accuracy", mass.accuracy, "fast, tight or textbook")
          ->capture_default_str()
          ->check(CLI::IsMember({"fast", "tight", "textbook"})),
      app.add_option(
             "--tolerance", mass.tolerance,
             "the share of the volume that may count wrongly where a surface crosses itself")
          ->capture_default_str(),
      app.add_flag("--thorough", mass.thorough, "look for crossings at every pair of triangles")};
  for (CLI::Option* const option : of_volumes)
    for (CLI::Option* const shell : of_shells) option->excludes(shell);
}

void add_options(CLI::App& app, tumble::scenes::MassCommand& mass) {
  app.add_option("files", mass.files,
                 "closed meshes in OBJ, STL or PLY files, or folders with such files")
      ->required();
  CLI::Option* const density =
      app.add_option("--density", mass.density,
                     "[kg/m³]; it is 1 if you don't say. If the body has parts: NAME=NUMBER, once "
                     "for each material, group or object of the OBJ file")
          ->allow_extra_args(false);
  app.add_option("--mass", mass.mass, "of the whole, as you have weighed it [kg]");
  CLI::Option* const shell =
      app.add_option("--shell", mass.shell,
                     "the mass lies in the surface, which may be open: density times thickness "
                     "[kg/m²]")
          ->excludes(density);
  CLI::Option* const thickness =
      app.add_option("--thickness", mass.thickness,
                     "of a shell of the material of --density, in the unit of the file")
          ->excludes(shell);
  app.add_option("--unit", mass.unit, "of the lengths in the file: mm, cm, m or in")
      ->capture_default_str()
      ->check(CLI::IsMember({"mm", "cm", "m", "in"}));
  CLI::Option* const about =
      app.add_option("--about", mass.about, "x y z: you also get the inertia about this point [m]")
          ->expected(3);
  add_options_of_volumes(app, mass, {shell, thickness});
  app.add_flag("--accept", mass.accept, "compute what we can from a bad mesh, too");
  std::vector<CLI::Option*> outputs = {
      app.add_flag("--json", mass.json, "all digits, and all that we have found, as JSON")};
  for (const char* format : {"urdf", "sdf", "mjcf"}) {
    CLI::Option* const block = app.add_flag_callback(
        std::string("--") + format, [&mass, format] { mass.block = format; },
        "only the <inertial> element of such a file");
    about->excludes(block);  // its tensor is the one about the centre of mass
    for (CLI::Option* const other : outputs) block->excludes(other);
    outputs.push_back(block);
  }
}

}  // namespace

int main(int argc, char** argv) {
  using namespace tumble::scenes;
  CLI::App app("Mass properties of meshes, and the motion of bodies.", "./tumble");
  app.require_subcommand(1);
  MassCommand mass;
  CLI::App* mass_app = app.add_subcommand("mass", "mass, centre of mass and inertia of meshes");
  add_options(*mass_app, mass);

  SimulateCommand simulate;
  CLI::App* simulate_app = app.add_subcommand("simulate", "the motion of a scene file's bodies");
  simulate_app
      ->add_option("scene", simulate.file,
                   "your scene file; chapters/scenes/README.md says what it holds")
      ->required();
  simulate_app->add_option("--csv", simulate.csv, "we write the recorded states into this file");
  simulate_app->add_option(
      "--svg", simulate.svg,
      "we draw into this file how the bodies turn, or a film strip if they can touch things");
  simulate_app->add_option("--impacts", simulate.impacts, "we write all impacts into this file");
  simulate_app->add_flag("--json", simulate.json,
                         "all digits, and all that we have chosen and spent, as JSON");
  return tumble::support::run_command_line(
      app, argc, argv, [&] { return mass_app->parsed() ? run(mass) : run(simulate); });
}
