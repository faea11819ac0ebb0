/// @file
/// 8.1 projection_integrals: its laws, and what goes wrong.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "08_mirtich/contract.hpp"
#include "08_mirtich/shapes.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/mass/mirtich/volume_integrals.hpp"

using namespace tumble::judge;
using mirtich::ProjectionIntegrals;
using tumble::Mat3, tumble::Vec3;

namespace student {
const Function<decltype(mirtich::projection_integrals)> projection_integrals{TUMBLE_UNIT};
}

namespace {

/// The ten integrals by their number, and the powers of α and β in each.
constexpr int count = 10;
constexpr double ProjectionIntegrals::*integral[count] = {
    &ProjectionIntegrals::one, &ProjectionIntegrals::a,   &ProjectionIntegrals::b,
    &ProjectionIntegrals::aa,  &ProjectionIntegrals::ab,  &ProjectionIntegrals::bb,
    &ProjectionIntegrals::aaa, &ProjectionIntegrals::aab, &ProjectionIntegrals::abb,
    &ProjectionIntegrals::bbb};
constexpr int power_of_a[count] = {0, 1, 0, 2, 1, 0, 3, 2, 1, 0};
constexpr int power_of_b[count] = {0, 0, 1, 0, 1, 2, 0, 1, 2, 3};

/// Each integral as `f(i, j)` gives it.
template <class F>
ProjectionIntegrals each(const F& f) {
  ProjectionIntegrals p{};
  for (int k = 0; k < count; ++k) p.*integral[k] = f(power_of_a[k], power_of_b[k]);
  return p;
}

ProjectionIntegrals operator*(double factor, ProjectionIntegrals p) {
  for (const auto& member : integral) p.*member *= factor;
  return p;
}

ProjectionIntegrals operator+(ProjectionIntegrals p, const ProjectionIntegrals& q) {
  for (const auto& member : integral) p.*member += q.*member;
  return p;
}

ProjectionIntegrals reference(const Corners& corners, int gamma) {
  const auto p = tumble::mirtich::projection_integrals(corners, gamma);
  return {p.one, p.a, p.b, p.aa, p.ab, p.bb, p.aaa, p.aab, p.abb, p.bbb};
}

/// How far ∬ αⁱβʲ may be off, i + j = degree. With n corners no farther than M, an edge brings at
/// most 2 Mᵈ⁺², off by 16 eps, or n eps where n of them are added up; on either side.
double rounding(const Corners& corners, int degree) {
  const double n = static_cast<double>(corners.size());
  return 4 * (16 + n) * n * eps * std::pow(farthest(corners), degree + 2);
}

/// How far any of them may be off.
double rounding(const Corners& corners) {
  return std::fmax(rounding(corners, 0), rounding(corners, 3));
}

/// By how many times its own rounding the worst of the integrals is off.
double error(const ProjectionIntegrals& p, const ProjectionIntegrals& expected,
             const Corners& corners) {
  double worst = 0;
  for (int k = 0; k < count; ++k) {
    const double off = std::abs(p.*integral[k] - expected.*integral[k]);
    const double ratio = off / rounding(corners, power_of_a[k] + power_of_b[k]);
    if (!(ratio <= worst)) worst = ratio;  // a NaN stays
  }
  return worst;
}

/// A polygon of any shape, anywhere, turned in any way.
Corners any_polygon(int n, const Vec3& middle) {
  const Corners star = any_star(n, 1.5);
  return mapped(star, any_rotation(), middle);
}

Corners any_polygon(int n) { return any_polygon(n, any_vector(1.5)); }

/// Corners at these (α, β), and anywhere along γ.
Corners at(const std::vector<std::pair<double, double>>& places, int gamma) {
  Corners corners;
  for (const auto& [a, b] : places) {
    Vec3 x;
    x[(gamma + 1) % 3] = a;
    x[(gamma + 2) % 3] = b;
    x[gamma] = any_number(-1, 1);
    corners.push_back(x);
  }
  return corners;
}

/// ∬ αⁱβʲ over the rectangle [a0, a1] × [b0, b1].
ProjectionIntegrals of_rectangle(double a0, double a1, double b0, double b1) {
  const auto strip = [](double from, double to, int n) {
    return (std::pow(to, n + 1) - std::pow(from, n + 1)) / (n + 1);
  };
  return each([&](int i, int j) { return strip(a0, a1, i) * strip(b0, b1, j); });
}

// ── Mistakes ──

/// The sum of `term(p, q, i, j)` over the shadow's edges, each from p to q.
template <class Term>
ProjectionIntegrals over_edges(const Corners& corners, int gamma, const Term& term) {
  const int alpha = (gamma + 1) % 3, beta = (gamma + 2) % 3;
  return each([&](int i, int j) {
    double sum = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vec3 &p = corners[k], &q = corners[(k + 1) % corners.size()];
      sum += term(Eigen::Vector2d(p[alpha], p[beta]), Eigen::Vector2d(q[alpha], q[beta]), i, j);
    }
    return sum;
  });
}

