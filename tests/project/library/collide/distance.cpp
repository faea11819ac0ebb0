#include "tumble/collide/distance.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "objects/shapes.hpp"
#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"

using namespace tumble;
using collide::Convex;
using collide::Pose;

namespace {

/// A box with its pose, and the corners, edges and faces that brute force needs.
struct TestBox {
  Vec3 size;
  Pose pose;

  Convex body() const { return Convex::box(size); }
  std::vector<Vec3> corners() const {
    std::vector<Vec3> all;
    const Convex box = body();
    for (const Vec3& p : box.points()) all.push_back(pose.x + pose.R * p);
    return all;
  }
  /// Two numbers of corners differ in one bit.
  std::vector<std::array<Vec3, 2>> edges() const {
    const auto c = corners();
    std::vector<std::array<Vec3, 2>> all;
    for (std::size_t i = 0; i < 8; ++i)
      for (const std::size_t bit : {1u, 2u, 4u})
        if (!(i & bit)) all.push_back({c[i], c[i | bit]});
    return all;
  }
  /// The point of the box that is nearest to p.
  Vec3 nearest(const Vec3& p) const {
    const Vec3 local = pose.R.transpose() * (p - pose.x);
    return pose.x + pose.R * Vec3(local.cwiseMin(size / 2).cwiseMax(-size / 2));
  }
};

double edge_to_edge(const std::array<Vec3, 2>& e, const std::array<Vec3, 2>& f) {
  const Vec3 d = e[1] - e[0], g = f[1] - f[0], r = e[0] - f[0];
  const double dd = d.dot(d), gg = g.dot(g), dg = d.dot(g), denominator = dd * gg - dg * dg;
  const auto along = [](double x) { return std::clamp(x, 0., 1.); };
  double s =
      denominator > 1e-12 * dd * gg ? along((dg * g.dot(r) - gg * d.dot(r)) / denominator) : 0;
  const double t = along((dg * s + g.dot(r)) / gg);
  s = along((dg * t - d.dot(r)) / dd);
  return (e[0] + s * d - f[0] - t * g).norm();
}

/// All pairs of features: corner to box on both sides, edge to edge.
double distance_by_force(const TestBox& a, const TestBox& b) {
  double least = 1e300;
  for (const Vec3& p : a.corners()) least = std::min(least, (p - b.nearest(p)).norm());
  for (const Vec3& p : b.corners()) least = std::min(least, (p - a.nearest(p)).norm());
  for (const auto& e : a.edges())
    for (const auto& f : b.edges()) least = std::min(least, edge_to_edge(e, f));
  return least;
}

/// The largest gap along the 15 directions.
double gap_by_axes(const TestBox& a, const TestBox& b) {
  double most = -1e300;
  const auto look = [&](const Vec3& axis) {
    if (axis.norm() < 1e-9) return;
    const Vec3 n = axis.normalized();
    const double reach = (a.pose.R.transpose() * n).cwiseAbs().dot(a.size / 2) +
                         (b.pose.R.transpose() * n).cwiseAbs().dot(b.size / 2);
    most = std::max(most, std::abs(n.dot(b.pose.x - a.pose.x)) - reach);
  };
  for (int i = 0; i < 3; ++i) {
    look(a.pose.R.col(i));
    look(b.pose.R.col(i));
    for (int j = 0; j < 3; ++j) look(a.pose.R.col(i).cross(b.pose.R.col(j)));
  }
  return most;
}

TestBox any_box(test::Random& rng, double spread) {
  const Vec3 size(rng.uniform(0.1, 2), rng.uniform(0.1, 2), rng.uniform(0.1, 2));
  return {size, {spread * rng.vector(), rng.rotation().toRotationMatrix()}};
}

/// The certificate, checked on all points, and the nearest points.
void check_certificate(const Convex& a, const Pose& pa, const Convex& b, const Pose& pb,
                       const collide::Distance& found, double rounding) {
  const Vec3 offset = pb.x - pa.x;
  double end_of_a = -1e300, begin_of_b = 1e300;
  for (const Vec3& p : a.points())
    end_of_a = std::max(end_of_a, found.normal.dot(pa.R * p) + a.radius());
  for (const Vec3& p : b.points())
    begin_of_b = std::min(begin_of_b, found.normal.dot(offset + pb.R * p) - b.radius());
  CHECK(std::abs(found.normal.norm() - 1) < 8 * test::eps);
  CHECK(std::abs(begin_of_b - end_of_a - found.gap) < rounding);
  const Vec3 between = offset + found.arm_b - found.arm_a;
  if (found.gap > 0)
    CHECK(std::abs(between.norm() - found.gap) < found.uncertainty + rounding);
  else
    CHECK((between - found.gap * found.normal).norm() < found.uncertainty + rounding);
}

}  // namespace

