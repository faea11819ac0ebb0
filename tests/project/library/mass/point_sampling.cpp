#include "tumble/mass/point_sampling.hpp"

#include <doctest/doctest.h>

#include "project/harness/refusal.hpp"
#include "project/library/mass/meshes.hpp"
#include "tumble/mass/grid_points.hpp"
#include "tumble/mass/low_discrepancy_points.hpp"
#include "tumble/mass/random_points.hpp"
#include "tumble/mass/replicated_sampling.hpp"
#include "tumble/mass/solids/ball.hpp"
#include "tumble/mass/solids/box.hpp"
#include "tumble/mass/solids/cone.hpp"
#include "tumble/mass/solids/placed.hpp"
#include "tumble/mass/stratified_points.hpp"
#include "tumble/mesh/mesh_solid.hpp"

using namespace tumble;
using test::eps;
using test::inertia_error;

namespace {

struct Nowhere {
  bool contains(const Vec3&) const { return false; }
  Eigen::AlignedBox3d bounds() const { return {Vec3(0, 0, 0), Vec3(1, 1, 1)}; }
};

struct Bounded {
  Eigen::AlignedBox3d box;
  bool contains(const Vec3&) const { return true; }
  Eigen::AlignedBox3d bounds() const { return box; }
};

}  // namespace

TEST_CASE("sample_mass_properties: eight points in a cube, counted by hand") {
  const sampling::SampledMassProperties body =
      sampling::sample_mass_properties(Box{Vec3(2, 2, 2)}, 10, sampling::GridPoints(2));
  CHECK(body.mass == 80);
  CHECK(body.centre == Vec3(0, 0, 0));
  // eight points of 10 kg at (±½, ±½, ±½): 80 (¼ + ¼); the cube itself has 80 · 8/12
  CHECK(body.inertia == 40 * Mat3::Identity());
  CHECK(body.points == 8);
  CHECK(body.inside == 8);
  CHECK(body.mass_standard_error == 0);
}

TEST_CASE("sample_mass_properties: a grid is exact for a box up to the cells' own inertia") {
  for (const int n : {1, 3, 10}) {
    const sampling::SampledMassProperties body =
        sampling::sample_mass_properties(Box{Vec3(1, 2, 3)}, 1, sampling::GridPoints(n));
    const MassProperties truth = mass_properties(Box{Vec3(1, 2, 3)}, 1);
    CAPTURE(n);
    // the cells have the box's inertia, 1/n² as large
    CHECK((body.inertia - truth.inertia * (1 - 1.0 / (n * n))).norm() <=
          16 * eps * truth.inertia.norm());
  }
}

TEST_CASE("sample_mass_properties: far away the same as near the origin") {
  const auto at = [](double d) {
    return solids::Placed<Ball>{{1}, Mat3::Identity(), Vec3(d, -d, d)};
  };
  const sampling::SampledMassProperties here =
      sampling::sample_mass_properties(at(0), 1, sampling::R3Points(10000));
  for (const double distance : {1e3, 1e6, 1e8}) {
    const sampling::SampledMassProperties there =
        sampling::sample_mass_properties(at(distance), 1, sampling::R3Points(10000));
    CAPTURE(distance);
    // Points within 1e-8 of the surface may change sides: 3 · 1e-8 of 10⁴ at most one.
    CHECK(std::abs(there.mass - here.mass) <= 8.0 / 10000);
    CHECK(inertia_error(there.inertia, here.inertia) <= 1.0 / 1000);
    CHECK((there.centre - here.centre - Vec3(distance, -distance, distance)).norm() <=
          2e-4 + 4 * eps * distance);
  }
}

