/// @file
/// 11.6 collide_with_friction: its laws, and what goes wrong.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "11_when_bodies_meet/contract.hpp"
#include "judge/spec/spec.hpp"
#include "tumble/contact/friction_impulse.hpp"

using namespace tumble::judge;
using tumble::Mat3, tumble::Vec3;
using when_bodies_meet::PlanarImpulse;
using Mat2 = Eigen::Matrix2d;
using Vec2 = Eigen::Vector2d;

namespace student {
const Function<decltype(when_bodies_meet::collide_with_friction)> collide_with_friction{
    TUMBLE_UNIT};
}

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// What a question consists of.
struct Contact {
  Mat2 K;
  Vec2 u;
  double e, mu;

  double slip_sign() const { return u[0] > 0 ? 1 : u[0] < 0 ? -1 : 0; }
  /// du_n/dp with a friction f per unit of p.
  double normal_rate(double f) const { return K(1, 1) + K(1, 0) * f; }
  double slip_rate(double f) const { return K(0, 1) + K(0, 0) * f; }
  /// The friction per unit of p that keeps the slip as it is.
  double holding() const { return -K(0, 1) / K(0, 0); }
  bool jammed() const { return u[1] < 0 && u[0] != 0 && normal_rate(-mu * slip_sign()) <= 0; }
  Vec2 after(const Vec2& j) const { return u + K * j; }
  /// ½ (u + u')·j: what both bodies together gain.
  double gain(const Vec2& j) const { return (u + after(j)).dot(j) / 2; }
  /// ½ u·K⁻¹ u: all that an impulse could take.
  double energy() const { return u.dot(K.inverse() * u) / 2; }
};

Answer<PlanarImpulse> ask(const Contact& c) {
  return student::collide_with_friction(c.K, c.u, c.e, c.mu);
}

// ── Right and wrong answers, in parts ──

/// How u_n goes with p: straight on with the rate a up to p = rest, and with the rate b from there.
struct Course {
  double u_n, a, rest, b;
  double friction, friction_at_rest;

  double after_rest(double p) const { return std::fmax(0, p - rest); }
  double u_n_at(double p) const { return u_n + a * std::fmin(p, rest) + b * after_rest(p); }
  Vec2 impulse(double p) const {
    return {friction * std::fmin(p, rest) + friction_at_rest * after_rest(p), p};
  }
  /// The first p after the moment at which u_n grows where it is v; infinite if there is none.
  double where_u_n_is(double v) const {
    if (a > 0 && (v - u_n) / a <= rest) return (v - u_n) / a;
    return std::isinf(rest) || b <= 0 ? never : rest + (v - u_n_at(rest)) / b;
  }
  double closest() const { return where_u_n_is(0); }
  /// ∫ u_n dp from p to q, where the slip doesn't end between them.
  double straight_work(double p, double q) const { return (q - p) * (u_n_at(p) + u_n_at(q)) / 2; }
  double work(double p, double q) const {
    const double middle = std::clamp(rest, p, q);
    return straight_work(p, middle) + straight_work(middle, q);
  }
};

/// The p at which a contact is over.
using End = double (*)(const Course& course, double e);

/// The p at which the part `given` of the work has come back.
double end_by_work(const Course& course, double given) {
  const double p = course.closest(), work = -given * course.work(0, p);
  if (p < course.rest) {
    const double q = p + std::sqrt(2 * work / course.a);
    if (q <= course.rest) return q;
  }
  const double from = std::fmax(p, course.rest), u_n = course.u_n_at(from);
  const double left = work - course.work(p, from);
  return from + (std::sqrt(u_n * u_n + 2 * course.b * left) - u_n) / course.b;
}

double stronge(const Course& course, double e) { return end_by_work(course, e * e); }
double newton(const Course& course, double e) { return course.where_u_n_is(-e * course.u_n); }
double poisson(const Course& course, double e) { return (1 + e) * course.closest(); }

/// e² of the work since the slip has ended, or of all of it if that was later.
double stronge_from_rest(const Course& course, double e) {
  const double p = course.closest(), all = course.work(0, p);
  const double part = course.rest < p ? course.work(course.rest, p) : all;
  return end_by_work(course, all < 0 ? e * e * part / all : 0);
}

