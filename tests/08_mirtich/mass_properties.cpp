/// @file
/// 8.4 mass_properties: its laws, and what goes wrong.
#include "tumble/mass/mass_properties.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "08_mirtich/bodies.hpp"
#include "08_mirtich/contract.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/mass/mesh_mass_properties.hpp"
#include "tumble/mass/tetrahedron.hpp"
#include "tumble/mass/transform.hpp"

using namespace tumble::judge;
using point_sampling::MassProperties;
using tumble::Mat3, tumble::PolygonMesh, tumble::Vec3;
namespace shapes = tumble::shapes;

namespace student {
const Function<decltype(mirtich::mass_properties)> mass_properties{TUMBLE_UNIT};
}

namespace {

MassProperties nothing() { return {0, Vec3::Zero(), Mat3::Zero()}; }

MassProperties from_library(const tumble::MassProperties& body) {
  return {body.mass, body.centre, body.inertia};
}

/// By signed tetrahedra over the faces, with some 30 digits.
MassProperties reference(const Polyhedron& body, double density) {
  const PolygonMesh mesh = mesh_of(body);
  const auto exact = tumble::unchecked_mass_properties(mesh, density);
  return exact.mass == 0 ? nothing() : from_library(exact);
}

/// The volume, without its sign.
double volume(const Polyhedron& body) { return std::abs(reference(body, 1).mass); }

/// The lowest and the highest coordinates.
std::pair<Vec3, Vec3> box_around(const std::vector<Vec3>& vertices) {
  Vec3 low = vertices.front(), high = low;
  for (const Vec3& x : vertices) low = low.cwiseMin(x), high = high.cwiseMax(x);
  return {low, high};
}

/// The diagonal of the box around a body.
double diameter(const Polyhedron& body) {
  const auto [low, high] = box_around(body.vertices);
  return (high - low).norm();
}

/// How far mass, centre and inertia may be off.
///
/// With n corners no farther than M from where the integrals are taken about, one of degree k is
/// off by 64 eps n Mᵏ⁺³ (see volume_integrals.cpp). The centre is a quotient of two of them; and
/// where the inertia is moved to it, two numbers with the mass, the centre or its square in them
/// are taken off: together 8 times as much.
struct Rounding {
  double mass, centre, inertia;

  Rounding(const Polyhedron& body, double density, double M) {
    const double unit = 64 * eps * corner_count(body);
    mass = unit * density * std::pow(M, 3);
    centre = 2 * unit * M * std::pow(M, 3) / volume(body) + 4 * eps * farthest(body);
    inertia = 8 * unit * density * std::pow(M, 5);
  }
  double any() const { return std::fmax(std::fmax(mass, centre), inertia); }
};

/// For someone who takes all integrals about the origin: allowed as long as the body is near it.
double rounding_near_origin(const Polyhedron& body, double density) {
  return Rounding(body, density, std::fmax(farthest(body), diameter(body))).any();
}

/// Near the origin.
void demand(const Polyhedron& body, double density, const MassProperties& expected) {
  REQUIRE(student::mass_properties(body, density) ==
          close_to(expected, rounding_near_origin(body, density)));
}

/// Anywhere, of any size: each of the three to its own rounding.
void demand_each(const Polyhedron& body, double density) {
  const auto found = student::mass_properties(body, density);
  const MassProperties expected = reference(body, density);
  const Rounding allowed(body, density, diameter(body));
  REQUIRE(found == obeys("the mass is right to the rounding of a body of this size, wherever it is",
                         std::abs(found->mass - expected.mass), allowed.mass));
  REQUIRE(found ==
          obeys("the inertia is right to the rounding of a body of this size, wherever it is",
                (found->inertia - expected.inertia).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(),
                allowed.inertia));
  REQUIRE(found ==
          obeys("the centre is as right as a place can be so far out",
                (found->centre - expected.centre).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(),
                allowed.centre));
}

double any_density() { return any_number(1.5, 5); }

Vec3 somewhere() { return any_vector(1.5); }

/// A body of triangles only: far from the origin, rounding bends every other face.
PolygonMesh any_triangles() {
  return shapes::triangulated(any_prism(4 + static_cast<int>(any_number(0, 4)), Vec3::Zero()));
}

/// A box of unit density.
MassProperties of_box(const Vec3& low, const Vec3& high) {
  const Vec3 size = high - low;
  const double mass = size.prod();
  const Vec3 squares = mass / 12 * size.cwiseAbs2();
  const Vec3 moments(squares.y() + squares.z(), squares.z() + squares.x(),
                     squares.x() + squares.y());
  return {mass, (low + high) / 2, moments.asDiagonal()};
}

// ── Mistakes ──

/// The right mass properties of unit density taken apart: volume, centre, and ∫ r rᵀ dV about it.
struct Parts {
  double V;
  Vec3 c;
  Mat3 S;

