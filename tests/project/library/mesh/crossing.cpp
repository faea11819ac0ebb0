// How much counts wrongly, however the body lies; and what rounding of a file's decimals is not.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"
#include "project/harness/scanned_meshes.hpp"
#include "project/library/mesh/shapes.hpp"
#include "tumble/mass/mesh_mass_properties.hpp"
#include "tumble/mesh/coordinate_rounding.hpp"
#include "tumble/mesh/diagnose.hpp"
#include "tumble/mesh/read_obj.hpp"

using namespace tumble;

namespace {

PolygonMesh two_boxes(const Vec3& low, const Vec3& high) {
  return test::together(test::cube(), test::box(low, high));
}

/// Turned and moved anyhow.
PolygonMesh placed(PolygonMesh mesh, test::Random& random, double scale = 1) {
  const Quat q = random.rotation();
  const Vec3 d = random.vector();
  for (Vec3& p : mesh.vertices) p = scale * (q * p + d);
  return mesh;
}

/// What a reader makes of what a program wrote.
PolygonMesh written(PolygonMesh mesh, const char* format) {
  for (Vec3& p : mesh.vertices)
    for (double& x : p) {
      std::array<char, 64> text{};
      std::snprintf(text.data(), text.size(), format, x);
      x = std::strtod(text.data(), nullptr);
    }
  return mesh;
}

/// The share that counts wrongly, 0 if nothing was found.
MeshDefect crossing_of(const PolygonMesh& mesh, crossings::Search search) {
  MeshDefect none;
  none.share = 0;
  for (const MeshDefect& finding : diagnose(mesh, {}, search)) {
    CHECK(finding.kind == MeshDefectKind::self_crossing);
    return finding;
  }
  return none;
}

}  // namespace

TEST_CASE("a crossing: its share is found, within its uncertainty, however the body lies") {
  struct Case {
    PolygonMesh mesh;
    double share;
  };
  const auto corner = [](double a) {
    return Case{two_boxes(Vec3::Constant(1 - a), Vec3::Constant(2)),
                a * a * a / (1 + (1 + a) * (1 + a) * (1 + a))};
  };
  const std::vector<Case> cases = {
      corner(0.3),
      corner(0.1),
      corner(0.04),
      // An edge that goes in by 0.02 on a length of 0.6.
      {two_boxes({0.98, 0.98, 0.2}, {1.7, 1.9, 0.8}), 0.02 * 0.02 * 0.6 / (1 + 0.72 * 0.92 * 0.6)},
      // A side that goes in by 1e-5.
      {two_boxes({1 - 1e-5, 0, 0}, {2, 1, 1}), 1e-5 / (2 + 1e-5)}};
  test::Random random(3);
  for (const Case& one : cases)
    for (int i = 0; i < 12; ++i) {
      const MeshDefect found = crossing_of(placed(one.mesh, random), crossings::Search::usual);
      CAPTURE(one.share);
      CAPTURE(found.share);
      CHECK(std::abs(found.share - one.share) <= 2 * found.share_uncertainty + 0.1 * one.share);
      CHECK(spoils_integrals(found));
      CHECK(!spoils_integrals(found, 2 * one.share));
    }
}

TEST_CASE("a crossing: small ones are found thoroughly, however the body lies") {
  test::Random random(5);
  for (const double a : {0.02, 0.01, 1e-3}) {
    const PolygonMesh mesh = two_boxes(Vec3::Constant(1 - a), Vec3::Constant(2));
    const double share = a * a * a / (1 + (1 + a) * (1 + a) * (1 + a));
    for (int i = 0; i < 12; ++i) {
      const MeshDefect found = crossing_of(placed(mesh, random), crossings::Search::thorough);
      CAPTURE(a);
      CAPTURE(found.share);
      CHECK(found.kind == MeshDefectKind::self_crossing);
      CHECK(spoils_integrals(found) == (share > 1e-6));
      if (a > 5e-3)
        CHECK(std::abs(found.share - share) <= 2 * found.share_uncertainty + 0.1 * share);
    }
  }
}