/// A friction per unit of p.
using Friction = double (*)(const Contact& c);

double against_slip(const Contact& c) { return -c.mu * c.slip_sign(); }
double held_if_possible(const Contact& c) { return std::clamp(c.holding(), -c.mu, c.mu); }

struct Law {
  Friction of_slip = against_slip, at_rest = held_if_possible;
  End end = stronge;

  Course course(const Contact& c) const {
    const double first = c.u[0] == 0 ? at_rest(c) : of_slip(c), second = at_rest(c);
    const double rate = c.slip_rate(first);
    const double rest = c.u[0] * rate < 0 ? -c.u[0] / rate : never;
    return {c.u[1], c.normal_rate(first), rest, c.normal_rate(second), first, second};
  }
  Vec2 impulse(const Contact& c) const {
    if (c.u[1] >= 0) return Vec2::Zero();
    const Course way = course(c);
    if (std::isinf(way.closest())) return Vec2::Constant(NAN);  // of a wrong law: it has no end
    return way.impulse(end(way, c.e));
  }
  PlanarImpulse operator()(const Contact& c) const {
    return {impulse(c), c.u[1] < 0 && course(c).a <= 0};
  }
};

PlanarImpulse right(const Contact& c) { return Law{}(c); }

/// How a number of the impulse changes with each number of the question, tried and not guessed:
/// each is off by some roundings of the largest that belongs with it, 32 on either side.
double rounding(const Contact& c) {
  constexpr double small = 0x1p-24;
  const Vec2 j = right(c).impulse;
  double sum = small * j.cwiseAbs().maxCoeff();
  const auto add = [&](auto change) {
    Contact other = c;
    change(other);
    sum += (right(other).impulse - j).cwiseAbs().maxCoeff();
  };
  for (const auto& [row, column] : {std::pair(0, 0), {0, 1}, {1, 1}})
    add([&, i = row, k = column](Contact& o) { o.K(i, k) = o.K(k, i) += small * c.K.norm(); });
  for (int i = 0; i < 2; ++i) add([&](Contact& o) { o.u[i] += small * c.u.norm(); });
  add([&](Contact& o) { o.e += small; });
  add([&](Contact& o) { o.mu += small * c.mu; });
  return 64 * eps / small * sum;
}

// ── Contacts ──

/// K in the plane, of a body with this moment of inertia that is hit at the end of `arm`.
Mat2 K_of(double mass, double moment, const Vec2& arm) {
  const Vec2 across(-arm[1], arm[0]);
  return Mat2::Identity() / mass + across * across.transpose() / moment;
}

/// A thin rod at this angle to the floor, hit at its lower end.
Mat2 K_of_rod(double mass, double length, double angle) {
  const Vec2 arm = length / 2 * Vec2(std::cos(angle), -std::sin(angle));
  return K_of(mass, mass * length * length / 12, arm);
}

Mat2 K_of_ball(double mass, double radius) {
  return K_of(mass, 0.4 * mass * radius * radius, {0, -radius});
}

Mat2 K_of_box(double mass, const Vec2& size, double angle) {
  const Vec2 corner = -size / 2;
  const Vec2 arm(std::cos(angle) * corner[0] - std::sin(angle) * corner[1],
                 std::sin(angle) * corner[0] + std::cos(angle) * corner[1]);
  return K_of(mass, mass * size.squaredNorm() / 12, arm);
}

/// Any that is symmetric and positive definite, with a condition number of 200 at most.
Mat2 any_positive_K() {
  const double angle = any_number(-2, 2), soft = any_number(1, 20), stiff = any_number(0.1, 1);
  const Vec2 axis(std::cos(angle), std::sin(angle));
  return stiff * Mat2::Identity() + (soft - stiff) * axis * axis.transpose();
}

