#include "tumble/mesh/line_lattice.hpp"

#include <doctest/doctest.h>

#include <set>

#include "project/harness/inputs.hpp"
#include "tumble/mesh/jittered_lines.hpp"

using namespace tumble;
using namespace tumble::detail;
using test::Random;

namespace {

/// The lines in a rectangle, by looking at all.
template <class Lines>
std::set<int> slow_but_correct(const Lines& lines, const Rectangle& r) {
  std::set<int> found;
  for (int i = 0; i < lines.size(); ++i)
    if (r.contains(lines.line(i))) found.insert(i);
  return found;
}

template <class Lines>
void check_rectangles(const Lines& lines, const Eigen::AlignedBox3d& box) {
  Random rng(5);
  for (int k = 0; k < 2000; ++k) {
    const double size = std::pow(10, rng.uniform(-4, 0.5));
    const Vec3 p = box.center() + 0.6 * rng.vector().cwiseProduct(box.sizes());
    Rectangle r{p.x(), p.x() + size * box.sizes().x(), p.y(), p.y() + size * box.sizes().y()};
    // Now and then an edge of the rectangle passes through a line exactly.
    if (k % 3 == 0) r.x0 = lines.line(k % lines.size()).x();
    if (k % 5 == 0) r.y1 = lines.line(k % lines.size()).y();
    std::set<int> found;
    lines.for_each_in(r, [&](int i, const PlanePoint& line) {
      CHECK(found.insert(i).second);
      CHECK(line == lines.line(i));
    });
    CAPTURE(k);
    CHECK(found == slow_but_correct(lines, r));
  }
}

const std::vector<Eigen::AlignedBox3d> boxes = {
    {Vec3(0, 0, 0), Vec3(1, 2, 3)},
    {Vec3(-1e-6, 0, 0), Vec3(1e-6, 3e-8, 0)},
    {Vec3(1e8, 1e8, 0), Vec3(1e8 + 1, 1e8 + 1, 1)},
    {Vec3(1e8, 0, 0), Vec3(1e8 + 1e-7, 1, 1)},  // 7 ulps wide
    {Vec3(0, 0, 0), Vec3(0, 1, 1)},             // no width
};

}  // namespace

TEST_CASE("LineLattice: a rectangle gets exactly the lines in it") {
  for (const Eigen::AlignedBox3d& box : boxes) {
    CAPTURE(box.min().transpose());
    const LineLattice lines(box, 1024);
    CHECK(lines.size() == 1024);
    check_rectangles(lines, box);
  }
}

TEST_CASE("LineLattice: every rectangle of a thousandth of the box is within reach of a line") {
  // A lattice of 1024 lines: boxes of 1/8 by 1/16 (8 cells of it) hold at least 4 lines each.
  const LineLattice lines({Vec3(0, 0, 0), Vec3(1, 1, 1)}, 1024);
  Random rng(6);
  for (int k = 0; k < 1000; ++k) {
    const double x = rng.uniform(0, 0.875), y = rng.uniform(0, 0.9375);
    CHECK(slow_but_correct(lines, {x, x + 0.125, y, y + 0.0625}).size() >= 4);
  }
}

TEST_CASE("LineLattice: regular lines stand in the middles of square cells") {
  const LineLattice lines = LineLattice::regular({Vec3(0, 0, 0), Vec3(2, 1, 5)}, 8);
  REQUIRE(lines.size() == 8);
  for (int i = 0; i < 8; ++i)
    CHECK(lines.line(i) == PlanePoint(0.25 + i / 2 * 0.5, 0.25 + i % 2 * 0.5));
  for (const Eigen::AlignedBox3d& box : boxes) {
    const LineLattice regular = LineLattice::regular(box, 1000);
    CHECK(regular.size() <= 1000);
    CHECK(regular.size() > 500);  // whole numbers, rounded down
    check_rectangles(regular, box);
  }
}

TEST_CASE("JitteredLines: one in each cell, and a rectangle gets exactly the lines in it") {
  const Eigen::AlignedBox3d box(Vec3(-1, -0.5, 0), Vec3(1, 0.5, 1));
  const JitteredLines lines(box, 800, 3);
  REQUIRE(lines.size() == 800);
  std::set<int> cells;
  for (int i = 0; i < lines.size(); ++i) {
    CHECK(box.contains(Vec3(lines.line(i).x(), lines.line(i).y(), 0)));
    cells.insert(static_cast<int>((lines.line(i).x() + 1) * 20) +
                 40 * static_cast<int>((lines.line(i).y() + 0.5) * 20));
  }
  CHECK(cells.size() == 800);
  check_rectangles(lines, box);
}

TEST_CASE("LineList: a rectangle gets exactly the lines in it") {
  for (const Eigen::AlignedBox3d& box : boxes) {
    CAPTURE(box.min().transpose());
    Random rng(7);
    std::vector<PlanePoint> points;
    for (int i = 0; i < 300; ++i) {
      const Vec3 p = box.center() + 0.5 * rng.vector().cwiseProduct(box.sizes());
      points.emplace_back(p.x(), p.y());
    }
    check_rectangles(LineList(box, points), box);
  }
}

TEST_CASE("LatticeFilter: leaves no rectangle out that has a line in it, and most that have none") {
  for (const Eigen::AlignedBox3d& box : boxes) {
    const LineLattice lines(box, 1024);
    CAPTURE(box.min().transpose());
    Random rng(6);
    int passed = 0, with_lines = 0;
    for (int k = 0; k < 20000; ++k) {
      const Vec3 p = box.center() + 0.5 * rng.vector().cwiseProduct(box.sizes());
      const Vec3 size = std::pow(10, rng.uniform(-4, -1)) * box.sizes();
      Rectangle r{p.x(), p.x() + size.x(), p.y(), p.y() + size.y()};
      if (k % 3 == 0) r.x0 = lines.line(k % lines.size()).x();
      if (k % 5 == 0) r.y1 = lines.line(k % lines.size()).y();
      using P = simd::FourDoubles;
      const P near = lines.filter().near<P>(P{} + r.x0, P{} + r.x1, P{} + r.y0, P{} + r.y1);
      const bool has_line = !slow_but_correct(lines, r).empty();
      passed += near[0] != 0, with_lines += has_line;
      if (has_line) CHECK(near[0] == 1);
    }
    if (box.sizes().x() > 1e-6) CHECK(passed <= 2 * with_lines);
  }
}
