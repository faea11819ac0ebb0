/// @file
/// Chapter 10: simpler models, closed forms, methods that respect the geometry, and what all of
/// it costs.
#include "moving_figures.hpp"
#include "parts.hpp"
#include "support/chapter.hpp"

int main(int argc, char** argv) {
  using namespace scene_chapter;
  tumble::support::Chapter chapter(
      "10_only_what_a_scene_needs",
      "Only what a scene needs: simpler models, and error against cost");
  chapter.table("chosen", "What bodies are", chosen_table);
  chapter.table("why", "What model_of_moments() says", why_table);
  chapter.table("spin", "A golf ball with back-spin after two seconds", spin_table);
  chapter.table("ladder", "The same answer, for less", ladder_table);
  chapter.measured("rungs", "What a rung costs", rungs_table);
  chapter.measured("absent", "Forces that are not there", absent_table);
  chapter.table("equal", "How wrong a simpler body turns", equal_table);
  chapter.table("nut", "The wing nut taken for a top", nut_table);
  chapter.table("future", "A free body, far in the future", future_table);
  chapter.table("condition", "What the start decides", condition_table);
  chapter.table("top_by_hand", "A free symmetric top on paper", top_by_hand_table);
  chapter.table("wobble", "Wobbles in a turn", wobble_table);
  chapter.table("sides", "Two turns, on the right side and on the wrong one", sides_table);
  chapter.table("sleep", "How far a top leans", sleep_table);
  chapter.table("event", "A top that slows down", event_table);
  chapter.table("series", "A lopsided body by Taylor series", series_table);
  chapter.table("energy_by_hand", "Five energies on paper", energy_by_hand_table);
  chapter.table("free_energy", "The energy of the free handle", free_energy_table);
  chapter.table("drift", "The energy of a nodding top", drift_table);
  chapter.table("ends", "A trend from two states, and from all", ends_table);
  chapter.table("stated", "What simulate() says, and what is true", stated_table);
  chapter.table("unreachable", "What cannot be had", unreachable_table);
  chapter.measured("crowd", "Many bodies", crowd_table);
  chapter.table("work", "Evaluations that an error needs", work_table);
  chapter.table("spoiled", "A force that looks at the spin", spoiled_table);
  chapter.table("changing", "Steps that change", changing_table);
  chapter.table("hard_cases", "Hard cases, one by one", hard_cases_table);
  chapter.table("hard_refused", "What no body has", hard_refused_table);
  chapter.table("hard_flips", "A thousand seconds next to the separatrix", hard_flips_table);
  chapter.table("hard_tops", "Tops that sleep, and tops that fall", hard_tops_table);
  chapter.table("hard_million", "A million steps", hard_million_table);
  chapter.table("hard_float", "Half the digits", hard_float_table);
  chapter.figure("tip", tip_figure);
  chapter.figure("tree", tree_figure);
  chapter.figure("future", future_figure);
  chapter.figure("cones", cones_figure);
  chapter.figure("sn", sn_figure);
  chapter.figure("clock", clock_figure);
  chapter.figure("sleep", sleep_figure);
  chapter.figure("drift", drift_figure);
  chapter.figure(tumble::figures::work);
  return chapter.run(argc, argv);
}
