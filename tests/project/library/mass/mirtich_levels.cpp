// The three levels of Mirtich's method one by one, each against integrals done another way.
#include <doctest/doctest.h>

#include "project/library/mass/meshes.hpp"
#include "tumble/mass/mirtich/volume_integrals.hpp"

using namespace tumble;
using namespace tumble::detail;
using namespace tumble::mirtich;
using test::eps;

namespace {

/// ∬ f dA over the triangle a b c in the plane, exact for polynomials up to the third degree:
/// weights −27/48 at the middle, 25/48 at three points (Strang & Fix).
template <class F>
double over_triangle(const Vec3& a, const Vec3& b, const Vec3& c, double area, F&& f) {
  const Vec3 middle = (a + b + c) / 3;
  const auto point = [&](const Vec3& corner) {
    return f(Vec3(0.6 * corner + 0.2 * (a + b + c - corner)));
  };
  return area * (25 * (point(a) + point(b) + point(c)) - 27 * f(middle)) / 48;
}

/// The same over a polygon, in a fan; `area(a, b, c)` gives the signed area of a triangle.
template <class Area, class F>
double over_polygon(const std::vector<Vec3>& polygon, Area&& area, F&& f) {
  double sum = 0;
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    const Vec3 &a = polygon[0], &b = polygon[k - 1], &c = polygon[k];
    sum += over_triangle(a, b, c, area(a, b, c), f);
  }
  return sum;
}

const std::vector<Vec3> concave = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0},
                                   {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};

}  // namespace

TEST_CASE("projection_integrals: the unit square: ∬ αⁱβʲ = 1/((i+1)(j+1))") {
  const std::vector<Vec3> square{{0, 0, 9}, {1, 0, 9}, {1, 1, 9}, {0, 1, 9}};
  const ProjectionIntegrals p = projection_integrals(square, 2);
  const double values[] = {p.one, p.a, p.b, p.aa, p.ab, p.bb, p.aaa, p.aab, p.abb, p.bbb};
  const double truth[] = {1,      1. / 2, 1. / 2, 1. / 3, 1. / 4,
                          1. / 3, 1. / 4, 1. / 6, 1. / 6, 1. / 4};
  for (int i = 0; i < 10; ++i) {
    CAPTURE(i);
    CHECK(std::abs(values[i] - truth[i]) <= 4 * eps);
  }
}

TEST_CASE("projection_integrals: any polygon, along each axis, either way round") {
  test::Random rng(121);
  for (int trial = 0; trial < 100; ++trial) {
    const Mat3 A = Eigen::AngleAxisd(rng.uniform(-3, 3), rng.direction()).toRotationMatrix();
    const Vec3 shift = rng.vector();
    std::vector<Vec3> polygon;
    for (const Vec3& x : concave) polygon.push_back(A * x + shift);
    for (int gamma = 0; gamma < 3; ++gamma) {
      const int alpha = (gamma + 1) % 3, beta = (gamma + 2) % 3;
      const auto area = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        return (b - a).cross(c - a)[gamma] / 2;
      };
      const ProjectionIntegrals p = projection_integrals(polygon, gamma);
      const double values[] = {p.one, p.a, p.b, p.aa, p.ab, p.bb, p.aaa, p.aab, p.abb, p.bbb};
      const int powers[][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1},
                               {0, 2}, {3, 0}, {2, 1}, {1, 2}, {0, 3}};
      for (int i = 0; i < 10; ++i) {
        const auto f = [&](const Vec3& x) {
          return std::pow(x[alpha], powers[i][0]) * std::pow(x[beta], powers[i][1]);
        };
        CAPTURE(gamma);
        CAPTURE(i);
        // 6 edges of terms up to (length 3.6)·(coordinate 4.2)^4, 10 roundings, over the divisor 20
        CHECK(std::abs(values[i] - over_polygon(polygon, area, f)) <= 100 * eps * std::pow(4.2, 5));
      }
    }
  }
}

