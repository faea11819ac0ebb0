/// @file
/// Figure 8.5, signed triangles of an outline; and what a reader can move in it: a corner, the
/// apex, and how far round the sum has come.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "08_mirtich/moving_figures.hpp"
#include "support/sketch.hpp"

namespace mirtich_chapter::tetrahedra_figure {

namespace {

namespace support = tumble::support;
using support::Control;
using support::Drag;
using support::Settings;
using support::Vec2;

enum Which { corner_x, corner_y, distance, turned, around };
constexpr std::array<Control, 5> controls{
    {{"x", "corner, x", "", 0.2, 4.6, 0.01, 2.5},
     {"y", "corner, y", "", -0.1, 2.2, 0.01, 0.9},
     {"k", "apex at 10ᵏ, k", "", -1, 8, 0.1, 0.3},
     {"turned", "the uppermost edge goes", "", 0, 1, 1, 0, "as the others|the other way round"},
     {"edges", "edges so far, 0: all", "", 0, 6, 0.02, 0}}};

/// Edges of the outline: which of them can be turned round.
constexpr std::size_t count = 6, uppermost = 3;
const Vec2 middle(2.2, 1.05);
const Vec2 away(-0.98734, -0.15862);  // to the left, and round in no unit
constexpr support::Window window{45, 250, 105};

std::array<Vec2, count> outline(Settings now) {
  return {Vec2(1.2, 0.3), {3.4, -0.1}, {now[corner_x], now[corner_y]},
          {3.3, 2.1},     {1.9, 1.5},  {0.7, 2.0}};
}

/// Before the pointer starts and when it is back.
bool whole_round(Settings now) { return now[around] == 0 || now[around] == count; }

struct Edge {
  Vec2 from, to;
};

std::array<Edge, count> edges_of(Settings now) {
  const auto p = outline(now);
  std::array<Edge, count> edges;
  for (std::size_t k = 0; k < count; ++k) edges[k] = {p[k], p[(k + 1) % count]};
  if (now[turned] > 0) std::swap(edges[uppermost].from, edges[uppermost].to);
  return edges;
}

// ── The sum, by the two ways to write a determinant ──

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The area of the triangle over an edge, with its sign: by its corners, seen from the apex.
double by_corners(const Edge& edge, const Vec2& apex) {
  const Vec2 a = edge.from - apex, b = edge.to - apex;
  return cross(a, b) / 2;
}

/// The same by one corner and the edge, as it is before anything has been moved.
double by_edges(const Edge& edge, const Vec2& apex) {
  const Vec2 a = edge.from - apex, e = edge.to - edge.from;
  return cross(a, e) / 2;
}

/// The edges up to where the pointer is.
std::vector<Edge> so_far(const std::array<Edge, count>& edges, double pointer) {
  std::vector<Edge> done(edges.begin(), edges.begin() + static_cast<int>(pointer));
  const double part = pointer - std::floor(pointer);
  if (part == 0) return done;
  const Edge& last = edges[done.size()];
  done.push_back({last.from, last.from + part * (last.to - last.from)});
  return done;
}

double sum(const std::vector<Edge>& edges, const Vec2& apex,
           double (*area)(const Edge&, const Vec2&)) {
  double total = 0;
  for (const Edge& edge : edges) total += area(edge, apex);
  return total;
}

// ── The picture ──

/// A triangle, or of a very far apex the part that is near the outline.
void draw_triangle(support::Sketch& sketch, const Edge& edge, const Vec2& apex) {
  const double area = by_edges(edge, apex);
  if (area == 0) return;
  constexpr double reach = 20;
  const double part = std::min(1., reach / (apex - middle).norm());
  const Vec2 p = edge.from + part * (apex - edge.from), q = edge.to + part * (apex - edge.to);
  sketch.curve({p, edge.from, edge.to, q}, {area > 0 ? "c0" : "c1", 1, 1, 0.25});
}

void draw_outline(support::Sketch& sketch, const std::array<Edge, count>& edges) {
  for (const Edge& edge : edges) {
    const Vec2 centre = (edge.from + edge.to) / 2,
               along = (edge.to - edge.from).normalized() * 0.12;
    sketch.curve({edge.from, edge.to}, {"ink", 2});
    sketch.arrow(centre - along, centre + along, {"ink", 1.6});
  }
}

/// A number whose wrong digits are red.
/// @param error 0 if there is nothing to compare with
void draw_digits(support::Sketch& sketch, double y, const std::string& name, double found,
                 double error) {
  const int digits = std::abs(found) < 1e6 ? 9 : 5;
  const std::string text = support::fixed_text(found, digits);
  int right = -12;  // digits behind the point that are right
  while (right < digits && error < 0.5 * std::pow(10., -right - 1)) ++right;
  const int wrong = digits - right + (right <= 0 ? 1 : 0);  // with the point
  const std::size_t part = text.size() - std::min(text.size(), static_cast<std::size_t>(wrong));
  const double x = 420 + 9.6 * static_cast<double>(part);
  sketch.words({0, 0}, {390, y}, name, "ink", "end");
  sketch.words({0, 0}, {x, y}, text.substr(0, part), "ink", "end");
  sketch.words({0, 0}, {x, y}, text.substr(part), "c6");
}

/// Only a whole round has an area that we can compare with.
void draw_sums(support::Sketch& sketch, Settings now, const std::vector<Edge>& done,
               const Vec2& apex) {
  std::vector<double> as_it_is(now.begin(), now.end());
  as_it_is[turned] = 0;
  const auto edges = edges_of(as_it_is);
  const double truth = sum({edges.begin(), edges.end()}, middle, by_edges);
  const auto error = [&](double found) { return !whole_round(now) ? 0 : std::abs(found - truth); };
  const double corners = sum(done, apex, by_corners), by_edge = sum(done, apex, by_edges);
  sketch.look({0, 0, 1});
  draw_digits(sketch, 335, "sum of ½ a × b, by the corners:", corners, error(corners));
  draw_digits(sketch, 363, "sum of ½ a × e, by the edge e = b − a:", by_edge, error(by_edge));
}

std::string draw(Settings now) {
  const std::array<Edge, count> edges = edges_of(now);
  const Vec2 apex = middle + std::pow(10., now[distance]) * away;
  const std::vector<Edge> done = so_far(edges, whole_round(now) ? count : now[around]);
  support::Sketch sketch(670, 385, "Signed triangles over the edges of an outline", 17);
  sketch.look(window);
  for (const Edge& edge : done) draw_triangle(sketch, edge, apex);
  draw_outline(sketch, edges);
  sketch.dot({now[corner_x], now[corner_y]}, "c3", 7);
  sketch.grip({{now[corner_x], now[corner_y]}});
  if (!done.empty()) sketch.dot(done.back().to, "ink", 5);
  sketch.dot(apex, "ink", 5);
  sketch.words({0, 0}, {405, 35}, "plus: seen from behind", "c0");
  sketch.words({0, 0}, {405, 59}, "minus: from the front", "c1");
  draw_sums(sketch, now, done, apex);
  return sketch.svg();
}

/// Takes the free corner with the pointer.
void drag(std::span<double> settings, const Drag& pointer) {
  settings[corner_x] = allowed(controls[corner_x], (pointer.x - window.x) / window.scale);
  settings[corner_y] = allowed(controls[corner_y], (window.y - pointer.y) / window.scale);
}

}  // namespace
}  // namespace mirtich_chapter::tetrahedra_figure

const tumble::support::MovingFigure tumble::figures::tetrahedra{
    "tetrahedra", mirtich_chapter::tetrahedra_figure::controls,
    mirtich_chapter::tetrahedra_figure::draw, mirtich_chapter::tetrahedra_figure::drag,
    mirtich_chapter::tetrahedra_figure::around};
