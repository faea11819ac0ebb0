#include "support/sketch.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "project/harness/refusal.hpp"

using namespace tumble::support;
using tumble::test::mentions;

TEST_CASE("sketch: a unit to the right and a unit up are as long, from where the window says") {
  Sketch sketch(100, 100, "a title");
  sketch.look({50, 60, 10});
  sketch.curve({{0, 0}, {1, 0}, {1, 2}}, {"c3"});
  CHECK(mentions(sketch.svg(), "<title>a title</title>", "d=\"M50 60l10 0 0 -20\"", stroke_of("c3"),
                 "fill=\"none\"", "</svg>"));
}

TEST_CASE("sketch: a frame is closed, and filled only if asked") {
  Sketch sketch(100, 100, "");
  sketch.look({0, 10, 1});
  sketch.frame({1, 2}, {3, 5}, {"grid", 1, 1, 0.25});
  CHECK(mentions(sketch.svg(), "M1 8l2 0 0 -3 -2 0 0 3\"", "fill-opacity=\"0.25\""));
}

TEST_CASE("sketch: discs grow with the window, dots do not") {
  Sketch sketch(100, 100, "");
  sketch.look({0, 0, 4});
  sketch.disc({1, 0}, 2, "c0");
  sketch.dot({1, 0}, "c1", 3);
  sketch.dots({{2, 0}, {3, 0}}, "c2", 2);
  CHECK(mentions(sketch.svg(), "cx=\"4\" cy=\"0\" r=\"8\" " + fill_of("c0"),
                 "cx=\"4\" cy=\"0\" r=\"3\" " + fill_of("c1"),
                 "<g " + fill_of("c2") + ">\n<circle cx=\"8\" cy=\"0\" r=\"2\"/>"));
}

TEST_CASE("sketch: words may have what XML reserves") {
  Sketch sketch(100, 100, "");
  sketch.words({0, 0}, {3, 4}, "a < b", "ink", "end");
  CHECK(mentions(sketch.svg(), "x=\"3\" y=\"4\"", "text-anchor=\"end\">a &lt; b</text>"));
}

TEST_CASE("sketch: an arrow's name is clear of its tip, whichever way it points") {
  for (const std::string name : {"x", "x_world"})
    for (int eighth = 0; eighth < 8; ++eighth) {
      CAPTURE(name);
      CAPTURE(eighth);
      const double angle = eighth * std::numbers::pi / 4;
      const Vec2 along(std::cos(angle), std::sin(angle));
      Sketch sketch(100, 100, "", 13);
      sketch.name_at_tip({0, 0}, 1e-9 * along, name);
      const std::string svg = sketch.svg();
      const auto coordinate = [&svg](const std::string& name_of_it) {
        const std::size_t at = svg.find("<text ");
        return std::stod(svg.substr(svg.find(name_of_it + "=\"", at) + name_of_it.size() + 2));
      };
      const Vec2 middle(coordinate("x"), 5 - coordinate("y"));  // of the letters, y up
      const Vec2 half(text_width(name) / 2, 5);
      CHECK(middle.dot(along) - along.cwiseAbs().dot(half) > 5);
      CHECK(std::abs(middle.x() * along.y() - middle.y() * along.x()) < 0.2);  // in its direction
    }
}
