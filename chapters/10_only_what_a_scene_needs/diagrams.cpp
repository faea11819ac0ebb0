/// @file
/// The choice of a model as a drawing.

#include "common.hpp"
#include "parts.hpp"
#include "support/flow_sketch.hpp"

namespace scene_chapter {

namespace {

using support::box, support::flow, support::Sketch;

/// A question in two lines.
void ask(Sketch& sketch, const Vec2& low, const Vec2& high, const std::string& first,
         const std::string& second) {
  sketch.frame(low, high, {"c0", 1.8, 1, 0.08});
  const Vec2 middle = (low + high) / 2;
  sketch.words(middle, {0, -4}, first, "ink", "middle");
  sketch.words(middle, {0, 17}, second, "ink", "middle");
}

/// The orientation does not count: what is left depends on the spin.
void draw_paths(Sketch& sketch) {
  flow(sketch, {312, 572}, {428, 572}, {0, -8}, "no");
  ask(sketch, {430, 544}, {740, 600}, "Does a force depend", "on its spin?");
  box(sketch, {400, 430}, {560, 486}, "particle", "x, P: 6 numbers", "c2");
  box(sketch, {580, 430}, {740, 486}, "spinning ball", "x, P, L: 9 numbers", "c2");
  flow(sketch, {480, 542}, {480, 488}, {-8, 5}, "no", "end");
  flow(sketch, {660, 542}, {660, 488}, {8, 5}, "yes", "start");
}

/// The orientation counts: 13 numbers, and the moments decide.
void draw_moments(Sketch& sketch) {
  flow(sketch, {165, 542}, {165, 398}, {8, 5}, "yes: 13 numbers", "start");
  ask(sketch, {20, 340}, {310, 396}, "Are all three moments", "as good as equal?");
  flow(sketch, {312, 368}, {428, 368}, {0, -8}, "yes");
  box(sketch, {430, 340}, {740, 396}, "ball", "one steady turn", "c2");
  flow(sketch, {165, 338}, {165, 304}, {8, 5}, "no", "start");
  ask(sketch, {20, 246}, {310, 302}, "Are two of them", "as good as equal?");
  flow(sketch, {312, 274}, {428, 274}, {0, -8}, "yes");
  box(sketch, {430, 246}, {740, 302}, "symmetric top", "two steady turns", "c2");
  sketch.curve({{165, 244}, {165, 180}, {310, 180}}, {"ink", 1.8});
  flow(sketch, {310, 180}, {428, 180}, {-196, -26}, "no", "start");
  box(sketch, {430, 152}, {740, 208}, "full body", "elliptic functions", "c2");
}

/// What becomes of the closed forms if something turns the body.
void draw_torques(Sketch& sketch) {
  sketch.frame({20, 16}, {740, 122}, {"c1", 1.8, 1, 0.08});
  const std::array<std::string, 4> lines{
      "And if a torque acts? The model stays, its closed form goes.",
      "the weight of a top on its point: an elliptic sine", "another steady force: Taylor series",
      "any other force: steps by DOP853, or, where they are many, by a splitting"};
  for (std::size_t i = 0; i < 4; ++i)
    sketch.words({380, 98 - 24. * static_cast<double>(i)}, {0, 0}, lines[i], i == 0 ? "c1" : "ink",
                 "middle");
}

/// On every rung: whether a flight has an end.
void draw_contacts(Sketch& sketch) {
  ask(sketch, {20, -94}, {310, -38}, "Can anything touch", "while you look?");
  flow(sketch, {312, -56}, {428, -38}, {0, -10}, "no");
  box(sketch, {430, -58}, {740, -2}, "one flight", "all of this holds to its end", "c1");
  flow(sketch, {312, -76}, {428, -96}, {0, 22}, "yes");
  box(sketch, {430, -134}, {740, -78}, "chapter 11", "flights from contact to contact", "c1");
}

}  // namespace

std::string tree_figure() {
  Sketch sketch(760, 766, "Which model a scene needs: five questions and five models", 15);
  sketch.look({0, 616, 1});
  ask(sketch, {20, 544}, {310, 600}, "Do you want its orientation,",
      "or does a force depend on it?");
  draw_paths(sketch);
  draw_moments(sketch);
  draw_torques(sketch);
  draw_contacts(sketch);
  return sketch.svg();
}

}  // namespace scene_chapter
