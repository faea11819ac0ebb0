// Bodies made of several materials: what each part weighs, and the whole.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "project/library/mass/meshes.hpp"
#include "project/library/mass/part_meshes.hpp"
#include "tumble/mass/parts/mass_properties.hpp"
#include "tumble/mass/solids/box.hpp"
#include "tumble/mass/transform.hpp"
#include "tumble/mesh/weld.hpp"

using namespace tumble;
using test::eps;
using test::of_materials;

namespace {

void check_exactly(const MassProperties& found, const MassProperties& expected) {
  CHECK(found.mass == expected.mass);
  CHECK(found.centre == expected.centre);
  CHECK(found.inertia == expected.inertia);
}

/// The same mesh and names, with vertices at the same place made one.
parts::LabelledMesh welded(parts::LabelledMesh mesh) {
  static_cast<PolygonMesh&>(mesh) = weld(mesh);
  return mesh;
}

/// A handle of hexagons with the side a along z, from −length to 0.
PolygonMesh handle(double a, double length) {
  std::vector<Eigen::Vector2d> hexagon;
  for (int k = 0; k < 6; ++k) {
    const double angle = k * std::numbers::pi / 3;
    hexagon.emplace_back(a * std::cos(angle), a * std::sin(angle));
  }
  return test::moved(test::prism(hexagon, length), 1, Vec3(0, 0, -length));
}

using T = simd::DoubleDouble;

/// Several bodies as one, by the parallel axis theorem from exact moments about points near them.
struct Truth {
  T mass;
  Vector3<T> centre = Vector3<T>::Zero();
  Matrix3<T> second = Matrix3<T>::Zero();  ///< ∫ r rᵀ dm about the centre

  explicit Truth(const std::vector<parts::Part>& all) {
    for (const parts::Part& part : all) {
      const auto [m, c, rr] = of(part);
      mass += m;
      centre += m * c;
    }
    centre = centre / mass;
    for (const parts::Part& part : all) {
      const auto [m, c, rr] = of(part);
      const Vector3<T> d = c - centre;
      second += rr + m * d * d.transpose();
    }
  }

  Mat3 inertia() const {
    const Matrix3<T> I = second.trace() * Matrix3<T>::Identity() - second;
    return I.unaryExpr([](const T& x) { return double(x); });
  }

 private:
  static std::tuple<T, Vector3<T>, Matrix3<T>> of(const parts::Part& part) {
    const Vec3 p = detail::reference_point(part.mesh);
    const Moments<T> m = test::exact_moments(part.mesh, p);
    const Vector3<T> first(m.x, m.y, m.z), c = first / m.one;
    Matrix3<T> rr;
    rr << m.xx, m.xy, m.zx, m.xy, m.yy, m.yz, m.zx, m.yz, m.zz;
    rr -= first * c.transpose();
    return {m.one * part.density, c + p.cast<T>(), T(part.density) * rr};
  }
};

}  // namespace