TEST_CASE(
    "face_integrals: the polygon in space, projected along the axis that is nearest to its "
    "normal") {
  test::Random rng(122);
  for (int trial = 0; trial < 100; ++trial) {
    const Mat3 A = Eigen::AngleAxisd(rng.uniform(-3, 3), rng.direction()).toRotationMatrix();
    std::vector<Vec3> polygon;
    const Vec3 shift = rng.vector();
    for (const Vec3& x : concave) polygon.push_back(A * x + shift);
    const Plane plane = plane_of(polygon, vector_area(polygon));
    CHECK((plane.n - A.col(2)).norm() <= 32 * eps);
    CHECK(is_planar(polygon, plane));
    const int C = projection_axis(plane.n), a = (C + 1) % 3, b = (C + 2) % 3, c = C;
    CHECK(std::abs(plane.n[C]) >= std::sqrt(1.0 / 3) - eps);
    const FaceIntegrals f = face_integrals(projection_integrals(polygon, C), plane, C);
    const auto area = [&](const Vec3& p, const Vec3& q, const Vec3& r) {
      return (q - p).cross(r - p).dot(A.col(2)) / 2;
    };
    const auto check = [&](double found, auto&& integrand) {
      // As above, times up to 1/n_γ⁴ = 9 and the sums that h³ is expanded into.
      CHECK(std::abs(found - over_polygon(polygon, area, integrand)) <=
            1000 * eps * std::pow(4.2, 5));
    };
    check(f.a, [&](const Vec3& x) { return x[a]; });
    check(f.b, [&](const Vec3& x) { return x[b]; });
    check(f.c, [&](const Vec3& x) { return x[c]; });
    check(f.aa, [&](const Vec3& x) { return x[a] * x[a]; });
    check(f.bb, [&](const Vec3& x) { return x[b] * x[b]; });
    check(f.cc, [&](const Vec3& x) { return x[c] * x[c]; });
    check(f.aaa, [&](const Vec3& x) { return x[a] * x[a] * x[a]; });
    check(f.bbb, [&](const Vec3& x) { return x[b] * x[b] * x[b]; });
    check(f.ccc, [&](const Vec3& x) { return x[c] * x[c] * x[c]; });
    check(f.aab, [&](const Vec3& x) { return x[a] * x[a] * x[b]; });
    check(f.bbc, [&](const Vec3& x) { return x[b] * x[b] * x[c]; });
    check(f.cca, [&](const Vec3& x) { return x[c] * x[c] * x[a]; });
  }
}

TEST_CASE("volume_integrals: the unit cube about its corner: 1, 1/2, 1/3 and 1/4") {
  const PolygonMesh cube =
      test::mapped(test::box_mesh(Vec3(1, 1, 1)), Mat3::Identity(), Vec3(0.5, 0.5, 0.5));
  const Moments<simd::DoubleDouble> m = volume_integrals(cube, Vec3(0, 0, 0));
  CHECK(std::abs(double(m.one) - 1) <= 4 * eps);
  for (const simd::DoubleDouble& first : {m.x, m.y, m.z})
    CHECK(std::abs(double(first) - 0.5) <= 4 * eps);
  for (const simd::DoubleDouble& square : {m.xx, m.yy, m.zz})
    CHECK(std::abs(double(square) - 1.0 / 3) <= 4 * eps);
  for (const simd::DoubleDouble& mixed : {m.xy, m.yz, m.zx})
    CHECK(std::abs(double(mixed) - 0.25) <= 4 * eps);
}

TEST_CASE(
    "plane_of, is_planar: the plane of all corners, and bends that rounding does not explain") {
  std::vector<Vec3> quad{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const Plane flat = plane_of(quad, vector_area(quad));
  CHECK(flat.n == Vec3(0, 0, 1));
  CHECK(flat.w == -1);
  CHECK(is_planar(quad, flat));
  quad[2].z() += 1e-14;
  CHECK_FALSE(is_planar(quad, plane_of(quad, vector_area(quad))));
  // Three corners on one line first: the plane is that of all, not of the first three.
  const std::vector<Vec3> collinear{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  CHECK(plane_of(collinear, vector_area(collinear)).n == Vec3(0, 0, 1));
}