/// Of a rod, a box, two boxes, a ball, or of nothing in particular.
Mat2 any_K() {
  const double mass = any_number(0.2, 3), angle = any_number(-1.5, 1.5);
  const auto any_box = [] {
    const Vec2 size{any_number(0.2, 2), any_number(0.2, 2)};
    const double box_mass = any_number(0.2, 3);
    return K_of_box(box_mass, size, any_number(0, 6));
  };
  const double kind = any_number(0, 5);
  if (kind < 1) return K_of_rod(mass, any_number(0.3, 3), angle);
  if (kind < 2) return any_box();
  if (kind < 3) {
    const Mat2 first = any_box();
    return first + any_box();
  }
  if (kind < 3.3) return K_of_ball(mass, any_number(0.1, 1));
  return any_positive_K();
}

Contact any_contact() {
  const double slip = any_number(0.05, 2);
  const Vec2 u{any_number(-1, 1) < 0 ? -slip : slip, any_number(-2, -0.5)};
  return {any_K(), u, any_number(0.1, 0.9), any_number(0.05, 1.5)};
}

/// What becomes of the slip.
enum class Kind { kept, stopped, stopped_late, turned, turned_late, jams };
constexpr Kind kinds[] = {Kind::kept,   Kind::stopped,     Kind::stopped_late,
                          Kind::turned, Kind::turned_late, Kind::jams};

/// Whether a < b by 2 %, at least, of the larger one.
bool clearly_less(double a, double b) {
  return b - a > 0.02 * std::fmax(std::abs(a), std::abs(b)) || (std::isinf(b) && !std::isinf(a));
}

/// Whether this is clearly a contact of that kind: 2 % away from any other.
bool is_clearly(Kind kind, const Contact& c) {
  const Course course = Law{}.course(c);
  const double rest = course.rest, closest = course.closest(), end = stronge(course, c.e);
  if (kind == Kind::jams) return course.a < -0.02 * c.K(1, 1);
  if (course.a < 0.02 * c.K(1, 1)) return false;
  if (kind == Kind::kept) return clearly_less(end, rest);
  const bool is_late = kind == Kind::stopped_late || kind == Kind::turned_late;
  if (!(is_late ? clearly_less(closest, rest) && clearly_less(rest, end)
                : clearly_less(rest, closest)))
    return false;
  const bool holds = kind == Kind::stopped || kind == Kind::stopped_late;
  const double needed = std::abs(c.holding());
  return holds ? clearly_less(needed, c.mu) : clearly_less(c.mu, needed);
}

Contact any_contact(Kind kind) {
  Contact c = any_contact();
  while (!is_clearly(kind, c)) c = any_contact();
  return c;
}

/// A thing seen in a mirror that stands upright on the floor.
Contact mirrored(Contact c) {
  c.K(0, 1) = c.K(1, 0) *= -1;
  c.u[0] *= -1;
  return c;
}

/// The rod that the usual law gives energy: 30° to the floor.
Contact rod_that_gains() { return {K_of_rod(1, 2, std::acos(-1.) / 6), Vec2(-0.2, -1), 0.9, 0.5}; }

/// Newton's law; friction stops the slip if μ suffices for that, and else is against the slip with
/// which the contact begins.
PlanarImpulse usual_law(const Contact& c) {
  if (c.u[1] >= 0) return {Vec2::Zero(), false};
  const Vec2 stop = -(c.K.inverse() * Vec2(c.u[0], (1 + c.e) * c.u[1]));
  const double f = against_slip(c), p = -(1 + c.e) * c.u[1] / c.normal_rate(f);
  return {std::abs(stop[0]) <= c.mu * stop[1] ? stop : Vec2(f * p, p), c.jammed()};
}

/// First the normal impulse, as if there were no friction; then the friction, as if it changed only
/// the slip.
PlanarImpulse one_after_the_other(const Contact& c) {
  if (c.u[1] >= 0) return {Vec2::Zero(), false};
  const double p = -(1 + c.e) * c.u[1] / c.K(1, 1);
  return {Vec2(std::clamp(-c.u[0] / c.K(0, 0), -c.mu * p, c.mu * p), p), c.jammed()};
}

/// A function of the four arguments from one of a Contact.
template <class Way>
auto as(Way way) {
  return [way](const Mat2& K, const Vec2& u, double e, double mu) -> PlanarImpulse {
    return way(Contact{K, u, e, mu});
  };
}

