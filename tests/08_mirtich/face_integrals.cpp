/// @file
/// 8.2 face_integrals: its laws, and what goes wrong.
#include <cmath>
#include <utility>

#include "08_mirtich/contract.hpp"
#include "08_mirtich/shapes.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/mass/mirtich/volume_integrals.hpp"

using namespace tumble::judge;
using mirtich::FaceIntegrals, mirtich::Plane, mirtich::ProjectionIntegrals;
using tumble::Mat3, tumble::Vec3;

namespace student {
const Function<decltype(mirtich::face_integrals)> face_integrals{TUMBLE_UNIT};
}

namespace {

/// The twelve integrals by their number, and the degree of each.
constexpr int count = 12;
constexpr double FaceIntegrals::*integral[count] = {
    &FaceIntegrals::a,   &FaceIntegrals::b,   &FaceIntegrals::c,   &FaceIntegrals::aa,
    &FaceIntegrals::bb,  &FaceIntegrals::cc,  &FaceIntegrals::aaa, &FaceIntegrals::bbb,
    &FaceIntegrals::ccc, &FaceIntegrals::aab, &FaceIntegrals::bbc, &FaceIntegrals::cca};
constexpr int degree_of[count] = {1, 1, 1, 2, 2, 2, 3, 3, 3, 3, 3, 3};

FaceIntegrals operator*(double factor, FaceIntegrals f) {
  for (const auto& member : integral) f.*member *= factor;
  return f;
}

FaceIntegrals reference(const ProjectionIntegrals& p, const Plane& plane, int gamma) {
  const tumble::mirtich::ProjectionIntegrals shadow{p.one, p.a,   p.b,   p.aa,  p.ab,
                                                    p.bb,  p.aaa, p.aab, p.abb, p.bbb};
  const auto f = tumble::mirtich::face_integrals(shadow, {plane.n, plane.w}, gamma);
  return {f.a, f.b, f.c, f.aa, f.bb, f.cc, f.aaa, f.bbb, f.ccc, f.aab, f.bbc, f.cca};
}

/// A plane polygon in space, which goes round counter-clockwise seen from the tip of its normal.
struct Face {
  Corners corners;
  Plane plane;