TEST_CASE("sample_mass_properties: the standard errors are the spread of many trials") {
  const Cone cone{1, 2};  // its centre of mass is not that of its box
  const MassProperties truth = mass_properties(cone, 2);
  constexpr int trials = 400;
  double mass2 = 0, centre2 = 0, inertia2 = 0;
  sampling::SampledMassProperties body;
  for (int i = 0; i < trials; ++i) {
    body = sampling::sample_mass_properties(
        cone, 2, sampling::RandomPoints(2000, static_cast<std::uint64_t>(i)));
    mass2 += std::pow(body.mass - truth.mass, 2);
    centre2 += (body.centre - truth.centre).squaredNorm();
    inertia2 += (body.inertia - truth.inertia).squaredNorm();
  }
  // The mean of 400 squares scatters by √(2/400) = 7 %, its root by half of that; the estimate from
  // the last 2000 points by a few percent: 4 σ are 20 %.
  CHECK(std::abs(std::sqrt(mass2 / trials) - body.mass_standard_error) <=
        0.2 * body.mass_standard_error);
  CHECK(std::abs(std::sqrt(centre2 / trials) - body.centre_standard_error) <=
        0.2 * body.centre_standard_error);
  CHECK(std::abs(std::sqrt(inertia2 / trials) - body.inertia_standard_error) <=
        0.2 * body.inertia_standard_error);
}

TEST_CASE("sample_mass_properties: stratified points scatter less than the standard errors say") {
  const Cone cone{1, 2};
  const MassProperties truth = mass_properties(cone, 2);
  double last = 1;
  for (const int n : {4, 8, 16}) {
    constexpr int trials = 100;
    double squares = 0;
    sampling::SampledMassProperties body;
    for (std::uint64_t seed = 1; seed <= trials; ++seed) {
      body = sampling::sample_mass_properties(cone, 2, sampling::StratifiedPoints(n, seed));
      squares += std::pow(body.mass - truth.mass, 2) / trials;
    }
    // the bound is never broken, and is ever more a bound
    const double ratio = std::sqrt(squares) / body.mass_standard_error;
    CAPTURE(n);
    CHECK(ratio <= last);
    last = ratio;
  }
  // (N^(−2/3) against N^(−1/2): a factor 8^(−1/6) = 0.7 with every step)
  CHECK(last <= 0.5);
}

TEST_CASE("sample_mass_properties: a grid along flat faces errs by far more than it says") {
  struct LooselyBounded : Box {
    Eigen::AlignedBox3d bounds() const { return {Vec3::Constant(-0.515), Vec3::Constant(0.515)}; }
  };
  // All 32 layers across each axis are inside, for 1.03 m: 1.03³ instead of 1 m³.
  const sampling::SampledMassProperties grid =
      sampling::sample_mass_properties(LooselyBounded{}, 1, sampling::GridPoints(32));
  CHECK(std::abs(grid.mass - 1.03 * 1.03 * 1.03) <= 16 * eps);
  CHECK(grid.mass_standard_error == 0);
  const sampling::SampledMassProperties r3 =
      sampling::sample_mass_properties(LooselyBounded{}, 1, sampling::R3Points(32768));
  CHECK(std::abs(r3.mass - 1) <= r3.mass_standard_error);
}

TEST_CASE("replicated_mass_properties: all points together, and an error that is the true one") {
  const Cone cone{1, 2};
  const MassProperties truth = mass_properties(cone, 2);
  const auto stratified = [](std::uint64_t seed) { return sampling::StratifiedPoints(8, seed); };
  const sampling::SampledMassProperties body =
      sampling::replicated_mass_properties(cone, 2, 200, stratified);
  CHECK(body.points == 200 * 512);
  CHECK(std::abs(body.mass - truth.mass) <= 4 * body.mass_standard_error);
  CHECK((body.centre - truth.centre).norm() <= 4 * body.centre_standard_error);
  CHECK((body.inertia - truth.inertia).norm() <= 4 * body.inertia_standard_error);
  // Other sets scatter as these say: 200 in groups of 20. σ is known to 1/√38 = 16 %.
  double squares = 0;
  for (std::uint64_t group = 1; group <= 10; ++group) {
    const sampling::SampledMassProperties part = sampling::replicated_mass_properties(
        cone, 2, 20,
        [&](std::uint64_t seed) { return sampling::StratifiedPoints(8, 1000 * group + seed); });
    squares += std::pow(part.mass - truth.mass, 2) / 10;
    CHECK(std::abs(part.mass_standard_error / (body.mass_standard_error * std::sqrt(10.0)) - 1) <=
          4 * 0.16);
  }
  CHECK(std::abs(std::sqrt(squares / 10) / body.mass_standard_error - 1) <= 4 / std::sqrt(20.0));
}