TEST_CASE("distance: boxes apart, as all pairs of features tell, each with its certificate") {
  test::Random rng(1111);
  int apart = 0;
  for (int i = 0; i < 3000; ++i) {
    const TestBox a = any_box(rng, 1.5), b = any_box(rng, 1.5);
    if (gap_by_axes(a, b) <= 0) continue;
    ++apart;
    const collide::Distance found = distance(a.body(), a.pose, b.body(), b.pose);
    const double rounding = 300 * test::eps * 10;
    CHECK(std::abs(found.gap - distance_by_force(a, b)) < rounding);
    CHECK(found.uncertainty < rounding);
    check_certificate(a.body(), a.pose, b.body(), b.pose, found, rounding);
  }
  CHECK(apart > 1000);
}

TEST_CASE("distance: boxes that overlap, as the 15 directions tell, each with its certificate") {
  test::Random rng(1112);
  int overlapping = 0;
  for (int i = 0; i < 3000; ++i) {
    const TestBox a = any_box(rng, 0.7), b = any_box(rng, 0.7);
    const double gap = gap_by_axes(a, b);
    if (gap > 0) continue;
    ++overlapping;
    const collide::Distance found = distance(a.body(), a.pose, b.body(), b.pose);
    const double rounding = 300 * test::eps * 10;
    CHECK(std::abs(found.gap - gap) < rounding);
    CHECK(found.uncertainty < rounding);
    check_certificate(a.body(), a.pose, b.body(), b.pose, found, rounding);
  }
  CHECK(overlapping > 1000);
}

TEST_CASE("distance: parallel edges, face on face, corner on corner, thin, huge, and far away") {
  test::Random rng(1113);
  int unsure = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto length = [&] { return std::pow(10, rng.uniform(-6, 6)); };
    TestBox a = any_box(rng, 1), b = any_box(rng, 1);
    if (i % 2) a.size = {length(), length(), length()}, b.size = {length(), length(), length()};
    if (i % 3) b.pose.R = a.pose.R;  // all edges parallel
    if (i % 3 == 2) b.pose.R = a.pose.R * Eigen::AngleAxisd(rng.uniform(), Vec3::UnitZ());
    // Face before face, by a gap that is far smaller than the bodies.
    const double gap = std::pow(10, rng.uniform(-9, 0)) * std::min(a.size.z(), b.size.z());
    Vec3 shift(0, 0, (a.size.z() + b.size.z()) / 2 + gap);
    shift.x() = (i % 5 - 2) * (a.size.x() + b.size.x()) / 4;
    b.pose.x = a.pose.x + a.pose.R * shift;
    if (i % 7 == 0) a.pose.x += Vec3(1e8, -1e8, 1e8), b.pose.x += Vec3(1e8, -1e8, 1e8);
    const double scale = a.size.norm() + b.size.norm() + (b.pose.x - a.pose.x).norm();
    const collide::Distance found = distance(a.body(), a.pose, b.body(), b.pose);
    const double rounding = 300 * test::eps * scale;
    check_certificate(a.body(), a.pose, b.body(), b.pose, found, rounding);
    // Where edges are up to 1e12 times longer than others, what is unsure is said.
    const bool extreme = i % 2;
    CHECK(found.uncertainty < (extreme ? 1e-8 * scale : rounding));
    unsure += extreme && found.uncertainty > rounding;
    // Never less than the largest gap along an axis, which is the distance where they overlap.
    const double along_axes = gap_by_axes(a, b);
    CHECK(found.gap > along_axes - rounding);
    if (along_axes < 0) CHECK(found.gap < rounding);
  }
  CHECK(unsure < 100);  // of 2000
}

