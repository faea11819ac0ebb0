#include "tumble/mass/bounding_box.hpp"

#include <doctest/doctest.h>

#include "project/harness/refusal.hpp"
#include "project/library/mass/meshes.hpp"
#include "tumble/core/solid.hpp"
#include "tumble/mass/transform.hpp"
#include "tumble/mass/validity.hpp"

using namespace tumble;
using test::askew;
using test::eps;
using test::inertia_error;

static_assert(solids::Solid<boxes::OrientedBox>);

namespace {

void check_inside(const boxes::OrientedBox& box, const std::vector<Vec3>& points) {
  const boxes::OrientedBox with_room{box.centre, box.R,
                                     box.size * (1 + 32 * eps) + Vec3::Constant(1e-14)};
  for (const Vec3& x : points) CHECK(with_room.contains(x));
}

}  // namespace

TEST_CASE("aligned_box: a worked number") {
  const std::vector<Vec3> points{{1, 2, 3}, {-1, 4, 3.5}, {0, 0, 4}};
  const boxes::OrientedBox box = boxes::aligned_box(points);
  CHECK(box.centre == Vec3(0, 2, 3.5));
  CHECK(box.size == Vec3(2, 4, 1));
  CHECK(box.R == Mat3::Identity());
  CHECK(box.volume() == 8);
}

TEST_CASE("box_mass_properties: m (b² + c²)/12, turned and moved") {
  const boxes::OrientedBox box{Vec3(1, 2, 3), askew(), Vec3(1, 2, 3)};
  const MassProperties body = boxes::box_mass_properties(box, 12);
  CHECK(body.mass == 12);
  CHECK((body.centre - box.centre).norm() <= 4 * eps * 4);
  CHECK(inertia_error(body.inertia,
                      rotate_inertia(box.R, Vec3(13, 10, 5).asDiagonal().toDenseMatrix())) <=
        8 * eps);
  const PolygonMesh mesh = test::mapped(test::box_mesh(box.size), box.R, box.centre);
  CHECK(inertia_error(body.inertia, test::exact_mass_properties(mesh, 2).inertia) <= 64 * eps);
}

TEST_CASE("OrientedBox: contains its corners moved in, not moved out, and its bounds hold them") {
  const boxes::OrientedBox box{Vec3(1, 2, 3), askew(), Vec3(1, 2, 3)};
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner =
        Vec3(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5).cwiseProduct(box.size);
    CHECK(box.contains(Vec3(box.centre + box.R * (0.999 * corner))));
    CHECK_FALSE(box.contains(Vec3(box.centre + box.R * (1.001 * corner))));
    CHECK(box.bounds().contains(Vec3(box.centre + box.R * (0.999 * corner))));
  }
}

TEST_CASE("principal_box, small_oriented_box: find a turned box again, wherever it is") {
  test::Random rng(101);
  for (int i = 0; i < 20; ++i) {
    const Mat3 R = Eigen::AngleAxisd(rng.uniform(-3, 3), rng.direction()).toRotationMatrix();
    const PolygonMesh mesh = test::mapped(test::box_mesh(Vec3(1, 2, 4)), R, 10 * rng.vector());
    CAPTURE(R);
    for (const boxes::OrientedBox& box :
         {boxes::principal_box(mesh.vertices), boxes::small_oriented_box(mesh.vertices)}) {
      check_inside(box, mesh.vertices);
      CHECK(std::abs(box.volume() - 8) <= 1000 * eps * 8);  // 10 away: 10 eps a coordinate and edge
      CHECK((box.R.transpose() * box.R - Mat3::Identity()).norm() <= 32 * eps);
      CHECK(box.R.determinant() > 0);
    }
  }
}

TEST_CASE(
    "principal_box: along the axes in which the points' spread about their mean is uncorrelated") {
  test::Random rng(103);
  for (int i = 0; i < 30; ++i) {
    std::vector<Vec3> points(
        5, rng.vector());  // most of them in one corner: the mean is far from the middle
    for (int k = 0; k < 6; ++k) points.push_back(rng.vector());
    const Mat3 R = boxes::principal_box(points).R;
    Vec3 mean = Vec3::Zero();
    for (const Vec3& x : points) mean += x / 11;
    Mat3 spread = Mat3::Zero();
    for (const Vec3& x : points) spread += R.transpose() * (x - mean) * (x - mean).transpose() * R;
    const Mat3 mixed = spread - Mat3(spread.diagonal().asDiagonal());
    CHECK(mixed.norm() <= 100 * eps * spread.norm());  // 11 terms, two products each way
  }
}

TEST_CASE("small_oriented_box: never larger than the box along the axes or the principal axes") {
  test::Random rng(102);
  for (int i = 0; i < 30; ++i) {
    std::vector<Vec3> points;
    for (int k = 0; k < 12; ++k) points.push_back(rng.vector());
    const boxes::OrientedBox box = boxes::small_oriented_box(points);
    check_inside(box, points);
    CHECK(box.volume() <= boxes::aligned_box(points).volume());
    CHECK(box.volume() <= boxes::principal_box(points).volume());
  }
}

TEST_CASE("small_oriented_box: finds a turned cube, whose principal axes say nothing") {
  const PolygonMesh cube = test::mapped(test::box_mesh(Vec3(1, 1, 1)), askew());
  // The last turn is by 1e-3 at most: cos + sin of that on two edges, 0.2 % each at most.
  CHECK(boxes::small_oriented_box(cube.vertices).volume() <= 1.004);
}

TEST_CASE("shrunk_to: keeps place and proportions, and is nearer to the truth for a ball") {
  const PolygonMesh ball = test::sphere(3);
  const MassProperties truth = test::exact_mass_properties(ball, 1);
  const boxes::OrientedBox box = boxes::aligned_box(ball.vertices),
                           shrunk = boxes::shrunk_to(box, truth.mass);
  CHECK(std::abs(shrunk.volume() - truth.mass) <= 8 * eps * truth.mass);
  CHECK(shrunk.centre == box.centre);
  CHECK((shrunk.size / shrunk.size.x() - box.size / box.size.x()).norm() <= 8 * eps);
  const double before =
      inertia_error(boxes::box_mass_properties(box, truth.mass).inertia, truth.inertia);
  const double after =
      inertia_error(boxes::box_mass_properties(shrunk, truth.mass).inertia, truth.inertia);
  CHECK(after < 0.2 * before);
}

TEST_CASE("boxes: refuse what makes none, and say which point") {
  const std::vector<Vec3> nothing, bad{Vec3(0, 0, 0), Vec3(0, std::nan(""), 1)},
      line{Vec3(0, 0, 0), Vec3(1, 0, 0)};
  CHECK_REFUSED(boxes::aligned_box(nothing), "no points");
  CHECK_REFUSED(boxes::small_oriented_box(nothing), "no points");
  CHECK_REFUSED(boxes::principal_box(bad), "point 1 at (0, nan, 1)");
  CHECK_REFUSED(boxes::box_mass_properties(boxes::aligned_box(line), 1), "the box's edge is 0");
  CHECK_REFUSED(boxes::shrunk_to(boxes::aligned_box(line), 1), "the box's volume is 0");
  const boxes::OrientedBox box{Vec3(0, 0, 0), Mat3::Identity(), Vec3(1, 1, 1)};
  for (const double value : {0.0, -1.0, std::nan("")}) {
    CHECK_REFUSED(boxes::box_mass_properties(box, value), "the mass is");
    CHECK_REFUSED(boxes::shrunk_to(box, value), "the volume is");
  }
  CHECK(boxes::small_oriented_box(line).volume() <= eps);
}
