// How the error of the inertia falls with the number of points or columns: the observed orders
// beside the theoretical ones, on turned bodies whose truth is known.
#include <doctest/doctest.h>

#include "project/library/mass/meshes.hpp"
#include "tumble/mass.hpp"
#include "tumble/ode/observed_order.hpp"

using namespace tumble;

namespace {

/// The typical error over 24 placements of a body: the geometric mean, which the one or other
/// placement along the grid does not spoil. Its logarithm scatters by about 0.6/√24 = 0.12.
/// @param error error(R, x, seed)
template <class Error>
double typical_error(Error&& error) {
  constexpr int trials = 24;
  test::Random rng(91);
  double sum = 0;
  for (std::uint64_t seed = 1; seed <= trials; ++seed) {
    const Mat3 R = Eigen::AngleAxisd(rng.uniform(-3, 3), rng.direction()).toRotationMatrix();
    sum += std::log(error(R, rng.vector(), seed));
  }
  return std::exp(sum / trials);
}

/// p in error ~ n^(−p), from the typical errors at three numbers n: their logarithms are 2.7 apart,
/// so that p scatters by 0.12/(2.7 √2) = 0.03.
template <class Error>
double order(const std::array<double, 3>& numbers, Error&& error) {
  std::array<double, 3> h{}, errors{};
  for (std::size_t i = 0; i < 3; ++i) {
    h[i] = 1 / numbers[i];
    errors[i] = typical_error([&](const Mat3& R, const Vec3& x, std::uint64_t seed) {
      return error(static_cast<int>(numbers[i]), R, x, seed);
    });
  }
  return runge_kutta::observed_order(h, errors);
}

/// The order at which points find the inertia of a solid. points(n, seed): about n of them.
template <solids::Solid S, class MakePoints>
double order_of_points(const S& solid, MakePoints&& points) {
  const Mat3 inertia = mass_properties(solid, 1).inertia;
  return order({216, 3375, 46656}, [&](int n, const Mat3& R, const Vec3& x, std::uint64_t seed) {
    const Mat3 found =
        sampling::sample_mass_properties(solids::placed(solid, R, x), 1, points(n, seed)).inertia;
    return test::inertia_error(found, rotate_inertia(R, inertia));
  });
}

/// The order at which columns find the inertia of a mesh. method(mesh, columns, seed).
template <class Method>
double order_of_columns(const PolygonMesh& mesh, Method&& method) {
  const Mat3 inertia = test::exact_mass_properties(mesh, 1).inertia;
  return order({250, 3720, 55350}, [&](int n, const Mat3& R, const Vec3& x, std::uint64_t seed) {
    const Mat3 found = method(test::mapped(mesh, R, x), n, seed).inertia;
    return test::inertia_error(found, rotate_inertia(R, inertia));
  });
}

int per_axis(int n) { return static_cast<int>(std::lround(std::cbrt(n))); }

constexpr double scatter = 4 * 0.03;

template <solids::Solid S>
void check_orders_of_points(const S& solid) {
  using Seed = std::uint64_t;
  const double random =
      order_of_points(solid, [](int n, Seed seed) { return sampling::RandomPoints(n, seed); });
  const double stratified = order_of_points(
      solid, [](int n, Seed seed) { return sampling::StratifiedPoints(per_axis(n), seed); });
  const double grid =
      order_of_points(solid, [](int n, Seed) { return sampling::GridPoints(per_axis(n)); });
  const double r3 = order_of_points(solid, [](int n, Seed) { return sampling::R3Points(n); });
  const double moved_r3 =
      order_of_points(solid, [](int n, Seed seed) { return sampling::R3Points(n, seed); });
  MESSAGE("random " << random << ", stratified " << stratified << ", grid " << grid << ", R3 " << r3
                    << ", R3 from a random start " << moved_r3);
  CHECK(std::abs(random - 1.0 / 2) <= scatter);
  CHECK(std::abs(stratified - 2.0 / 3) <= scatter);
  CHECK(std::abs(grid - 2.0 / 3) <= scatter);
  CHECK(std::abs(r3 - 2.0 / 3) <= scatter);
  CHECK(std::abs(moved_r3 - 2.0 / 3) <= scatter);
}

double order_of_grid_columns(const PolygonMesh& mesh) {
  return order_of_columns(mesh, [](const PolygonMesh& turned, int n, std::uint64_t) {
    return sampling::column_mass_properties(turned, 1, n);
  });
}

double order_of_jittered_columns(const PolygonMesh& mesh) {
  return order_of_columns(mesh, [](const PolygonMesh& turned, int n, std::uint64_t seed) {
    return sampling::jittered_column_mass_properties(turned, 1, n, seed);
  });
}

}  // namespace

TEST_CASE("orders: random points 1/2, all others 2/3, on a cone and on an ellipsoid") {
  check_orders_of_points(Cone{1, 2});
  check_orders_of_points(Ellipsoid{Vec3(1, 2, 3)});
}

TEST_CASE("orders: columns in a grid 1 for a curved outline and 3/2 for a straight one") {
  // The body has to be as curved at the scale of the cells as it is at large: 20 480 triangles.
  const double curved = order_of_grid_columns(test::sphere(5));
  const double straight = order_of_grid_columns(test::box_mesh(Vec3(1, 2, 3)));
  MESSAGE("curved " << curved << ", straight " << straight);
  CHECK(std::abs(curved - 1) <= scatter);
  CHECK(std::abs(straight - 1.5) <= scatter);
}

TEST_CASE("orders: jittered columns 1, whatever the outline") {
  const double curved = order_of_jittered_columns(test::sphere(4));
  const double straight = order_of_jittered_columns(test::box_mesh(Vec3(1, 2, 3)));
  MESSAGE("curved " << curved << ", straight " << straight);
  CHECK(std::abs(curved - 1) <= scatter);
  CHECK(std::abs(straight - 1) <= scatter);
}