/// The right answer, and what `change` makes of it.
template <class Change>
auto changed(Change change) {
  return as([change](const Contact& c) {
    PlanarImpulse answer = right(c);
    change(answer, c);
    return answer;
  });
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("slip that lasts, comes to rest, turns round, or jams, early or late") {
    // All is asked before the first answer is looked at: two wrong laws may agree on one contact.
    std::vector<Contact> contacts;
    std::vector<Answer<PlanarImpulse>> answers;
    for (int n = 0; n < 24; ++n) {
      contacts.push_back(any_contact(kinds[n % 6]));
      if (n % 12 == 11) contacts.back().u[0] *= -1;  // the other slip doesn't jam
      answers.push_back(ask(contacts.back()));
    }
    for (std::size_t n = 0; n < contacts.size(); ++n)
      REQUIRE(answers[n] == close_to(right(contacts[n]), rounding(contacts[n])));
  }

  TEST_CASE(
      "right impulses: no energy created, no pull, friction at most μ, no end pressed together") {
    for (int n = 0; n < 150; ++n) {
      const Contact c = any_contact(kinds[n % 6]);
      const auto answer = ask(c);
      const Vec2 j = answer->impulse;
      const double bound = 4 * rounding(c), u_n = c.after(j)[1];
      // j by j: its change brings u' times that, and the two products some 8 roundings.
      const double energies = bound * (c.u.norm() + c.after(j).norm()) +
                              16 * eps * j.norm() * (c.u.norm() + c.K.norm() * j.norm());
      REQUIRE(answer == obeys("the energy of both never grows", c.gain(j), energies));
      REQUIRE(answer == obeys("friction is at most μ times the normal impulse",
                              std::abs(j[0]) - c.mu * j[1], bound * (1 + c.mu)));
      REQUIRE(answer == obeys("the normal impulse pushes", -j[1], bound));
      REQUIRE(answer == obeys("the bodies part", -u_n, bound * c.K.norm()));
      REQUIRE(answer == close_to(right(c), rounding(c)));
    }
  }

  TEST_CASE("the rod at 30° that the usual law gives energy: its slip turns round in the contact") {
    const Contact rod = rod_that_gains();
    const auto answer = ask(rod);
    const Vec2 j = answer->impulse;
    REQUIRE(answer == obeys("the energy of both never grows", rod.gain(j), 4 * rounding(rod)));
    REQUIRE(answer ==
            obeys("the rod came with a slip to the left, and leaves with one to the right",
                  -rod.after(j)[0], 0));
    REQUIRE(answer == close_to(right(rod), rounding(rod)));
    REQUIRE(ask(mirrored(rod)) == close_to(right(mirrored(rod)), rounding(rod)));
  }

  TEST_CASE("as the library has it, which does this in space") {
    for (int n = 0; n < 12; ++n) {
      const Contact c = any_contact(kinds[n % 6]);
      Mat3 K = Mat3::Identity();
      K(0, 0) = c.K(0, 0);
      K(0, 2) = K(2, 0) = c.K(0, 1);
      K(2, 2) = c.K(1, 1);
      const auto same = tumble::contact::collide_with_friction(
          {K, Vec3(c.u[0], 0, c.u[1]), Vec3::UnitZ(), c.e, c.mu});
      // Its axes are turned, which costs 16 roundings more; a slip of less than 64 is none.
      const PlanarImpulse expected{Vec2(same.impulse.x(), same.impulse.z()), same.jammed};
      REQUIRE(ask(c) == close_to(expected, 4 * rounding(c)));
    }
  }

  TEST_CASE("without friction it is the impact of 11.5") {
    for (int n = 0; n < 6; ++n) {
      Contact c = any_contact();
      c.mu = 0;
      const Vec2 j(0, -(1 + c.e) * c.u[1] / c.K(1, 1));
      REQUIRE(ask(c) == close_to(PlanarImpulse{j, false}, 32 * eps * j[1]));
    }
  }

  TEST_CASE(
      "a ball thrown with slip rolls off with 5/7 of its speed if friction suffices, else slips") {
    for (int n = 0; n < 6; ++n) {
      const double mass = any_number(0.1, 2), radius = any_number(0.02, 1);
      const double v = any_number(0.5, 2), w = any_number(1, 3), e = any_number(0, 1);
      const double least = 2. / 7 * v / ((1 + e) * w);
      Contact ball{K_of_ball(mass, radius), Vec2(v, -w), e, any_number(1.1, 3) * least};
      const auto rolls = ask(ball);
      REQUIRE(rolls == close_to(PlanarImpulse{mass * Vec2(-2. / 7 * v, (1 + e) * w), false},
                                rounding(ball)));
      ball.mu = any_number(0.2, 0.9) * least;
      REQUIRE(ask(ball) == close_to(PlanarImpulse{mass * (1 + e) * w * Vec2(-ball.mu, 1), false},
                                    rounding(ball)));
    }
  }

  TEST_CASE("without slip at first: friction holds, or the normal impulse drives the point away") {
    for (int n = 0; n < 12; ++n) {
      Contact c = any_contact();
      c.u[0] = 0;
      const double needed = std::abs(c.holding());
      c.mu = (n % 2 ? any_number(1.1, 2) : any_number(0.2, 0.9)) * needed;
      const auto answer = ask(c);
      REQUIRE(answer == close_to(right(c), rounding(c)));
      const double slip = c.after(answer->impulse)[0], bound = 4 * c.K.norm() * rounding(c);
      if (n % 2)
        REQUIRE(answer == obeys("friction holds the point at rest", std::abs(slip), bound));
      else
        REQUIRE(answer == obeys("the point slips the way in which K_nt drives it",
                                c.K(0, 1) > 0 ? -slip : slip, bound));
    }
  }

  TEST_CASE("in a mirror the right impulse is mirrored") {
    for (const Kind kind : kinds) {
      const Contact c = any_contact(kind);
      const PlanarImpulse expected = right(c);
      const Vec2 j(-expected.impulse[0], expected.impulse[1]);
      REQUIRE(ask(c) == close_to(expected, rounding(c)));
      REQUIRE(ask(mirrored(c)) == close_to(PlanarImpulse{j, expected.jammed}, rounding(c)));
    }
  }

  TEST_CASE(
      "right with e = 0, which leaves no normal velocity, and e = 1: only friction takes energy") {
    for (const Kind kind : {Kind::kept, Kind::stopped, Kind::turned, Kind::jams}) {
      Contact c = any_contact(kind);
      c.e = 0;
      while (!is_clearly(kind, c)) {
        c = any_contact(kind);
        c.e = 0;
      }
      const auto soft = ask(c);
      REQUIRE(soft == close_to(right(c), rounding(c)));
      REQUIRE(soft == obeys("with e = 0 they stay together", std::abs(c.after(soft->impulse)[1]),
                            4 * c.K.norm() * rounding(c)));
      c.e = 1;
      REQUIRE(ask(c) == close_to(right(c), rounding(c)));
      c.u[0] = 0;
      c.mu = any_number(1.1, 2) * std::abs(c.holding());
      const auto held = ask(c);
      REQUIRE(held == close_to(right(c), rounding(c)));
      REQUIRE(held == obeys("with e = 1, and friction that only holds, the energy stays",
                            std::abs(c.gain(held->impulse)), 8 * c.u.norm() * rounding(c)));
    }
  }

  TEST_CASE("Painlevé: a thin rod can jam if μ > 4/3, it is said, and it parts all the same") {
    for (const double mu : {1.2, 1.5, 3.})
      for (int n = 0; n < 12; ++n) {
        Contact rod{K_of_rod(1, 2, 0.75 + 0.05 * n), Vec2(n % 2 ? 1 : -1, -0.1), 0.5, mu};
        // Clear of the border, where a rounding decides whether it jams.
        while (std::abs(rod.normal_rate(against_slip(rod))) < 0.02 * rod.K(1, 1)) rod.mu *= 1.03;
        const auto answer = ask(rod);
        REQUIRE(answer == close_to(right(rod), rounding(rod)));
        REQUIRE(answer == obeys("the bodies part", -rod.after(answer->impulse)[1],
                                4 * rod.K.norm() * rounding(rod)));
      }
    // On the border, in numbers that are not rounded: u_n doesn't grow.
    const Contact border{(Mat2() << 2, 1, 1, 1).finished(), Vec2(1, -1), 0.5, 1};
    REQUIRE(ask(border) == close_to(right(border), rounding(border)));
  }

  TEST_CASE("bodies that part, or neither part nor come together, get nothing and don't jam") {
    for (const Kind kind : {Kind::kept, Kind::turned, Kind::jams}) {
      Contact c = any_contact(kind);
      c.u[1] = 0;
      REQUIRE(ask(c) == close_to(PlanarImpulse{Vec2::Zero(), false}, 0));
      c.u[1] = any_number(0.5, 2);
      REQUIRE(ask(c) == close_to(PlanarImpulse{Vec2::Zero(), false}, 0));
      c.u.setZero();
      REQUIRE(ask(c) == close_to(PlanarImpulse{Vec2::Zero(), false}, 0));
    }
  }

  TEST_CASE("specks of dust, planets, slow and fast, and friction like glue") {
    for (const double size : {1e-30, 1e-9, 1e9, 1e30})
      for (const Kind kind : kinds) {
        Contact c = any_contact(kind);
        c.K /= size;
        REQUIRE(ask(c) == close_to(right(c), rounding(c)));
        c.u *= size;
        REQUIRE(ask(c) == close_to(right(c), rounding(c)));
      }
    for (const double mu : {30., 1e3, 1e6}) {
      Contact c = any_contact();
      while (std::abs(c.K(0, 1)) < 0.1 * c.K(1, 1)) c = any_contact();
      c.mu = mu;
      REQUIRE(ask(c) == close_to(right(c), rounding(c)));
      REQUIRE(ask(mirrored(c)) == close_to(right(mirrored(c)), rounding(c)));
    }
  }
}