TEST_CASE("parts: a hammer, a steel box on a wooden prism") {
  constexpr double a = 0.02, length = 0.3;
  const auto hammer =
      of_materials({{"wood", handle(a, length)},
                    {"steel", test::box(Vec3(-0.06, -0.02, 0), Vec3(0.06, 0.02, 0.04))}});
  const parts::Assembly body = parts::mass_properties(hammer, {{"steel", 7850}, {"wood", 700}});
  REQUIRE(body.parts.size() == 2);
  CHECK(body.parts[0].name == "wood");
  CHECK(body.parts[0].faces == 8);
  CHECK(body.parts[1].name == "steel");
  CHECK(body.parts[1].density == 7850);
  CHECK(body.findings.empty());
  // A hexagon has the area 3√3/2 a², and of any axis in its plane the second moment 5/24 a² of it.
  const double wood = 700 * 1.5 * std::sqrt(3.0) * a * a * length;
  const double steel = 7850 * 0.12 * 0.04 * 0.04;
  const double across = wood * (5 * a * a / 24 + length * length / 12);
  const MassProperties in_wood{wood, Vec3(0, 0, -length / 2),
                               Vec3(across, across, wood * 5 * a * a / 12).asDiagonal()};
  const MassProperties in_steel =
      translated(mass_properties(Box{Vec3(0.12, 0.04, 0.04)}, 7850), Vec3(0, 0, 0.02));
  const MassProperties whole = combine(in_wood, in_steel);
  // Corners are rounded, relative to the thinnest length a by a few eps: 3 lengths in a mass, 5 in
  // an inertia.
  CHECK(std::abs(body.parts[0].mass - wood) <= 12 * eps * wood);
  CHECK(std::abs(body.parts[1].mass - steel) <= 12 * eps * steel);
  CHECK(std::abs(body.mass - whole.mass) <= 12 * eps * whole.mass);
  CHECK((body.centre - whole.centre).norm() <= 12 * eps * length);
  CHECK(test::inertia_error(body.inertia, whole.inertia) <= 20 * eps);
  CHECK(test::inertia_error(body.parts[0].inertia, in_wood.inertia) <= 20 * eps);
}

TEST_CASE("parts: a hollow box is one part with a surface that looks inwards, and may be filled") {
  const PolygonMesh outer = test::box(Vec3(-2, -2, -2), Vec3(2, 2, 2));
  const PolygonMesh inner = test::box(Vec3(-1, -1, -1), Vec3(1, 1, 1));
  const auto hollow = of_materials({{"steel", test::together(outer, test::inside_out(inner))}});
  const auto filled =
      of_materials({{"steel", test::together(outer, test::inside_out(inner))}, {"foam", inner}});
  // A cube of the side s has the inertia m s²/6 = ρ s⁵/6.
  const double shell = 6 * (1024 - 32) / 6.0, foam = 3 * 32 / 6.0;
  const auto cube = [](double mass, double inertia) {
    return MassProperties{mass, Vec3::Zero(), inertia * Mat3::Identity()};
  };
  check_exactly(parts::mass_properties(hollow, {{"steel", 6}}), cube(6 * 56, shell));
  for (const auto& mesh : {filled, welded(filled)}) {
    const parts::Assembly body = parts::mass_properties(mesh, {{"steel", 6}, {"foam", 3}});
    CHECK(body.findings.empty());
    check_exactly(body, cube(6 * 56 + 3 * 8, shell + foam));
    check_exactly(body.parts[0], cube(6 * 56, shell));
    check_exactly(body.parts[1], cube(3 * 8, foam));
  }
}

TEST_CASE("parts: two halves that share vertices, far away and askew, are the whole") {
  const Mat3 R = test::askew();
  const Vec3 far(1e6, -2e6, 3e5);
  const auto half = [&](double low, double high) {
    return test::mapped(test::box(Vec3(low, 0, 0), Vec3(high, 1, 1)), R, far);
  };
  auto both = welded(of_materials({{"a", half(0, 1)}, {"b", half(1, 2)}}));
  CHECK(both.vertices.size() == 12);
  for (const Accuracy accuracy : {Accuracy::fast, Accuracy::tight, Accuracy::textbook}) {
    const parts::Assembly body =
        parts::mass_properties(both, {{"a", 5}, {"b", 5}}, {.accuracy = accuracy});
    const BoundedMassProperties one = unchecked_mass_properties(both, 5, accuracy);
    CHECK(std::abs(body.mass - one.mass) <=
          (body.mass_error_bound + one.mass_error_bound) * one.mass);
    CHECK((body.centre + body.centre_rest - one.centre - one.centre_rest).norm() <=
          body.centre_error_bound + one.centre_error_bound + 4 * eps * far.norm());
    CHECK(test::inertia_error(body.inertia, one.inertia) <=
          body.inertia_error_bound + one.inertia_error_bound);
  }
}