/// What comes out if the mean of αⁱ⁺¹βʲ along an edge is guessed by `mean(p, q, f)`.
template <class Mean>
ProjectionIntegrals with_mean(const Corners& corners, int gamma, const Mean& mean) {
  return over_edges(corners, gamma,
                    [&](const Eigen::Vector2d& p, const Eigen::Vector2d& q, int i, int j) {
                      const auto f = [&](const Eigen::Vector2d& x) {
                        return std::pow(x[0], i + 1) * std::pow(x[1], j);
                      };
                      return (q[1] - p[1]) * mean(p, q, f) / (i + 1);
                    });
}

bool has_upright_edge(const Corners& corners, int gamma) {
  const int alpha = (gamma + 1) % 3;
  for (std::size_t k = 0; k < corners.size(); ++k)
    if (corners[k][alpha] == corners[(k + 1) % corners.size()][alpha]) return true;
  return false;
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any polygon anywhere, its shadow cast along any axis") {
    const auto demand = [](const Corners& corners, int gamma) {
      REQUIRE(student::projection_integrals(corners, gamma) ==
              close_to(reference(corners, gamma), rounding(corners)));
    };
    for (const int n : {5, 3, 4, 8, 12}) {
      const Corners corners = any_polygon(n);
      for (int gamma = 0; gamma < 3; ++gamma) {
        // Counter-clockwise first, so that a sign that is always wrong shows as such.
        const bool positive = reference(corners, gamma).one > 0;
        demand(positive ? corners : reversed(corners), gamma);
        demand(positive ? reversed(corners) : corners, gamma);
      }
    }
  }

  TEST_CASE("rectangles along the axes: integrals from school, wherever the corners are along γ") {
    for (int gamma = 0; gamma < 3; ++gamma) {
      const Corners square = at({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, gamma);
      REQUIRE(student::projection_integrals(square, gamma) ==
              close_to(of_rectangle(0, 1, 0, 1), rounding(square)));
      const double a0 = any_number(-2, 0), a1 = any_number(0.5, 2);
      const double b0 = any_number(-2, 1), b1 = any_number(1.5, 3);
      const Corners any = at({{a0, b0}, {a1, b0}, {a1, b1}, {a0, b1}}, gamma);
      REQUIRE(student::projection_integrals(any, gamma) ==
              close_to(of_rectangle(a0, a1, b0, b1), rounding(any)));
    }
  }

  TEST_CASE("round one way the right integrals, round the other way the same with a minus") {
    for (int n = 3; n < 8; ++n) {
      const Corners corners = any_polygon(n);
      const int gamma = n % 3;
      const ProjectionIntegrals p = reference(corners, gamma);
      REQUIRE(student::projection_integrals(corners, gamma) == close_to(p, rounding(corners)));
      REQUIRE(student::projection_integrals(reversed(corners), gamma) ==
              close_to(-1 * p, rounding(corners)));
    }
  }

  TEST_CASE("an L and a U: what a dent takes away is not counted") {
    for (int gamma = 0; gamma < 3; ++gamma) {
      const Corners L = at({{1, 1}, {1, 3}, {0, 3}, {0, 0}, {2, 0}, {2, 1}}, gamma);
      const ProjectionIntegrals of_L = of_rectangle(0, 1, 0, 3) + of_rectangle(1, 2, 0, 1);
      REQUIRE(student::projection_integrals(L, gamma) == close_to(of_L, rounding(L)));
      const Corners U = at({{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, gamma);
      const ProjectionIntegrals of_U = of_rectangle(0, 3, 0, 2) + -1 * of_rectangle(1, 2, 1, 2);
      REQUIRE(student::projection_integrals(U, gamma) == close_to(of_U, rounding(U)));
    }
  }

  TEST_CASE("cut in two, the parts are right and add up to the whole, wherever the cut goes") {
    for (int n = 0; n < 6; ++n) {
      const Vec3 centre = any_vector(1.5);
      const Corners corners = any_polygon(7, centre);
      // From the first corner to the centre, and on to one of the others.
      Corners first(corners.begin(), corners.begin() + n + 1);
      Corners second(corners.begin() + n, corners.end());
      second.push_back(corners.front());
      first.push_back(centre);
      second.push_back(centre);
      const int gamma = n % 3;
      const auto p = student::projection_integrals(first, gamma);
      REQUIRE(p == close_to(reference(first, gamma), rounding(first)));
      const auto q = student::projection_integrals(second, gamma);
      REQUIRE(q == close_to(reference(second, gamma), rounding(second)));
      REQUIRE(
          student::projection_integrals(corners, gamma) ==
          close_to(p.value() + q.value(), rounding(corners) + rounding(first) + rounding(second)));
    }
  }

  TEST_CASE(
      "wherever it begins, with corners twice or in the middle of an edge: right all the same") {
    for (int n = 0; n < 5; ++n) {
      const Corners corners = any_polygon(5);
      const int gamma = n % 3;
      const ProjectionIntegrals expected = reference(corners, gamma);
      Corners other = corners;
      std::rotate(other.begin(), other.begin() + n, other.end());
      REQUIRE(student::projection_integrals(other, gamma) == close_to(expected, rounding(other)));
      other.insert(other.begin() + n, other[static_cast<std::size_t>(n)]);
      other.push_back(other.front());
      REQUIRE(student::projection_integrals(other, gamma) == close_to(expected, rounding(other)));
      other.push_back((3 * other.front() + other[1]) / 4);
      std::rotate(other.begin() + 1, other.end() - 1, other.end());  // to where it belongs
      REQUIRE(student::projection_integrals(other, gamma) == close_to(expected, rounding(other)));
    }
  }

  TEST_CASE("a shadow without area (edge-on, there and back, one corner, none): all integrals 0") {
    const ProjectionIntegrals nothing{};
    for (int gamma = 0; gamma < 3; ++gamma) {
      Corners edge_on = any_star(6);
      Mat3 stand;  // the plane of α and γ
      stand << Vec3::Unit((gamma + 1) % 3), Vec3::Unit(gamma), Vec3::Unit((gamma + 2) % 3);
      edge_on = mapped(edge_on, stand, any_vector());
      const Vec3 p = any_vector(2), q = any_vector(2);
      for (const Corners& corners : {edge_on, Corners{p, q}, Corners{p, q, (p + q) / 2},
                                     Corners{p, p, p}, Corners{p}, Corners{}})
        REQUIRE(student::projection_integrals(corners, gamma) ==
                close_to(nothing, rounding(corners)));
    }
  }

  TEST_CASE("tiny and huge polygons, and some far away: each integral to its own rounding") {
    for (const double size : {1e-40, 1e-8, 1e8, 1e40}) {
      const Corners corners = mapped(any_polygon(6), size * Mat3::Identity(), Vec3::Zero());
      for (int gamma = 0; gamma < 3; ++gamma) {
        const auto p = student::projection_integrals(corners, gamma);
        REQUIRE(p == obeys("every integral is right to its rounding",
                           error(p, reference(corners, gamma), corners), 1));
      }
    }
    for (const double far : {10., 1e3, 1e6}) {
      const Corners corners = any_polygon(6, far * any_direction());
      for (int gamma = 0; gamma < 3; ++gamma) {
        const auto p = student::projection_integrals(corners, gamma);
        REQUIRE(p == obeys("every integral is right to its rounding",
                           error(p, reference(corners, gamma), corners), 1));
      }
    }
  }
}

const Misconceptions<decltype(mirtich::projection_integrals)> misconceptions{
    TUMBLE_UNIT,
    {{"last edge left out",
      "You left out the edge from the last corner to the first one. Only a closed walk encloses "
      "anything: look at where your loop ends.",
      "From the shadow to its edges",
      [](const Corners& corners, int gamma) -> ProjectionIntegrals {
        if (corners.size() < 2) return reference(corners, gamma);
        const Vec3 &last = corners.back(), &first = corners.front();
        // Only the closing edge: the whole minus the way from the first corner to the last.
        const int alpha = (gamma + 1) % 3, beta = (gamma + 2) % 3;
        tumble::mirtich::ProjectionIntegrals e;
        tumble::mirtich::add_edge(e, {last[alpha], last[beta]}, {first[alpha], first[beta]});
        return reference(corners, gamma) +
               -1 * ProjectionIntegrals{e.one / 2, e.a / 6,    e.b / 6,    e.aa / 12,  e.ab / 24,
                                        e.bb / 12, e.aaa / 20, e.aab / 60, e.abb / 60, e.bbb / 20};
      }},
     {"area always positive",
      "You made the area positive, and with it all the rest. A shadow that goes round clockwise "
      "belongs to a face that looks the other way. The sign tells them apart.",
      "From a face to its shadow",
      [](const Corners& corners, int gamma) {
        const ProjectionIntegrals p = reference(corners, gamma);
        return (p.one < 0 ? -1 : 1) * p;
      }},
     {"only the area without its sign",
      "You made the area positive, while your other integrals keep their sign. The area is "
      "negative where the corners go round clockwise.",
      "From a face to its shadow",
      [](const Corners& corners, int gamma) {
        ProjectionIntegrals p = reference(corners, gamma);
        p.one = std::abs(p.one);
        return p;
      }},
     {"minus in front of dα forgotten",
      "The integrals that you took with dα have the wrong sign. Round the same edge, Green's "
      "theorem has a plus with dβ and a minus with dα.",
      "From the shadow to its edges",
      [](const Corners& corners, int gamma) {
        ProjectionIntegrals p = reference(corners, gamma);
        for (double* with_da : {&p.b, &p.bb, &p.bbb, &p.abb}) *with_da *= -1;
        return p;
      }},
     {"clockwise taken for positive",
      "All your signs are wrong: you count a shadow as positive if its corners go round clockwise.",
      "From the shadow to its edges",
      [](const Corners& corners, int gamma) { return -1 * reference(corners, gamma); }},
     {"α and β swapped",
      "You swapped α and β. They follow γ in a cycle, α first: after z comes x again.",
      "From a face to its shadow",
      [](const Corners& corners, int gamma) {
        const ProjectionIntegrals p = reference(corners, gamma);
        return -1 *
               ProjectionIntegrals{p.one, p.b, p.a, p.bb, p.ab, p.aa, p.bbb, p.abb, p.aab, p.aaa};
      }},
     {"x before z",
      "Along x and z you are right, along y you are not: there you swapped α and β. In the cycle z "
      "comes before x.",
      "From a face to its shadow",
      [](const Corners& corners, int gamma) {
        const ProjectionIntegrals p = reference(corners, gamma);
        if (gamma != 1) return p;
        return -1 *
               ProjectionIntegrals{p.one, p.b, p.a, p.bb, p.ab, p.aa, p.bbb, p.abb, p.aab, p.aaa};
      }},
     {"always along z", "You cast the shadow along z, whatever γ is.", "From a face to its shadow",
      [](const Corners& corners, int) { return reference(corners, 2); }},
     {"true size instead of the shadow's",
      "You integrated over the polygon itself, with its true area. The shadow of a plane that "
      "leans is smaller.",
      "From a face to its shadow",
      [](const Corners& corners, int gamma) {
        const Vec3 area = tumble::mirtich::vector_area(corners);
        return area.norm() / std::abs(area[gamma]) * reference(corners, gamma);
      }},
     {"edges as their midpoints",
      "You took each edge as its midpoint. That is exact for the area alone: along an edge, the "
      "mean of a square is larger than the square of the mean.",
      "From the shadow to its edges",
      [](const Corners& corners, int gamma) {
        return with_mean(corners, gamma, [](const auto& p, const auto& q, const auto& f) {
          return f(Eigen::Vector2d((p + q) / 2));
        });
      }},
     {"edges as their two ends",
      "Along each edge you took the mean of its two ends. That is exact for the area alone: "
      "between the ends, a square lies below the straight line from one to the other.",
      "From the shadow to its edges",
      [](const Corners& corners, int gamma) {
        return with_mean(corners, gamma, [](const auto& p, const auto& q, const auto& f) {
          return (f(p) + f(q)) / 2;
        });
      }},
     {"i + 1 forgotten",
      "Your integrals are too large, by a factor of 2, 3 or 4. Green's theorem raises a power by "
      "one; divide by the new exponent, as in every integral of a power.",
      "From the shadow to its edges",
      [](const Corners& corners, int gamma) {
        ProjectionIntegrals p = reference(corners, gamma);
        for (int k = 0; k < count; ++k) {
          // As the integrals are taken with dβ, but those of pure powers of β and of αβ² with dα.
          const int i = power_of_a[k], j = power_of_b[k];
          p.*integral[k] *= j > i ? j + 1 : i + 1;
        }
        return p;
      }},
     {"α²β and αβ² swapped", "You swapped the integrals of α²β and αβ²; all others are right.",
      "From the shadow to its edges",
      [](const Corners& corners, int gamma) {
        ProjectionIntegrals p = reference(corners, gamma);
        std::swap(p.aab, p.abb);
        return p;
      }},
     {"mixed ones as products of means",
      "You took the product of the means for the mean of the product. Along an edge α and β change "
      "together.",
      "From the shadow to its edges",
      [](const Corners& corners, int gamma) {
        ProjectionIntegrals p = reference(corners, gamma);
        p.ab = p.a * p.b / p.one;
        p.aab = p.aa * p.b / p.one;
        p.abb = p.a * p.bb / p.one;
        return p;
      }},
     {"fan of positive triangles",
      "You counted all triangles from the first corner as positive. Where there is a dent, one of "
      "them goes round the other way, and you have to take it off again.",
      "Back up again",
      [](const Corners& corners, int gamma) {
        ProjectionIntegrals p = reference(corners, gamma);
        const double sign = p.one < 0 ? -1 : 1;
        p = {};
        for (std::size_t k = 2; k < corners.size(); ++k) {
          const ProjectionIntegrals part =
              reference({corners[0], corners[k - 1], corners[k]}, gamma);
          p = p + (part.one * sign < 0 ? -1 : 1) * part;
        }
        return p;
      }},
     {"divided by the slope of an edge",
      "You are right until an edge has the same α at both ends: there its slope is infinite, or 0 "
      "divided by 0. Follow the edge by a parameter that runs from 0 to 1 instead.",
      "From the shadow to its edges", [](const Corners& corners, int gamma) -> ProjectionIntegrals {
        if (!has_upright_edge(corners, gamma)) return reference(corners, gamma);
        return each([](int, int) { return std::numeric_limits<double>::quiet_NaN(); });
      }}}};
