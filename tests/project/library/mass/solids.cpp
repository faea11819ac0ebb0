// The closed forms: against numbers, against meshes and samples, against each other.
#include <doctest/doctest.h>

#include "project/harness/refusal.hpp"
#include "project/library/mass/meshes.hpp"
#include "tumble/mass.hpp"

using namespace tumble;
using namespace tumble::detail;
using std::numbers::pi;
using test::eps;
using test::inertia_error;

namespace {

/// ∫ f(z) dz from a to b, exact for polynomials up to the fifth degree (Gauss, three points).
template <class F>
double integral(double a, double b, F&& f) {
  const double middle = (a + b) / 2, half = (b - a) / 2, x = std::sqrt(0.6) * half;
  return half * (5 * f(middle - x) + 8 * f(middle) + 5 * f(middle + x)) / 9;
}

/// A body of revolution about z from its outline r²(z), a polynomial of degree ≤ 2: sums of discs.
template <class F>
MassProperties revolved(double a, double b, F&& r2) {
  const double V = integral(a, b, [&](double z) { return pi * r2(z); });
  const double z0 = integral(a, b, [&](double z) { return pi * r2(z) * z; }) / V;
  const double Izz = integral(a, b, [&](double z) { return pi * r2(z) * r2(z) / 2; });
  const double zz = integral(a, b, [&](double z) { return pi * r2(z) * (z - z0) * (z - z0); });
  return symmetric_body(V, z0, Izz / 2 + zz, Izz / 2 + zz, Izz);
}

void check_same(const MassProperties& found, const MassProperties& truth) {
  // About 20 roundings on the longest way, here and in the quadrature.
  CHECK(std::abs(found.mass - truth.mass) <= 20 * eps * truth.mass);
  CHECK((found.centre - truth.centre).norm() <= 20 * eps * (1 + truth.centre.norm()));
  CHECK(inertia_error(found.inertia, truth.inertia) <= 40 * eps);
}

/// The samples agree with the closed form within 4 standard errors (one in 10⁴ would not), and the
/// box around the solid fits: points in its outermost layers are inside the solid.
template <solids::Solid S>
void check_sampled(const S& solid) {
  const MassProperties truth = mass_properties(solid, 3);
  const sampling::SampledMassProperties found =
      sampling::sample_mass_properties(solid, 3, sampling::RandomPoints(20000, 5));
  CHECK(std::abs(found.mass - truth.mass) <= 4 * found.mass_standard_error + 8 * eps * truth.mass);
  CHECK((found.centre - truth.centre).norm() <= 4 * found.centre_standard_error);
  CHECK((found.inertia - truth.inertia).norm() <= 4 * found.inertia_standard_error);
  const Eigen::AlignedBox3d box = solid.bounds();
  Eigen::AlignedBox3d seen;
  sampling::GridPoints points(40);
  for (std::int64_t i = 0; i < points.count(); ++i) {
    const Vec3 x = box.min() + points.next().cwiseProduct(box.sizes());
    if (solid.contains(x)) seen.extend(x);
  }
  // Three of 40 cells at each side: where the outline is round, the very last may be missed.
  CHECK((box.sizes() - seen.sizes()).cwiseQuotient(box.sizes()).maxCoeff() <= 6.0 / 40);
  CHECK_FALSE(solid.contains(box.max() + 1e-9 * box.sizes()));
}

}  // namespace

TEST_CASE("solids: worked numbers") {
  CHECK(mass_properties(Box{Vec3(1, 2, 3)}, 2).mass == 12);
  CHECK(mass_properties(Box{Vec3(1, 2, 3)}, 2).inertia ==
        Vec3(13, 10, 5).asDiagonal().toDenseMatrix());
  CHECK(std::abs(mass_properties(Ball{1}, 1).mass - (4 * pi / 3)) <= 4 * eps * (4 * pi / 3));
  CHECK(std::abs(mass_properties(Cylinder{1, 2}, 1).inertia(2, 2) - pi) <= 4 * eps * pi);
  CHECK(mass_properties(Cone{1, 4}, 1).centre == Vec3(0, 0, 1));
}

