/// @file
/// 8.3 volume_integrals: its laws, and what goes wrong.
#include "tumble/mass/mirtich/volume_integrals.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "08_mirtich/bodies.hpp"
#include "08_mirtich/contract.hpp"
#include "judge/spec/spec.hpp"

using namespace tumble::judge;
using mirtich::VolumeIntegrals;
using tumble::Mat3, tumble::PolygonMesh, tumble::Vec3;
using tumble::mirtich::Plane;
namespace shapes = tumble::shapes;

namespace student {
const Function<decltype(mirtich::volume_integrals)> volume_integrals{TUMBLE_UNIT};
}

namespace {

VolumeIntegrals zero() { return {0, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}; }

VolumeIntegrals operator+(const VolumeIntegrals& a, const VolumeIntegrals& b) {
  return {a.one + b.one, a.r + b.r, a.squares + b.squares, a.products + b.products};
}

VolumeIntegrals operator*(double factor, const VolumeIntegrals& a) {
  return {factor * a.one, factor * a.r, factor * a.squares, factor * a.products};
}

/// By signed tetrahedra over the faces, with some 30 digits.
VolumeIntegrals reference(const Polyhedron& body) {
  const auto m = tumble::reference::exact_moments(mesh_of(body), Vec3::Zero());
  return {double(m.one),
          {double(m.x), double(m.y), double(m.z)},
          {double(m.xx), double(m.yy), double(m.zz)},
          {double(m.xy), double(m.yz), double(m.zx)}};
}

/// How far an integral of degree d may be off. Of n corners no farther than M, each brings an edge
/// with at most 2 Mᵈ⁺³, and some 30 roundings on its way to the volume. (By way of shadows as by
/// tetrahedra, the largest error seen in 30,000 bodies is 0.2 eps n Mᵈ⁺³: most of it cancels.)
double rounding(const Polyhedron& body, int degree) {
  return 64 * eps * corner_count(body) * std::pow(farthest(body), degree + 3);
}

/// How far any of them may be off.
double rounding(const Polyhedron& body) { return std::fmax(rounding(body, 0), rounding(body, 2)); }

/// By how many times its own rounding the worst of the integrals is off.
double error(const VolumeIntegrals& v, const VolumeIntegrals& expected, const Polyhedron& body) {
  const double second = rounding(body, 2);
  double worst = 0;
  for (const double ratio :
       {std::abs(v.one - expected.one) / rounding(body, 0),
        (v.r - expected.r).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() / rounding(body, 1),
        (v.squares - expected.squares).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() / second,
        (v.products - expected.products).cwiseAbs().maxCoeff<Eigen::PropagateNaN>() / second})
    if (!(ratio <= worst)) worst = ratio;  // a NaN stays
  return worst;
}

void demand(const Polyhedron& body, const VolumeIntegrals& expected) {
  REQUIRE(student::volume_integrals(body) == close_to(expected, rounding(body)));
}

void demand(const Polyhedron& body) { demand(body, reference(body)); }

Vec3 somewhere() { return any_vector(1.5); }

/// The integrals of the box [low, high].
VolumeIntegrals of_box(const Vec3& low, const Vec3& high) {
  const Vec3 size = high - low, middle = (low + high) / 2;
  const double V = size.prod();
  const Vec3 squares = middle.cwiseAbs2() + size.cwiseAbs2() / 12;
  return {V, V * middle, V * squares,
          V * Vec3(middle.x() * middle.y(), middle.y() * middle.z(), middle.z() * middle.x())};
}

/// The corner of a cube, cut off: three faces along the axes, seen from their positive sides.
PolygonMesh corner_of_cube() {
  return shapes::mapped(shapes::inside_out(shapes::unit_tetrahedron()), -Mat3::Identity(),
                        Vec3::Ones());
}

/// An L that is 1 high: it has a dent at (1, 1), and a corner in the middle of an edge at (1, 0).
const std::vector<Eigen::Vector2d> L = {{1, 1}, {1, 3}, {0, 3}, {0, 0}, {1, 0}, {2, 0}, {2, 1}};

VolumeIntegrals of_L() { return of_box({0, 0, 0}, {1, 3, 1}) + of_box({1, 0, 0}, {2, 1, 1}); }

/// The same faces, each of them beginning `k` corners later.
Polyhedron beginning_later(Polyhedron body, std::size_t k) {
  for (std::vector<int>& face : body.faces)
    std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(k % face.size()),
                face.end());
  return body;
}

