#include <doctest/doctest.h>

#include <string>

#include "project/harness/scanned_meshes.hpp"
#include "project/library/mesh/parts.hpp"
#include "tumble/mesh/diagnose.hpp"
#include "tumble/mesh/read_obj.hpp"

using namespace tumble;
using test::parts_of;

TEST_CASE("diagnose: finds nothing wrong with closed real meshes") {
  if (!test::have_scanned_meshes()) return;
  for (const char* file : {"spot.obj", "spot_low.obj", "fish_low.obj"}) {
    CAPTURE(std::string(file));
    for (const Finding& finding : diagnose(read_obj(test::scanned_mesh(file))))
      FAIL_CHECK(finding.message);
  }
}

TEST_CASE("diagnose: names the open edges of a scan") {
  if (!test::have_scanned_meshes()) return;
  const std::string path = test::scanned_mesh("demosthenes_open.obj");
  const PolygonMesh mesh = read_obj(path);
  CHECK(mesh.face_count() == 16719);
  const std::vector<Finding> findings = diagnose(mesh);
  REQUIRE(findings.size() == FindingsOfOneKind::most);
  for (const Finding& finding : findings) CHECK(finding.kind == FindingKind::open_edge);
  CHECK(findings.back().message.find("(open edges in all: 67) (and 62 more)") != std::string::npos);
  CHECK_THROWS_AS(require_body(mesh), std::invalid_argument);
}

TEST_CASE("diagnose: a control cage of polygons passes through itself, and they are not plane") {
  if (!test::have_scanned_meshes()) return;
  const std::string path = test::scanned_mesh("spot_control.obj");
  const std::vector<Finding> findings = diagnose(read_obj(path));
  const auto count = [&](FindingKind kind) {
    return std::count_if(findings.begin(), findings.end(),
                         [=](const Finding& finding) { return finding.kind == kind; });
  };
  CHECK(count(FindingKind::self_crossing) > 0);
  CHECK(count(FindingKind::nonplanar_face) == FindingsOfOneKind::most);
  CHECK(count(FindingKind::self_crossing) + FindingsOfOneKind::most ==
        static_cast<std::ptrdiff_t>(findings.size()));
}

TEST_CASE("components: a real mesh encloses what rational arithmetic says") {
  if (!test::have_scanned_meshes()) return;
  const std::string path = test::scanned_mesh("spot.obj");
  const Component part = parts_of(read_obj(path)).parts.at(0);
  CHECK(std::abs(part.volume - 7.1825878809986468231744395113720e-1) <= part.rounding);
}
