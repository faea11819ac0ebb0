/// @file
/// Chapter 8: mass, centre and inertia of a polyhedron, exactly, from its surface alone.
#include "moving_figures.hpp"
#include "parts.hpp"
#include "support/chapter.hpp"

int main(int argc, char** argv) {
  using namespace mirtich_chapter;
  tumble::support::Chapter chapter("08_mirtich",
                                   "Mirtich: a body's mass and inertia from its surface");
  chapter.table("shadows", "What the faces of a gem contribute to its volume", shadows_table);
  chapter.table("turned", "The gem, with some of its faces turned round", turned_table);
  chapter.table("walk", "Once around a square with a dent", walk_table);
  chapter.table("walk_beta", "The same walk, for the integral of β", walk_beta_table);
  chapter.table("axis", "Relative errors of shadows along z, the worst of 50 faces", axis_table);
  chapter.table("corner", "The corner of a cube, by all three steps", corner_table);
  chapter.table("corner_body", "The corner as a body", corner_body_table);
  chapter.table("gem", "The gem, of diamond", gem_table);
  chapter.table("far_by_shadows", "A mug far from the origin, by shadows: relative errors",
                far_by_shadows_table);
  chapter.table("mesh", "A torus, and meshes that stand for it", mesh_table);
  chapter.table("apex", "The corner of a cube as signed tetrahedra", apex_table);
  chapter.table("apex_inside", "The same, with the apex in the body", apex_inside_table);
  chapter.table("far", "A mug far from the origin: relative errors", far_table);
  chapter.table("rest", "Its centre of mass", rest_table);
  chapter.table("thin", "Relative errors of the mass, and their bounds", thin_table);
  chapter.table("pairs", "What rounding loses of a sum and of a product", pairs_table);
  chapter.table("accept", "What integrals make of spoiled cubes", accept_table);
  chapter.table("findings", "What is found in spoiled cubes", findings_table);
  chapter.table("balance", "Surfaces spread out over random places", balance_table);
  chapter.table("nonplanar", "A cube with one corner pulled by 0.2 m", nonplanar_table);
  chapter.table("counts", "Operations", counts_table);
  chapter.table("errors", "Relative errors of the inertia", errors_table);
  chapter.measured("times", "Times", times_table);
  chapter.table("missed", "A cube with a spike through its top", missed_table);
  chapter.table("sizes", "Very small and very large", sizes_table);
  chapter.figure("gem", gem_figure);
  chapter.figure("rods", rods_figure);
  chapter.figure("shadow", shadow_figure);
  chapter.figure("walk", walk_figure);
  chapter.figure(tumble::figures::tetrahedra);
  chapter.figure("far", far_figure);
  chapter.figure("thin", thin_figure);
  chapter.figure("places", places_figure);
  chapter.figure("depth", depth_figure);
  return chapter.run(argc, argv);
}
