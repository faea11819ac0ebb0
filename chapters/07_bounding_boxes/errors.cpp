/// @file
/// How far the boxes' mass, centre and inertia are from the objects', and what decides on it.

#include <algorithm>

#include "common.hpp"
#include "parts.hpp"
#include "support/plot.hpp"

namespace bounding_boxes_chapter {

// ── Objects, boxes, fillings ──

namespace {

/// What is wrong with a box in the place of a body; all of them relative.
struct BoxErrors {
  double volume, centre;  // box to body; in diagonals of the body's upright box
  double density, true_mass, true_volume;

  static constexpr int count = 5;
  std::array<double, count> numbers() const {
    return {volume, centre, density, true_mass, true_volume};
  }
};

BoxErrors errors_of(const boxes::OrientedBox& box, const Thing& body) {
  const Mat3& truth = body.truth.inertia;
  return {box.volume() / body.volume(),
          (box.centre - body.truth.centre).norm() / boxes::aligned_box(body.points()).size.norm(),
          inertia_error(at_density(box, body).inertia, truth),
          inertia_error(at_true_mass(box, body).inertia, truth),
          inertia_error(at_true_volume(box, body).inertia, truth)};
}

/// The mean over all orientations in which the object may lie.
BoxErrors errors_askew(const Thing& body) {
  std::array<double, BoxErrors::count> sums{};
  for (const Mat3& R : turns()) {
    const auto numbers = errors_of(askew_box(body.points(), R), body).numbers();
    for (std::size_t i = 0; i < sums.size(); ++i)
      sums[i] += numbers[i] / static_cast<double>(turns().size());
  }
  return {sums[0], sums[1], sums[2], sums[3], sums[4]};
}

}  // namespace

Table errors_table() {
  Table table({"object", "box", "its volume", "off centre", "density", "true mass", "true volume"});
  const auto add = [&](const Thing& body, const std::string& name, const BoxErrors& e) {
    table.add({body.name, name, times(e.volume), e.centre < 1e-6 ? "0" : percent(e.centre),
               percent(e.density), percent(e.true_mass), percent(e.true_volume)});
  };
  for (const Thing& body : things()) {
    add(body, "upright", errors_of(boxes::aligned_box(body.points()), body));
    add(body, "askew", errors_askew(body));
    add(body, "principal", errors_of(boxes::principal_box(body.points()), body));
    add(body, "smaller", errors_of(boxes::small_oriented_box(body.points()), body));
  }
  return table;
}

// ── Hollow balls ──

namespace {

/// A ball of radius 1 m with a hollow ball of radius r in its middle, in its cube.
double ball_to_cube(double r) {
  const double moment = 2.0 / 5 * (1 - std::pow(r, 5)) / (1 - r * r * r);
  return moment / (2.0 / 3);
}
double share_of_cube(double r) { return pi / 6 * (1 - r * r * r); }

}  // namespace

Table hollow_table() {
  Table table({"wall of the ball", "share of the cube", "density", "true mass", "true volume"});
  for (const double wall : {1., 0.5, 0.2, 0.1, 0.05, 0.01}) {
    const double f = share_of_cube(1 - wall), mass = 1 / ball_to_cube(1 - wall);
    table.add({wall == 1 ? "solid" : percent(wall) + " of its radius", percent(f), times(mass / f),
               times(mass), times(mass * std::cbrt(f * f))});
  }
  return table;
}

std::string between_figure() {
  support::Plot plot{"how full is the box?",
                     {"share of the box that the body fills", support::Scale::linear},
                     {"inertia: body / box", support::Scale::linear},
                     {}};
  support::Series full{"true mass: 1", {}, {}}, shrunk{"true volume: ∛f²", {}, {}},
      ball{"hollow balls", {}, {}};
  for (int i = 1; i <= 50; ++i) {
    const double f = 0.6 * i / 50, r = std::cbrt(std::max(0.0, 1 - f * 6 / pi));
    full.x.push_back(f), full.y.push_back(1);
    shrunk.x.push_back(f), shrunk.y.push_back(std::cbrt(f * f));
    if (share_of_cube(r) < f - 1e-9) continue;  // fuller than the solid ball
    ball.x.push_back(f), ball.y.push_back(ball_to_cube(r));
  }
  std::ranges::reverse(shrunk.x);  // a name is at the end of its curve: here at the left,
  std::ranges::reverse(shrunk.y);  // where no object is
  plot.series = {full, shrunk, ball};
  for (const Thing& body : things()) {
    const boxes::OrientedBox box = boxes::aligned_box(body.points());
    const double ratio = body.truth.inertia.trace() / at_true_mass(box, body).inertia.trace();
    plot.series.push_back(
        {body.name, {body.volume() / box.volume()}, {ratio}, support::Look::dots});
  }
  return support::to_svg(plot);
}

}  // namespace bounding_boxes_chapter
