/// @file
/// In the plane, where it can be seen: how points are spread, and which cells leave something to
/// chance.

#include "common.hpp"
#include "die.hpp"
#include "parts.hpp"

namespace point_sampling_chapter {

namespace {

/// A shape of the unit square, with a curved outline.
bool in_shape(const Vec2& p) {
  const Vec2 d = p - Vec2(0.5, 0.49);
  const double angle = std::atan2(d.y(), d.x());
  return d.norm() <= 0.36 + 0.05 * std::cos(3 * angle + 0.4);
}

std::vector<Vec2> shape_outline() {
  std::vector<Vec2> line;
  for (int i = 0; i <= 120; ++i) {
    const double angle = 3 * i * degree;
    const double r = 0.36 + 0.05 * std::cos(3 * angle + 0.4);
    line.emplace_back(0.5 + r * std::cos(angle), 0.49 + r * std::sin(angle));
  }
  return line;
}

void draw_points(support::Sketch& sketch, const std::vector<Vec2>& points) {
  std::vector<Vec2> inside, outside;
  for (const Vec2& p : points) (in_shape(p) ? inside : outside).push_back(p);
  sketch.specks(outside, "faint", 2.2);
  sketch.specks(inside, "c1", 2.8);
}

/// x and y of the first layer or of all points.
template <sampling::SamplePoints P>
std::vector<Vec2> first_two(P points, int count) {
  std::vector<Vec2> list;
  list.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) list.push_back(points.next().template head<2>());
  return list;
}

/// Whether a cell of n × n is neither wholly inside nor wholly outside.
bool is_cut(int i, int j, int n) {
  constexpr int fine = 12;
  int inside = 0;
  for (int a = 0; a <= fine; ++a)
    for (int b = 0; b <= fine; ++b)
      inside +=
          in_shape(Vec2(i + static_cast<double>(a) / fine, j + static_cast<double>(b) / fine) / n);
  return inside > 0 && inside < (fine + 1) * (fine + 1);
}

}  // namespace

std::string squares_figure() {
  constexpr int n = 16, all = n * n;
  support::Sketch sketch(760, 236, "256 points of the unit square, spread in four ways", 22);
  const std::array<std::string, 4> names{"random", "stratified", "grid", "R3"};
  const std::array<std::vector<Vec2>, 4> sets{
      first_two(sampling::RandomPoints(all), all), first_two(sampling::StratifiedPoints(n), all),
      first_two(sampling::GridPoints(n), all), first_two(sampling::R3Points(all), all)};
  for (std::size_t k = 0; k < 4; ++k) {
    sketch.look({8 + 190 * static_cast<double>(k), 186, 176});
    if (k == 1)
      for (int i = 1; i < n; ++i) {
        const double t = static_cast<double>(i) / n;
        sketch.curves({{{t, 0}, {t, 1}}, {{0, t}, {1, t}}}, {"grid", 0.7});
      }
    sketch.frame({0, 0}, {1, 1}, {"faint", 1});
    sketch.curve(shape_outline(), {"c1", 1, 1, 0.08});
    draw_points(sketch, sets[k]);
    sketch.words({0.5, 0}, {0, 28}, names[k], "ink", "middle");
  }
  return sketch.svg();
}

std::string cells_figure() {
  support::Sketch sketch(700, 276, "The cells that the outline cuts", 21);
  const std::array<int, 3> sizes{8, 16, 32};
  for (std::size_t k = 0; k < 3; ++k) {
    const int n = sizes[k];
    sketch.look({8 + 232 * static_cast<double>(k), 226, 216});
    std::vector<std::vector<Vec2>> lines;
    for (int i = 0; i <= n; ++i) {
      const double t = static_cast<double>(i) / n;
      lines.push_back({{t, 0}, {t, 1}});
      lines.push_back({{0, t}, {1, t}});
    }
    sketch.curves(lines, {"grid", 0.8});
    int cut = 0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        if (!is_cut(i, j, n)) continue;
        ++cut;
        const double a = static_cast<double>(i) / n, b = static_cast<double>(j) / n, w = 1.0 / n;
        sketch.curve({{a, b}, {a + w, b}, {a + w, b + w}, {a, b + w}, {a, b}},
                     {"c1", 0.5, 1, 0.55});
      }
    sketch.curve(shape_outline(), {"ink", 1.4});
    sketch.words({0.5, 0}, {0, 30}, number(cut) + " of " + number(n * n, 4) + " cells", "ink",
                 "middle");
  }
  return sketch.svg();
}

}  // namespace point_sampling_chapter
