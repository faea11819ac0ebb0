#include <doctest/doctest.h>

#include <string>

#include "project/harness/scanned_meshes.hpp"
#include "project/library/mesh/parts.hpp"
#include "tumble/mesh/diagnose.hpp"
#include "tumble/mesh/read_obj.hpp"

using namespace tumble;
using namespace tumble::detail;
using test::parts_of;

TEST_CASE("diagnose: finds nothing wrong with closed real meshes") {
  if (!test::have_scanned_meshes()) return;
  for (const char* file : {"spot.obj", "spot_low.obj", "fish_low.obj"}) {
    CAPTURE(std::string(file));
    for (const MeshDefect& finding : diagnose(read_obj(test::scanned_mesh(file))))
      FAIL_CHECK(finding.message);
  }
}

TEST_CASE("diagnose: names the open edges of a scan") {
  if (!test::have_scanned_meshes()) return;
  const std::string path = test::scanned_mesh("demosthenes_open.obj");
  const PolygonMesh mesh = read_obj(path);
  CHECK(mesh.face_count() == 16719);
  const std::vector<MeshDefect> findings = diagnose(mesh);
  REQUIRE(findings.size() == MeshDefectsOfOneKind::max_shown);
  for (const MeshDefect& finding : findings) CHECK(finding.kind == MeshDefectKind::open_edge);
  CHECK(findings.back().message.find("(open edges in all: 67) (and 62 more)") != std::string::npos);
  CHECK_THROWS_AS(require_body(mesh), std::invalid_argument);
}

TEST_CASE("diagnose: a control cage of polygons passes through itself, and they are not plane") {
  if (!test::have_scanned_meshes()) return;
  const std::string path = test::scanned_mesh("spot_control.obj");
  const std::vector<MeshDefect> findings = diagnose(read_obj(path));
  const auto count = [&](MeshDefectKind kind) {
    return std::count_if(findings.begin(), findings.end(),
                         [=](const MeshDefect& finding) { return finding.kind == kind; });
  };
  CHECK(count(MeshDefectKind::self_crossing) == 1);
  CHECK(count(MeshDefectKind::nonplanar_face) == MeshDefectsOfOneKind::max_shown);
  CHECK(count(MeshDefectKind::self_crossing) + MeshDefectsOfOneKind::max_shown ==
        static_cast<std::ptrdiff_t>(findings.size()));
}

TEST_CASE("components: a real mesh encloses what rational arithmetic says") {
  if (!test::have_scanned_meshes()) return;
  const std::string path = test::scanned_mesh("spot.obj");
  const Component part = parts_of(read_obj(path)).parts.at(0);
  CHECK(std::abs(part.volume - 7.1825878809986468231744395113720e-1) <= part.rounding);
}