TEST_CASE("distance: 1e8 m away from the origin no digit is lost") {
  test::Random rng(1114);
  for (int i = 0; i < 500; ++i) {
    TestBox a = any_box(rng, 2), b = any_box(rng, 2);
    // Places that 1e8 can be added to without rounding.
    for (Pose* pose : {&a.pose, &b.pose}) pose->x = (pose->x * 1024).array().round() / 1024;
    const collide::Distance near = distance(a.body(), a.pose, b.body(), b.pose);
    const Vec3 away(1e8, -1e8, 1e8);
    const collide::Distance far =
        distance(a.body(), {a.pose.x + away, a.pose.R}, b.body(), {b.pose.x + away, b.pose.R});
    CHECK(near.gap == far.gap);
    CHECK(near.normal == far.normal);
    CHECK(near.arm_a == far.arm_a);
  }
}

TEST_CASE("distance: balls, balls and boxes, balls inside of boxes and of balls") {
  test::Random rng(1115);
  for (int i = 0; i < 1000; ++i) {
    const double r = rng.uniform(0.1, 1), s = rng.uniform(0.1, 1);
    const Convex ball = Convex::ball(r), other = Convex::ball(s);
    const Pose at{rng.vector(), rng.rotation().toRotationMatrix()}, there{rng.vector(), at.R};
    const double rounding = 100 * test::eps;
    const collide::Distance balls = distance(ball, at, other, there);
    CHECK(std::abs(balls.gap - ((there.x - at.x).norm() - r - s)) < rounding);
    check_certificate(ball, at, other, there, balls, rounding);
    const TestBox box = any_box(rng, 1);
    const collide::Distance found = distance(ball, at, box.body(), box.pose);
    check_certificate(ball, at, box.body(), box.pose, found, 30 * rounding);
    const Vec3 local = box.pose.R.transpose() * (at.x - box.pose.x);
    const Vec3 out = local.cwiseAbs() - box.size / 2;
    const double to_box = out.maxCoeff() > 0 ? out.cwiseMax(0).norm() : out.maxCoeff();
    CHECK(std::abs(found.gap - (to_box - r)) < 30 * rounding);
  }
  const collide::Distance same = distance(Convex::ball(1), {}, Convex::ball(2), {});
  CHECK(same.gap == -3);
  CHECK(std::abs(same.normal.norm() - 1) < 4 * test::eps);
}

TEST_CASE("distance: hulls of many points, swapped, moved along the normal, and turned together") {
  test::Random rng(1116);
  for (int i = 0; i < 300; ++i) {
    std::vector<Vec3> points, others;
    for (int k = 0; k < 4 + i % 60; ++k) points.push_back(rng.direction());
    for (int k = 0; k < 30; ++k) others.push_back(rng.vector());
    const Convex a = Convex::hull(points), b = Convex::hull(others);
    const Pose pa{rng.vector(), rng.rotation().toRotationMatrix()};
    const Pose pb{3 * rng.vector(), rng.rotation().toRotationMatrix()};
    const collide::Distance found = distance(a, pa, b, pb);
    const double rounding = 2000 * test::eps;
    check_certificate(a, pa, b, pb, found, rounding);
    CHECK(found.uncertainty < rounding);
    const collide::Distance swapped = distance(b, pb, a, pa);
    CHECK(std::abs(swapped.gap - found.gap) < rounding);
    const collide::Distance moved = distance(a, pa, b, {pb.x + 0.5 * found.normal, pb.R});
    if (found.gap > 0) {
      CHECK((swapped.normal + found.normal).norm() < rounding / std::min(1., found.gap));
      CHECK(std::abs(moved.gap - found.gap - 0.5) < rounding);
    } else {
      CHECK(distance(a, pa, b, {pb.x - found.gap * found.normal, pb.R}).gap > -rounding);
    }
    const Mat3 R = rng.rotation().toRotationMatrix();
    const collide::Distance turned = distance(a, {R * pa.x, R * pa.R}, b, {R * pb.x, R * pb.R});
    CHECK(std::abs(turned.gap - found.gap) < rounding);
  }
}

