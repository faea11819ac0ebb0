// Speed against error of rigid-body dynamics: every method, ours and others', on the same problems
// in one run. The methods take turns (random interleaving), so that ratios hold on a busy machine.
#include <iostream>

#include "project/bench/dynamics/absent.hpp"
#include "project/bench/dynamics/honesty.hpp"
#include "project/bench/dynamics/long_run.hpp"
#include "project/bench/dynamics/many_bodies.hpp"
#include "project/bench/dynamics/own_on_plain_numbers.hpp"
#include "project/bench/dynamics/problems.hpp"
#include "project/bench/dynamics/step_by_step.hpp"
#include "project/bench/dynamics/work_precision.hpp"
#include "project/bench/report.hpp"
#include "support/command_line.hpp"
#include "support/text_file.hpp"

namespace tumble::bench {
namespace {

struct Options {
  Budget budget{0.4, 0.4, 5, 0.002};
  int long_steps = 1'000'000;
  int bodies = 10'000;
  std::size_t stepped_bodies = 1'000'000;
  int scenes = 2'000;
  bool with_peers = true;
  std::string only, svg_folder;

  bool wants(const std::string& problem) const { return only.empty() || only == problem; }
};

/// To see that everything works, in seconds.
Options quick(Options options) {
  options.budget = {0.1, 0.01, 1, 0.0002};
  options.long_steps = 10'000;
  options.bodies = 500;
  options.stepped_bodies = 1000;
  options.scenes = 60;
  return options;
}

Contestants contestants(bool with_peers) {
  Contestants all = own_methods();
  add_own_on_plain_numbers(all);
  if (with_peers) add_peers(all);
  return all;
}

constexpr auto orientation_error = "orientation error [rad]";

void show_precision(const Problem& problem, const std::vector<Method>& methods,
                    const Options& options) {
  const std::vector<Curve> curves = work_precision(problem, methods, options.budget);
  std::cout << problem.title << '\n' << times_table(curves).text() << '\n';
  if (options.with_peers) std::cout << ratio_table(curves).text() << '\n';
  std::cout << std::flush;
  if (!options.svg_folder.empty())
    support::write_text(options.svg_folder + "/" + problem.name + ".svg",
                        support::to_svg(figure(problem.title, orientation_error, curves)));
  check_promises(problem.name, orientation_error, curves);
}

void show_long(const Problem& free, const std::vector<Stepper>& steppers, int steps) {
  const LongRun all = long_run(free, steppers, steps);
  std::cout << "FREE in " << steps << " steps of one length: largest relative error\n"
            << all.table.text() << std::endl;
  require(all.broken.empty(), "long: drifts more than we promise", all.broken);
}

void show_many(const std::vector<Stepper>& steppers, const Options& options) {
  const ManyBodies all = many_bodies(options.bodies, steppers, options.budget);
  std::cout << options.bodies << " free bodies, 1 s in steps of 1/240 s\n"
            << all.table.text() << std::endl;
  require(all.broken.empty(), "many: errs more than we promise", all.broken);
  std::cout << "One step a call, under a weight\n"
            << step_by_step(options.stepped_bodies, options.budget).text() << std::endl;
}

void show_absent(const Budget& budget) {
  const Absent all = absent(budget);
  std::cout << "Forces that are not there\n"
            << all.forces.text() << "\nThe rungs of the ladder\n"
            << all.rungs.text() << std::endl;
  require(all.broken.empty(), "absent", all.broken);
}

void show_honesty(int scenes) {
  const Honesty all = honesty(scenes);
  std::cout << "What simulate() states and what is true, on " << scenes
            << " random scenes of which " << all.unknown
            << " have no truth that is known well enough\n"
            << all.table.text() << std::endl;
  require(all.broken.empty(), "honesty", all.broken);
}

void run(const Options& options) {
  const auto [methods, steppers] = contestants(options.with_peers);
  std::vector<Method> all = methods;
  for (const Stepper& stepper : steppers) all.push_back(as_method(stepper));
  const std::vector<Problem> three = problems();
  for (const Problem& problem : three)
    if (options.wants(problem.name)) show_precision(problem, all, options);
  if (options.wants("long")) show_long(three.front(), steppers, options.long_steps);
  if (options.wants("many")) show_many(steppers, options);
  if (options.wants("absent")) show_absent(options.budget);
  if (options.wants("honesty")) show_honesty(options.scenes);
}

}  // namespace
}  // namespace tumble::bench

int main(int argc, char** argv) {
  tumble::bench::Options options;
  CLI::App app("Rigid-body dynamics: time to reach an error, of every method on the same problems.",
               "./tumble bench dynamics");
  app.add_option("--only", options.only, "one problem")
      ->check(CLI::IsMember({"free", "top", "heavy", "long", "many", "absent", "honesty"}));
  app.add_option("--scenes", options.scenes, "how many random scenes for honesty")
      ->check(CLI::PositiveNumber);
  app.add_option("--svg-dir", options.svg_folder, "draw error against time into this folder")
      ->check(CLI::ExistingDirectory);
  bool is_quick = false, no_peers = false;
  app.add_flag("--quick", is_quick, "short runs, each once: to see that everything works");
  app.add_flag("--no-peers", no_peers, "our own methods only");
  return tumble::support::run_command_line(app, argc, argv, [&] {
    if (is_quick) options = quick(options);
    options.with_peers = !no_peers;
    tumble::bench::run(options);
    return tumble::support::exit_status::achieved;
  });
}
