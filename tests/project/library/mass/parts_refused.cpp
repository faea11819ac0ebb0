// Bodies made of several materials: what is refused, and that it says which part, and where.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "project/harness/refusal.hpp"
#include "project/library/mass/part_meshes.hpp"
#include "tumble/mass/parts/diagnose.hpp"
#include "tumble/mass/parts/mass_properties.hpp"

using namespace tumble;
using test::of_materials;

namespace {

PolygonMesh cube_at(double x) { return test::moved(test::cube(), 1, Vec3(x, 0, 0)); }

/// A cube of iron, and another one of something else beside it.
parts::LabelledMesh iron_and(const PolygonMesh& other) {
  return of_materials({{"iron", cube_at(0)}, {"lead", test::moved(other, 1, Vec3(3, 0, 0))}});
}

parts::Assembly mass_of(const parts::LabelledMesh& mesh, const MassOptions& options = {}) {
  return parts::mass_properties(mesh, {{"iron", 7874}, {"lead", 11340}}, options);
}

}  // namespace

TEST_CASE("parts: a name without density, a density without name, and faces with two") {
  const parts::LabelledMesh mesh = iron_and(test::cube());
  CHECK_REFUSED(parts::mass_properties(mesh, {{"iron", 1}}), "faces #7 to #12 (usemtl \"lead\")",
                "have no density", "usemtl \"iron\", \"lead\"");
  CHECK_REFUSED(parts::mass_properties(mesh, {{"iron", 1}, {"lead", 1}, {"led", 1}}),
                "no face is in \"led\"", "usemtl \"iron\", \"lead\"");
  CHECK_REFUSED(parts::mass_properties(mesh, {}), "there are no densities");
  CHECK_REFUSED(parts::mass_properties(parts::LabelledMesh(test::cube()), {{"iron", 1}}),
                "no face has a name", "usemtl");
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    CHECK_REFUSED(parts::mass_properties(mesh, {{"iron", 1}, {"lead", bad}}),
                  "the part \"lead\": the density", "is not positive and finite");
  parts::LabelledMesh twice = mesh;
  twice.labels[1].object = "weight";
  CHECK_REFUSED(parts::mass_properties(twice, {{"iron", 1}, {"lead", 2}, {"weight", 3}}),
                "faces #7 to #12 (usemtl \"lead\", o \"weight\")", "two densities", "\"lead\"",
                "\"weight\"");
}

TEST_CASE("parts: the names that there are, but not thousands") {
  PolygonMesh mesh;
  for (int k = 0; k < 40; ++k) mesh = test::together(mesh, cube_at(2 * k));
  detail::LabelReader many;
  for (int k = 0; k < 40; ++k) many.set(&parts::Label::group, "part" + std::to_string(k), 6 * k);
  CHECK_REFUSED(parts::split(many.put_on(mesh), {{"part", 1}}), "\"part11\" and 28 more");
}

TEST_CASE("parts: what is wrong with a part has its name, and the numbers of the file") {
  const PolygonMesh cube = test::cube();
  PolygonMesh bent = cube;
  bent.vertices[7].z() += 0.25;
  const PolygonMesh flat = test::mapped(test::triangulated(cube), Vec3(1, 1, 0).asDiagonal());
  for (const PolygonMesh& bad :
       {test::without_face(cube, 2), test::with_face_flipped(cube, 5),
        test::with_face_twice(cube, 1), test::inside_out(cube), bent, flat}) {
    const parts::LabelledMesh mesh = iron_and(bad);
    const std::vector<parts::Part> split = parts::split(mesh, {{"iron", 1}, {"lead", 1}});
    const std::vector<MeshDefect> found = parts::diagnose(split), whole = diagnose(mesh);
    REQUIRE(!found.empty());
    REQUIRE(found.size() == whole.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      CHECK(found[i].kind == whole[i].kind);
      CHECK(found[i].face == whole[i].face);
      CHECK(found[i].edge == whole[i].edge);
      // A part by itself is "the surface", and of several "the part with face #7".
      const bool of_part = whole[i].message.find("the part with") != std::string::npos;
      if (!of_part) CHECK(found[i].message == "\"lead\": " + whole[i].message);
      CHECK(found[i].message.starts_with("\"lead\": "));
    }
    if (spoils_integrals(found[0])) CHECK_REFUSED(mass_of(mesh), "\"lead\": ", found[0].message);
  }
}

TEST_CASE("parts: that overlap are refused, with the parts that do") {
  const auto crossing = of_materials({{"iron", cube_at(0)}, {"lead", cube_at(0.75)}});
  CHECK_REFUSED(mass_of(crossing), "self_crossing: parts overlap: ", "of \"iron\"", "of \"lead\"",
                "of the volume count wrongly");
  const auto inside =
      of_materials({{"iron", test::moved(test::cube(), 4, Vec3::Zero())}, {"lead", cube_at(1)}});
  CHECK_REFUSED(mass_of(inside), "nested_wrong: parts overlap: the part with face #7 of \"lead\"",
                "count 2 times", "cut its place out of the part around it");
  CHECK(mass_of(inside, {.policy = Policy::accept}).mass == 64 * 7874 + 11340);
  CHECK(mass_of(crossing, {.policy = Policy::accept}).findings.size() == 1);
  const auto touching = of_materials({{"iron", cube_at(0)}, {"lead", cube_at(1)}});
  CHECK(mass_of(touching).findings.empty());
  const auto slightly = of_materials({{"iron", cube_at(0)}, {"lead", cube_at(1 - 1e-7)}});
  CHECK(mass_of(slightly).findings.size() == 1);
  CHECK_REFUSED(mass_of(slightly, {.tolerance = 1e-9}), "parts overlap");
}

TEST_CASE("parts: an overlap is judged by its mass, not by its volume") {
  // A cube of iron enters a block of foam by 1e-5, in more digits than rounding explains.
  const auto mesh =
      of_materials({{"foam", test::moved(test::cube(), 4, Vec3::Zero())},
                    {"iron", test::moved(test::cube(), 1, Vec3(4 - 1.00001e-5, 1, 1))}});
  const auto share = [&](double foam, double iron) {
    const auto findings = parts::diagnose(parts::split(mesh, {{"foam", foam}, {"iron", iron}}));
    REQUIRE(findings.size() == 1);
    CHECK(test::mentions(findings[0].message, "of the mass"));
    return findings[0].share;
  };
  const double of_volume = share(1, 1), of_mass = share(1, 1000);
  CHECK(of_volume < 1e-6);
  CHECK(of_volume == doctest::Approx(1e-5 / 65).epsilon(0.2));  // from some hundred lines
  CHECK(of_mass / of_volume == doctest::Approx(1000 * 65 / 1064.0));
  const auto weigh = [&](double iron) {
    return parts::mass_properties(mesh, {{"foam", 1}, {"iron", iron}});
  };
  CHECK(weigh(1).mass == doctest::Approx(65));
  CHECK_REFUSED(weigh(1000), "parts overlap", "of the mass");
}

TEST_CASE("parts: one that is too small for double is named") {
  const auto mesh = of_materials(
      {{"iron", cube_at(0)}, {"dust", test::moved(test::cube(), 1e-70, Vec3(3, 0, 0))}});
  CHECK_REFUSED(parts::mass_properties(mesh, {{"iron", 1}, {"dust", 1}}), "\"dust\": ");
  const auto tiny = of_materials({{"dust", test::moved(test::cube(), 1e-70, Vec3::Zero())}});
  CHECK_REFUSED(parts::mass_properties(tiny, {{"dust", 1}}), "the part \"dust\": ", "too small");
}
