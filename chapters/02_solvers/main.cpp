/// @file
/// Chapter 2: steps that suit the motion, steps that stiffness forces, and what each error costs.
#include "moving_figures.hpp"
#include "parts.hpp"
#include "support/chapter.hpp"

int main(int argc, char** argv) {
  using namespace solvers_chapter;
  tumble::support::Chapter chapter("02_solvers",
                                   "Solvers: adaptive and implicit steps, and their cost");
  chapter.table("comet", "One revolution of a comet, 75 years", comet_table);
  chapter.table("norm", "Four errors and their norm", norm_table);
  chapter.table("estimate", "Estimated and true errors of one step, allowed = 1", estimate_table);
  chapter.table("tolerance", "Tolerance and final error", tolerance_table);
  chapter.table("factors", "The next step after an error", factors_table);
  chapter.table("eigenvalues", "A speck in a simple wind", eigenvalues_table);
  chapter.table("damped", "A damped spring, and what one step makes of it", damped_table);
  chapter.table("newton_by_hand", "One implicit step by hand", newton_by_hand_table);
  chapter.table("stability", "How far each method is stable", stability_table);
  chapter.table("dust", "Ten seconds of a speck of dust, tolerance 1e-6", dust_table);
  chapter.table("indifferent", "A speck of 1 µm at several tolerances", indifferent_table);
  chapter.table("newton", "Distance from the solution of a backward Euler step", newton_table);
  chapter.table("order", "The observed order", order_table);
  chapter.table("eccentricity", "Evaluations for one revolution within 1e-6", eccentricity_table);
  chapter.table("reach", "Evaluations to reach an error", reach_table);
  chapter.measured("times", "Time to reach an error", times_table);
  chapter.table("kink", "An engine that stops", kink_table);
  chapter.table("pulse", "A pulse that is jumped over", pulse_table);
  chapter.table("rest", "A weight that comes to rest", rest_table);
  chapter.table("floor", "Tolerances below rounding", floor_table);
  chapter.table("no_solution", "A backward Euler step that does not exist", no_solution_table);
  chapter.table("rod", "Evaluations for a pendulum on a stiff rod", rod_table);
  chapter.table("unseen", "Orders that do not show", unseen_table);
  chapter.figure("comet", comet_figure);
  chapter.figure("norm", norm_figure);
  chapter.figure("implicit", implicit_figure);
  chapter.figure("steps", steps_figure);
  chapter.figure(tumble::figures::regions);
  chapter.figure("dust", dust_figure);
  chapter.figure("stiffness", stiffness_figure);
  chapter.figure("relaxation", relaxation_figure);
  chapter.figure("ridden", ridden_figure);
  chapter.figure("order", order_figure);
  chapter.figure("comet_work", comet_work_figure);
  chapter.figure("dust_work", dust_work_figure);
  return chapter.run(argc, argv);
}