  explicit Parts(const Polyhedron& body) {
    const MassProperties right = reference(body, 1);
    V = right.mass;
    c = right.centre;
    S = right.inertia.trace() / 2 * Mat3::Identity() - right.inertia;
  }
};

/// The inertia tensor of unit density from ∫ r rᵀ dV.
Mat3 tensor(const Mat3& S) { return S.trace() * Mat3::Identity() - S; }

Mat3 outer(const Vec3& r) { return r * r.transpose(); }

Mat3 diagonal_of(const Mat3& A) { return A.diagonal().asDiagonal(); }

/// What `change` makes of the right inertia.
template <class Change>
auto with_inertia(const Change& change) {
  return [change](const Polyhedron& body, double density) {
    MassProperties result = reference(body, density);
    result.inertia = change(Parts(body), density);
    return result;
  };
}

/// The centre as seen from the point that `choose(vertices)` gives.
template <class Choose>
auto centre_seen_from(const Choose& choose) {
  return [choose](const Polyhedron& body, double density) {
    MassProperties result = reference(body, density);
    if (result.mass != 0) result.centre -= choose(body.vertices);
    return result;
  };
}

/// All integrals about the origin, in double.
MassProperties about_origin(const Polyhedron& body, double density) {
  tumble::Moments<double> m;
  tumble::for_each_triangle(mesh_of(body), [&](int, const std::array<int, 3>& t) {
    const auto corner = [&](std::size_t k) -> tumble::simd::Point<double> {
      const Vec3& x = body.vertices[static_cast<std::size_t>(t[k])];
      return {x.x(), x.y(), x.z()};
    };
    const auto a = corner(0), b = corner(1), c = corner(2);
    m += tumble::detail::raw_moments(tumble::simd::six_volume(a, b, c), a, b, c);
  });
  if (m.one == 0) return nothing();
  const double V = m.one / 6;
  const Vec3 c = Vec3(m.x, m.y, m.z) / 24 / V;
  Mat3 S;
  S << m.xx, m.xy, m.zx, m.xy, m.yy, m.yz, m.zx, m.yz, m.zz;
  return {density * V, c, density * tensor(S / 120 - V * outer(c))};
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any body, of any density, turned in any way, near the origin") {
    for (const int n : {4, 3, 5, 8}) {
      for (const PolygonMesh& mesh : {any_prism(n, somewhere()), any_tetrahedron()}) {
        const Polyhedron body = polyhedron_of(mesh);
        const double density = any_density();
        demand(body, density, reference(body, density));
      }
    }
  }

  TEST_CASE("a box: its centre is in the middle, and m (b² + c²)/12 about the axis along a") {
    demand(polyhedron_of(shapes::box(-Vec3::Ones(), Vec3::Ones())), 3,
           {24, Vec3::Zero(), 16 * Mat3::Identity()});
    for (int n = 0; n < 5; ++n) {
      const Vec3 low = any_vector(2), high = low + Vec3::Constant(1.5) + any_vector();
      demand(polyhedron_of(shapes::box(low, high)), 1, of_box(low, high));
    }
  }