TEST_CASE("a crossing: a small one of parts with thousands of faces is found, however they lie") {
  // A corner goes in by 0.02 of the edge, 4e-6 of the volume: between the lines of most lattices.
  const PolygonMesh cube = test::regular_cube(18, 0.5);
  const PolygonMesh mesh = test::together(cube, test::moved(cube, 1, Vec3::Constant(0.98)));
  test::Random random(17);
  for (int i = 0; i < 4; ++i) {
    const MeshDefect found = crossing_of(placed(mesh, random), crossings::Search::usual);
    CHECK(found.kind == MeshDefectKind::self_crossing);
    CHECK(std::abs(found.share - 4e-6) <= 0.4e-6);
    CHECK(spoils_integrals(found));
  }
}

TEST_CASE("a crossing: parts that touch do not cross, whatever decimals a file has") {
  const PolygonMesh standing =
      test::together(test::box({0, 0, 0}, {2, 2, 1}), test::box({0.5, 0.6, 1}, {1.3, 1.2, 1.7}));
  const PolygonMesh peg = two_boxes({1, 0.4, 0.3}, {1.5, 0.7, 0.6});
  test::Random random(7);
  for (const PolygonMesh& mesh : {standing, peg})
    for (const double scale : {1.0, 1e3})
      for (const char* format : {"%.17g", "%.9f", "%.6f"})
        for (int i = 0; i < 10; ++i) {
          const PolygonMesh read = written(placed(mesh, random, scale), format);
          CAPTURE(format);
          for (const auto search : {crossings::Search::usual, crossings::Search::thorough})
            for (const MeshDefect& finding : diagnose(read, {}, search))
              CHECK(!spoils_integrals(finding));
        }
}

TEST_CASE("a crossing: few digits are a shape's, not a file's") {
  // 1 − 0.001 has three decimals; that they overlap by a thousandth is no rounding.
  CHECK_REFUSED(require_body(two_boxes({0.999, 0, 0}, {2, 1, 1})), "of the volume count wrongly");
  CHECK_REFUSED(require_body(two_boxes({0.99999, 0, 0}, {2, 1, 1})), "of the volume count wrongly");
}

TEST_CASE("a crossing: parts that touch, written with few digits, pass if their mass is right") {
  const PolygonMesh standing =
      test::together(test::box({0, 0, 0}, {2, 2, 1}), test::box({0.5, 0.6, 1}, {1.3, 1.2, 1.7}));
  const PolygonMesh peg = two_boxes({1, 0.4, 0.3}, {1.5, 0.7, 0.6});
  const auto volume = [](const PolygonMesh& mesh) {
    return unchecked_mass_properties(mesh, 1).mass;
  };
  test::Random random(13);
  int right = 0;
  for (const PolygonMesh& mesh : {standing, peg})
    for (const double scale : {0.3, 0.03})
      for (const char* format : {"%.4f", "%.5f", "%.6f", "%.3g", "%.4g", "%.5g"})
        for (int i = 0; i < 3; ++i) {
          const PolygonMesh whole = placed(mesh, random, scale), read = written(whole, format);
          // The sum of the two volumes: what counts twice is not in it, and what rounding did is.
          const bool is_right = std::abs(volume(read) / volume(whole) - 1) < 1e-6;
          right += is_right;
          INFO(std::string(format), " at ", scale, ", rounding ",
               detail::coordinate_rounding(read));
          for (const MeshDefect& finding : diagnose(read)) {
            INFO(finding.message);
            // By luck, a mass may be right of which much counts twice.
            CHECK((!is_right || !spoils_integrals(finding) || finding.share > 5e-6));
          }
          // With all pairs, and without the digits, nothing that counts much has passed.
          const bool passes = test::message_of([&] { require_body(read); }) == "(nothing thrown)";
          for (const MeshDefect& finding :
               diagnose(read, {}, crossings::Search::thorough, std::optional(0.0)))
            CHECK((!passes || !(finding.share > 1e-5)));
        }
  CHECK(right > 5);
}

TEST_CASE("a crossing: what the last decimal may have done is a note, with its share") {
  // 1e-5 is two halves of the last decimal; a share of 2e-6 is more than the tolerance.
  const std::vector<MeshDefect> found = diagnose(two_boxes({0.99999, 0, 0}, {1.99999, 0.5, 0.5}));
  REQUIRE(found.size() == 1);
  CHECK(found[0].kind == MeshDefectKind::self_crossing);
  CHECK(found[0].share == doctest::Approx(2e-6).epsilon(0.01));
  CHECK(found[0].may_be_rounding);
  CHECK_FALSE(spoils_integrals(found[0]));
  CHECK(found[0].message.starts_with("perhaps because the last digit is rounded, the surface"));
  CHECK(found[0].message.ends_with("of the volume count wrongly"));
}

