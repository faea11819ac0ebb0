/// @file
/// 11.5 collide: its laws, and what goes wrong.
#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "11_when_bodies_meet/contract.hpp"
#include "judge/spec/shared/impacts.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/contact/impact.hpp"

using namespace impacts;

namespace student {
const Function<decltype(when_bodies_meet::collide)> collide{TUMBLE_UNIT};
}

namespace {

/// What K answers along n to an impulse along n.
double answer_along(const Vec3& n, const Mat3& K) { return n.transpose() * K * n; }

/// What a question consists of.
struct Impact {
  Mat3 K;
  Vec3 u, n;
  double e;

  double u_n() const { return u.dot(n); }
  double n_K_n() const { return answer_along(n, K); }
  Vec3 after(const Vec3& impulse) const { return u + K * impulse; }
};

/// The right impulse has this length; it is negative where the bodies part.
double strength(const Impact& c) { return -(1 + c.e) * c.u_n() / c.n_K_n(); }

Vec3 right(const Impact& c) { return c.u_n() < 0 ? Vec3(strength(c) * c.n) : Vec3(Vec3::Zero()); }

Answer<Vec3> ask(const Impact& c) { return student::collide(c.K, c.u, c.n, c.e); }

/// u·n is off by 3 roundings of |u|, and n·K n by 6 of the norm of K; the length of n adds 6 of
/// each. On either side.
double rounding(const Impact& c) {
  return eps * (24 * (1 + c.e) * c.u.norm() + 32 * std::abs(strength(c)) * c.K.norm()) / c.n_K_n();
}

double any_e() { return any_number(0.1, 0.9); }

/// An impact in which u·n is at least a tenth of |u|.
Impact between(const Mat3& K, const Vec3& u) {
  Vec3 n = any_direction();
  while (std::abs(u.dot(n)) < 0.1 * u.norm()) n = any_direction();
  return {K, u, u.dot(n) < 0 ? n : Vec3(-n), any_e()};
}

Impact any_impact() {
  const Meeting meeting;
  return between(meeting.K(), meeting.u());
}

Impact any_parting() {
  Impact impact = any_impact();
  impact.n = -impact.n;
  return impact;
}

/// The right impulse, but for the factor that `law` gives, where the bodies come together.
template <class Law>
auto along_normal(Law law) {
  return [law](const Mat3& K, const Vec3& u, const Vec3& n, double e) -> Vec3 {
    if (u.dot(n) >= 0) return Vec3::Zero();
    return law(K, u.dot(n), n, e) * n;
  };
}

/// The right impulse with another e.
template <class Law>
auto with_e(Law law) {
  return [law](const Mat3& K, const Vec3& u, const Vec3& n, double e) -> Vec3 {
    return right({K, u, n, law(e)});
  };
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any two bodies that come together, or part, at any point") {
    for (int n = 0; n < 40; ++n) {
      const Impact impact = n % 4 == 3 ? any_parting() : any_impact();
      REQUIRE(ask(impact) == close_to(right(impact), rounding(impact)));
    }
  }

  TEST_CASE("as the library has it") {
    for (int n = 0; n < 10; ++n) {
      const Impact impact = any_impact();
      const tumble::contact::Impact same{impact.K, impact.u, impact.n, impact.e, 0};
      REQUIRE(ask(impact) == close_to(tumble::contact::collide(same).impulse, rounding(impact)));
    }
  }

  TEST_CASE("the impulse is along the normal, and u·n becomes −e times what it was") {
    for (const double e : {0., 0.5, 1.}) {
      Impact impact = any_impact();
      impact.e = e;
      const auto j = ask(impact);
      REQUIRE(j == close_to(right(impact), rounding(impact)));
      REQUIRE(j == obeys("the impulse is along the normal",
                         (j.value() - j->dot(impact.n) * impact.n).norm(), 2 * rounding(impact)));
      REQUIRE(j == obeys("u·n becomes −e u·n",
                         std::abs(impact.after(j).dot(impact.n) + e * impact.u_n()),
                         2 * impact.K.norm() * rounding(impact)));
    }
  }