  ProjectionIntegrals shadow(int gamma) const {
    const auto p = tumble::mirtich::projection_integrals(corners, gamma);
    return {p.one, p.a, p.b, p.aa, p.ab, p.bb, p.aaa, p.aab, p.abb, p.bbb};
  }
};

/// The polygon, given in the xy plane, in the plane through `middle` with the axes of R.
Face placed(const Corners& polygon, const Mat3& R, const Vec3& middle) {
  const Vec3 n = R.col(2);
  return {mapped(polygon, R, middle), {n, -n.dot(middle)}};
}

/// A face of n corners, leaning in any way.
Face any_face(int n, double size, const Vec3& middle) {
  const Corners polygon = any_star(n, size);
  return placed(polygon, any_rotation(), middle);
}

Face any_face(int n = 5) { return any_face(n, 1.5, any_vector(1.5)); }

/// The axis that n is nearest to.
int best_axis(const Face& face) { return tumble::mirtich::projection_axis(face.plane.n); }

/// How far the integrals of degree d may be off.
///
/// With n corners no farther than M, the shadow's numbers are at most 4 Mᵈ⁺² and come with errors
/// of 4 (16 + n) n eps of Mᵈ⁺². |γ| is replaced by (|n_α| M + |n_β| M + |w|)/|n_γ|, which enlarges
/// both; multiplying out takes 32 roundings on either side.
double rounding(const Face& face, int gamma, int degree) {
  const double n = static_cast<double>(face.corners.size()), M = farthest(face.corners);
  const Vec3 size = face.plane.n.cwiseAbs();
  const double height =
      ((size.sum() - size[gamma]) * M + std::abs(face.plane.w)) / (size[gamma] * M);
  return (256 + 4 * (16 + n) * n) * eps * std::pow(M, degree + 2) *
         std::pow(std::fmax(height, 1), degree) / size[gamma];
}

/// How far any of them may be off.
double rounding(const Face& face, int gamma) {
  return std::fmax(rounding(face, gamma, 1), rounding(face, gamma, 3));
}

/// By how many times its own rounding the worst of the integrals is off.
double error(const FaceIntegrals& f, const FaceIntegrals& expected, const Face& face, int gamma) {
  double worst = 0;
  for (int k = 0; k < count; ++k) {
    const double off = std::abs(f.*integral[k] - expected.*integral[k]);
    const double ratio = off / rounding(face, gamma, degree_of[k]);
    if (!(ratio <= worst)) worst = ratio;  // a NaN stays
  }
  return worst;
}

Answer<FaceIntegrals> ask(const Face& face, int gamma) {
  return student::face_integrals(face.shadow(gamma), face.plane, gamma);
}

/// The integrals if `f(x)` is summed over the face's area by `sum`.
template <class Sum>
FaceIntegrals each(int gamma, const Sum& sum) {
  const int A = (gamma + 1) % 3, B = (gamma + 2) % 3, C = gamma;
  const auto of = [&](int i, int j, int k) {
    return sum([=](const Vec3& x) { return x[i] * x[j] * x[k]; });
  };
  const auto of_first = [&](int i) { return sum([=](const Vec3& x) { return x[i]; }); };
  const auto of_square = [&](int i) { return sum([=](const Vec3& x) { return x[i] * x[i]; }); };
  return {of_first(A),  of_first(B),  of_first(C),   //
          of_square(A), of_square(B), of_square(C),  //
          of(A, A, A),  of(B, B, B),  of(C, C, C),   //
          of(A, A, B),  of(B, B, C),  of(C, C, A)};
}

/// ∬ f dA over the rectangle from `corner` along u and v, exact up to the third power: two Gauss
/// points each way.
template <class F>
double over_rectangle(const Vec3& corner, const Vec3& u, const Vec3& v, const F& f) {
  const double near = (1 - 1 / std::sqrt(3.)) / 2;
  double sum = 0;
  for (const double s : {near, 1 - near})
    for (const double t : {near, 1 - near}) sum += f(Vec3(corner + s * u + t * v));
  return sum / 4 * u.cross(v).norm();
}

/// Integrals in the order of x, y and z, whatever γ was: first powers, squares and cubes, then x²y,
/// y²z, z²x.
Eigen::Matrix<double, 12, 1> in_xyz(const FaceIntegrals& f, int gamma) {
  Eigen::Matrix<double, 12, 1> v;
  for (int k = 0; k < count; ++k) v[k / 3 * 3 + (gamma + 1 + k % 3) % 3] = f.*integral[k];
  return v;
}

/// The reverse: numbers in the order of x, y and z as an answer for γ.
FaceIntegrals from_xyz(const Eigen::Matrix<double, 12, 1>& v, int gamma) {
  FaceIntegrals f{};
  for (int k = 0; k < count; ++k) f.*integral[k] = v[k / 3 * 3 + (gamma + 1 + k % 3) % 3];
  return f;
}

// ── Mistakes ──

/// The integrals with γ = A α + B β + C, dA = stretch dα dβ.
FaceIntegrals with_height(const ProjectionIntegrals& p, double A, double B, double C,
                          double stretch) {
  // With n_γ = 1 the library's γ is −(n_α α + n_β β + w).
  Plane plane{Vec3::Zero(), -C};
  plane.n << -A, -B, 1;
  return stretch * reference(p, plane, 2);
}

/// The numbers of a plane along α, β and γ.
struct Slopes {
  double a, b, c;
  Slopes(const Plane& plane, int gamma)
      : a(plane.n[(gamma + 1) % 3]), b(plane.n[(gamma + 2) % 3]), c(plane.n[gamma]) {}
};

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any face in any plane, its shadow cast along the axis that n is nearest to") {
    const auto demand = [](const Face& face) {
      const int gamma = best_axis(face);
      REQUIRE(ask(face, gamma) ==
              close_to(reference(face.shadow(gamma), face.plane, gamma), rounding(face, gamma)));
    };
    for (const int n : {5, 3, 4, 8, 12}) {
      Face face = any_face(n);
      // From above first, then from below, so that a sign that is always wrong shows as such.
      if (face.plane.n[best_axis(face)] < 0)
        face = {reversed(face.corners), {-face.plane.n, -face.plane.w}};
      demand(face);
      demand({reversed(face.corners), {-face.plane.n, -face.plane.w}});
    }
  }

  TEST_CASE("a leaning rectangle, integrated point by point") {
    for (int n = 0; n < 10; ++n) {
      const Mat3 R = any_rotation();
      const double u = any_number(0.5, 2), v = any_number(0.5, 2);
      const Vec3 corner = any_vector(1.5);
      const Face face = placed({{0, 0, 0}, {u, 0, 0}, {u, v, 0}, {0, v, 0}}, R, corner);
      const int gamma = best_axis(face);
      const FaceIntegrals expected = each(gamma, [&](const auto& f) {
        return over_rectangle(corner, u * R.col(0), v * R.col(1), f);
      });
      REQUIRE(ask(face, gamma) == close_to(expected, rounding(face, gamma)));
    }
  }

  TEST_CASE("a level square at three heights, seen from above and from below: right both times") {
    for (int gamma = 0; gamma < 3; ++gamma) {
      for (const double height : {0., 2., -0.5}) {
        Mat3 axes;
        axes << Vec3::Unit((gamma + 1) % 3), Vec3::Unit((gamma + 2) % 3), Vec3::Unit(gamma);
        const Face above =
            placed({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, axes, height * Vec3::Unit(gamma));
        const Face below{reversed(above.corners), {-above.plane.n, -above.plane.w}};
        const double h2 = height * height;
        const FaceIntegrals expected{1. / 2, 1. / 2, height,  //
                                     1. / 3, 1. / 3, h2,      //
                                     1. / 4, 1. / 4, h2 * height, 1. / 6, height / 3, h2 / 2};
        REQUIRE(ask(above, gamma) == close_to(expected, rounding(above, gamma)));
        REQUIRE(ask(below, gamma) == close_to(expected, rounding(below, gamma)));
      }
    }
  }

  TEST_CASE("along whichever axis the shadow is cast, the face has the same right integrals") {
    for (int n = 0; n < 10; ++n) {
      Face face = any_face();
      while (face.plane.n.cwiseAbs().minCoeff() < 0.1) face = any_face();
      const int best = best_axis(face);
      const auto in_order = in_xyz(reference(face.shadow(best), face.plane, best), best);
      for (const int gamma : {(best + 1) % 3, (best + 2) % 3})
        REQUIRE(ask(face, gamma) ==
                close_to(from_xyz(in_order, gamma), rounding(face, gamma) + rounding(face, best)));
    }
  }

  TEST_CASE("x, y and z renamed in a cycle: the same right numbers under the same letters") {
    Mat3 cycle;  // x to y, y to z, z to x
    cycle << Vec3::UnitY(), Vec3::UnitZ(), Vec3::UnitX();
    for (int n = 0; n < 5; ++n) {
      Face face = any_face();
      int gamma = best_axis(face);
      const FaceIntegrals f = reference(face.shadow(gamma), face.plane, gamma);
      for (int k = 0; k < 2; ++k) {
        face = {mapped(face.corners, cycle, Vec3::Zero()), {cycle * face.plane.n, face.plane.w}};
        gamma = (gamma + 1) % 3;
        REQUIRE(ask(face, gamma) == close_to(f, 2 * rounding(face, gamma)));
      }
    }
  }

  TEST_CASE(
      "a steep plane: the middle of the face lies in it, and all twelve integrals are right") {
    for (const double steep : {0.5, 0.1, 0.01}) {
      for (int gamma = 0; gamma < 3; ++gamma) {
        Vec3 n = any_direction();
        n[gamma] = steep * (n[gamma] < 0 ? -1 : 1) * (n - n[gamma] * Vec3::Unit(gamma)).norm();
        Mat3 R;
        R.col(2) = n.normalized();
        R.col(0) = R.col(2).unitOrthogonal();
        R.col(1) = R.col(2).cross(R.col(0));
        const auto star = any_star(6, 1.5);
        const Face face = placed(star, R, any_vector(1.5));
        const auto f = ask(face, gamma);
        const Slopes m(face.plane, gamma);
        const double area = face.shadow(gamma).one / m.c;
        const double off = m.a * f->a + m.b * f->b + m.c * f->c + face.plane.w * area;
        REQUIRE(f == obeys("n · ∬ x dA + w ∬ dA = 0", std::abs(off),
                           4 * (std::abs(face.plane.w) + 1) * rounding(face, gamma, 1)));
        REQUIRE(f ==
                close_to(reference(face.shadow(gamma), face.plane, gamma), rounding(face, gamma)));
      }
    }
  }

  TEST_CASE("a shadow without area: all zero; a plane through the origin: right as any other") {
    for (int n = 0; n < 5; ++n) {
      Face face = any_face();
      const int gamma = best_axis(face);
      REQUIRE(student::face_integrals(ProjectionIntegrals{}, face.plane, gamma) ==
              close_to(FaceIntegrals{}, 0));
      face = any_face(5, 1, Vec3::Zero());
      face.plane.w = 0;
      const int axis = best_axis(face);
      REQUIRE(ask(face, axis) ==
              close_to(reference(face.shadow(axis), face.plane, axis), rounding(face, axis)));
    }
  }

  TEST_CASE("tiny and huge faces, and some far away: each integral to its own rounding") {
    const auto demand = [](const Face& face) {
      const int gamma = best_axis(face);
      const auto f = ask(face, gamma);
      REQUIRE(f == obeys("every integral is right to its rounding",
                         error(f, reference(face.shadow(gamma), face.plane, gamma), face, gamma),
                         1));
    };
    for (const double size : {1e-40, 1e-8, 1e8, 1e40}) demand(any_face(6, size, any_vector(size)));
    for (const double far : {10., 1e3, 1e6}) demand(any_face(6, 1, far * any_direction()));
  }
}

