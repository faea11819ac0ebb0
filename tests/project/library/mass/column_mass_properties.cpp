#include "tumble/mass/column_mass_properties.hpp"

#include <doctest/doctest.h>

#include <numbers>

#include "project/harness/refusal.hpp"
#include "project/harness/scanned_meshes.hpp"
#include "project/library/mass/meshes.hpp"
#include "reference/meshes.hpp"
#include "tumble/mass/solids/box.hpp"
#include "tumble/mass/transform.hpp"
#include "tumble/mesh/mesh_solid.hpp"
#include "tumble/mesh/read_obj.hpp"

using namespace tumble;
using namespace tumble::detail;
using test::eps;
using test::inertia_error;

namespace {

/// A box is what its columns are, up to their own inertia: a line of mass m in a column of width w
/// lacks m w²/12.
void check_box(const Vec3& size, int columns, const sampling::ColumnMassProperties& body) {
  const MassProperties truth = mass_properties(Box{size}, 2);
  const double nx = std::sqrt(columns * size.x() / size.y()), ny = columns / nx;
  const double xx = truth.mass * std::pow(size.x() / nx, 2) / 12;
  const double yy = truth.mass * std::pow(size.y() / ny, 2) / 12;
  const Mat3 lacking = Vec3(yy, xx, xx + yy).asDiagonal();
  CHECK(body.columns == columns);
  CHECK(body.crossings == 2 * columns);
  // 10 roundings a crossing, in blocks of 128 of them
  CHECK(std::abs(body.mass - truth.mass) <= 128 * eps * truth.mass);
  CHECK((body.centre - truth.centre).norm() <= 128 * eps * size.norm());
  CHECK((body.inertia + lacking - truth.inertia).norm() <= 128 * eps * truth.inertia.norm());
}

/// ∫ over the columns of a grid, by sorting what each meets: the slow way.
double slow_but_correct_volume(const PolygonMesh& mesh, int columns) {
  const Eigen::AlignedBox3d box = bounds(mesh);
  const XyGrid grid(box, columns);
  const Vec3 size = box.sizes();
  const MeshSolid solid(mesh);
  double sum = 0;
  for (int i = 0; i < grid.nx(); ++i)
    for (int j = 0; j < grid.ny(); ++j) {
      constexpr int steps = 500;
      int inside = 0;
      for (int k = 0; k < steps; ++k)
        inside += solid.contains(box.min() +
                                 size.cwiseProduct(Vec3((i + 0.5) / grid.nx(),
                                                        (j + 0.5) / grid.ny(), (k + 0.5) / steps)));
      sum += inside * (size.z() / steps);
    }
  return sum * size.x() * size.y() / (grid.nx() * grid.ny());
}

}  // namespace

TEST_CASE("columns: a box whose faces lie on borders of columns, exactly") {
  for (const Vec3& size : {Vec3(1, 1, 1), Vec3(1, 4, 3), Vec3(2, 0.5, 7)})
    for (const int n : {2, 32, 62}) {  // columns meet the faces' diagonals, too
      CAPTURE(size.transpose());
      CAPTURE(n);
      const PolygonMesh quads = test::box_mesh(size);
      check_box(size, n * n, sampling::column_mass_properties(quads, 2, n * n));
      check_box(size, n * n, sampling::column_mass_properties(test::triangulated(quads), 2, n * n));
    }
}

TEST_CASE("columns: through edges and vertices they enter once and leave once") {
  // The middle of a 15 × 15 or 31 × 31 grid is a vertex or lies on edges of all of these.
  const PolygonMesh peaks[] = {test::sphere(2), test::torus(16, 12), test::unit_tetrahedron(),
                               test::mapped(test::cube(), test::askew())};
  for (const PolygonMesh& mesh : peaks)
    for (const int n : {15, 31}) {
      CAPTURE(n);
      const sampling::ColumnMassProperties body = sampling::column_mass_properties(mesh, 1, n * n);
      CHECK(body.crossings % 2 == 0);
      // the slow way is right to a 500th of the height in every crossing
      const double slow = slow_but_correct_volume(mesh, n * n), box = bounds(mesh).volume();
      CHECK(std::abs(body.mass - slow) <=
            box * static_cast<double>(body.crossings) / static_cast<double>(body.columns) / 500);
    }
}

TEST_CASE("columns: far away and scaled they find the same, to the last bit") {
  PolygonMesh mesh = test::mapped(test::torus(24, 12), test::askew());
  for (Vec3& v : mesh.vertices) v = (v * 0x1p20).array().round() * 0x1p-20;  // moves are exact then
  const auto methods = {
      +[](const PolygonMesh& m) { return sampling::column_mass_properties(m, 3, 1000); },
      +[](const PolygonMesh& m) { return sampling::jittered_column_mass_properties(m, 3, 1000); }};
  for (const auto method : methods) {
    const sampling::ColumnMassProperties here = method(mesh);
    const Vec3 far(0x1p26, -0x1p26, 0x1p25);
    const sampling::ColumnMassProperties there = method(test::moved(mesh, 1, far));
    CHECK(there.mass == here.mass);
    CHECK(there.inertia == here.inertia);
    CHECK((there.centre - far - here.centre).norm() <= 0x1p-26);
    const double s = 0x1p-30;
    const sampling::ColumnMassProperties tiny = method(test::moved(mesh, s, Vec3::Zero()));
    CHECK(tiny.mass == s * s * s * here.mass);
    CHECK(tiny.inertia == s * s * s * s * s * here.inertia);
  }
}

