/// @file
/// Chapter 6: mass properties by asking points whether they are inside.
#include "moving_figures.hpp"
#include "parts.hpp"
#include "support/chapter.hpp"

int main(int argc, char** argv) {
  using namespace point_sampling_chapter;
  tumble::support::Chapter chapter("06_point_sampling",
                                   "Point sampling: a body by asking what is inside");
  chapter.table("kilograms", "One, two and four kilograms", kilograms_table);
  chapter.table("cells", "A plank of 5 kg, cut into cells", cells_table);
  chapter.table("finer", "The same plank, with more cells", finer_table);
  chapter.measured("inside", "Is a point inside?", inside_table);
  chapter.table("edge", "A box on a grid of 32³ points", edge_table);
  chapter.table("edge_31", "The same on a grid of 31³ points", edge_31_table);
  chapter.table("die", "The centre of mass of a die with drilled pips", die_table);
  chapter.table("racket", "A tennis racket about other axes", racket_table);
  chapter.table("twice", "Where a racket is twice as hard to swing", twice_table);
  chapter.table("fill", "How much of its box a body fills", fill_table);
  chapter.table("orders", "The error of a mug's inertia", orders_table);
  chapter.table("honest", "The standard error of a mug's mass", honest_table);
  chapter.measured("times", "The inertia of a mug", times_table);
  chapter.table("loose", "A cube of 1 kg in bounds that are 3 % too wide", loose_table);
  chapter.table("meshes", "The same objects by coarser and finer meshes", meshes_table);
  chapter.figure("cloud", cloud_figure);
  chapter.figure("rays", rays_figure);
  chapter.figure("sides", sides_figure);
  chapter.figure("edge", edge_figure);
  chapter.figure(tumble::figures::corners);
  chapter.figure("csg", csg_figure);
  chapter.figure("swing", swing_figure);
  chapter.figure("far", far_figure);
  chapter.figure("squares", squares_figure);
  chapter.figure("cells", cells_figure);
  chapter.figure("orders", orders_figure);
  chapter.figure(tumble::figures::sampled);
  chapter.figure("columns", columns_figure);
  return chapter.run(argc, argv);
}