const Misconceptions<decltype(mirtich::face_integrals)> misconceptions{
    TUMBLE_UNIT,
    {{"γ with the wrong sign",
      "Your odd powers of γ have the wrong sign: you lost a minus when you solved the plane's "
      "equation for γ.",
      "From a face to its shadow",
      [](const ProjectionIntegrals& p, const Plane& plane, int gamma) {
        const Slopes n(plane, gamma);
        return with_height(p, n.a / n.c, n.b / n.c, plane.w / n.c, 1 / n.c);
      }},
     {"n_γ without its sign",
      "Your faces are negative if we see them from below. Their shadow is negative, and the sign "
      "of n_γ, which you dropped, would have made them positive again.",
      "From a face to its shadow",
      [](const ProjectionIntegrals& p, const Plane& plane, int gamma) {
        return (plane.n[gamma] < 0 ? -1 : 1) * reference(p, plane, gamma);
      }},
     {"as large as the shadow",
      "You integrated over the shadow. The face itself is larger, the more it leans, and the "
      "normal tells you by how much.",
      "From a face to its shadow",
      [](const ProjectionIntegrals& p, const Plane& plane, int gamma) {
        return plane.n[gamma] * reference(p, plane, gamma);
      }},
     {"smaller than the shadow",
      "Your face is smaller than its shadow. It is the other way round: what leans casts a smaller "
      "shadow.",
      "From a face to its shadow",
      [](const ProjectionIntegrals& p, const Plane& plane, int gamma) {
        return plane.n[gamma] * plane.n[gamma] * reference(p, plane, gamma);
      }},
     {"w with the wrong sign",
      "You put the plane on the other side of the origin. In n · x + w = 0, w is minus the "
      "distance.",
      "From a face to its shadow",
      [](const ProjectionIntegrals& p, const Plane& plane, int gamma) {
        return reference(p, {plane.n, -plane.w}, gamma);
      }},
     {"w left out", "You are right for planes through the origin alone: you left out w.",
      "From a face to its shadow",
      [](const ProjectionIntegrals& p, const Plane& plane, int gamma) {
        return reference(p, {plane.n, 0}, gamma);
      }},
     {"taken for level",
      "You took γ for the same number all over the face, as if the face did not lean.",
      "From a face to its shadow",
      [](const ProjectionIntegrals& p, const Plane& plane, int gamma) {
        const Slopes n(plane, gamma);
        return with_height(p, 0, 0, -plane.w / n.c, 1 / n.c);
      }},
     {"normal in the order x, y, z",
      "You used the normal's numbers as if α, β and γ were always x, y and z. That is right for "
      "shadows along z alone.",
      "From a face to its shadow",
      [](const ProjectionIntegrals& p, const Plane& plane, int) { return reference(p, plane, 2); }},
     {"n_α and n_β swapped",
      "You swapped the normal's numbers along α and β. α is the axis right after γ.",
      "From a face to its shadow",
      [](const ProjectionIntegrals& p, const Plane& plane, int gamma) {
        Plane swapped = plane;
        std::swap(swapped.n[(gamma + 1) % 3], swapped.n[(gamma + 2) % 3]);
        return reference(p, swapped, gamma);
      }},
     {"γ not divided by n_γ",
      "Each of your γ is too small by a factor n_γ: solve the plane's equation for γ to the end.",
      "From a face to its shadow",
      [](const ProjectionIntegrals& p, const Plane& plane, int gamma) {
        const Slopes n(plane, gamma);
        return with_height(p, -n.a, -n.b, -plane.w, 1 / n.c);
      }},
     {"products between the terms forgotten",
      "In powers of γ you took the sum of the squares for the square of a sum: you left out the "
      "mixed products.",
      "From a face to its shadow",
      [](const ProjectionIntegrals& p, const Plane& plane, int gamma) {
        const Slopes n(plane, gamma);
        const double A = -n.a / n.c, B = -n.b / n.c, C = -plane.w / n.c;
        FaceIntegrals f = reference(p, plane, gamma);
        f.cc = (A * A * p.aa + B * B * p.bb + C * C * p.one) / n.c;
        f.cca = (A * A * p.aaa + B * B * p.abb + C * C * p.a) / n.c;
        f.ccc = (A * A * A * p.aaa + B * B * B * p.bbb + C * C * C * p.one) / n.c;
        return f;
      }},
     {"power of the mean γ",
      "You made γ² and γ³ from the mean height of the face. The mean of a square is larger than "
      "the square of the mean where the face leans.",
      "From a face to its shadow",
      [](const ProjectionIntegrals& p, const Plane& plane, int gamma) {
        FaceIntegrals f = reference(p, plane, gamma);
        const double area = p.one / plane.n[gamma], mean = area != 0 ? f.c / area : 0;
        f.cc = mean * f.c;
        f.ccc = mean * f.cc;
        f.bbc = mean * f.bb;
        f.cca = mean * mean * f.a;
        return f;
      }},
     {"square on the other letter",
      "In the last three, your square is on the second letter instead of the first: you need α²β, "
      "β²γ and γ²α.",
      "Back up again", [](const ProjectionIntegrals& p, const Plane& plane, int gamma) {
        const Slopes n(plane, gamma);
        const double A = -n.a / n.c, B = -n.b / n.c, C = -plane.w / n.c;
        FaceIntegrals f = reference(p, plane, gamma);
        const double cb = A * p.ab + B * p.bb + C * p.b;
        const double caa = A * p.aaa + B * p.aab + C * p.aa;
        const double cab = A * p.aab + B * p.abb + C * p.ab;
        const double cbb = A * p.abb + B * p.bbb + C * p.bb;
        f.aab = p.abb / n.c;
        f.bbc = (A * cab + B * cbb + C * cb) / n.c;
        f.cca = caa / n.c;
        return f;
      }}}};