TEST_CASE("replicated_mass_properties: of random points it is what their formula says") {
  const auto random = [](std::uint64_t seed) { return sampling::RandomPoints(500, seed); };
  const sampling::SampledMassProperties sets =
      sampling::replicated_mass_properties(Cone{1, 2}, 2, 100, random);
  const sampling::SampledMassProperties formula =
      sampling::sample_mass_properties(Cone{1, 2}, 2, sampling::RandomPoints(100 * 500));
  // 100 sets know σ to 1/√198 = 7 %
  CHECK(std::abs(sets.mass_standard_error / formula.mass_standard_error - 1) <= 4 * 0.07);
  CHECK(std::abs(sets.centre_standard_error / formula.centre_standard_error - 1) <= 4 * 0.07);
  CHECK(std::abs(sets.inertia_standard_error / formula.inertia_standard_error - 1) <= 4 * 0.07);
  CHECK_REFUSED(sampling::replicated_mass_properties(Ball{1}, 1, 1, random), "sets of points is 1");
  CHECK_REFUSED(sampling::replicated_mass_properties(Ball{1}, -1, 2, random), "the density");
}

TEST_CASE("sample_mass_properties: meshes are solids, and agree with their integrals") {
  for (const PolygonMesh& mesh :
       {test::unit_tetrahedron(), test::torus_mesh(24, 12, 1, 0.4),
        test::mapped(test::box_mesh(Vec3(1, 2, 3)), test::askew(), Vec3(1, 2, 3))}) {
    const MassProperties truth = test::exact_mass_properties(mesh, 1);
    const sampling::SampledMassProperties body =
        sampling::sample_mass_properties(MeshSolid(mesh), 1, sampling::RandomPoints(20000, 4));
    CHECK(std::abs(body.mass - truth.mass) <= 4 * body.mass_standard_error);
    CHECK((body.centre - truth.centre).norm() <= 4 * body.centre_standard_error);
    CHECK((body.inertia - truth.inertia).norm() <= 4 * body.inertia_standard_error);
  }
}

TEST_CASE("sample_mass_properties: refuses what has no answer, and says what to do") {
  CHECK_REFUSED(sampling::sample_mass_properties(Nowhere{}, 1, sampling::R3Points(77)),
                "none of 77 points", "more points", "(0, 0, 0) to (1, 1, 1)");
  for (const double density : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    CHECK_REFUSED(sampling::sample_mass_properties(Ball{1}, density, sampling::R3Points(10)),
                  "the density");
  CHECK_REFUSED(sampling::sample_mass_properties(Bounded{}, 1, sampling::R3Points(10)),
                "bounds are empty");
  const Vec3 one(1, 1, 1), flat(1, 1, 0), inf(1, 1, std::numeric_limits<double>::infinity()),
      nan(1, 1, std::nan(""));
  for (const Vec3& corner : {flat, inf, nan}) {
    CAPTURE(corner.transpose());
    CHECK_REFUSED(sampling::sample_mass_properties(Bounded{{Vec3(0, 0, 0), corner}}, 1,
                                                   sampling::R3Points(10)),
                  "bounds are empty");
  }
  CHECK_NOTHROW(
      sampling::sample_mass_properties(Bounded{{Vec3(0, 0, 0), one}}, 1, sampling::R3Points(10)));
}