  TEST_CASE("the corner of a cube: products of inertia carry the minus sign") {
    // About the centre ∫ x y dV is negative there, −1/480, and so I_xy positive.
    Mat3 I = Mat3::Constant(1. / 480);
    I.diagonal().setConstant(1. / 80);
    const Polyhedron body = polyhedron_of(shapes::unit_tetrahedron());
    demand(body, 1, {1. / 6, Vec3::Constant(1. / 4), I});
    demand(body, 480, {80, Vec3::Constant(1. / 4), 480 * I});
  }

  TEST_CASE("moved and turned, a body takes the right centre and the right inertia along") {
    for (int n = 0; n < 5; ++n) {
      const PolygonMesh mesh = any_prism(5, somewhere());
      const Mat3 R = any_rotation();
      const Vec3 d = somewhere();
      const double density = any_density();
      const Polyhedron before = polyhedron_of(mesh);
      const Polyhedron after = polyhedron_of(shapes::mapped(mesh, R, d));
      const auto [mass, centre, inertia] = reference(before, density);
      const MassProperties expected{mass, R * centre + d, R * inertia * R.transpose()};
      demand(before, density, {mass, centre, inertia});
      // Turning and moving round the vertices.
      REQUIRE(student::mass_properties(after, density) ==
              close_to(expected, 2 * rounding_near_origin(after, density)));
    }
  }

  TEST_CASE(
      "right with one density; with twice of it, twice the mass and inertia, the same centre") {
    for (int n = 0; n < 5; ++n) {
      const Polyhedron body = polyhedron_of(any_prism(5, somewhere()));
      const double density = any_density();
      const auto [mass, centre, inertia] = reference(body, density);
      demand(body, density, {mass, centre, inertia});
      demand(body, 2 * density, {2 * mass, centre, 2 * inertia});
    }
  }

  TEST_CASE("two bodies as one: each counts about the common centre; a cavity is taken off") {
    const Vec3 corner = 3 * Vec3::Ones();
    for (int n = 0; n < 5; ++n) {
      const PolygonMesh one = any_prism(5, somewhere()), block = shapes::box(corner, 2 * corner);
      const MassProperties a = reference(polyhedron_of(one), 1);
      const MassProperties b = of_box(corner, 2 * corner);
      const tumble::MassProperties first{a.mass, a.centre, a.inertia};
      const Polyhedron both = polyhedron_of(shapes::together(one, block));
      demand(both, 1, from_library(tumble::combine(first, {b.mass, b.centre, b.inertia})));
      const Polyhedron hollow = polyhedron_of(shapes::together(
          shapes::box(-corner, corner), shapes::inside_out(any_prism(6, somewhere()))));
      demand(hollow, 2, reference(hollow, 2));
    }
  }

  TEST_CASE("inside out: the right mass and inertia with a minus, and the right centre") {
    for (int n = 0; n < 5; ++n) {
      const PolygonMesh mesh = any_prism(5, somewhere());
      const double density = any_density();
      const auto [mass, centre, inertia] = reference(polyhedron_of(mesh), density);
      demand(polyhedron_of(shapes::inside_out(mesh)), density, {-mass, centre, -inertia});
    }
  }

