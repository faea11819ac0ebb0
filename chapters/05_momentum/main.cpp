/// @file
/// Chapter 5: what pushes a body and turns it, and why momenta are stored.
#include "moving_figures.hpp"
#include "parts.hpp"
#include "support/chapter.hpp"

int main(int argc, char** argv) {
  using namespace momentum_chapter;
  tumble::support::Chapter chapter("05_momentum", "Momentum: what pushes a body, what turns it");
  chapter.table("centres", "Where the centre of mass is", centres_table);
  chapter.table("forgotten", "An arm that was not turned with its body", forgotten_table);
  chapter.table("wheel", "A wheel of a train at 300 km/h", wheel_table);
  chapter.table("lever", "A force that slides along its line", lever_table);
  chapter.table("push", "A kick of 200 N for 10 ms against a plank of 2 kg and 1 m", push_table);
  chapter.table("sixth", "The same kick a sixth of the length off the centre", sixth_table);
  chapter.table("askew", "Two masses on a leaning rod", askew_table);
  chapter.table("along", "The same rod about two other axes", along_table);
  chapter.table("apart", "How far L and ω can be apart", apart_table);
  chapter.table("split", "Orbital and spin parts", split_table);
  chapter.table("kept", "Ten minutes of a free T-handle", kept_table);
  chapter.table("longer", "Fifteen minutes of it, by Euler", longer_table);
  chapter.table("stored", "Ten seconds of a free T-handle, by RK4, averaged over twelve starts",
                stored_table);
  chapter.table("gaps", "From one number to the next", gaps_table);
  chapter.table("counts", "From L to ω: operations", counts_table);
  chapter.measured("times", "From L to ω: times", times_table);
  chapter.table("nozzle", "A spinning satellite with a nozzle", nozzle_table);
  chapter.table("arm", "A plank that hangs from a spring", arm_table);
  chapter.table("cancel", "Forces that cancel", cancel_table);
  chapter.figure("flight", flight_figure);
  chapter.figure("frames", frames_figure);
  chapter.figure("wheel", wheel_figure);
  chapter.figure("torque", torque_figure);
  chapter.figure("push", push_figure);
  chapter.figure("askew", askew_figure);
  chapter.figure(tumble::figures::wander);
  chapter.figure("stored", stored_figure);
  chapter.figure("far", far_figure);
  chapter.figure("needle", needle_figure);
  return chapter.run(argc, argv);
}
