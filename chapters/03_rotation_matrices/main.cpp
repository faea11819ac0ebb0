/// @file
/// Chapter 3: what the order of three turns does, how a rotation matrix drifts, and what each
/// repair costs and gives back.
#include "moving_figures.hpp"
#include "parts.hpp"
#include "support/chapter.hpp"

int main(int argc, char** argv) {
  using namespace rotation_matrices_chapter;
  tumble::support::Chapter chapter(
      "03_rotation_matrices", "Rotation matrices: the order of turns, drift, and what repairs it");
  chapter.table("order", "The same three angles in different orders", order_table);
  chapter.table("lock", "A turn by 1°, seen by three angles near gimbal lock", lock_table);
  chapter.table("turning_point", "Two points of a body that turns", turning_point_table);
  chapter.table("drift", "A steady turn of 2 rad/s in steps of 1/60 s", drift_table);
  chapter.table("backward", "The same with the slope at the end of the step", backward_table);
  chapter.table("by_hand", "Gram–Schmidt by hand", gram_schmidt_by_hand_table);
  chapter.table("favourite", "A sheared matrix, repaired", favourite_table);
  chapter.table("newton", "Newton's iteration on three stretches", newton_table);
  chapter.table("repair", "One repair, on average over 10 000 drifted matrices", repair_table);
  chapter.table("schedule", "A minute of midpoint steps, repaired now and then", schedule_table);
  chapter.measured("times", "What one repair takes", times_table);
  chapter.figure("order", order_figure);
  chapter.figure("sheared", sheared_figure);
  chapter.figure("columns", columns_figure);
  chapter.figure("gimbal", gimbal_figure);
  chapter.figure("cross", cross_figure);
  chapter.figure("drift", drift_figure);
  chapter.figure("gram_schmidt", gram_schmidt_figure);
  chapter.figure("ellipsoid", ellipsoid_figure);
  chapter.figure(tumble::figures::pulled);
  chapter.figure("repair", repair_figure);
  return chapter.run(argc, argv);
}
