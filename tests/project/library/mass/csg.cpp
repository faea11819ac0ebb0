#include "tumble/mass/solids/csg.hpp"

#include <doctest/doctest.h>

#include "project/harness/refusal.hpp"
#include "project/library/mass/meshes.hpp"
#include "tumble/mass.hpp"
#include "tumble/mesh/mesh_solid.hpp"

using namespace tumble;
using std::numbers::pi;
using test::eps;

namespace {

/// The volume agrees with the true one within 4 standard errors (one in 10⁴ would not).
template <solids::Solid S>
void check_volume(const S& solid, double volume) {
  const sampling::SampledMassProperties found =
      sampling::sample_mass_properties(solid, 1, sampling::RandomPoints(40000, 8));
  CAPTURE(found.mass);
  CHECK(std::abs(found.mass - volume) <= 4 * found.mass_standard_error + 8 * eps * volume);
}

Box half_space_above() { return {Vec3(20, 20, 20)}; }  // once it is placed at (0, 0, 10)

}  // namespace

TEST_CASE("csg: contains is or, and, and-not") {
  test::Random rng(51);
  const Ball ball{1};
  const solids::Placed<Box> box = solids::placed(Box{Vec3(1, 1, 1)}, Vec3(0.5, 0.5, 0));
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = 1.5 * rng.vector();
    CAPTURE(p.transpose());
    CHECK(solids::union_of(ball, box).contains(p) == (ball.contains(p) || box.contains(p)));
    CHECK(solids::intersection(ball, box).contains(p) == (ball.contains(p) && box.contains(p)));
    CHECK(solids::difference(ball, box).contains(p) == (ball.contains(p) && !box.contains(p)));
  }
}

TEST_CASE("csg: the bounds hold the solid and are no larger than need be") {
  const Box low{Vec3(2, 2, 2)};
  const solids::Placed<Box> high = solids::placed(Box{Vec3(2, 2, 2)}, Vec3(1, 1, 0));
  CHECK(solids::union_of(low, high).bounds().isApprox({Vec3(-1, -1, -1), Vec3(2, 2, 1)}));
  CHECK(solids::intersection(low, high).bounds().isApprox({Vec3(0, 0, -1), Vec3(1, 1, 1)}));
  CHECK(solids::difference(low, high).bounds().isApprox(low.bounds()));
}

TEST_CASE("csg: lens, drilled ball and hemisphere have the volumes of the closed forms") {
  // Two balls of radius r, d apart: π (2r − d)² (d² + 4 d r)/(12 d).
  const double r = 1, d = 1.2;
  const double lens = pi * (2 * r - d) * (2 * r - d) * (d * d + 4 * d * r) / (12 * d);
  const solids::Placed<Ball> other = solids::placed(Ball{r}, Vec3(d, 0, 0));
  const double ball = mass_properties(Ball{r}, 1).mass;
  check_volume(solids::intersection(Ball{r}, other), lens);
  check_volume(solids::union_of(Ball{r}, other), 2 * ball - lens);
  check_volume(solids::difference(Ball{r}, other), ball - lens);
  // The napkin ring: what a drill leaves of a ball depends on the ring's height h alone, π h³/6.
  const double h = 1.6, drill = std::sqrt(r * r - h * h / 4);
  check_volume(solids::difference(Ball{r}, Cylinder{drill, 3}), pi * h * h * h / 6);
  check_volume(solids::intersection(Ball{r}, solids::placed(half_space_above(), Vec3(0, 0, 10))),
               ball / 2);
  // Two cylinders that cross at right angles: 16/3 r³ (Archimedes).
  const Mat3 lying = Eigen::AngleAxisd(pi / 2, Vec3::UnitX()).toRotationMatrix();
  check_volume(
      solids::intersection(Cylinder{r, 3}, solids::placed(Cylinder{r, 3}, lying, Vec3::Zero())),
      16 * r * r * r / 3);
}