/// One of the meshes that `any()` gives, where no number of a face's normal is near 0.
template <class Any>
PolygonMesh leaning(const Any& any) {
  for (;;) {
    const PolygonMesh mesh = any();
    double smallest = 1;
    for (int f = 0; f < mesh.face_count(); ++f) {
      Corners corners;
      for (const int v : mesh.face(f)) corners.push_back(mesh.vertex(v));
      const Vec3 n = tumble::mirtich::vector_area(corners).normalized();
      smallest = std::fmin(smallest, n.cwiseAbs().minCoeff());
    }
    if (smallest > 0.1) return mesh;
  }
}

// ── Mistakes ──

/// The integrals over what lies between a face and the origin, negative if it is seen from there.
VolumeIntegrals of_cone(const Corners& corners) {
  std::vector<int> all(corners.size());
  std::iota(all.begin(), all.end(), 0);
  return reference({corners, {all}});
}

/// The plane of a face, and along which axis its shadow is cast.
struct View {
  Plane plane;
  int gamma;
};

View view_of(const Corners& corners) {
  const Vec3 area = tumble::mirtich::vector_area(corners);
  const Vec3 n = area / area.norm();
  return {{n, -n.dot(corners.front())}, tumble::mirtich::projection_axis(n)};
}

/// What a face brings, by way of its shadow.
/// @param n what the integrals over the face are multiplied with: its normal
VolumeIntegrals of_face(const Corners& corners, const View& view, const Vec3& n) {
  const auto [plane, gamma] = view;
  const auto f = tumble::mirtich::face_integrals(
      tumble::mirtich::projection_integrals(corners, gamma), plane, gamma);
  const Vec3 powers[] = {{f.a, f.b, f.c}, {f.aa, f.bb, f.cc}, {f.aaa, f.bbb, f.ccc}};
  const Vec3 mixed(f.aab, f.bbc, f.cca);
  VolumeIntegrals v = zero();
  for (int k = 0; k < 3; ++k) {  // along α, β, γ
    const int axis = (gamma + 1 + k) % 3;
    v.one += n[axis] * powers[0][k];
    v.r[axis] = n[axis] * powers[1][k] / 2;
    v.squares[axis] = n[axis] * powers[2][k] / 3;
    v.products[axis] = n[axis] * mixed[k] / 2;
  }
  v.one /= 3;
  return v;
}

VolumeIntegrals of_face(const Corners& corners, const View& view) {
  return of_face(corners, view, view.plane.n);
}

Corners corners_of(const Polyhedron& body, const std::vector<int>& face) {
  Corners corners;
  for (const int v : face) corners.push_back(body.vertices[static_cast<std::size_t>(v)]);
  return corners;
}

/// The sum of `term(corners)` over the faces that have an area.
template <class Term>
VolumeIntegrals over_faces(const Polyhedron& body, const Term& term) {
  VolumeIntegrals sum = zero();
  for (const std::vector<int>& face : body.faces) {
    const Corners corners = corners_of(body, face);
    if (!tumble::mirtich::vector_area(corners).isZero(0)) sum = sum + term(corners);
  }
  return sum;
}

/// The integrals if the plane of each face and the axis of its shadow are what `choose(corners,
/// view)` makes of the right ones.
template <class Choose>
VolumeIntegrals with_view(const Polyhedron& body, const Choose& choose) {
  return over_faces(body, [&](const Corners& corners) {
    return of_face(corners, choose(corners, view_of(corners)));
  });
}

