/// @file
/// Gram–Schmidt and Newton's iteration with numbers that fit on paper.

#include "common.hpp"
#include "favourite.hpp"
#include "parts.hpp"

namespace rotation_matrices_chapter {

namespace {

/// The paper rotation with its first two axes stretched and pulled towards each other.
Mat3 paper_matrix() {
  Mat3 M;
  M << 0.66, -0.65, 0.4, 0.88, 0.8, -0.3, 0, 0.75, 0.9;
  return M;
}

}  // namespace

Table gram_schmidt_by_hand_table() {
  Table table({"step", "number"});
  const Mat3 M = paper_matrix(), R = rotation::gram_schmidt(M);
  const Vec3 m1 = M.col(0), m2 = M.col(1), x = R.col(0);
  const Vec3 left = m2 - x.dot(m2) * x;
  table.add({"|m₁|", number(m1.norm())});
  table.add({"x = m₁ / |m₁|", in_brackets(x)});
  table.add({"x · m₂", number(x.dot(m2))});
  table.add({"m₂ − (x · m₂) x", in_brackets(left)});
  table.add({"its length", number(left.norm())});
  table.add({"y", in_brackets(R.col(1))});
  table.add({"z = x × y", in_brackets(R.col(2))});
  return table;
}

Table favourite_table() {
  Table table({"favourite", "x becomes", "y becomes", "changed by ‖R − M‖"});
  Mat3 M = Mat3::Identity();
  M(0, 1) = 0.1;
  const auto add = [&](const std::string& name, const Mat3& R) {
    table.add({name, in_brackets(R.col(0)), in_brackets(R.col(1)), number((R - M).norm(), 3)});
  };
  add("x first", gram_schmidt_from(M, 0));
  add("y first", gram_schmidt_from(M, 1));
  add("none: nearest", nearest_rotation(M));
  return table;
}

Table newton_table() {
  Table table({"after step", "σ = 2", "σ = 1.1", "σ = 0.5"});
  Vec3 sigma(2, 1.1, 0.5);
  for (int step = 0; step <= 4; ++step) {
    table.add({number(step), number(sigma[0], 10), number(sigma[1], 10), number(sigma[2], 10)});
    sigma = (sigma + sigma.cwiseInverse()) / 2;
  }
  return table;
}

// ── Gram–Schmidt as a drawing ──

namespace {

using support::Sketch, support::Vec2;

/// In the plane of the first two columns, where x is to the right.
void draw_plane(Sketch& sketch, double left, const std::string& below) {
  sketch.look({left, 218, 120});
  sketch.curve({{-0.25, 0}, {1.35, 0}}, {"grid", 1.6});
  sketch.curve({{0, -0.25}, {0, 1.5}}, {"grid", 1.6});
  sketch.words({0.55, 0}, {0, 70}, below, "ink", "middle");
}

}  // namespace

std::string gram_schmidt_figure() {
  Sketch sketch(760, 306, "Gram and Schmidt in the plane of the first two columns", 17);
  const Vec2 m1(1.1, 0), m2(0.25, 1.25);
  draw_plane(sketch, 60, "two columns of M");
  sketch.arrow({0, 0}, m1, {"c0", 2.6});
  sketch.words(m1, {0, -10}, "m₁", "c0");
  sketch.arrow({0, 0}, m2, {"c1", 2.6});
  sketch.words(m2, {8, -6}, "m₂", "c1");
  draw_plane(sketch, 310, "subtract the part along x");
  sketch.arrow({0, 0}, {1, 0}, {"c0", 2.6});
  sketch.words({1, 0}, {12, -8}, "x", "c0");
  sketch.arrow({0, 0}, m2, {"c1", 2.6, 0.5});
  sketch.words(m2, {10, 22}, "m₂", "c1");
  sketch.arrow(m2, {0, 1.25}, {"c3", 2.2});
  sketch.words({0.12, 1.25}, {0, -10}, "−(x · m₂) x", "c3", "middle");
  draw_plane(sketch, 560, "normalise; z = x × y");
  sketch.arrow({0, 0}, {1, 0}, {"c0", 2.6});
  sketch.words({1, 0}, {12, -8}, "x", "c0");
  sketch.arrow({0, 0}, {0, 1}, {"c1", 2.6});
  sketch.words({0, 1}, {12, 4}, "y", "c1");
  sketch.dot({0, 0}, "c2", 5);
  sketch.words({0, 0}, {-10, 24}, "z towards you", "c2", "start");
  return sketch.svg();
}

}  // namespace rotation_matrices_chapter
