/// @file
/// Chapter 9: the whole rigid body, its thirteen numbers and their rates.
#include "moving_figures.hpp"
#include "parts.hpp"
#include "support/chapter.hpp"

int main(int argc, char** argv) {
  using namespace rigid_body_chapter;
  tumble::support::Chapter chapter("09_rigid_body",
                                   "The rigid body: thirteen numbers and their rates");
  chapter.table("derived_by_hand", "What follows from one state", derived_by_hand_table);
  chapter.table("step_by_hand", "One step of Euler's method", step_by_hand_table);
  chapter.table("length_by_hand", "Quaternions of another length", length_by_hand_table);
  chapter.table("term_by_hand", "The gyroscopic term in that state", term_by_hand_table);
  chapter.table("half_turn", "The same after a half turn", half_turn_table);
  chapter.table("aimed", "Aimed to a billionth of a radian", aimed_table);
  chapter.table("frames", "ω from L in right axes and in wrong ones", frames_table);
  chapter.table("flips", "How often a body turns over", flips_table);
  chapter.table("laws", "The free handle by right laws and by wrong ones", laws_table);
  chapter.table("length", "When q is given the length 1", length_table);
  chapter.table("trusting", "A force that takes q at its word", trusting_table);
  chapter.table("ledger", "The energy of a mug on a spring", ledger_table);
  chapter.table("steps", "Three seconds of the mug on its spring", steps_table);
  chapter.table("free", "Ten seconds of the free handle, by RK4", free_table);
  chapter.table("stale", "Forces asked four times per step, and once", stale_table);
  chapter.table("matrix", "Nine numbers or four", matrix_table);
  chapter.table("sampled", "A tensor from points, and from faces", sampled_table);
  chapter.table("arrays", "The same on plain arrays", arrays_table);
  chapter.table("counts", "One evaluation: operations", counts_table);
  chapter.measured("times", "One evaluation: times", times_table);
  chapter.table("stated", "What simulate() says, and what is true", stated_table);
  chapter.measured("race", "Half a second of the mug: time to reach an error", race_table);
  chapter.table("thousand", "A thousand seconds of the free handle", thousand_table);
  chapter.table("begins", "A force that begins within a step", begins_table);
  chapter.table("fast", "Twenty turns by long steps of RK4", fast_table);
  chapter.table("honey", "A mug in honey", honey_table);
  chapter.figure("nut", nut_figure);
  chapter.figure("slow_motion", slow_motion_figure);
  chapter.figure("machine", machine_figure);
  chapter.figure("frames", frames_figure);
  chapter.figure("seen", seen_figure);
  chapter.figure("spin", spin_figure);
  chapter.figure(tumble::figures::handle);
  chapter.figure("polhode", polhode_figure);
  chapter.figure("laws", laws_figure);
  chapter.figure("mug", mug_figure);
  chapter.figure("energy", energy_figure);
  chapter.figure("work", work_figure);
  return chapter.run(argc, argv);
}