  TEST_CASE("right also with faces without area; no volume at all is no mass, not NaN") {
    for (int n = 0; n < 5; ++n) {
      Polyhedron body = polyhedron_of(n == 0 ? shapes::cube() : any_prism(5, somewhere()));
      const double density = any_density();
      const MassProperties expected = reference(body, density);
      for (const std::vector<int>& face : {std::vector<int>{0, 1, 0}, {2, 3}, {3}, {1, 1, 1}}) {
        body.faces.insert(body.faces.begin() + n, face);
        demand(body, density, expected);
      }
    }
    const Vec3 x = any_vector();
    const std::vector<std::vector<int>> faces{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    for (const Polyhedron& body :
         {Polyhedron{{x, 2 * x, 3 * x}, {}}, Polyhedron{{}, {}}, Polyhedron{{x, x, x, x}, faces}})
      REQUIRE(student::mass_properties(body, any_density()) == close_to(nothing(), 0));
  }

  TEST_CASE(
      "far away mass and inertia lose no digit, the centre no more than any place out there") {
    for (const double far : {1e8, 1e6, 1e4, 1e2}) {
      for (int n = 0; n < 3; ++n) {
        const Vec3 d = far * any_direction();
        const PolygonMesh mesh = n == 0 ? shapes::cube() : any_triangles();
        demand_each(polyhedron_of(shapes::mapped(mesh, Mat3::Identity(), d)), any_density());
      }
    }
  }

  TEST_CASE("tiny and huge bodies, light and heavy ones: each to its own rounding") {
    for (const double size : {1e-40, 1e-8, 1e8, 1e40}) {
      for (const double density : {1e-3, 1e4}) {
        const PolygonMesh mesh = any_prism(5, somewhere());
        demand_each(polyhedron_of(shapes::mapped(mesh, size * Mat3::Identity())), density);
      }
    }
  }
}

const Misconceptions<decltype(mirtich::mass_properties)> misconceptions{
    TUMBLE_UNIT,
    {{"density forgotten",
      "You found the mass properties of a body of 1 kg/m³: you left out the density.",
      "Mass, centre and inertia",
      [](const Polyhedron& body, double) { return reference(body, 1); }},
     {"density in the mass alone",
      "Your mass is right, but your inertia is that of a body of 1 kg/m³. It grows with the "
      "density too.",
      "Mass, centre and inertia",
      with_inertia([](const Parts& parts, double) { return tensor(parts.S); })},
     {"centre divided by the mass",
      "Your centre is wrong by a factor of the density: you divided an integral over the volume by "
      "the mass.",
      "Mass, centre and inertia",
      [](const Polyhedron& body, double density) {
        MassProperties result = reference(body, density);
        result.centre /= density;
        return result;
      }},
     {"centre not divided",
      "Your centre is an integral of places, in m⁴. A mean place is that integral divided by the "
      "volume.",
      "Mass, centre and inertia",
      [](const Polyhedron& body, double density) {
        MassProperties result = reference(body, density);
        result.centre *= Parts(body).V;
        return result;
      }},
     {"products with a plus",
      "Your numbers off the diagonal have the wrong sign. With L = I ω, the products of inertia "
      "carry a minus.",
      "Mass, centre and inertia", with_inertia([](const Parts& parts, double density) -> Mat3 {
        const Mat3 I = tensor(parts.S);
        return density * (2 * diagonal_of(I) - I);
      })},
     {"square of the same axis",
      "On your diagonal is ∫ x² for the axis x. What resists a turn about x is how far the "
      "mass is from that axis, along y and z.",
      "Mass, centre and inertia", with_inertia([](const Parts& parts, double density) -> Mat3 {
        return density * (2 * diagonal_of(parts.S) - parts.S);
      })},
     {"yz and zx swapped",
      "You swapped two products. The integrals come in the order xy, yz, zx, and the first row of "
      "the matrix holds xy and zx.",
      "Mass, centre and inertia", with_inertia([](const Parts& parts, double density) {
        Mat3 I = density * tensor(parts.S);
        std::swap(I(0, 2), I(1, 2));
        std::swap(I(2, 0), I(2, 1));
        return I;
      })},
     {"upper half only",
      "Below the diagonal your matrix is empty. A tensor of inertia is symmetric.",
      "Mass, centre and inertia", with_inertia([](const Parts& parts, double density) -> Mat3 {
        return density * tensor(parts.S).triangularView<Eigen::Upper>().toDenseMatrix();
      })},
     {"inertia about the origin",
      "Your inertia is about the origin of the coordinates. We want it about the centre of mass, "
      "where it is smaller.",
      "Mass, centre and inertia", with_inertia([](const Parts& parts, double density) -> Mat3 {
        return density * tensor(parts.S + parts.V * outer(parts.c));
      })},
     {"moved away from the centre",
      "On the way from the origin to the centre of mass you added m d². About the centre a body "
      "has the least inertia: take it off.",
      "Mass, centre and inertia", with_inertia([](const Parts& parts, double density) -> Mat3 {
        return density * tensor(parts.S + 2 * parts.V * outer(parts.c));
      })},
     {"products not moved",
      "You moved the diagonal to the centre of mass, and left the products about the origin.",
      "Mass, centre and inertia", with_inertia([](const Parts& parts, double density) -> Mat3 {
        const Mat3 shift = tensor(parts.V * outer(parts.c));
        return density * (tensor(parts.S) + shift - diagonal_of(shift));
      })},
     {"products moved the wrong way",
      "You moved the diagonal to the centre of mass, and the products the other way, so they are "
      "now off by twice as much. They carry the minus sign already.",
      "Mass, centre and inertia", with_inertia([](const Parts& parts, double density) -> Mat3 {
        const Mat3 shift = tensor(parts.V * outer(parts.c));
        return density * (tensor(parts.S) + 2 * (shift - diagonal_of(shift)));
      })},
     {"moved without the density",
      "You made the step to the centre of mass with the volume in the place of the mass.",
      "Mass, centre and inertia", with_inertia([](const Parts& parts, double density) -> Mat3 {
        const Mat3 shift = tensor(parts.V * outer(parts.c));
        return density * (tensor(parts.S) + shift) - shift;
      })},
     {"centre measured from the middle of the box",
      "You gave the centre as seen from the middle of the box around the body, not in the "
      "coordinates that the body came in.",
      "Far from the origin", centre_seen_from([](const std::vector<Vec3>& vertices) {
        const auto [low, high] = box_around(vertices);
        return Vec3((low + high) / 2);
      })},
     {"centre measured from the mean of the vertices",
      "You gave the centre as seen from the mean of the vertices, not in the coordinates that the "
      "body came in.",
      "Far from the origin", centre_seen_from([](const std::vector<Vec3>& vertices) {
        const Vec3 zero = Vec3::Zero();
        return Vec3(std::accumulate(vertices.begin(), vertices.end(), zero) /
                    static_cast<double>(vertices.size()));
      })},
     {"centre measured from the first vertex",
      "You gave the centre as seen from the first vertex, not in the coordinates that the body "
      "came in.",
      "Far from the origin",
      centre_seen_from([](const std::vector<Vec3>& vertices) { return vertices.front(); })},
     {"digits lost far from the origin",
      "Near the origin you are right. Far from it your integrals are huge and nearly cancel, in "
      "the volume and once more on the way to the centre of mass. Go to the body first.",
      "Far from the origin",
      [](const Polyhedron& body, double density) { return about_origin(body, density); }},
     {"nothing divided by nothing",
      "A body without volume has no centre: 0 divided by 0 is not a number. The contract says what "
      "you return instead.",
      "What breaks",
      [](const Polyhedron& body, double density) -> MassProperties {
        const MassProperties right = reference(body, density);
        if (right.mass != 0) return right;
        const double nan = std::nan("");
        return {0, Vec3::Constant(nan), Mat3::Constant(nan)};
      }},
     {"a tiny body taken for none",
      "You took a body with a volume below some small number for none. What is small depends on "
      "the unit of length: only 0 is always small.",
      "What breaks",
      [](const Polyhedron& body, double density) {
        constexpr double small = 1e-9;
        const MassProperties right = reference(body, density);
        return std::abs(right.mass) < small * density ? nothing() : right;
      }},
     {"only the mass made positive",
      "You gave a body inside out a positive mass, while its inertia is negative. Leave both as "
      "they are: the sign says that the faces go round the wrong way.",
      "What breaks",
      [](const Polyhedron& body, double density) -> MassProperties {
        const MassProperties right = reference(body, density);
        return {std::abs(right.mass), right.centre, right.inertia};
      }},
     {"made positive",
      "You gave a body inside out a positive mass. Then nobody can see that its faces go round the "
      "wrong way.",
      "What breaks", [](const Polyhedron& body, double density) -> MassProperties {
        const MassProperties right = reference(body, density);
        return {std::abs(right.mass), right.centre, (right.mass < 0 ? -1 : 1) * right.inertia};
      }}}};
