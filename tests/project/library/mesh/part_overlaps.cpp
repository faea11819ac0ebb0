// Parts of an assembly that pass through each other are found, however many there are.
#include "tumble/mesh/part_overlaps.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "project/harness/inputs.hpp"
#include "project/library/mesh/shapes.hpp"
#include "tumble/mesh/diagnose.hpp"

using namespace tumble;

namespace {

/// 125 balls of 320 triangles, so far from each other, that lie anyhow.
PolygonMesh balls(test::Random& random, double apart) {
  PolygonMesh mesh;
  const PolygonMesh ball = test::sphere(2);
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      for (int k = 0; k < 5; ++k)
        mesh = test::together(
            mesh, test::mapped(ball, random.rotation().toRotationMatrix(), apart * Vec3(i, j, k)));
  return mesh;
}

/// One more ball, that goes into the first by about 0.1.
PolygonMesh with_one_too_near(const PolygonMesh& mesh, test::Random& random) {
  return test::together(mesh, test::mapped(test::sphere(2), random.rotation().toRotationMatrix(),
                                           1.88 * random.direction()));
}

/// A ball of many faces whose top is pushed through its bottom.
PolygonMesh pushed_through(int fineness) {
  PolygonMesh mesh = test::sphere(fineness);
  for (Vec3& v : mesh.vertices)
    if (v.z() > 0) v.z() -= 2.5 * std::exp(-8 * v.head<2>().squaredNorm());
  return mesh;
}

}  // namespace

TEST_CASE("hardly seen: a part that crosses itself, however far away something else is") {
  const auto crossing_of = [](const PolygonMesh& body) {
    const std::vector<MeshDefect> findings = diagnose(body);
    REQUIRE(findings.size() == 1);
    CHECK(findings[0].kind == MeshDefectKind::self_crossing);
    return findings[0];
  };
  for (const int fineness : {4, 5, 6})
    for (const double away : {10., 100., 1e4, 1e6}) {
      CAPTURE(fineness);
      CAPTURE(away);
      const PolygonMesh mesh = pushed_through(fineness);
      const MeshDefect alone = crossing_of(mesh),
                       beside = crossing_of(test::together(
                           mesh,
                           test::moved(test::regular_cube(1, 0.1), 1, away * Vec3(1, 0.8, -0.7))));
      CHECK(beside.share == doctest::Approx(alone.share).epsilon(0.05));
      CHECK(std::abs(beside.share - alone.share) <=
            2 * (beside.share_uncertainty + alone.share_uncertainty));
    }
}

TEST_CASE("overlaps: of two of a hundred parts of many faces, however few lines meet them") {
  test::Random random(2);
  for (const double apart : {3., 30., 300.})
    for (int i = 0; i < 3; ++i) {
      CAPTURE(apart);
      CAPTURE(i);
      const PolygonMesh mesh = balls(random, apart);
      REQUIRE(mesh.face_count() > detail::few_pairs);
      CHECK(diagnose(mesh).empty());
      const std::vector<MeshDefect> findings = diagnose(with_one_too_near(mesh, random));
      REQUIRE(findings.size() == 1);
      CHECK(findings[0].kind == MeshDefectKind::self_crossing);
      CHECK(spoils_integrals(findings[0]));
    }
}

TEST_CASE("triangles_near_other_parts: those in boxes of others, unless they are too many") {
  const PolygonMesh one = test::regular_cube(4, 0.5);  // 192 triangles
  const PolygonMesh mesh = test::together(test::together(one, test::moved(one, 1, {0.9, 0.9, 0.9})),
                                          test::moved(one, 1, {9, 0, 0}));
  const detail::Components surface = detail::components(mesh, detail::enclosed_by(mesh));
  const auto near = detail::triangles_near_other_parts(mesh, surface, 1000, 100);
  CHECK(near.size() == 2 * 3 * 2);  // at the corner of each, on three sides
  CHECK(detail::triangles_near_other_parts(mesh, surface, 11, 100).empty());
  CHECK(detail::triangles_near_other_parts(mesh, surface, 1000, 0).empty());
  const auto of_parts = detail::triangles_of_parts(mesh, surface, {0, 0, 1});
  CHECK(of_parts[0].empty());
  CHECK(of_parts[2].size() == 192);
}

TEST_CASE("hardly_seen_parts: those that are small along all axes") {
  const PolygonMesh rod = test::mapped(test::regular_cube(1, 1), Vec3(10, 1, 1).asDiagonal(), {});
  const PolygonMesh mesh = test::together(rod, test::moved(test::regular_cube(1, 1), 1, {0, 8, 8}));
  const detail::Components surface = detail::components(mesh, detail::enclosed_by(mesh));
  const Eigen::AlignedBox3d box(Vec3(-10, -1, -1), Vec3(10, 9, 9));
  CHECK(detail::hardly_seen_parts(mesh, surface, box, 0.03) == std::vector<char>{0, 0});
  CHECK(detail::hardly_seen_parts(mesh, surface, box, 0.1) == std::vector<char>{0, 1});
  CHECK(detail::hardly_seen_parts(mesh, surface, box, 0.3) == std::vector<char>{1, 1});
}