  TEST_CASE("both bodies together lose the energy ½ (1 − e²) (u·n)²/(n·K n), and no more") {
    for (int n = 0; n < 10; ++n) {
      const Meeting meeting;
      Impact impact = between(meeting.K(), meeting.u());
      if (n < 2) impact.e = n;  // all of it, or none
      const auto j = ask(impact);
      REQUIRE(j == close_to(right(impact), rounding(impact)));
      const Meeting after = meeting.after(j);
      const double lost =
          (1 - impact.e * impact.e) * impact.u_n() * impact.u_n() / (2 * impact.n_K_n());
      // ω is off by up to 160 roundings on either side, and so is the energy of each state.
      const auto size = [](const Body& body, const State& s) {
        return s.P.squaredNorm() / body.mass + body.I_body_inv.norm() * s.L.squaredNorm();
      };
      const double energies = size(meeting.a, meeting.state_a) + size(meeting.b, meeting.state_b) +
                              size(after.a, after.state_a) + size(after.b, after.state_b);
      REQUIRE(j == obeys("the energy of both falls by ½ (1 − e²) (u·n)²/(n·K n)",
                         std::abs(meeting.energy() - after.energy() - lost),
                         320 * eps * energies + 2 * impact.u.norm() * rounding(impact)));
    }
  }

  TEST_CASE("bodies that part, slide along each other or rest get no impulse") {
    for (int n = 0; n < 5; ++n) {
      Impact impact = any_parting();
      REQUIRE(ask(impact) == close_to(Vec3(Vec3::Zero()), 0));
      impact.n = Vec3::Unit(n % 3);
      impact.u[n % 3] = 0;  // so that u·n is 0 to the last bit
      REQUIRE(ask(impact) == close_to(Vec3(Vec3::Zero()), 0));
      impact.u.setZero();
      REQUIRE(ask(impact) == close_to(Vec3(Vec3::Zero()), 0));
    }
  }

  TEST_CASE("with e = 1 the impulse is right, and the film runs backwards as well") {
    for (int n = 0; n < 5; ++n) {
      Impact impact = any_impact();
      impact.e = 1;
      const auto j = ask(impact);
      REQUIRE(j == close_to(right(impact), rounding(impact)));
      Impact back = impact;
      back.u = -impact.after(j);
      REQUIRE(ask(back) == close_to(j.value(), 4 * (rounding(impact) + rounding(back))));
    }
  }

  TEST_CASE(
      "the right impulse: for swapped bodies the opposite one, in a turned world a turned one") {
    for (int n = 0; n < 5; ++n) {
      const Impact impact = any_impact();
      const Impact swapped{impact.K, -impact.u, -impact.n, impact.e};
      REQUIRE(ask(swapped) == close_to(Vec3(-right(impact)), rounding(impact)));
      const Mat3 T = any_rotation(), K = T * impact.K * T.transpose();
      const Impact turned{(K + K.transpose()) / 2, T * impact.u, T * impact.n, impact.e};
      REQUIRE(ask(turned) == close_to(Vec3(T * right(impact)), 4 * rounding(impact)));
    }
  }

  TEST_CASE("hardly together, specks of dust, planets, and a body that slips easily") {
    for (const double size : {1e-40, 1e-12, 1e12, 1e40}) {
      Impact impact = any_impact();
      impact.u -= (1 - 1e-9) * impact.u_n() * impact.n;
      REQUIRE(ask(impact) == close_to(right(impact), rounding(impact)));
      impact = any_impact();
      impact.K /= size;
      REQUIRE(ask(impact) == close_to(right(impact), rounding(impact)));
      impact.u *= size;
      REQUIRE(ask(impact) == close_to(right(impact), rounding(impact)));
      impact = any_impact();
      const Mat3 R = any_rotation();
      const Mat3 K = R * Vec3(1, 10, 1000).asDiagonal() * R.transpose();
      impact.K = (K + K.transpose()) / 2;
      REQUIRE(ask(impact) == close_to(right(impact), rounding(impact)));
    }
  }
}