TEST_CASE("csg: a hemisphere has its centre at ⅜ r and inertia ⅖ m r² about the base's middle") {
  const auto hemisphere =
      solids::intersection(Ball{1}, solids::placed(half_space_above(), Vec3(0, 0, 10)));
  const sampling::SampledMassProperties found =
      sampling::sample_mass_properties(hemisphere, 1, sampling::RandomPoints(40000, 9));
  const double mass = 2 * pi / 3;
  CHECK((found.centre - Vec3(0, 0, 0.375)).norm() <= 4 * found.centre_standard_error);
  const Mat3 about_base = 0.4 * mass * Mat3::Identity();
  const Mat3 truth = inertia_about_centre(about_base, mass, Vec3(0, 0, 0.375));
  CHECK((found.inertia - truth).norm() <= 4 * found.inertia_standard_error);
}

TEST_CASE("csg: nests: inclusion and exclusion, and De Morgan, point by point") {
  const Ball a{1};
  const solids::Placed<Box> b =
      solids::placed(Box{Vec3(1, 1, 3)}, test::askew(), Vec3(0.2, 0, 0.1));
  const solids::Placed<Cone> c = solids::placed(Cone{1, 2}, Vec3(0, 0.3, -1));
  const sampling::GridPoints points(20);
  const auto volume = [&](const auto& solid) {
    // the same points for all: bounds of all
    sampling::GridPoints grid = points;
    std::int64_t inside = 0;
    for (std::int64_t i = 0; i < grid.count(); ++i)
      inside += solid.contains(6 * grid.next() - Vec3(3, 3, 3));
    return inside;
  };
  CHECK(volume(solids::union_of(solids::union_of(a, b), c)) ==
        volume(a) + volume(b) + volume(c) - volume(solids::intersection(a, b)) -
            volume(solids::intersection(b, c)) - volume(solids::intersection(c, a)) +
            volume(solids::intersection(a, solids::intersection(b, c))));
  CHECK(volume(solids::difference(a, solids::union_of(b, c))) ==
        volume(solids::intersection(solids::difference(a, b), solids::difference(a, c))));
}

TEST_CASE("csg: meshes are solids like others, and are not copied") {
  const MeshSolid cube(test::box_mesh(Vec3(2, 2, 2)));
  const auto dome = solids::difference(cube, solids::placed(cube, test::askew(), Vec3(1, 1, 1)));
  CHECK(&dome.a.mesh() == &cube.mesh());
  CHECK(&dome.b.solid.mesh() == &cube.mesh());
  const Box same{Vec3(2, 2, 2)};
  const auto twin = solids::difference(same, solids::placed(same, test::askew(), Vec3(1, 1, 1)));
  test::Random rng(52);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = 1.2 * rng.vector();
    CAPTURE(p.transpose());
    CHECK(dome.contains(p) == twin.contains(p));
  }
}

TEST_CASE("csg: what is empty is refused when it is sampled, and only then") {
  const auto apart = solids::intersection(Ball{1}, solids::placed(Ball{1}, Vec3(5, 0, 0)));
  CHECK_REFUSED(sampling::sample_mass_properties(apart, 1, sampling::R3Points(100)),
                "bounds are empty", "intersection");
  CHECK_REFUSED(sampling::sample_mass_properties(
                    solids::placed(apart, test::askew(), Vec3(1, 2, 3)), 1, sampling::R3Points(9)),
                "bounds are empty");
  CHECK_REFUSED(sampling::sample_mass_properties(solids::difference(Ball{1}, Ball{2}), 1,
                                                 sampling::R3Points(100)),
                "none of 100 points");
  // Corners of the boxes meet, the balls do not.
  const auto corners = solids::intersection(Ball{1}, solids::placed(Ball{1}, Vec3(1.5, 1.5, 0)));
  CHECK_REFUSED(sampling::sample_mass_properties(corners, 1, sampling::R3Points(100)),
                "none of 100 points");
  CHECK_REFUSED(sampling::sample_mass_properties(solids::union_of(Ball{-1}, Ball{1}), 1,
                                                 sampling::R3Points(9)),
                "the ball's radius");
  // Nothing joined with something is something.
  CHECK(solids::union_of(apart, Ball{1}).bounds().isApprox(Ball{1}.bounds()));
  check_volume(solids::union_of(Ball{1}, solids::placed(apart, test::askew(), Vec3(1, 2, 3))),
               4 * pi / 3);
}
