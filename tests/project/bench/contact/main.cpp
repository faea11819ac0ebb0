// Speed against error where bodies hit each other: ours and others' on the same scenes in one run.
// They take turns (random interleaving), so that ratios hold on a busy machine.
#include <iostream>

#include "project/bench/contact/crowd.hpp"
#include "project/bench/contact/jamming.hpp"
#include "project/bench/contact/nothing_meets.hpp"
#include "project/bench/contact/problem.hpp"
#include "project/bench/contact/standing.hpp"
#include "project/bench/report.hpp"
#include "support/command_line.hpp"
#include "support/text_file.hpp"

namespace tumble::bench {
namespace {

struct Options {
  Budget budget{0.5, 1.5, 9, 0.002};
  std::vector<int> crowds = {10, 100, 1000, 10'000};
  bool with_peers = true;
  std::string only, svg_folder;

  bool wants(const std::string& scene) const { return only.empty() || only == scene; }
};

/// To see that everything works, in seconds.
Options quick(Options options) {
  options.budget = {0.1, 0.01, 1, 0.0002};
  options.crowds = {10, 100, 1000};
  return options;
}

std::vector<Problem> problems() {
  std::vector<Problem> all = ball_problems();
  for (const Problem& problem : corner_problems()) all.push_back(problem);
  all.push_back(billiard_break());
  all.push_back(brick_in_room());
  return all;
}

std::vector<Entrant> entrants(const Problem& problem, const std::vector<Stepper>& steppers) {
  std::vector<Entrant> all = {own_method(problem)};
  for (const Stepper& stepper : steppers)
    if (stepper.make(problem.scene, problem.duration)) all.push_back(stepping(problem, stepper));
  return all;
}

void show(const Problem& problem, const std::vector<Stepper>& steppers, const Options& options) {
  const std::vector<Curve> curves =
      speed_against_error(problem.name, entrants(problem, steppers), options.budget);
  const support::Table table =
      problem.count > 0 ? counts_table(problem, curves) : times_table(curves);
  std::cout << problem.title << '\n' << table.text() << standing(problem, curves) << std::endl;
  if (!options.svg_folder.empty()) {
    const std::string title = problem.title.substr(0, problem.title.find(':'));
    support::write_text(options.svg_folder + "/" + problem.name + ".svg",
                        support::to_svg(figure(title, problem.error, curves)));
  }
  check_promises(problem.name, problem.error, curves);
}

void show_crowd(const std::vector<Stepper>& steppers, const Options& options) {
  const Crowd all = crowd(options.crowds, steppers, options.budget);
  std::cout << "CROWD: balls in a room, e = 1; others in steps of a tenth of a radius\n"
            << all.table.text() << all.growth << std::endl;
  require(all.broken.empty(), "crowd", all.broken);
}

void show_jamming(const std::vector<Stepper>& steppers) {
  const Jamming all = jamming(steppers);
  std::cout << "JAMMING: Painlevé's rod, after a contact that no finite force explains\n"
            << all.table.text() << std::endl;
  require(all.broken.empty(), "jamming", all.broken);
}

void show_nothing_meets(const Options& options) {
  const NothingMeets all = nothing_meets(options.budget);
  std::cout << "APART: bodies that nothing meets in 10 s, and the question whether it can\n"
            << all.table.text() << std::endl;
  require(all.broken.empty(), "apart", all.broken);
}

void run(const Options& options) {
  std::vector<Stepper> steppers;
  if (options.with_peers) add_peers(steppers);
  for (const Problem& problem : problems())
    if (options.wants(problem.name)) show(problem, steppers, options);
  if (options.wants("crowd")) show_crowd(steppers, options);
  if (options.wants("jamming")) show_jamming(steppers);
  if (options.wants("apart")) show_nothing_meets(options);
}

}  // namespace
}  // namespace tumble::bench

int main(int argc, char** argv) {
  tumble::bench::Options options;
  CLI::App app(
      "Bodies that hit each other: time to reach an error, ours and others' on the same "
      "scenes.",
      "./tumble bench contact");
  app.add_option("--only", options.only, "one scene")
      ->check(CLI::IsMember({"ball", "bounces", "stops", "rolls", "slips", "cradle", "rod", "brick",
                             "break", "room", "crowd", "jamming", "apart"}));
  app.add_option("--svg-dir", options.svg_folder, "draw error against time into this folder")
      ->check(CLI::ExistingDirectory);
  bool is_quick = false, no_peers = false;
  app.add_flag("--quick", is_quick, "short runs, each once: to see that everything works");
  app.add_flag("--no-peers", no_peers, "our own method only");
  return tumble::support::run_command_line(app, argc, argv, [&] {
    if (is_quick) options = quick(options);
    options.with_peers = !no_peers;
    tumble::bench::run(options);
    return tumble::support::exit_status::achieved;
  });
}