TEST_CASE("distance: bodies with one centre, which several shifts free as well") {
  test::Random rng(1118);
  for (int i = 0; i < 500; ++i) {
    TestBox a = any_box(rng, 0), b = any_box(rng, 0);
    if (i % 3 == 0) b.pose.R = a.pose.R;
    if (i % 3 == 1) b.size *= 1e-2;
    const Convex ball = Convex::ball(rng.uniform(0.1, 1)), box = a.body(), other = b.body();
    const double rounding = 300 * test::eps * 10;
    const auto check = [&](const Convex& p, const Pose& at, const Convex& q, const Pose& there) {
      const collide::Distance found = distance(p, at, q, there);
      CHECK(found.uncertainty < rounding);
      check_certificate(p, at, q, there, found, rounding);
    };
    check(box, a.pose, other, b.pose);
    check(box, a.pose, ball, b.pose);
    check(ball, a.pose, other, b.pose);
  }
}

TEST_CASE("distance: from a floor or a wall, the mesh's hull, and what bounds hold") {
  test::Random rng(1117);
  const PolygonMesh mesh = shapes::torus_mesh(20, 10, 1, 0.3);
  const Convex hull = Convex::hull(mesh, Vec3(0.1, 0, 0));
  CHECK(hull.points().size() == mesh.vertices.size());
  for (int i = 0; i < 200; ++i) {
    const Pose pose{3 * rng.vector(), rng.rotation().toRotationMatrix()};
    const collide::HalfSpace wall{rng.vector(), rng.direction()};
    double least = 1e300;
    for (const Vec3& p : mesh.vertices)
      least =
          std::min(least, wall.normal.dot(pose.x + pose.R * (p - Vec3(0.1, 0, 0)) - wall.point));
    const collide::Distance found = distance(hull, pose, wall);
    CHECK(std::abs(found.gap - least) < 100 * test::eps);
    CHECK(found.normal == -wall.normal);
    CHECK(std::abs(found.arm_b.dot(wall.normal)) < 100 * test::eps);
    const Vec3 between = wall.point + found.arm_b - pose.x - found.arm_a;
    CHECK((between - found.gap * found.normal).norm() < 100 * test::eps);
    const collide::Bounds bounds = bounds_of(hull, pose);
    for (const Vec3& p : hull.points())
      CHECK(bounds.exteriorDistance(Vec3(pose.x + pose.R * p)) < 16 * test::eps);
  }
}

TEST_CASE("bodies that are none are refused") {
  CHECK_REFUSED(Convex::ball(0), "radius");
  CHECK_REFUSED(Convex::box(Vec3(1, -1, 1)), "edges");
  CHECK_REFUSED(Convex::box(Vec3::Ones(), Vec3::Zero(), 2 * Mat3::Identity()), "no rotation");
  CHECK_REFUSED(Convex::hull(std::vector<Vec3>{}), "volume");
  const std::vector<Vec3> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.1, 0.3, 0}, {1, 1, 0}};
  CHECK_REFUSED(Convex::hull(flat), "volume", "5 points");
  CHECK_REFUSED(Convex::hull(std::vector<Vec3>{Vec3::Constant(NAN)}), "point 0", "not finite");
  CHECK_REFUSED((collide::HalfSpace{Vec3::Zero(), Vec3::Zero()}.require_valid()), "normal");
}