/// The numbers along α, β, γ of a face.
Vec3 in_cycle(const Vec3& v, int gamma) {
  return {v[(gamma + 1) % 3], v[(gamma + 2) % 3], v[gamma]};
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any body, turned in any way, anywhere") {
    for (const int n : {4, 3, 5, 6}) {
      // With no face nearly upright or level: what goes wrong there has its own cases.
      demand(polyhedron_of(leaning([&] { return any_prism(n, somewhere()); })));
      demand(polyhedron_of(leaning([] { return any_tetrahedron(); })));
    }
  }

  TEST_CASE("boxes along the axes, and the corner of a cube") {
    demand(polyhedron_of(corner_of_cube()));
    demand(polyhedron_of(shapes::box(Vec3::Zero(), Vec3::Ones())),
           {1, Vec3::Constant(1. / 2), Vec3::Constant(1. / 3), Vec3::Constant(1. / 4)});
    for (int n = 0; n < 5; ++n) {
      const Vec3 low = any_vector(2), high = low + Vec3::Constant(1.5) + any_vector();
      demand(polyhedron_of(shapes::box(low, high)), of_box(low, high));
    }
  }

  TEST_CASE("faces with a dent, and with corners on one line: whichever corner comes first") {
    for (std::size_t k = 0; k < L.size(); ++k)
      demand(beginning_later(polyhedron_of(shapes::prism(L, 1)), k), of_L());
    for (std::size_t k = 0; k < L.size(); ++k) {
      const Mat3 R = any_rotation();
      const PolygonMesh turned = shapes::mapped(shapes::prism(L, 1), R, somewhere());
      demand(beginning_later(polyhedron_of(turned), k));
    }
  }

  TEST_CASE("two bodies add up, a cavity is taken off: each time the right sum") {
    for (int n = 0; n < 5; ++n) {
      const PolygonMesh one = any_prism(5, somewhere());
      const PolygonMesh other =
          shapes::mapped(any_tetrahedron(), Mat3::Identity(), 6 * Vec3::Ones());
      const Polyhedron both = polyhedron_of(shapes::together(one, other));
      const VolumeIntegrals a = reference(polyhedron_of(one));
      demand(both, a + reference(polyhedron_of(other)));
      const PolygonMesh hollow = shapes::together(shapes::box(-3 * Vec3::Ones(), 3 * Vec3::Ones()),
                                                  shapes::inside_out(one));
      demand(polyhedron_of(hollow), of_box(-3 * Vec3::Ones(), 3 * Vec3::Ones()) + -1 * a);
    }
  }

  TEST_CASE("inside out, every integral is the right one with a minus") {
    for (int n = 0; n < 5; ++n) {
      const PolygonMesh mesh = any_prism(5, somewhere());
      demand(polyhedron_of(shapes::inside_out(mesh)), -1 * reference(polyhedron_of(mesh)));
    }
  }

  TEST_CASE("right all the same with faces without area; without any face all is 0") {
    for (int n = 0; n < 5; ++n) {
      Polyhedron body = polyhedron_of(n == 0 ? shapes::cube() : any_prism(5, somewhere()));
      const VolumeIntegrals expected = reference(body);
      const int middle = static_cast<int>(body.vertices.size());
      body.vertices.push_back((body.vertices[0] + body.vertices[1]) / 2);
      // There and back along an edge; two corners, one, none; thrice the same.
      for (const std::vector<int>& face : {std::vector<int>{0, 1, middle},
                                           {0, middle, 1},
                                           {0, 1, middle, 0},
                                           {2, 3},
                                           {3},
                                           {},
                                           {1, 1, 1}}) {
        body.faces.insert(body.faces.begin() + n, face);
        demand(body, expected);
      }
    }
    demand({{}, {}}, zero());
    demand({{any_vector(), any_vector(), any_vector()}, {}}, zero());
  }

  TEST_CASE("faces as they are, or cut into triangles: the same right integrals") {
    for (int n = 0; n < 5; ++n) {
      const PolygonMesh mesh = any_prism(6, somewhere());
      demand(polyhedron_of(mesh));
      demand(polyhedron_of(shapes::triangulated(mesh)), reference(polyhedron_of(mesh)));
    }
    demand(polyhedron_of(shapes::triangulated(shapes::torus_mesh(8, 5, 1, 0.4))));
  }

  TEST_CASE(
      "moved by d: the same volume V, ∫ r dV grows by V d, and the second powers as they must") {
    for (int n = 0; n < 5; ++n) {
      const PolygonMesh mesh = any_prism(5, somewhere());
      const Vec3 d = any_vector(3);
      const auto [V, r, squares, products] = reference(polyhedron_of(mesh));
      const Vec3 next_r(r.y(), r.z(), r.x()), next_d(d.y(), d.z(), d.x());
      // x² grows by 2 x d_x + d_x², x y by x d_y + y d_x + d_x d_y.
      const VolumeIntegrals expected{
          V, r + V * d, squares + 2 * d.cwiseProduct(r) + V * d.cwiseAbs2(),
          products + r.cwiseProduct(next_d) + next_r.cwiseProduct(d) + V * d.cwiseProduct(next_d)};
      const Polyhedron moved = polyhedron_of(shapes::mapped(mesh, Mat3::Identity(), d));
      // Moving rounds the vertices.
      REQUIRE(student::volume_integrals(moved) == close_to(expected, 2 * rounding(moved)));
    }
  }

  TEST_CASE("tiny and huge bodies, and some far away: each integral to its own rounding") {
    const auto demand_each = [](const PolygonMesh& mesh) {
      const Polyhedron body = polyhedron_of(mesh);
      const auto v = student::volume_integrals(body);
      REQUIRE(v ==
              obeys("every integral is right to its rounding", error(v, reference(body), body), 1));
    };
    for (const double size : {1e-40, 1e-8, 1e8, 1e40})
      demand_each(shapes::mapped(any_prism(5, somewhere()), size * Mat3::Identity()));
    for (const double far : {10., 1e3, 1e6}) demand_each(any_prism(5, far * any_direction()));
  }
}

