// Differentiation of a whole motion: numbers that carry their derivative go through the solvers.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <ostream>

#include "tumble/body/dydt.hpp"
#include "tumble/ode/dop853.hpp"
#include "tumble/ode/dormand_prince_54.hpp"
#include "tumble/ode/integrate_adaptive.hpp"
#include "tumble/ode/integrate_fixed.hpp"
#include "tumble/ode/rk4.hpp"

namespace dual {

/// a + b ε with ε² = 0. Its functions are found beside it, as those of a library's type would be;
/// there is no way from an int to it, as there is none to Ceres' Jet.
struct Dual {
  double a = 0, b = 0;
  Dual() = default;
  template <class Number>
  explicit Dual(Number value, double slope = 0) : a(static_cast<double>(value)), b(slope) {}

  Dual& operator+=(const Dual& y) { return *this = Dual(a + y.a, b + y.b); }
  Dual& operator-=(const Dual& y) { return *this = Dual(a - y.a, b - y.b); }
  Dual& operator*=(const Dual& y) { return *this = Dual(a * y.a, a * y.b + b * y.a); }
  Dual& operator/=(const Dual& y) { return *this = Dual(a / y.a, (b - a / y.a * y.b) / y.a); }
};

Dual operator+(Dual x, const Dual& y) { return x += y; }
Dual operator-(Dual x, const Dual& y) { return x -= y; }
Dual operator*(Dual x, const Dual& y) { return x *= y; }
Dual operator/(Dual x, const Dual& y) { return x /= y; }
Dual operator-(const Dual& x) { return Dual(-x.a, -x.b); }
auto operator<=>(const Dual& x, const Dual& y) { return x.a <=> y.a; }
bool operator==(const Dual& x, const Dual& y) { return x.a == y.a; }
auto operator<=>(const Dual& x, double y) { return x.a <=> y; }
bool operator==(const Dual& x, double y) { return x.a == y; }
std::ostream& operator<<(std::ostream& out, const Dual& x) { return out << x.a; }

Dual sqrt(const Dual& x) { return Dual(std::sqrt(x.a), x.b / (2 * std::sqrt(x.a))); }
Dual abs(const Dual& x) { return x.a < 0 ? -x : x; }
Dual copysign(const Dual& x, const Dual& y) { return std::signbit(y.a) ? -abs(x) : abs(x); }
Dual pow(const Dual& x, const Dual& y) {
  return Dual(std::pow(x.a, y.a), y.a * std::pow(x.a, y.a - 1) * x.b);
}
bool isfinite(const Dual& x) { return std::isfinite(x.a) && std::isfinite(x.b); }

}  // namespace dual

template <>
struct std::numeric_limits<dual::Dual> : std::numeric_limits<double> {
  static dual::Dual epsilon() { return dual::Dual(std::numeric_limits<double>::epsilon()); }
  static dual::Dual quiet_NaN() { return dual::Dual(std::numeric_limits<double>::quiet_NaN()); }
};

template <>
struct Eigen::NumTraits<dual::Dual> : Eigen::NumTraits<double> {
  using Real = dual::Dual;
  using NonInteger = dual::Dual;
  using Nested = dual::Dual;
  using Literal = double;
};

namespace tumble {
namespace {

using dual::Dual;
using Swing = Eigen::Matrix<Dual, 2, 1>;

Swing swing(const Dual&, const Swing& y) { return {y[1], -y[0]}; }

TEST_CASE("A derivative goes through every solver") {
  const Swing start(Dual(1), Dual(0.5, 1));  // the slope is that by the start's velocity
  const auto shows = [](const Swing& end, double error) {
    CHECK(std::abs(end[0].a - (std::cos(2) + 0.5 * std::sin(2))) < error);
    CHECK(std::abs(end[0].b - std::sin(2)) < error);
    CHECK(std::abs(end[1].b - std::cos(2)) < error);
  };
  shows(integrate_fixed<Rk4>(swing, start, Dual(0), Dual(2), 200), 1e-9);
  shows(integrate_adaptive<DormandPrince54>(swing, start, Dual(0), Dual(2), {1e-10, 1e-10}).y,
        1e-8);
  shows(integrate_adaptive<Dop853>(swing, start, Dual(0), Dual(2), {1e-12, 1e-12}).y, 1e-10);
}

/// Where a free body has turned to after a second.
template <class T>
PackedState<T> after_a_second(const T& spin) {
  RigidBodyState<T> start;
  start.x.setConstant(T(0));
  start.P.setConstant(T(0));
  start.q = Quaternion<T>(T(1), T(0), T(0), T(0));
  start.L = Vector3<T>(T(0.1), spin, T(0.3));
  const RigidBody<T> body(2.0, Mat3(Vec3(1, 2, 2.5).asDiagonal()));
  return integrate_fixed<Rk4>(RigidBodyRhs<T>(body), pack(start), T(0), T(1), 100);
}

TEST_CASE("The orientation of a tumbling body, differentiated by its spin") {
  const PackedState<Dual> end = after_a_second(Dual(2, 1));
  const double h = 1e-5;  // differences are good to h² and to rounding / h
  const PackedState<double> difference = (after_a_second(2 + h) - after_a_second(2 - h)) / (2 * h);
  const PackedState<double> value = after_a_second(2.0);
  for (int i = 0; i < 13; ++i) {
    CAPTURE(i);
    CHECK(std::abs(end[i].a - value[i]) < 1e-14);
    CHECK(std::abs(end[i].b - difference[i]) < 1e-9);
  }
}

}  // namespace
}  // namespace tumble
