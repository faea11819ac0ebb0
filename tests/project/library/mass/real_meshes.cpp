// Scanned and modelled meshes, whose true mass properties are known to 40 digits.
#include <doctest/doctest.h>

#include <string>

#include "project/harness/scanned_meshes.hpp"
#include "project/library/mass/meshes.hpp"
#include "reference/meshes.hpp"
#include "tumble/mesh/read_obj.hpp"

using namespace tumble;
using test::eps;
using test::inertia_error;

namespace {

void check_within(const MassProperties& found, const MassProperties& truth, double size,
                  double error) {
  CHECK(std::abs(found.mass - truth.mass) <= error * truth.mass);
  CHECK((found.centre - truth.centre).norm() <= error * size);
  CHECK(inertia_error(found.inertia, truth.inertia) <= error);
}

}  // namespace

TEST_CASE("real meshes: every method finds the true mass properties") {
  if (!test::have_scanned_meshes()) return;
  for (const test::MeshTruth& reference : test::mesh_truths) {
    const PolygonMesh mesh = detail::read_obj(test::scanned_mesh(reference.file));
    const MassProperties truth = reference.mass_properties();
    const double size = bounds(mesh).sizes().norm();
    CAPTURE(reference.file);
    for (const auto method : {test::textbook, test::fast}) {
      const BoundedMassProperties body = method(mesh, 1);
      // The bounds themselves, and the rounding of the truth.
      check_within(body, truth, size,
                   std::max(body.mass_error_bound, body.inertia_error_bound) + eps);
      CHECK(body.mass_error_bound <= 1e-12);
      CHECK(body.inertia_error_bound <= 1e-11);
    }
    check_within(test::tight(mesh, 1), truth, size, 2 * eps);
  }
}

TEST_CASE("real meshes: the doors let the good ones in, and refuse the scan that is open") {
  if (!test::have_scanned_meshes()) return;
  for (const char* file : {"spot.obj", "spot_low.obj", "fish_low.obj"}) {
    const PolygonMesh mesh = detail::read_obj(test::scanned_mesh(file));
    CAPTURE(std::string(file));
    CHECK(std::abs(mesh_mass_properties(mesh, 1000).mass -
                   1000 * test::exact_mass_properties(mesh, 1).mass) <=
          4 * eps * (1000 * test::exact_mass_properties(mesh, 1).mass));
  }
  const PolygonMesh open = detail::read_obj(test::scanned_mesh("demosthenes_open.obj"));
  CHECK_THROWS_AS(mesh_mass_properties(open, 1000), std::invalid_argument);
}
