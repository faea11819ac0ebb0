/// @file
/// What a formula cannot show: errors in units of what is allowed, and how an implicit step is
/// found.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "drawing.hpp"
#include "parts.hpp"
#include "problems.hpp"
#include "support/sketch.hpp"

namespace solvers_chapter {

namespace {

using support::Sketch;

/// Two axes through a point, with their names.
void draw_axes(Sketch& sketch, const Vec2& low, const Vec2& high, const Vec2& origin,
               const std::string& right, const std::string& up) {
  sketch.arrow({low.x(), origin.y()}, {high.x(), origin.y()}, {"faint", 1.3});
  sketch.arrow({origin.x(), low.y()}, {origin.x(), high.y()}, {"faint", 1.3});
  sketch.words({high.x(), origin.y()}, {4, 20}, right, "ink", "end");
  sketch.words({origin.x(), high.y()}, {8, 8}, up);
}

/// A closed curve of half axes a and b.
Path ellipse_of(double a, double b) {
  Path path;
  for (int i = 0; i <= 80; ++i)
    path.emplace_back(a * std::cos(pi * i / 40), b * std::sin(pi * i / 40));
  return path;
}

/// How far an error may go along each axis, and what that is called.
void draw_allowances(Sketch& sketch, const Vec2& allowed, const std::array<std::string, 2>& names) {
  const support::Pen pen{"ink", 2.2};
  sketch.arrow({0, 0}, {allowed.x(), 0}, pen);
  sketch.arrow({0, 0}, {0, allowed.y()}, pen);
  sketch.words({allowed.x() / 2, 0}, {0, 19}, names[0], "ink", "middle");
  sketch.words({0, allowed.y() / 2}, {-7, 5}, names[1], "ink", "end");
}

}  // namespace

// ── The error norm ──

std::string norm_figure() {
  Sketch sketch(760, 320, "Errors of two components, and the same in units of what is allowed", 16);
  const Vec2 allowed(1.1, 0.42), good(0.6, 0.45), bad(1.45, -0.52);
  sketch.look({190, 160, 72});
  draw_axes(sketch, {-2.2, -1.6}, {2.2, 1.6}, {0, 0}, "e₁ [m]", "e₂ [m/s]");
  sketch.curve(ellipse_of(std::sqrt(2) * allowed.x(), std::sqrt(2) * allowed.y()),
               {"c2", 2.2, 1, 0.1});
  sketch.frame(-allowed, allowed, {"faint", 1.2});
  draw_allowances(sketch, allowed, {"a₁", "a₂"});
  sketch.dot(good, "c0", 5);
  sketch.dot(bad, "c1", 5);
  sketch.look({560, 160, 72});
  draw_axes(sketch, {-2.2, -1.9}, {2.4, 1.9}, {0, 0}, "e₁/a₁", "e₂/a₂");
  sketch.curve(ellipse_of(std::sqrt(2), std::sqrt(2)), {"c2", 2.2, 1, 0.1});
  sketch.frame({-1, -1}, {1, 1}, {"faint", 1.2});
  draw_allowances(sketch, {1, 1}, {"1", "1"});
  sketch.dot(good.cwiseQuotient(allowed), "c0", 5);
  sketch.words(good.cwiseQuotient(allowed), {-4, 22}, "kept", "c0", "middle");
  sketch.dot(bad.cwiseQuotient(allowed), "c1", 5);
  sketch.words(bad.cwiseQuotient(allowed), {10, 12}, "rejected", "c1");
  return sketch.svg();
}

// ── Implicit steps ──

namespace {

/// y' = −4 (y − 0.3), from 1.6: one long step with the slope at the start, one with that at the
/// end. The time is drawn three times as long.
void draw_backward(Sketch& sketch) {
  constexpr double rate = 4, rest = 0.3, start = 1.6, h = 0.6;
  const auto at = [](double t, double y) -> Vec2 { return {3 * t, y}; };
  draw_axes(sketch, at(0, -1.7), at(0.98, 1.85), at(0, 0), "t", "y");
  Path exact;
  for (int i = 0; i <= 60; ++i) {
    const double t = 0.9 * i / 60;
    exact.push_back(at(t, rest + (start - rest) * std::exp(-rate * t)));
  }
  sketch.curve(exact, {"ink", 2.2});
  const double euler = start - h * rate * (start - rest);
  const double backward = (start + h * rate * rest) / (1 + h * rate);
  const double rise = -0.12 * rate * (backward - rest);
  sketch.curve({at(0, start), at(h, euler)}, {"c1", 2});
  sketch.dot(at(h, euler), "c1", 5);
  sketch.words(at(h, euler), {10, 5}, "Euler", "c1");
  sketch.curve({at(0, start), at(h, backward)}, {"c6", 2});
  sketch.curve({at(h - 0.12, backward - rise), at(h + 0.12, backward + rise)}, {"c3", 3.4});
  sketch.dot(at(h, backward), "c6", 5);
  sketch.words(at(h, backward), {8, -14}, "backward Euler", "c6");
  sketch.words(at(h, 0), {0, 19}, "t + h", "ink", "middle");
}

/// g(w) = 1 + 0.24 w² − w, drawn five times as high, and the tangents whose zeros come nearer and
/// nearer to its zero.
void draw_newton(Sketch& sketch) {
  constexpr double h = 0.24;
  const auto at = [](double w) -> Vec2 { return {w, 5 * (1 + h * w * w - w)}; };
  draw_axes(sketch, {0.8, -0.3}, {2.7, 1.46}, {0.8, 0}, "w", "g(w)");
  Path curve;
  for (int i = 0; i <= 60; ++i) curve.push_back(at(0.93 + 1.67 * i / 60));
  sketch.curve(curve, {"ink", 2.2});
  double w = 1;
  for (const char* name : {"w₀", "w₁", "w₂"}) {
    const double next = w - (1 + h * w * w - w) / (2 * h * w - 1);
    sketch.curve({{w, 0}, at(w)}, {"faint", 1.2});
    sketch.curve({at(w), {next, 0}}, {"c3", 2});
    sketch.dot(at(w), "c3", 4);
    sketch.words({w, 0}, {0, 20}, name, "ink", "middle");
    w = next;
  }
  sketch.dot({w, 0}, "c6", 5);
  sketch.words({w, 0}, {14, -10}, "y₁", "c6");
}

}  // namespace

std::string implicit_figure() {
  Sketch sketch(760, 330, "A step with the slope at its end, and how Newton's method finds it", 16);
  sketch.look({30, 165, 86});
  draw_backward(sketch);
  sketch.look({270, 270, 168});
  draw_newton(sketch);
  return sketch.svg();
}

}  // namespace solvers_chapter
