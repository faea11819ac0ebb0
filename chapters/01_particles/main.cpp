/// @file
/// Chapter 1: what moves particles, three ways to follow it, and what each step costs and misses.
#include "moving_figures.hpp"
#include "parts.hpp"
#include "support/chapter.hpp"

int main(int argc, char** argv) {
  using namespace particles_chapter;
  tumble::support::Chapter chapter("01_particles",
                                   "Particles: forces, states, and the steps that follow them");
  chapter.table("orbit", "Five revolutions of a satellite, 960 evaluations each", orbit_table);
  chapter.table("state", "Two particles as one column of numbers", state_table);
  chapter.table("halved", "Euler's error while the step is halved", halved_table);
  chapter.table("dydt_by_hand", "The rates of two particles on a spring", dydt_by_hand_table);
  chapter.table("slopes_by_hand", "The four slopes of one step of RK4", slopes_by_hand_table);
  chapter.table("steps_by_hand", "One step of each method", steps_by_hand_table);
  chapter.table("mistakes", "RK4, and RK4 with a mistake", mistakes_table);
  chapter.table("ode", "From perigee to apogee with ode()", ode_table);
  chapter.table("balls", "The same throw of different balls, by RK4 in steps of 1/64 s",
                balls_table);
  chapter.table("net", "Energy gained by a net of 63 knots in half a second", net_table);
  chapter.table("conditions", "The conditions for the order of a method", conditions_table);
  chapter.table("order", "How the error falls with the step", order_table);
  chapter.table("price", "Evaluations of the right-hand side that an error asks for", price_table);
  chapter.measured("times", "What one step takes", times_table);
  chapter.table("limits", "The longest step that does not explode", limits_table);
  chapter.table("smash", "Euler steps against quadratic drag", smash_table);
  chapter.table("same_place", "A spring of 10 N/m and 1 m whose ends meet", same_place_table);
  chapter.table("time", "A force that depends on time", time_table);
  chapter.table("jump", "A force that jumps", jump_table);
  chapter.figure("orbit", orbit_figure);
  chapter.figure("column", column_figure);
  chapter.figure("asks", asks_figure);
  chapter.figure("spring", spring_figure);
  chapter.figure("tangents", tangents_figure);
  chapter.figure("balls", balls_figure);
  chapter.figure("net", net_figure);
  chapter.figure("growth", growth_figure);
  chapter.figure("one_step", one_step_figure);
  chapter.figure("error", error_figure);
  chapter.figure(tumble::figures::price);
  return chapter.run(argc, argv);
}