TEST_CASE("a crossing: decimals of a body far away may hide no part of it") {
  // Half a unit is 5e-4, a seven-digit number; the boxes are 0.1 long, and 1e-3 of them overlaps.
  const PolygonMesh mesh =
      test::moved(two_boxes({0.99, 0, 0}, {2, 1, 1}), 0.1, Vec3(1234.567, 0, 0));
  CHECK_REFUSED(require_body(written(mesh, "%.3f")), "of the volume count wrongly");
}

TEST_CASE("coordinate_rounding: half of what lies between two floats") {
  test::Random random(15);
  PolygonMesh body = placed(test::sphere(2), random, 3);
  for (Vec3& p : body.vertices) p = p.cast<float>().cast<double>();
  const double largest =
      std::abs(std::max_element(body.vertices.begin(), body.vertices.end(),
                                [](const Vec3& a, const Vec3& b) {
                                  return a.cwiseAbs().maxCoeff() < b.cwiseAbs().maxCoeff();
                                })
                   ->cwiseAbs()
                   .maxCoeff());
  const auto x = static_cast<float>(largest);
  const double gap = static_cast<double>(std::nextafter(x, INFINITY)) - static_cast<double>(x);
  CHECK(detail::coordinate_rounding(body) == gap / 2);
  body.vertices[0].x() += 1e-12;
  CHECK(detail::coordinate_rounding(body) == 0);
}

TEST_CASE("coordinate_rounding: floats far away have few digits behind the point, and are floats") {
  test::Random random(21);
  const PolygonMesh body = placed(test::cube(), random, 2);
  for (const double far : {1e3, 1e4, 7e4, 1e6}) {
    PolygonMesh there = test::moved(body, 1, Vec3(far, -far / 3, far / 7));
    for (Vec3& p : there.vertices) p = p.cast<float>().cast<double>();
    const double half = std::ldexp(1.0, std::ilogb(far) - 24);
    CAPTURE(far);
    for (const char* format : {"%.17g", "%.9g", "%.9f"})
      CHECK(detail::coordinate_rounding(written(there, format)) == doctest::Approx(half));
  }
  // Whole numbers, halves and the like are floats too, but nobody rounded them.
  CHECK(detail::coordinate_rounding(test::moved(test::cube(), 0x1p-12, Vec3(3, 5, 9))) < 1e-12);
}

TEST_CASE("a crossing: parts that touch pass as floats too, far away, with what counts twice") {
  const PolygonMesh standing =
      test::together(test::box({0, 0, 0}, {2, 2, 1}), test::box({0.5, 0.6, 1}, {1.3, 1.2, 1.7}));
  const PolygonMesh peg = two_boxes({1, 0.4, 0.3}, {1.5, 0.7, 0.6});
  test::Random random(23);
  int notes = 0;
  for (const PolygonMesh& mesh : {standing, peg})
    for (const double far : {1e4, 1e5})
      for (const double scale : {1., 10., 100., 1000.})
        for (int i = 0; i < 4; ++i) {
          if (scale < 1e-4 * far) continue;  // two floats are a hundredth of the body apart
          const Vec3 d = far * random.vector().normalized();
          PolygonMesh there = test::moved(placed(mesh, random, scale), 1, d);
          for (Vec3& p : there.vertices) p = p.cast<float>().cast<double>();
          INFO("scale ", scale, " at ", far);
          for (const MeshDefect& finding : diagnose(test::triangulated(there))) {
            INFO(finding.message);
            CHECK(!spoils_integrals(finding));
            notes += finding.may_be_rounding && finding.share > 1e-6;
          }
        }
  CHECK(notes > 5);
  // A part that is lost is no rounding.
  PolygonMesh deep = placed(two_boxes({0.99, 0.1, 0.1}, {2, 0.9, 0.9}), random);
  deep = test::moved(deep, 1, Vec3(1e4, 2e4, 3e4));
  for (Vec3& p : deep.vertices) p = p.cast<float>().cast<double>();
  CHECK_REFUSED(require_body(deep), "of the volume count wrongly");
}