TEST_CASE("solids: bodies of revolution are sums of discs") {
  for (const double r : {0.1, 1.0, 7.0}) {
    for (const double h : {0.05, 2.0, 30.0}) {
      CAPTURE(r);
      CAPTURE(h);
      check_same(mass_properties(Cylinder{r, h}, 1),
                 revolved(-h / 2, h / 2, [&](double) { return r * r; }));
      const auto cone = [&](double z) { return r * r * (1 - z / h) * (1 - z / h); };
      check_same(mass_properties(Cone{r, h}, 1), revolved(0, h, cone));
      check_same(mass_properties(Ellipsoid{Vec3(r, r, h)}, 1),
                 revolved(-h, h, [&](double z) { return r * r * (1 - z / h) * (1 + z / h); }));
      const auto cap = [&](double z) { return (r - z) * (r + z); };
      const MassProperties top = translated(revolved(0, r, cap), Vec3(0, 0, h / 2));
      const MassProperties bottom = translated(revolved(-r, 0, cap), Vec3(0, 0, -h / 2));
      check_same(mass_properties(Capsule{r, h}, 1),
                 combine(combine(top, bottom), mass_properties(Cylinder{r, h}, 1)));
    }
  }
}

TEST_CASE("solids: special cases of each other") {
  check_same(mass_properties(Capsule{2, 0}, 3), mass_properties(Ball{2}, 3));
  check_same(mass_properties(Ellipsoid{Vec3(2, 2, 2)}, 3), mass_properties(Ball{2}, 3));
  check_same(mass_properties(Ellipsoid{Vec3(1, 2, 3)}, 3),
             scaled(mass_properties(Ball{1}, 3), Vec3(1, 2, 3)));
}

TEST_CASE("solids: contains() and the closed form speak of the same body") {
  check_sampled(Box{Vec3(1, 2, 3)});
  check_sampled(Ball{1.5});
  check_sampled(Ellipsoid{Vec3(1, 2, 3)});
  check_sampled(Cylinder{1, 3});
  check_sampled(Cone{1, 3});
  check_sampled(Capsule{1, 3});
  check_sampled(solids::Placed<Box>{{Vec3(1, 2, 3)}, Mat3::Identity(), Vec3(5, -3, 1)});
}

TEST_CASE("placed solids: contains, bounds and mass properties are turned and moved together") {
  const solids::Placed<Cone> cone{{1, 3}, test::askew(), Vec3(4, 5, 6)};
  CHECK(cone.contains(Vec3(cone.x + cone.R * Vec3(0, 0, 2.9))));
  CHECK_FALSE(cone.contains(Vec3(cone.x + cone.R * Vec3(0, 0, 3.1))));
  const MassProperties truth = mass_properties(cone, 1);
  CHECK((truth.centre - cone.x - cone.R * Vec3(0, 0, 0.75)).norm() <= 8 * eps * 10);
  const sampling::SampledMassProperties found =
      sampling::sample_mass_properties(cone, 1, sampling::RandomPoints(40000, 6));
  CHECK(std::abs(found.mass - truth.mass) <= 4 * found.mass_standard_error);
  CHECK((found.centre - truth.centre).norm() <= 4 * found.centre_standard_error);
  CHECK((found.inertia - truth.inertia).norm() <= 4 * found.inertia_standard_error);
  const Eigen::AlignedBox3d box = cone.bounds();
  CHECK(box.contains(Vec3(cone.x + cone.R * Vec3(0, 0, 3))));
}

TEST_CASE("solids: are bodies, and refuse dimensions that are not lengths, with their names") {
  require_valid(mass_properties(Capsule{1, 3}, 1000));
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    CAPTURE(bad);
    CHECK_REFUSED(mass_properties(Box{Vec3(1, bad, 1)}, 1), "the box's edge");
    CHECK_REFUSED(mass_properties(Ball{bad}, 1), "the ball's radius");
    CHECK_REFUSED(mass_properties(Ellipsoid{Vec3(1, 1, bad)}, 1), "the ellipsoid's half axis");
    CHECK_REFUSED(mass_properties(Cylinder{bad, 1}, 1), "the cylinder's radius");
    CHECK_REFUSED(mass_properties(Cylinder{1, bad}, 1), "the cylinder's height");
    CHECK_REFUSED(mass_properties(Cone{bad, 1}, 1), "the cone's radius");
    CHECK_REFUSED(mass_properties(Cone{1, bad}, 1), "the cone's height");
    CHECK_REFUSED(mass_properties(Capsule{bad, 1}, 1), "the capsule's radius");
    CHECK_REFUSED(mass_properties(Ball{1}, bad), "the density");
    CHECK_REFUSED(mass_properties(Box{}, bad), "the density");
    CHECK_REFUSED(mass_properties(Ellipsoid{}, bad), "the density");
    CHECK_REFUSED(mass_properties(Cylinder{}, bad), "the density");
    CHECK_REFUSED(mass_properties(Cone{}, bad), "the density");
    CHECK_REFUSED(mass_properties(Capsule{}, bad), "the density");
  }
  CHECK_REFUSED(mass_properties(Capsule{1, -1}, 1), "the capsule's height is -1");
}