const Misconceptions<decltype(when_bodies_meet::collide)> misconceptions{
    TUMBLE_UNIT,
    {{"pulls together",
      "Your impulse pulls the bodies into each other: its sign is wrong. The normal points out of "
      "the second body, and bodies that come together have a negative u·n.",
      "An impact without friction",
      along_normal([](const Mat3& K, double u_n, const Vec3& n, double e) {
        return u_n * (1 + e) / answer_along(n, K);
      })},
     {"only stopped",
      "Your impulse only stops the bodies, whatever e is. It has to throw them back, too.",
      "An impact without friction", with_e([](double) { return 0.; })},
     {"always thrown back whole", "Your bodies part as fast as they came together, whatever e is.",
      "An impact without friction", with_e([](double) { return 1.; })},
     {"not stopped first",
      "Your impulse is as strong as the throwing back alone needs. It has to stop the bodies "
      "first.",
      "An impact without friction",
      along_normal([](const Mat3& K, double u_n, const Vec3& n, double e) {
        return -e * u_n / answer_along(n, K);
      })},
     {"1 − e",
      "You have e with the wrong sign: the more a ball bounces, the weaker your impulse is.",
      "An impact without friction", with_e([](double e) { return -e; })},
     {"e as a part of the energy",
      "You took e for the part of the energy that comes back. It is the part of the velocity.",
      "An impact without friction", with_e([](double e) { return std::sqrt(e); })},
     {"whole velocity turned round",
      "You turned the whole velocity round, not only the part along the normal. A smooth surface "
      "can't push along itself.",
      "An impact without friction",
      [](const Mat3& K, const Vec3& u, const Vec3& n, double e) -> Vec3 {
        if (u.dot(n) >= 0) return Vec3::Zero();
        return (-1 - e) * (K.inverse() * u);
      }},
     {"against the velocity",
      "Your impulse is along the velocity, not along the normal. A smooth surface pushes along its "
      "normal, however the bodies come.",
      "An impact without friction",
      [](const Mat3& K, const Vec3& u, const Vec3& n, double e) -> Vec3 {
        if (u.dot(n) >= 0) return Vec3::Zero();
        return (-1 - e) * u / answer_along(n, K);
      }},
     {"inverse taken too early",
      "You inverted K and then took its part along the normal. The impulse is along the normal, so "
      "take that part of K first, and then divide by it.",
      "An impact without friction",
      along_normal([](const Mat3& K, double u_n, const Vec3& n, double e) {
        return (-1 - e) * u_n * n.dot(K.inverse() * n);
      })},
     {"change of velocity",
      "You returned by how much u·n changes, in m/s. We ask for the impulse that does it.",
      "An impact without friction",
      along_normal([](const Mat3&, double u_n, const Vec3&, double e) { return (-1 - e) * u_n; })},
     {"multiplied by n·K n",
      "You multiplied by n·K n, where you have to divide: what is easily moved needs less.",
      "An impact without friction",
      along_normal([](const Mat3& K, double u_n, const Vec3& n, double e) {
        return (-1 - e) * u_n * answer_along(n, K);
      })},
     {"along K n",
      "Your impulse is along K n. That is where the point goes; the impulse is along n.",
      "An impact without friction",
      [](const Mat3& K, const Vec3& u, const Vec3& n, double e) -> Vec3 {
        if (u.dot(n) >= 0) return Vec3::Zero();
        return (-1 - e) * u.dot(n) / answer_along(n, K) * (K * n);
      }},
     {"parting bodies held fast",
      "You give an impulse to bodies that part already. A contact can push, but it can't pull.",
      "Which contacts there are",
      [](const Mat3& K, const Vec3& u, const Vec3& n, double e) -> Vec3 {
        return strength({K, u, n, e}) * n;
      }}}};
