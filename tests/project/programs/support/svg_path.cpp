#include "support/svg_path.hpp"

#include <doctest/doctest.h>

#include <sstream>

using namespace tumble::support;

TEST_CASE("SvgPath: steps from one point to the next, none to a point in the same place") {
  SvgPath path;
  path.move_to(1, 2);
  path.line_to(3.25, 2);
  path.line_to(3.2, 2.01);
  path.line_to(0, 0);
  path.move_to(5, 5);
  path.line_to(6, 4);
  CHECK(path.text() == "M1 2l2.2 0 -3.2 -2M5 5l1 -1");
}

TEST_CASE("SvgPath: specks are lines of no length, each a step from the one before") {
  SvgPath path;
  path.speck(10, 20);
  path.speck(10.26, 19);
  path.speck(10.26, 19);
  path.speck(0, 0.04);
  CHECK(path.text() == "M10 20h0m0.3 -1h0m0 0h0m-10.3 -19h0");
}

TEST_CASE("SvgPath: after thousands of steps the last point is right to a tenth of a pixel") {
  SvgPath path;
  const auto x = [](int i) { return 0.033 * i; };
  const auto y = [](int i) { return 100 * std::sin(0.01 * i); };
  for (int i = 0; i <= 5000; ++i) path.add(x(i), y(i), i == 0);
  std::string text = path.text();
  text[text.find('l')] = ' ';
  std::istringstream steps(text.substr(1));
  double at_x = 0, at_y = 0;
  for (double dx, dy; steps >> dx >> dy;) {
    at_x += dx;
    at_y += dy;
  }
  CHECK(std::abs(at_x - x(5000)) <= 0.05 + 1e-9);
  CHECK(std::abs(at_y - y(5000)) <= 0.05 + 1e-9);
}
