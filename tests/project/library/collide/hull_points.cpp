#include "tumble/collide/hull_points.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "objects/mug.hpp"
#include "objects/shapes.hpp"
#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"

using namespace tumble;

namespace {

/// How far the points reach along a direction.
double support(std::span<const Vec3> points, const Vec3& direction) {
  double most = -std::numeric_limits<double>::infinity();
  for (const Vec3& p : points) most = std::max(most, p.dot(direction));
  return most;
}

void require_same_hull(const std::vector<Vec3>& all, const std::vector<Vec3>& kept) {
  test::Random rng(1181);
  double size = 0;
  for (const Vec3& p : all) size = std::max(size, p.norm());
  for (int i = 0; i < 2000; ++i) {
    const Vec3 direction = rng.vector().normalized();
    // A search tells in from out to 64 roundings of twice the sizes.
    CHECK(support(all, direction) - support(kept, direction) < 4 * 64 * 2.3e-16 * size);
  }
}

}  // namespace

TEST_CASE("hull_points: what lies inside goes, the hull stays") {
  test::Random rng(1180);
  std::vector<Vec3> cloud;
  for (int i = 0; i < 3000; ++i) cloud.push_back(rng.vector());
  const std::vector<Vec3> kept = collide::hull_points(cloud);
  CHECK(kept.size() < 1000);
  require_same_hull(cloud, kept);
  const std::vector<Vec3> mug = objects::mug(3).vertices;
  const std::vector<Vec3> outside = collide::hull_points(mug);
  MESSAGE("a mug of " << mug.size() << " points: its hull has " << outside.size() << " at most");
  CHECK(3 * outside.size() < mug.size());
  require_same_hull(mug, outside);
}

TEST_CASE("hull_points: of a sphere no point goes, and of few points none") {
  const std::vector<Vec3> sphere = shapes::sphere(3).vertices;
  REQUIRE(sphere.size() > 600);
  CHECK(collide::hull_points(sphere).size() == sphere.size());
  const std::vector<Vec3> cube = shapes::cube().vertices;
  CHECK(collide::hull_points(cube) == cube);
}

TEST_CASE("hull_points: a hull without volume and points that are not finite are refused") {
  std::vector<Vec3> flat(1000, Vec3::Zero());
  for (std::size_t i = 0; i < flat.size(); ++i)
    flat[i] = Vec3(std::cos(static_cast<double>(i)), std::sin(static_cast<double>(i)), 0);
  CHECK_REFUSED(collide::hull_points(flat), "no volume");
  flat[7].z() = NAN;
  CHECK_REFUSED(collide::hull_points(flat), "point 7");
}