namespace {

/// Two blocks 10 m thick, far away, one of which lies some ulps of a float deep in the other.
struct FarBlocks {
  PolygonMesh mesh;
  double share;
};

FarBlocks far_blocks(int ulps, double margin, int axis) {
  constexpr double far = 1e4, side = 100;
  const double deep = ulps * 0x1p-10, inner = side - 2 * margin;
  PolygonMesh mesh = test::together(
      test::box({far, 0, 0}, {far + 10, side, side}),
      test::box({far + 10 - deep, margin, margin}, {far + 20, side - margin, side - margin}));
  for (Vec3& p : mesh.vertices) {
    std::rotate(p.begin(), p.begin() + 3 - axis, p.end());
    p = p.cast<float>().cast<double>();
  }
  return {test::triangulated(mesh),
          deep * inner * inner / (10 * side * side + (10 + deep) * inner * inner)};
}

}  // namespace

TEST_CASE("a crossing: parts along the axes, one ulp deep in each other, have the true share") {
  for (int axis = 0; axis < 3; ++axis)
    for (const double margin : {0.5, 1., 2., 3., 7.}) {
      const FarBlocks blocks = far_blocks(1, margin, axis);
      const MeshDefect found = crossing_of(blocks.mesh, crossings::Search::usual);
      CAPTURE(axis);
      CAPTURE(margin);
      INFO(found.message);
      CHECK(found.may_be_rounding);
      CHECK(std::abs(found.share - blocks.share) <= 0.1 * blocks.share);
    }
}

TEST_CASE("a crossing: parts along the axes, several ulps deep in each other, are refused") {
  for (int axis = 0; axis < 3; ++axis)
    for (const int ulps : {2, 3, 8}) {
      // At 2 ulps this is 0.8e-4, below what floats may lose.
      const FarBlocks blocks = far_blocks(ulps, 10, axis);
      const MeshDefect found = crossing_of(blocks.mesh, crossings::Search::usual);
      CAPTURE(axis);
      CAPTURE(ulps);
      INFO(found.message);
      CHECK(spoils_integrals(found));
      CHECK(std::abs(found.share - blocks.share) <= 0.1 * blocks.share);
    }
}

TEST_CASE("a crossing: floats near the origin hide no overlap") {
  for (const double deep : {5e-5, 9e-5}) {
    PolygonMesh mesh = two_boxes({0, 0, 1 - deep}, {1, 1, 2});
    for (Vec3& p : mesh.vertices) p = p.cast<float>().cast<double>();
    const MeshDefect found = crossing_of(mesh, crossings::Search::usual);
    CHECK(spoils_integrals(found));
    CHECK(found.share == doctest::Approx(deep / 2).epsilon(0.01));
  }
}

TEST_CASE("a crossing: large coordinates that were chosen are no floats") {
  // Whole metres and halves of a map's grid: some need all bits of a float.
  const PolygonMesh halves =
      test::together(test::box({500000, 4649776.5, 0}, {500100, 4649876.5, 100}),
                     test::box({500040, 4649876, 40}, {500050, 4649886.5, 50}));
  const PolygonMesh whole = test::together(test::box({500000, 9000001, 0}, {500100, 9000101, 100}),
                                           test::box({500040, 9000100, 40}, {500048, 9000111, 50}));
  CHECK(detail::coordinate_rounding(halves) < 0.1);
  CHECK(detail::may_be_chosen(halves.vertices));
  CHECK(detail::may_be_chosen(whole.vertices));
  // Many different ones do not change that, as long as the smaller ones need few bits.
  PolygonMesh row = test::box({500000, 4649776.5, 0}, {500003.5, 4649780.5, 3});
  for (int i = 1; i < 20; ++i)
    row = test::together(row, test::box({500000 + 9.5 * i, 4649776.5 + 9.5 * i, 4. * i},
                                        {500003.5 + 9.5 * i, 4649780.5 + 9.5 * i, 4. * i + 3}));
  CHECK(detail::coordinate_rounding(row) < 0.1);
  for (Vec3& p : row.vertices) p.z() *= 0.7;  // decimals, which floats need all their bits for
  CHECK(detail::coordinate_rounding(written(row, "%.1f")) < 0.1);
  for (const PolygonMesh& mesh : {halves, whole})
    CHECK_REFUSED(require_body(mesh), "of the volume count wrongly");
}

