#include <iostream>

#include "scenes/commands.hpp"
#include "scenes/contact_motion.hpp"
#include "scenes/motion_output.hpp"
#include "support/own_files.hpp"
#include "support/printable.hpp"
#include "support/text_file.hpp"

namespace tumble::scenes {
namespace {

using support::escaped;

/// @throws std::invalid_argument if a file that we are to write is another one of the command
void require_own_outputs(const SimulateCommand& command, const Scene& scene) {
  std::vector<support::NamedFile> inputs = {{"your scene", command.file}};
  for (const SceneBody& body : scene.bodies)
    if (!body.mesh.empty()) inputs.push_back({"the mesh of " + escaped(body.name), body.mesh});
  support::require_own_files(
      inputs, {{"--csv", command.csv}, {"--svg", command.svg}, {"--impacts", command.impacts}});
}

void write_files(const SimulateCommand& command, const Scene& scene, const Motions& motions) {
  if (!command.csv.empty())
    support::write_text(command.csv,
                        [&](std::ostream& csv) { write_states_csv(csv, scene, motions); });
  if (!command.impacts.empty()) support::write_text(command.impacts, impacts_csv(scene, motions));
  if (!command.svg.empty())
    support::write_text(command.svg,
                        scene.contact ? film_strip(scene, motions) : spin_plot(scene, motions));
}

bool tolerances_reached(const Scene& scene, const Motions& motions) {
  bool reached = true;
  for (std::size_t i = 0; i < motions.trajectories.size(); ++i) {
    const SimulationReport& report = motions.trajectories[i].report();
    if (report.reached()) continue;
    std::cerr << "tumble: " << escaped(scene.bodies[i].name) << ": your tolerance "
              << report.tolerance << " was not reached. The error is about "
              << report.error_estimate << '\n';
    reached = false;
  }
  return reached;
}

bool followed_to_the_end(const Scene& scene, const Motions& motions) {
  if (!motions.contacts || complete(*motions.contacts)) return true;
  const contact::ContactRun& run = motions.contacts->run;
  std::cerr << "tumble: at t = " << motions.end << " s ";
  if (run.undecided >= 0)
    std::cerr << escaped(scene.bodies[static_cast<std::size_t>(run.undecided)].name)
              << " stays in touch, and we can't tell how it goes on. The motion "
                 "ends here\n";
  else
    std::cerr << "there are " << motions.contacts->settings.max_impacts
              << " impacts, the most that we allow. The motion ends here\n";
  return false;
}

}  // namespace

int run(const SimulateCommand& command) {
  const Scene scene = read_scene(command.file);
  require(scene.contact || command.impacts.empty(), command.file,
          ": there are no impacts without contact. Give the scene a floor, walls, restitution or "
          "friction");
  require_own_outputs(command, scene);
  const Motions motions = move(scene);
  write_files(command, scene, motions);
  if (command.json) {
    write_scene_json(std::cout, scene, motions, command.file);
  } else {
    print_motion(scene, motions);
    if (motions.contacts) print_contacts(scene, motions);
  }
  const bool reached = tolerances_reached(scene, motions);
  return followed_to_the_end(scene, motions) && reached ? 0 : 1;
}

}  // namespace tumble::scenes