TEST_CASE("parts: the bounds of the whole are bounds, near and far apart, for all accuracies") {
  test::Random rng(18);
  for (int i = 0; i < 200; ++i) {
    const double apart = std::pow(10, rng.uniform(0, 6));
    CAPTURE(apart);
    std::vector<parts::Part> all(3);
    for (parts::Part& part : all) {
      part.density = std::pow(10, rng.uniform(-2, 4));
      const Mat3 R = Eigen::AngleAxisd(rng.uniform(-3, 3), rng.direction()).toRotationMatrix();
      const Mat3 A = R * Vec3(1, rng.uniform(0.1, 1), rng.uniform(0.1, 1)).asDiagonal();
      part.mesh = test::mapped(test::sphere(1), A, apart * rng.vector());
    }
    const Truth truth(all);
    for (const Accuracy accuracy : {Accuracy::fast, Accuracy::tight, Accuracy::textbook}) {
      const parts::Assembly body = parts::unchecked_mass_properties(all, accuracy);
      const T mass_error = (T(body.mass) - truth.mass) / truth.mass;
      CHECK(std::abs(double(mass_error)) <= body.mass_error_bound);
      const Vector3<T> centre = body.centre.cast<T>() + body.centre_rest.cast<T>();
      CHECK(detail::to_double(centre - truth.centre).norm() <= body.centre_error_bound);
      // The truth is itself rounded: ε.
      CHECK(test::inertia_error(body.inertia, truth.inertia()) <= body.inertia_error_bound + eps);
      if (accuracy == Accuracy::tight) CHECK(body.inertia_error_bound <= 4 * eps);
    }
  }
}

TEST_CASE("parts: a single part is the mesh by itself") {
  const PolygonMesh mesh = test::mapped(test::sphere(2), test::askew(), Vec3(3, 4, 5));
  const parts::Assembly body = parts::mass_properties(of_materials({{"all", mesh}}), {{"all", 7}});
  const BoundedMassProperties alone = mesh_mass_properties(mesh, 7);
  check_exactly(body.parts[0], alone);
  // The whole is rounded once, and the mesh by itself also before it gets its density.
  CHECK(std::abs(body.mass - alone.mass) <= 2 * eps * alone.mass);
  CHECK((body.centre - alone.centre).norm() <= 2 * eps * alone.centre.norm());
  CHECK(test::inertia_error(body.inertia, alone.inertia) <= 4 * eps);
}

TEST_CASE("split: a name stands for a material, an object or a group, in any number of places") {
  PolygonMesh all;
  detail::LabelReader labels;
  const auto cube_at = [&](double x) {
    all = test::together(all, test::moved(test::cube(), 1, Vec3(x, 0, 0)));
  };
  const auto name = [&](std::string parts::Label::*what, const char* text) {
    labels.set(what, text, all.face_count());
  };
  name(&parts::Label::object, "wheel");
  name(&parts::Label::material, "rubber");
  name(&parts::Label::group, "tyre left");
  cube_at(0);
  name(&parts::Label::material, "steel");
  name(&parts::Label::group, "rim left");
  cube_at(2);
  name(&parts::Label::material, "rubber");
  name(&parts::Label::group, "tyre right");
  cube_at(4);
  const parts::LabelledMesh mesh = labels.put_on(all);
  const auto centres = [&](const parts::Densities& densities) {
    std::vector<double> result;
    for (const parts::PartMass& part : parts::mass_properties(mesh, densities).parts)
      result.push_back(part.centre.x());
    return result;
  };
  using Centres = std::vector<double>;
  CHECK(centres({{"wheel", 1}}) == Centres{2.5});
  CHECK(centres({{"steel", 1}, {"rubber", 1}}) == Centres{2.5, 2.5});
  CHECK(centres({{"left", 1}, {"right", 2}}) == Centres{1.5, 4.5});
  CHECK(centres({{"tyre", 1}, {"steel", 2}}) == Centres{2.5, 2.5});
  CHECK(centres({{"tyre left", 1}, {"rim left", 2}, {"right", 3}}) == Centres{0.5, 2.5, 4.5});
}