TEST_CASE("columns: needles and plates, turned") {
  for (const Vec3& size : {Vec3(1, 1e-3, 1e-3), Vec3(1, 1, 1e-6)}) {
    const PolygonMesh mesh = test::mapped(test::box_mesh(size), test::askew());
    const MassProperties truth = test::exact_mass_properties(mesh, 1);
    const sampling::ColumnMassProperties body =
        sampling::column_mass_properties(mesh, 1, 1'000'000);
    CAPTURE(size.transpose());
    CAPTURE(body.crossings);
    // never worse than as many lines at random, however few meet the body
    CHECK(std::abs(body.mass - truth.mass) <=
          truth.mass / std::sqrt(static_cast<double>(body.crossings)));
  }
}

TEST_CASE("columns: a cavity counts once less, parts that overlap count twice") {
  const PolygonMesh outer = test::cube();
  const PolygonMesh inner = test::box({0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
  const double hollow =
      sampling::column_mass_properties(test::together(outer, test::inside_out(inner)), 1, 64 * 64)
          .mass;
  const double twice =
      sampling::column_mass_properties(test::together(outer, inner), 1, 64 * 64).mass;
  CHECK(std::abs(hollow - 0.875) <= 128 * eps);
  CHECK(std::abs(twice - 1.125) <= 128 * eps);
}

TEST_CASE("jittered columns: right on average") {
  const PolygonMesh mesh = test::mapped(test::torus(24, 12), test::askew());
  const MassProperties truth = test::exact_mass_properties(mesh, 1);
  constexpr int sets = 100;
  double mean = 0, squares = 0;
  for (std::uint64_t seed = 1; seed <= sets; ++seed) {
    const double error =
        sampling::jittered_column_mass_properties(mesh, 1, 400, seed).mass - truth.mass;
    mean += error / sets, squares += error * error / sets;
  }
  CHECK(std::abs(mean) <= 4 * std::sqrt(squares / sets));
  CHECK(std::sqrt(squares) <= 0.02 * truth.mass);
  CHECK(sampling::jittered_column_mass_properties(mesh, 1, 400, 7).mass ==
        sampling::jittered_column_mass_properties(mesh, 1, 400, 7).mass);
  CHECK(sampling::jittered_column_mass_properties(mesh, 1, 400, 7).mass !=
        sampling::jittered_column_mass_properties(mesh, 1, 400, 8).mass);
}

TEST_CASE("columns: real meshes to 2·10⁻⁴ with 10⁵ of them") {
  if (!test::have_scanned_meshes()) return;
  for (const test::MeshTruth& reference : test::mesh_truths) {
    const PolygonMesh mesh = read_obj(test::scanned_mesh(reference.file));
    const MassProperties truth = reference.mass_properties();
    CAPTURE(reference.file);
    for (const sampling::ColumnMassProperties& body :
         {sampling::column_mass_properties(mesh, 1, 100'000),
          sampling::jittered_column_mass_properties(mesh, 1, 100'000)}) {
      CHECK(std::abs(body.mass - truth.mass) <= 2e-4 * truth.mass);
      CHECK((body.centre - truth.centre).norm() <= 2e-4 * bounds(mesh).sizes().norm());
      CHECK(inertia_error(body.inertia, truth.inertia) <= 2e-4);
    }
  }
}

TEST_CASE("columns: a body too thin for them is refused, not guessed") {
  // along a diagonal of the grid all columns in a row meet it, or none: 10⁵ times its mass, or none
  const PolygonMesh needle = test::box_mesh(Vec3(1, 1e-8, 1e-8));
  for (const double turn : {std::numbers::pi / 4, 0.3}) {
    const Mat3 R = Eigen::AngleAxisd(turn, Vec3::UnitZ()).toRotationMatrix();
    CHECK_REFUSED(sampling::column_mass_properties(test::mapped(needle, R), 1, 100'000), "columns");
  }
  const Mat3 R = Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitZ()).toRotationMatrix();
  CHECK_REFUSED(sampling::column_mass_properties(test::mapped(needle, R), 1, 99 * 99),
                "so thin a body");
}

TEST_CASE("columns: refuse what has no answer") {
  const PolygonMesh cube = test::cube();
  for (const auto method : {+[](const PolygonMesh&mesh, double density, int columns) {
                              sampling::column_mass_properties(mesh, density, columns);
                            },
                            +[](const PolygonMesh&mesh, double density, int columns) {
                              sampling::jittered_column_mass_properties(mesh, density, columns);
                            }}) {
    for (const double density : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
      CHECK_REFUSED(method(cube, density, 100), "the density");
    for (const int columns : {0, -3, 100'000'001})
      CHECK_REFUSED(method(cube, 1, columns), "columns is " + std::to_string(columns));
    CHECK_REFUSED(method(test::without_face(cube, 2), 1, 100), "not closed");
    CHECK_REFUSED(method(PolygonMesh{}, 1, 100), "no faces");
    PolygonMesh wrong = cube;
    wrong.corners[5] = 8;
    CHECK_REFUSED(method(wrong, 1, 100), "face #2 has vertex #9");
    wrong = cube;
    wrong.vertices[3].y() = std::nan("");
    CHECK_REFUSED(method(wrong, 1, 100), "vertex #4");
    CHECK_REFUSED(method(test::inside_out(cube), 1, 100), "inside out");
    CHECK_REFUSED(method(test::box({0, 0, 0}, {1, 1, 0}), 1, 100), "no volume");
    CHECK_REFUSED(method(test::box({0, 0, 0}, {0, 1, 1}), 1, 100), "none of 100 columns");
    const PolygonMesh apart =
        test::together(test::cube(), test::moved(test::cube(), 1, Vec3(99, 99, 0)));
    CHECK_REFUSED(method(apart, 1, 1), "none of 1 columns met the mesh");
  }
}