const Misconceptions<decltype(mirtich::volume_integrals)> misconceptions{
    TUMBLE_UNIT,
    {{"faces taken for triangles",
      "You looked at only the first three corners of each face. Faces may have more.",
      "Back up again",
      [](const Polyhedron& body) {
        Polyhedron triangles = body;
        for (std::vector<int>& face : triangles.faces)
          face.resize(std::min<std::size_t>(face.size(), 3));
        return reference(triangles);
      }},
     {"plane of the first three corners",
      "You are right until the first three corners of a face lie on one line: then they don't tell "
      "you the plane. All corners together do.",
      "Back up again",
      [](const Polyhedron& body) {
        return with_view(body, [](const Corners& corners, View) {
          return view_of({corners[0], corners[1], corners[2]});
        });
      }},
     {"faces left out that begin straight",
      "You left out a face whose first three corners lie on one line, as if it had no area. Look "
      "at all of its corners before you say so.",
      "Back up again",
      [](const Polyhedron& body) {
        return over_faces(body, [](const Corners& corners) {
          const Vec3 first = tumble::mirtich::vector_area({{corners[0], corners[1], corners[2]}});
          return first.isZero(0) ? zero() : of_face(corners, view_of(corners));
        });
      }},
     {"shadows always along z",
      "You cast all shadows along z. An upright wall has none there, and one that "
      "is nearly upright has a very thin one: choose the axis face by face.",
      "Back up again",
      [](const Polyhedron& body) {
        return with_view(body, [](const Corners&, View view) {
          view.gamma = 2;
          return view;
        });
      }},
     {"largest, but not in size",
      "You chose the axis by the largest number of the normal, so you took −1 for smaller than 0. "
      "The size counts, whatever the sign.",
      "Back up again",
      [](const Polyhedron& body) {
        return with_view(body, [](const Corners&, View view) {
          view.plane.n.maxCoeff(&view.gamma);
          return view;
        });
      }},
     {"w with the wrong sign",
      "You put each plane on the other side of the origin. Put a corner into n · x + w: you must "
      "get 0.",
      "Back up again",
      [](const Polyhedron& body) {
        return with_view(body, [](const Corners&, View view) {
          view.plane.w *= -1;
          return view;
        });
      }},
     {"left under α, β, γ",
      "You stored under x, y and z what belongs to α, β and γ. Which axes these are is different "
      "for each face.",
      "Back up again",
      [](const Polyhedron& body) {
        return over_faces(body, [](const Corners& corners) {
          const View view = view_of(corners);
          const VolumeIntegrals v = of_face(corners, view);
          const int C = view.gamma;
          return VolumeIntegrals{v.one, in_cycle(v.r, C), in_cycle(v.squares, C),
                                 in_cycle(v.products, C)};
        });
      }},
     {"½ and ⅓ forgotten",
      "Your volume is right, the others are too large, by a factor of 2 or 3. The surface "
      "integral holds an integral of the power: divide by the new exponent.",
      "From a volume to its surface",
      [](const Polyhedron& body) -> VolumeIntegrals {
        const VolumeIntegrals v = reference(body);
        return {v.one, 2 * v.r, 3 * v.squares, 2 * v.products};
      }},
     {"normal left out",
      "You added up the integrals over the faces without their normals. They tell apart where a "
      "rod enters the body and where it leaves.",
      "From a volume to its surface",
      [](const Polyhedron& body) {
        return over_faces(body, [](const Corners& corners) {
          return of_face(corners, view_of(corners), Vec3::Ones());
        });
      }},
     {"thrice the volume",
      "Your volume is three times too large. Along x, along y and along z: each of the three sums "
      "is the whole volume already.",
      "Back up again",
      [](const Polyhedron& body) {
        VolumeIntegrals v = reference(body);
        v.one *= 3;
        return v;
      }},
     {"volume along another axis on each face",
      "You took the volume along α, which is another axis on each face. Take one and the same axis "
      "for all of them, or the mean of all three.",
      "Back up again",
      [](const Polyhedron& body) {
        VolumeIntegrals v = reference(body);
        v.one = over_faces(body, [](const Corners& corners) {
                  const View view = view_of(corners);
                  const auto f = tumble::mirtich::face_integrals(
                      tumble::mirtich::projection_integrals(corners, view.gamma), view.plane,
                      view.gamma);
                  VolumeIntegrals sum = zero();
                  sum.one = view.plane.n[(view.gamma + 1) % 3] * f.a;
                  return sum;
                }).one;
        return v;
      }},
     {"products in the order xy, zx, yz",
      "You swapped the last two products: the cycle is xy, yz, zx.", "From a volume to its surface",
      [](const Polyhedron& body) {
        VolumeIntegrals v = reference(body);
        std::swap(v.products[1], v.products[2]);
        return v;
      }},
     {"cones all counted as positive",
      "You always added what lies between a face and the origin. If the origin sees the face's "
      "front, take it off.",
      "From a volume to its surface",
      [](const Polyhedron& body) {
        return over_faces(body, [](const Corners& corners) {
          const VolumeIntegrals v = of_cone(corners);
          return (v.one < 0 ? -1 : 1) * v;
        });
      }},
     {"area counted twice",
      "You count the area of each face twice. The face's integrals have the area in them already; "
      "you multiply them by a normal that you did not scale to length 1.",
      "Back up again",
      [](const Polyhedron& body) {
        return over_faces(body, [](const Corners& corners) {
          return tumble::mirtich::vector_area(corners).norm() * of_face(corners, view_of(corners));
        });
      }},
     {"a face without area spoils all",
      "You are right until a face has no area. Its normal is 0 divided by 0, which is not a "
      "number, and neither is anything that you add it to.",
      "Back up again",
      [](const Polyhedron& body) {
        VolumeIntegrals sum = zero();
        for (const std::vector<int>& face : body.faces) {
          const Corners corners = corners_of(body, face);
          if (!corners.empty()) sum = sum + of_face(corners, view_of(corners));
        }
        return sum;
      }},
     {"small faces left out",
      "You left out faces with an area below some small number, and so a tiny body lost all of its "
      "surface. What is small depends on how large the body is: only 0 is always small.",
      "Back up again",
      [](const Polyhedron& body) {
        return over_faces(body, [](const Corners& corners) {
          constexpr double small = 1e-10;
          return tumble::mirtich::vector_area(corners).norm() < small
                     ? zero()
                     : of_face(corners, view_of(corners));
        });
      }},
     {"last face left out", "You did not look at the last face: check where your loop ends.",
      "From a volume to its surface",
      [](const Polyhedron& body) {
        Polyhedron open = body;
        if (!open.faces.empty()) open.faces.pop_back();
        return reference(open);
      }},
     {"made positive",
      "You made the negative integrals of a body inside out positive. Then nobody can see that "
      "something is wrong with it; and a cavity is such a body.",
      "What breaks",
      [](const Polyhedron& body) {
        const VolumeIntegrals v = reference(body);
        return (v.one < 0 ? -1 : 1) * v;
      }},
     {"about the middle of the body",
      "You integrated about the mean of the vertices. Here we want the integrals about the origin "
      "of the coordinates.",
      "Mass, centre and inertia", [](const Polyhedron& body) {
        Vec3 middle = Vec3::Zero();
        for (const Vec3& x : body.vertices) middle += x / static_cast<double>(body.vertices.size());
        Polyhedron moved = body;
        for (Vec3& x : moved.vertices) x -= middle;
        return reference(moved);
      }}}};
