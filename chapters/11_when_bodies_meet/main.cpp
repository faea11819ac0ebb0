/// @file
/// Chapter 11: when bodies meet, and what an impact leaves.
#include "moving_figures.hpp"
#include "parts.hpp"
#include "support/chapter.hpp"

int main(int argc, char** argv) {
  using namespace contact_chapter;
  tumble::support::Chapter chapter("11_when_bodies_meet",
                                   "When bodies meet: the time of a contact, and its impulse");
  chapter.table("ball", "A ball dropped from 5 m, after 20 s", ball_table);
  chapter.table("sweep", "Pairs that are compared", sweep_table);
  chapter.table("tunnel", "A bullet and a thin plate", tunnel_table);
  chapter.table("by_hand", "A rod hit at its end, on paper", by_hand_table);
  chapter.table("rod", "The rod that jumps up", rod_table);
  chapter.table("laws", "A thousand impacts", laws_table);
  chapter.table("painleve", "A slender rod that jams", painleve_table);
  chapter.table("zeno", "A ball that comes to rest", zeno_table);
  chapter.table("magnify", "A die, and one that starts a nanometre higher", magnify_table);
  chapter.table("hard_cases", "Hard cases, one by one", hard_cases_table);
  chapter.figure(tumble::figures::strip);
  chapter.figure("dropped", dropped_figure);
  chapter.figure("plane", plane_figure);
  chapter.figure("staircase", staircase_figure);
  chapter.figure("answers", answers_figure);
  chapter.figure("rod", rod_figure);
  chapter.figure("slip", slip_figure);
  chapter.figure(tumble::figures::impulses);
  chapter.figure("bounces", bounces_figure);
  chapter.figure("zeno", zeno_figure);
  return chapter.run(argc, argv);
}
