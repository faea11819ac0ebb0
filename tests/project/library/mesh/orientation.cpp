#include "tumble/mesh/orientation.hpp"

#include <doctest/doctest.h>

#include "project/harness/inputs.hpp"
#include "project/library/mesh/shapes.hpp"

using namespace tumble;
using namespace tumble::detail;
using test::Random;

TEST_CASE("orientation: left is 1, right is −1, on the line is 0") {
  CHECK(orientation(0, 0, 1, 0, 0.5, 1) == 1);
  CHECK(orientation(0, 0, 1, 0, 0.5, -1) == -1);
  CHECK(orientation(0, 0, 1, 0, 7, 0) == 0);
}

TEST_CASE("orientation: is exact for points that are an ulp from the line, near and far") {
  // (0.5 + i 2⁻⁵³, 0.5 + j 2⁻⁵³) against the line y = x through (12, 12) and (24, 24): the
  // sign of j − i, where plain doubles give nonsense (Kettner et al., "Classroom examples
  // of robustness problems").
  for (int i = 0; i < 64; ++i)
    for (int j = 0; j < 64; ++j) {
      CAPTURE(i);
      CAPTURE(j);
      const double x = 0.5 + i * 0x1p-53, y = 0.5 + j * 0x1p-53;
      const int sign = (y > x) - (y < x);
      CHECK(orientation(12, 12, 24, 24, x, y) == sign);
      CHECK(orientation(24, 24, 12, 12, x, y) == -sign);
      CHECK(orientation(x, y, 12, 12, 24, 24) == sign);
    }
}

TEST_CASE("exact_sign_of_products: sees what is left when everything large cancels") {
  using Pair = std::array<double, 2>;
  const double a = 1 + 0x1p-52, b = 1 - 0x1p-53;
  CHECK(exact_sign_of_products(
            std::array<Pair, 3>{Pair{1e15, 1e15}, Pair{-1e15, 1e15}, Pair{1e-30, 1}}) == 1);
  // a b = 1 + 2⁻⁵³ − 2⁻¹⁰⁵
  CHECK(exact_sign_of_products(std::array<Pair, 3>{Pair{a, b}, Pair{-1, 1}, Pair{-0x1p-53, 1}}) ==
        -1);
  CHECK(exact_sign_of_products(std::array<Pair, 4>{Pair{a, b}, Pair{-1, 1}, Pair{-0x1p-53, 1},
                                                   Pair{0x1p-105, 1}}) == 0);
}

TEST_CASE("line_crossing: a line through a vertex, an edge or a face enters and leaves once") {
  // Every grid line of these bodies meets edges, diagonals or vertices.
  for (PolygonMesh mesh :
       {test::triangulated(test::cube()), test::triangulated(test::box({0, 0, 0}, {1, 2, 3})),
        test::sphere(2), test::torus(16, 12)}) {
    for (const double offset : {0.0, 0.1, 1e8}) {
      const PolygonMesh shifted = test::moved(mesh, 1, Vec3(offset, -offset, offset));
      std::vector<Vec3> points = shifted.vertices;
      for_each_triangle(shifted, [&](int, const std::array<int, 3>& t) {
        for (int k = 0; k < 3; ++k)
          points.push_back((shifted.vertex(t[static_cast<std::size_t>(k)]) +
                            shifted.vertex(t[static_cast<std::size_t>((k + 1) % 3)])) /
                           2);
      });
      for (const Vec3& p : points) {
        int sum = 0, entered = 0;
        for_each_triangle(shifted, [&](int, const std::array<int, 3>& t) {
          const int c = line_crossing(shifted.vertex(t[0]), shifted.vertex(t[1]),
                                      shifted.vertex(t[2]), p.x(), p.y());
          sum += c;
          entered += c < 0;
        });
        CAPTURE(offset);
        CAPTURE(p.transpose());
        CHECK(sum == 0);
        CHECK(entered <= 2);
      }
    }
  }
}

TEST_CASE("line_crossing: triangles round a vertex are met once by the line through it") {
  // A fan of n triangles round the origin, with the centre of the lowest, the highest or
  // a middle name.
  Random rng(3);
  for (int n = 3; n < 30; ++n) {
    std::vector<Vec3> rim;
    for (int k = 0; k < n; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.4 * rng.uniform()) / n;
      rim.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    int met = 0;
    for (std::size_t k = 0; k < rim.size(); ++k)
      met += line_crossing(Vec3::Zero(), rim[k], rim[(k + 1) % rim.size()], 0, 0);
    CAPTURE(n);
    CHECK(met == 1);
  }
}

TEST_CASE("line_crossing: of two triangles that share an edge one is met, an ulp from it too") {
  Random rng(4);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 p = rng.vector(), q = rng.vector();
    const Vec3 across(p.y() - q.y(), q.x() - p.x(), 0);
    const Vec3 r = p + rng.uniform(0.1, 0.9) * (q - p);  // on the edge, up to an ulp
    const int side = side_of_edge(p, q, r.x(), r.y());
    CAPTURE(p.transpose());
    CAPTURE(q.transpose());
    CHECK(line_crossing(p, q, p + across, r.x(), r.y()) == (side > 0));
    CHECK(line_crossing(q, p, p - across, r.x(), r.y()) == (side < 0));
  }
}

TEST_CASE("line_crossing: a line on the rim is moved by (ε, ε²), ε > 0") {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  CHECK(line_crossing(a, b, c, 0, 0) == 1);
  CHECK(line_crossing(a, b, c, 0.5, 0) == 1);
  CHECK(line_crossing(a, b, c, 0, 0.5) == 1);
  CHECK(line_crossing(a, b, c, 1, 0) == 0);
  CHECK(line_crossing(a, b, c, 0, 1) == 0);
  CHECK(line_crossing(a, b, c, 0.5, 0.5) == 0);
  CHECK(line_crossing(a, c, b, 0.5, 0) == -1);
}

TEST_CASE("line_crossing: a triangle that is vertical is never met") {
  CHECK(line_crossing({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 0.25, 0) == 0);
  CHECK(line_crossing({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0, 0) == 0);
}

TEST_CASE("collinear: exactly") {
  CHECK(collinear({0, 0, 0}, {1, 2, 3}, {2, 4, 6}));
  CHECK(collinear({1, 1, 1}, {1, 1, 1}, {5, 6, 7}));
  CHECK_FALSE(collinear({0, 0, 0}, {1, 2, 3}, {2, 4, std::nextafter(6, 7)}));
  CHECK_FALSE(collinear({1e8, 0, 0}, {1e8 + 1, 2, 3}, {1e8 + 2, 4, 6 + 1e-15}));
}
