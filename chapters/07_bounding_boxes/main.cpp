/// @file
/// Chapter 7: boxes in the place of bodies, and what that does to mass, inertia and motion.
#include "moving_figures.hpp"
#include "parts.hpp"
#include "support/chapter.hpp"

int main(int argc, char** argv) {
  using namespace bounding_boxes_chapter;
  tumble::support::Chapter chapter("07_bounding_boxes",
                                   "Bounding boxes: a box in the place of a body");
  chapter.table("mug", "A mug spun about its easiest axis, 3 turns per second", mug_table);
  chapter.table("corners", "The box of three points", corners_table);
  chapter.table("diamond", "Eight points, and two boxes", diamond_table);
  chapter.table("errors", "Inertia of a box for that of an object: relative error", errors_table);
  chapter.table("descent", "Turning boxes until no turn makes them smaller", descent_table);
  chapter.table("hollow", "The inertia of a cube around a hollow ball, to the ball's",
                hollow_table);
  chapter.table("equivalent", "The box that turns like the object", equivalent_table);
  chapter.table("moments", "Which axis is the easy one", moments_table);
  chapter.table("flight", "Orientation off after one second of 10 rad/s", flight_table);
  chapter.measured("times", "What a box takes, and what the exact sum does", times_table);
  chapter.table("hard", "Bodies that are bad for boxes", hard_table);
  chapter.figure("spin", spin_figure);
  chapter.figure("slow_motion", slow_motion_figure);
  chapter.figure("lies", lies_figure);
  chapter.figure("cube", cube_figure);
  chapter.figure("sides", sides_figure);
  chapter.figure("valley", valley_figure);
  chapter.figure("between", between_figure);
  chapter.figure("equivalent", equivalent_figure);
  chapter.figure("rule", rule_figure);
  chapter.figure(tumble::figures::throws);
  chapter.figure("far", far_figure);
  return chapter.run(argc, argv);
}
