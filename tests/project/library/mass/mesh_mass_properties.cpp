#include "tumble/mass/mesh_mass_properties.hpp"
#include "tumble/mass/require_volume.hpp"

#include <doctest/doctest.h>

#include <limits>

#include "project/harness/refusal.hpp"
#include "project/library/mass/meshes.hpp"

using namespace tumble;
using test::askew;

namespace {

constexpr Accuracy tiers[] = {Accuracy::fast, Accuracy::tight, Accuracy::textbook};

bool has(const std::vector<MeshDefect>& findings, MeshDefectKind kind) {
  return std::any_of(findings.begin(), findings.end(),
                     [&](const MeshDefect& finding) { return finding.kind == kind; });
}

}  // namespace

TEST_CASE("mesh_mass_properties: refuses what has no mass, and says where, however accurate") {
  const PolygonMesh cube = test::box_mesh(Vec3(1, 1, 1));
  PolygonMesh bad_index = cube, nan = cube;
  bad_index.corners[3] = 99;
  nan.vertices[2].x() = std::nan("");
  for (const Accuracy accuracy : tiers) {
    const auto door = [&](const PolygonMesh& mesh, double density) {
      return mesh_mass_properties(mesh, density, {.accuracy = accuracy});
    };
    CHECK(door(cube, 2).mass == 2);
    CHECK(door(cube, 2).findings.empty());
    for (const double density : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
      CHECK_REFUSED(door(cube, density), "the density");
    CHECK_REFUSED(door(test::without_face(cube, 2), 1), "open");
    CHECK_REFUSED(door(test::inside_out(cube), 1), "inside out");
    CHECK_REFUSED(door(bad_index, 1), "#100");
    CHECK_REFUSED(door(nan, 1), "nan");
    CHECK_REFUSED(door(PolygonMesh{}, 1), "no faces");
    CHECK_REFUSED(door(test::mapped(cube, Vec3(1, 1, 0).asDiagonal().toDenseMatrix()), 1),
                  "no volume");
  }
}

TEST_CASE("mesh_mass_properties: with Policy::accept the integrals come with the findings") {
  const PolygonMesh cube = test::triangulated(test::box_mesh(Vec3(1, 1, 1)));
  for (const Accuracy accuracy : {Accuracy::fast, Accuracy::tight}) {
    const MassOptions accept{.accuracy = accuracy, .policy = Policy::accept};
    const MeshMassProperties open = mesh_mass_properties(test::without_face(cube, 0), 6, accept);
    // A twelfth of the surface is missing, and with it the pyramid between it and the middle.
    CHECK(std::abs(open.mass - 5.5) <= 1e-14);
    CHECK(has(open.findings, MeshDefectKind::open_edge));
    const MeshMassProperties inverted = mesh_mass_properties(test::inside_out(cube), 6, accept);
    CHECK(std::abs(inverted.mass + 6) <= 1e-14);
    CHECK(has(inverted.findings, MeshDefectKind::inverted));
    const PolygonMesh small = test::moved(cube, 0.5, Vec3::Constant(0.125));
    const MeshMassProperties nested = mesh_mass_properties(test::together(cube, small), 8, accept);
    CHECK(std::abs(nested.mass - 9) <= 1e-14);
    CHECK(has(nested.findings, MeshDefectKind::nested_wrong));
  }
}

TEST_CASE("mesh_mass_properties: even Policy::accept needs faces with vertices that are there") {
  const MassOptions accept{.policy = Policy::accept};
  PolygonMesh bad_index = test::cube(), nan = test::cube();
  bad_index.corners[3] = 99;
  nan.vertices[2].x() = std::nan("");
  CHECK_REFUSED(mesh_mass_properties(bad_index, 1, accept), "#100");
  CHECK_REFUSED(mesh_mass_properties(nan, 1, accept), "nan");
  CHECK_REFUSED(mesh_mass_properties(PolygonMesh{}, 1, accept), "no faces");
  CHECK_REFUSED(mesh_mass_properties(test::cube(), -1, accept), "the density");
  CHECK_REFUSED(mesh_mass_properties(test::cube(), 1, {.loop = {.threads = 0}}), "threads");
}

TEST_CASE("mesh_mass_properties: what does not spoil the integrals is told, not refused") {
  PolygonMesh bent = test::box_mesh(Vec3(1, 1, 1));
  bent.vertices[6].z() += 0.2;
  const MeshMassProperties body = mesh_mass_properties(bent, 1);
  REQUIRE(body.findings.size() == 1);  // the top; the two sides there stay plane
  CHECK(body.findings[0].kind == MeshDefectKind::nonplanar_face);
}

TEST_CASE("require_volume: what the diagnosis may let through is refused after the integrals") {
  const PolygonMesh cube = test::box_mesh(Vec3(1, 1, 1));
  CHECK_REFUSED(require_volume(test::tight(test::inside_out(cube), 1)), "inside out", "mass -1");
  const PolygonMesh sheet = test::mapped(cube, askew() * Vec3(1, 1, 0).asDiagonal());
  CHECK_REFUSED(require_volume(test::textbook(sheet, 1)), "rounding hides the volume");
  CHECK_REFUSED(require_volume(test::tight(PolygonMesh{}, 1)), "rounding hides the volume");
  const PolygonMesh speck = test::mapped(cube, 1e-80 * Mat3::Identity());
  CHECK_REFUSED(require_volume(test::tight(speck, 1)), "too small or too large");
  for (const double size : {1e-64, 1e-62, 1e62, 1e70}) {
    CAPTURE(size);
    // A subnormal tensor, or a bound that is not a number.
    CHECK_REFUSED(require_volume(test::tight(test::mapped(cube, size * askew()), 1)), "inertia");
  }
  for (const double size : {1e-55, 1e-30, 1e30, 1e45, 1e58}) {
    const BoundedMassProperties body = test::tight(test::mapped(cube, size * askew()), 1);
    CAPTURE(size);
    CHECK_NOTHROW(require_volume(body));
    CHECK(std::abs(body.inertia.trace() / (body.mass * size * size / 2) - 1) <= 1e-14);
  }
}
