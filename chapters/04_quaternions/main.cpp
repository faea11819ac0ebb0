/// @file
/// Chapter 4: what four numbers do better than nine. Ways between two orientations, drift, what a
/// step costs and what error it buys, and the places where a formula loses its digits.
#include "moving_figures.hpp"
#include "parts.hpp"
#include "support/chapter.hpp"

int main(int argc, char** argv) {
  using namespace quaternions_chapter;
  tumble::support::Chapter chapter(
      "04_quaternions", "Quaternions: the way between two orientations, drift, and its price");
  chapter.table("ways", "Five ways of 150°", ways_table);
  chapter.table("by_hand", "The product of two quarter turns", product_by_hand_table);
  chapter.table("point", "Four points, turned by that product", point_by_hand_table);
  chapter.table("halfway", "Halfway by mixing", halfway_table);
  chapter.table("shrink", "How RK4 shortens a quaternion", shrink_table);
  chapter.table("turns", "Some turns and their quaternions", turns_table);
  chapter.table("order", "Two quarter turns in both orders", order_table);
  chapter.table("length", "A turn of 60° by a quaternion that is too long", length_table);
  chapter.table("pace", "The pace of a mixture", pace_table);
  chapter.table("drift", "A steady turn of 2 rad/s in steps of 1/60 s", drift_table);
  chapter.table("big_steps", "One step of a large turn", big_steps_table);
  chapter.table("counts", "What the arithmetic of an orientation costs", counts_table);
  chapter.measured("reach", "What an orientation error costs", reach_table);
  chapter.measured("times", "What the other operations take", times_table);
  chapter.table("small_angles", "The angle of a small turn", small_angles_table);
  chapter.table("near", "A quarter of the way between two that are close", near_table);
  chapter.figure("between", between_figure);
  chapter.figure(tumble::figures::tracks);
  chapter.figure("turn", turn_figure);
  chapter.figure("arc", arc_figure);
  chapter.figure("circle", circle_figure);
  chapter.figure("half_turn", half_turn_figure);
  chapter.figure("chord", chord_figure);
  chapter.figure("pace", pace_figure);
  chapter.figure("drift", drift_figure);
  chapter.figure("work", work_figure);
  return chapter.run(argc, argv);
}