TEST_CASE("a crossing: a concave polygon that rounding has bent crosses nothing") {
  const auto star = [](int n, double inner) {
    std::vector<Eigen::Vector2d> outline;
    for (int i = 0; i < 2 * n; ++i) {
      const double r = i % 2 == 0 ? 1 : inner, a = std::numbers::pi * i / n;
      outline.emplace_back(r * std::cos(a), r * std::sin(a));
    }
    return outline;
  };
  const std::vector<std::vector<Eigen::Vector2d>> outlines = {
      star(5, 0.4),
      star(9, 0.2),
      {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}},
      {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {3, 2}, {3, 3}, {0, 3}}};
  test::Random random(25);
  int bent = 0;
  for (const auto& outline : outlines)
    for (const double height : {0.05, 1., 20.})
      for (std::size_t first = 0; first < outline.size(); first += 3) {
        std::vector<Eigen::Vector2d> turned = outline;
        std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(first),
                    turned.end());
        const PolygonMesh prism = placed(test::prism(turned, height), random);
        for (const char* format : {"%.6f", "%.9f"})
          for (const MeshDefect& finding : diagnose(written(prism, format))) {
            INFO(finding.message);
            CHECK(!spoils_integrals(finding));
            bent += finding.kind == MeshDefectKind::nonplanar_face ||
                    finding.kind == MeshDefectKind::self_crossing;
            if (finding.kind == MeshDefectKind::self_crossing)
              CHECK(finding.share + finding.share_uncertainty < 1e-4);
          }
      }
  CHECK(bent > 0);  // else nothing was looked at
}

TEST_CASE("coordinate_rounding: half a unit of the last decimal that is written") {
  using detail::coordinate_rounding;
  test::Random random(9);
  const PolygonMesh body = placed(test::sphere(2), random, 3);
  CHECK(coordinate_rounding(body) == 0);
  CHECK(coordinate_rounding(written(body, "%.6f")) == doctest::Approx(5e-7));
  CHECK(coordinate_rounding(written(body, "%.9f")) == doctest::Approx(5e-10));
  CHECK(coordinate_rounding(written(body, "%.8e")) == doctest::Approx(5e-9));
  // Few digits are rounding if many numbers need the last.
  CHECK(coordinate_rounding(written(body, "%.3f")) == doctest::Approx(5e-4));
  CHECK(coordinate_rounding(written(body, "%.2e")) == doctest::Approx(5e-3));
  CHECK(coordinate_rounding(written(body, "%.5g")) == doctest::Approx(5e-5).epsilon(1e-12));
  CHECK(coordinate_rounding(written(body, "%.1f")) == 0);
  CHECK(coordinate_rounding(two_boxes({0.99999, 0, 0}, {2, 1, 1})) == 0);
  CHECK(coordinate_rounding(test::cube()) == 0);
  CHECK(coordinate_rounding(test::moved(test::cube(), 0.125, Vec3(0.25, 0.5, 3))) == 0);
}

TEST_CASE("a crossing: a scanned body's control cage, however it lies") {
  if (!test::have_scanned_meshes()) return;
  const PolygonMesh cage = detail::read_obj(test::scanned_mesh("spot_control.obj"));
  test::Random random(11);
  for (int i = 0; i < 8; ++i) {
    double share = 0;
    for (const MeshDefect& finding : diagnose(placed(cage, random)))
      if (finding.kind == MeshDefectKind::self_crossing) share = finding.share;
    CHECK(std::abs(share - 6.4e-4) <= 0.2e-4);
  }
}

TEST_CASE("a crossing: where the volume is 0 the share is NaN, and the message leaves it out") {
  // It counts positively and negatively alike.
  const PolygonMesh mesh =
      test::together(test::cube(), test::inside_out(test::moved(test::cube(), 1, {0.5, 0, 0})));
  bool found = false;
  for (const MeshDefect& finding : diagnose(mesh)) {
    INFO(finding.message);
    CHECK(finding.message.find("nan") == std::string::npos);
    CHECK(finding.message.find("inf") == std::string::npos);
    if (finding.kind != MeshDefectKind::self_crossing) continue;
    found = true;
    CHECK(std::isnan(finding.share));
    CHECK(std::isnan(finding.share_uncertainty));
  }
  CHECK(found);
}

TEST_CASE("SpaceGrid: a body whose volume is no double any more has cells all the same") {
  for (const double size : {1e-150, 1e-110, 1., 1e110, 1e150}) {
    const Eigen::AlignedBox3d low(Vec3::Zero(), Vec3::Constant(size)),
        high(Vec3::Constant(size), Vec3::Constant(2 * size));
    const detail::SpaceGrid grid({{0, {0, 1, 2}, low}, {1, {3, 4, 5}, high}});
    int found = 0;
    grid.for_each_cell([&](const detail::SpaceGrid::Cell&, std::span<const int> items) {
      found += static_cast<int>(items.size());
    });
    CHECK(found >= 2);
  }
  const Eigen::AlignedBox3d nothing(Vec3::Zero(), Vec3::Zero());
  const detail::SpaceGrid grid({{0, {0, 1, 2}, nothing}});
  CHECK(grid.cell_of(Vec3::Zero()) == detail::SpaceGrid::Cell{0, 0, 0});
}

