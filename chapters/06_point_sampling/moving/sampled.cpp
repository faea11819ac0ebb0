/// @file
/// Figure 6.12: a mug that is sampled by the reader's method, and the errors of all runs so far.

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "06_point_sampling/moving_figures.hpp"
#include "06_point_sampling/sampling_runs.hpp"
#include "objects/plain_mug.hpp"
#include "support/box_edges.hpp"
#include "support/facets.hpp"
#include "support/space_sketch.hpp"

namespace point_sampling_chapter::sampled_figure {

namespace {

using support::Control;
using support::Settings;
using support::Sketch;
using support::svg_number;
using support::Vec2;

enum Which { doublings, set, placement };
constexpr std::array<Control, 3> controls{
    {{"k", "points, 2ᵏ, k", "", fewest, most, 1, 12},
     {"points", "kind of points", "", 0, 3, 1, 0, "random|grid|stratified|R3"},
     {"placement", "placement of the mug", "", 1, all_placements, 1, 5}}};
// ── The mug in its box ──

void draw_mug(Sketch& sketch, const Run& run) {
  constexpr double x = 190, y = 200, scale = 1550;
  static const PolygonMesh pale = objects::plain_mug();
  const Mat3 view = support::view_from(-65 * degree, 18 * degree);
  const auto body = body_of(run);
  const Eigen::AlignedBox3d box = body.bounds();
  const Vec3 origin = view * (place_of(run).x - box.center());
  sketch.drawing(support::draw_pale_facets(
      pale, view * place_of(run).R, {x + scale * origin.x(), y - scale * origin.y(), scale}));
  sketch.look({x, y, scale});
  const Mat3 edges = box.sizes().asDiagonal();
  sketch.curves(support::box_edges(Vec3::Zero(), edges, view), {"faint", 1});
  std::vector<Vec2> seen;
  with_points(run.set, run.number(), run.seed(), [&](const auto& points) {
    for (const Vec3& p : points_inside(body, points))
      seen.emplace_back((view * (p - box.center())).head<2>());
  });
  sketch.specks(seen, "c1", 1.8);
  sketch.look({40, 395, 1});
  support::SpaceSketch(sketch, view).world_axes(Vec3::Zero(), 34);
}

// ── The diagram of errors against numbers, both logarithmic ──

constexpr double left = 450, top = 40, per_doubling = 42, per_decade = 117;
constexpr int decades = 3;

Vec2 in_diagram(double k, double error) {
  const double down = -std::log(error) / std::numbers::ln10 * per_decade;
  return {left + per_doubling * (k - fewest), -top - down};
}

void draw_axes(Sketch& sketch) {
  const double right = left + per_doubling * (most - fewest);
  for (const auto& [error, name] :
       {std::pair{1., "1"}, {0.1, "0.1"}, {0.01, "0.01"}, {0.001, "0.001"}}) {
    const double y = in_diagram(fewest, error).y();
    sketch.curve({{left, y}, {right, y}}, {"grid", 1});
    sketch.words({left, y}, {-8, 6}, name, "ink", "end");
  }
  const double bottom = -top - decades * per_decade;
  for (int k = fewest; k <= most; k += 2)
    sketch.words(in_diagram(k, 1), {0, decades * per_decade + 24}, std::to_string(1 << k), "ink",
                 "middle");
  sketch.words({(left + right) / 2, bottom}, {0, 48}, "points", "ink", "middle");
  sketch.words({left, -top}, {-50, -16}, "error of the inertia");
  constexpr double start = 0.4;
  for (const auto& [order, name] : {std::pair{0.5, "−1/2"}, {2. / 3, "−2/3"}, {1., "−1"}}) {
    const double end = start * std::exp(-order * (most - fewest) * std::numbers::ln2);
    sketch.curve({in_diagram(fewest, start), in_diagram(most, end)}, {"faint", 1.4});
    sketch.words(in_diagram(most, end), {6, 6}, name, "faint");
  }
}

/// The runs up to this one: all placements small, this placement large, and the mean as a line.
void draw_runs(Sketch& sketch, const Run& run) {
  std::vector<Vec2> others, own, mean;
  for (int k = fewest; k <= run.k; ++k) {
    for (int i = 1; i <= all_placements; ++i)
      others.push_back(in_diagram(k, error_of({run.set, k, i})));
    own.push_back(in_diagram(k, error_of({run.set, k, run.placement})));
    mean.push_back(in_diagram(k, typical_error({run.set, k, 0})));
  }
  sketch.specks(others, "c0", 2.2);
  sketch.curve(mean, {"c0", 2});
  sketch.dots(own, "c1", 4);
  sketch.dot(own.back(), "c1", 7);
}

std::string percent(double share) { return svg_number(100 * share, share < 0.01 ? 3 : 1) + " %"; }

void draw_numbers(Sketch& sketch, const Run& run) {
  const auto line = [&](double y, const std::string& text, const std::string& colour) {
    sketch.words({20, -y}, {0, 0}, text, colour);
  };
  line(478,
       "mass " + svg_number(1000 * found(run).mass, 1) + " g; exactly " +
           svg_number(1000 * truth_of_the_mug().mass, 1) + " g",
       "ink");
  line(504, "its inertia, in this placement: off by " + percent(error_of(run)), "c1");
  line(530, "typical of the sixteen placements: " + percent(typical_error(run)), "c0");
}

std::string draw(Settings now) {
  const Run run{static_cast<int>(now[set]), static_cast<int>(now[doublings]),
                static_cast<int>(now[placement])};
  Sketch sketch(760, 545, "A sampled mug, and its error against the number of points", 17);
  draw_mug(sketch, run);
  sketch.look({0, 0, 1});
  draw_axes(sketch);
  draw_runs(sketch, run);
  draw_numbers(sketch, run);
  return sketch.svg();
}

}  // namespace
}  // namespace point_sampling_chapter::sampled_figure

const tumble::support::MovingFigure tumble::figures::sampled{
    "sampled", point_sampling_chapter::sampled_figure::controls,
    point_sampling_chapter::sampled_figure::draw};