const Misconceptions<decltype(when_bodies_meet::collide_with_friction)> misconceptions{
    TUMBLE_UNIT,
    {{"the usual law",
      "Either you stop the slip, or your friction is against the slip of the beginning to the end. "
      "That is what most tutorials do, and it can create energy: the slip may change on the way.",
      "The slip may turn round", as(usual_law)},
     {"work of the last piece only",
      "Where the slip ends while the bodies still come together, you count the work from there "
      "only. What the spring has taken before comes back as well.",
      "Energy comes back by Stronge's law", as(Law{.end = stronge_from_rest})},
     {"friction after the slip has ended",
      "Your friction goes on in the same direction when the slip is at its end, so it drives the "
      "point the other way. Look at the slip again there.",
      "The slip may turn round",
      as(Law{.at_rest =
                 [](const Contact& c) {
                   return c.u[0] == 0 ? held_if_possible(c) : against_slip(c);
                 }})},
     {"held by more than μ",
      "When the slip has ended you hold the point at rest, whatever that takes. Friction can't be "
      "larger than μ per unit of p.",
      "The slip may turn round", as(Law{.at_rest = [](const Contact& c) { return c.holding(); }})},
     {"no friction without slip",
      "Without slip you have no friction. There it is as large as it has to be to hold the point, "
      "up to μ.",
      "Friction during the impact", as(Law{.at_rest = [](const Contact&) { return 0.; }})},
     {"all the friction that μ allows",
      "Where the slip has ended your friction is as large as μ allows. It is only as large as it "
      "has to be to hold the point.",
      "Friction during the impact",
      as(Law{.at_rest = [](const Contact& c) { return -std::copysign(c.mu, c.K(0, 1)); }})},
     {"no friction where it can't hold",
      "Where μ is too small to hold the point, you have no friction. It still brakes the point, "
      "with all of μ.",
      "The slip may turn round",
      as(Law{
          .at_rest =
              [](const Contact& c) { return std::abs(c.holding()) <= c.mu ? c.holding() : 0.; }})},
     {"no slip taken for one",
      "Without slip your friction is −μ, as if the slip were positive. There it is as large as it "
      "has to be to hold the point, on either side.",
      "Friction during the impact", as(Law{.at_rest = [](const Contact& c) { return -c.mu; }})},
     {"slips off the wrong way",
      "Where μ doesn't hold the point, yours slips off against the way in which the normal impulse "
      "drives it.",
      "The slip may turn round",
      as(Law{.at_rest =
                 [](const Contact& c) {
                   const bool holds = std::abs(c.holding()) <= c.mu;
                   return holds ? c.holding() : std::copysign(c.mu, -c.holding());
                 }})},
     {"friction along the slip", "Your friction drives the slip on. It is against it.",
      "Friction during the impact",
      as(Law{.of_slip = [](const Contact& c) { return -against_slip(c); }})},
     {"friction forgotten", "You left friction out. Your answer is that of 11.5.",
      "Friction during the impact",
      as(Law{.of_slip = [](const Contact&) { return 0.; },
             .at_rest = [](const Contact&) { return 0.; },
             .end = newton})},
     {"one after the other",
      "You found the normal impulse without friction, and then the friction for it. Each of them "
      "changes both velocities: K has numbers off its diagonal.",
      "How a point responds to an impulse", as(one_after_the_other)},
     {"Newton's end",
      "You end the contact when u_n is −e times what it was. With friction that can create energy: "
      "end it when the part e² of the work is given back.",
      "Energy comes back by Stronge's law", as(Law{.end = newton})},
     {"Poisson's end",
      "You end the contact when the normal impulse has grown by e times what it was at u_n = 0. If "
      "the friction changes in between, that is not e² of the work.",
      "Energy comes back by Stronge's law", as(Law{.end = poisson})},
     {"e of the work",
      "You give the part e of the work back. It is e²: without friction u_n would become −e u_n.",
      "Energy comes back by Stronge's law",
      as(Law{.end = [](const Course& course, double e) { return end_by_work(course, e); }})},
     {"nothing given back",
      "You end the contact when u_n = 0. After that it gives the part e² of the work back.",
      "Energy comes back by Stronge's law",
      as(Law{.end = [](const Course& course, double) { return course.closest(); }})},
     {"jamming never told",
      "Your impulses are right, but you never say that a contact jams. Look at how u_n changes at "
      "the beginning.",
      "Energy comes back by Stronge's law",
      changed([](PlanarImpulse& answer, const Contact&) { answer.jammed = false; })},
     {"no impulse where it jams",
      "You give no impulse where the contact jams. It is pressed together all the more there, "
      "until the slip has ended, and parts then.",
      "Energy comes back by Stronge's law", changed([](PlanarImpulse& answer, const Contact&) {
        if (answer.jammed) answer.impulse.setZero();
      })},
     {"impulse on the second body",
      "Your impulse is the one on the second body. The first one gets its negative.",
      "An impact without friction",
      changed([](PlanarImpulse& answer, const Contact&) { answer.impulse *= -1; })},
     {"jams with the other slip",
      "You say that a contact jams where it would with the opposite slip. Friction is against the "
      "slip, so the sign of K_nt counts.",
      "Energy comes back by Stronge's law", changed([](PlanarImpulse& answer, const Contact& c) {
        answer.jammed = Contact{c.K, {-c.u[0], c.u[1]}, c.e, c.mu}.jammed();
      })},
     {"jams with either slip",
      "You say that a contact jams where it would with either slip. Friction is against the slip, "
      "so the sign of K_nt counts.",
      "Energy comes back by Stronge's law", changed([](PlanarImpulse& answer, const Contact& c) {
        const Contact other{c.K, {-c.u[0], c.u[1]}, c.e, c.mu};
        answer.jammed = c.jammed() || other.jammed();
      })},
     {"normal first",
      "You swapped the two numbers of the impulse. The first one is along the surface.",
      "Friction during the impact",
      changed([](PlanarImpulse& answer, const Contact&) { answer.impulse.reverseInPlace(); })},
     {"parting bodies held fast",
      "You give an impulse to bodies that part already. A contact can push, but it can't pull.",
      "Which contacts there are", changed([](PlanarImpulse& answer, const Contact& c) {
        if (c.u[1] > 0) answer.impulse = -right({c.K, -c.u, c.e, c.mu}).impulse;
      })}}};