TEST_CASE("crossings that are apart: each is measured, however small it is beside their distance") {
  const auto pair = [](double o) {  // two cubes, one of which goes into a corner of the other
    return two_boxes(Vec3(1 - o, 1 - 0.9 * o, 1 - 0.95 * o),
                     Vec3(2 - o, 2 - 0.9 * o, 2 - 0.95 * o));
  };
  const auto moved = [](PolygonMesh mesh, const Vec3& d) {
    for (Vec3& p : mesh.vertices) p += d;
    return mesh;
  };
  struct Case {
    double distance, overlap;
  };
  for (const Case& one : {Case{10, 0.05}, {100, 0.12}, {1e3, 0.5}, {1e4, 0.8}}) {
    const PolygonMesh near = pair(one.overlap);
    const PolygonMesh mesh = test::together(near, moved(near, one.distance * Vec3(1, 0.7, 0.4)));
    const double share = 0.855 * one.overlap * one.overlap * one.overlap / 2;
    for (const auto search : {crossings::Search::usual, crossings::Search::thorough}) {
      const MeshDefect found = crossing_of(mesh, search);
      CAPTURE(one.distance);
      CAPTURE(found.share);
      CHECK(std::abs(found.share - share) <= 2 * found.share_uncertainty + 0.1 * share);
      CHECK(found.share_uncertainty < 0.1 * share);
    }
  }
}

TEST_CASE("crossings that are apart: a chain of many, of which some are drawn") {
  struct Case {
    int boxes;
    double overlap;
  };
  for (const Case& one : {Case{24, 0.03}, {48, 0.08}, {200, 0.12}, {600, 0.2}}) {
    const int n = one.boxes;
    const double h = one.overlap;
    PolygonMesh mesh = test::cube();
    for (int j = 1; j < n; ++j) {
      const Vec3 low = j * Vec3(1 - h, 1 - 1.3 * h, 1 - 0.8 * h);
      mesh = test::together(mesh, test::box(low, low + Vec3::Ones()));
    }
    const double share = 1.04 * h * h * h * (n - 1) / n;
    const MeshDefect found = crossing_of(mesh, crossings::Search::usual);
    CAPTURE(n);
    CAPTURE(found.share);
    CHECK(std::abs(found.share - share) <= 2 * found.share_uncertainty + 0.1 * share);
  }
}

TEST_CASE("a crossing whose edges pass exactly through edges of the other part is found") {
  for (const double h : {0.0128, 0.01442, 0.0154}) {
    const PolygonMesh mesh = two_boxes(Vec3::Constant(1 - h), Vec3::Constant(2 - h));
    const MeshDefect found = crossing_of(mesh, crossings::Search::usual);
    CAPTURE(h);
    CHECK(found.share == doctest::Approx(h * h * h / 2).epsilon(0.2));
  }
}

TEST_CASE("a crossing that no line meets says what may be there") {
  // A needle through a cube: 1e-10 of the volume count twice.
  const MeshDefect found =
      crossing_of(two_boxes({0.5, 0.5, -0.5}, {0.50001, 0.50001, 1.5}), crossings::Search::usual);
  CHECK(found.share + found.share_uncertainty >= 1e-10);
  CHECK(found.share + found.share_uncertainty < 1e-3);
}

TEST_CASE("a crossing of three parts: what all of them share counts twice, not three times") {
  const auto bar = [](int axis, double half) {
    Vec3 high = Vec3::Constant(half);
    high[axis] = 5;
    return test::box(-high, high);
  };
  const PolygonMesh bars = test::together(test::together(bar(0, 0.5), bar(1, 0.45)), bar(2, 0.4));
  const double volume = 10 * (1 + 0.81 + 0.64), twice = 0.81 + 0.64 + 0.576 - 0.576;
  const MeshDefect found = crossing_of(bars, crossings::Search::usual);
  CAPTURE(found.share);
  CHECK(std::abs(found.share - twice / volume) <= 2 * found.share_uncertainty + 0.003);
}
