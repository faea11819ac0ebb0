/// @file
/// 11.7 bounce: its laws, and what goes wrong.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "11_when_bodies_meet/contract.hpp"
#include "judge/spec/spec.hpp"

using namespace tumble::judge;
using tumble::Mat3, tumble::Vec3;
using when_bodies_meet::BallAndFloor, when_bodies_meet::BallState, when_bodies_meet::Bounces;

namespace student {
const Function<decltype(when_bodies_meet::bounce)> bounce{TUMBLE_UNIT};
}

namespace {

/// What a question consists of.
struct Scene {
  BallAndFloor ball;
  BallState start;
  double t1;

  double above() const { return start.x.z() - (ball.height + ball.radius); }
  /// The speed at which it lands first.
  double landing() const {
    return std::sqrt(start.v.z() * start.v.z() + 2 * ball.gravity * above());
  }
  double first_contact() const { return start.t + (start.v.z() + landing()) / ball.gravity; }
  /// The time at which all bounces are over.
  double rest_time() const {
    return first_contact() + 2 * ball.e * landing() / (ball.gravity * (1 - ball.e));
  }
  /// How often it bounces until it leaves the floor with at most a billionth of its first speed.
  double bounces_to_rest() const { return std::log(1e-9) / std::log(ball.e); }
};

Answer<Bounces> ask(const Scene& s) { return student::bounce(s.ball, s.start, s.t1); }

// ── Right and wrong answers, in parts ──

/// The right way, and what can go wrong with it.
struct Way {
  double spin_in_slip = 1;   ///< its factor in the velocity of the point that touches
  double torque = 1;         ///< the factor of what friction does to the spin
  double inertia = 0.4;      ///< of the ball, by mass and radius
  double answer = 3.5;       ///< of the point along the surface, to an impulse, by the mass
  double centre = 1;         ///< where it stops, in radii above the floor
  double flight = 2;         ///< its time, in v_z/g
  double root = 1;           ///< which one of the first contact
  bool bounces_back = true;  ///< as fast as e says
  bool limits_friction = true;
  bool from_rest = false;      ///< falls as if v_z had been 0
  bool clock_at_zero = false;  ///< times count from the start
  bool lists_before = false;   ///< the states before the contacts
  bool adds_up_z = false;      ///< instead of setting it at each contact
  double near = 0;             ///< it rests if it is no higher above the floor, and no faster
  double slowest = 1e-9;       ///< of the speed of the first landing …
  bool in_metres = false;      ///< … or of 1 m/s
  double rest = 1;             ///< the factor of the flights that are left
  bool one_flight = false;     ///< only one of them
  bool skips_next = false;     ///< all of them but the next one
  bool rests_later = false;    ///< also after t1

  void hit(const BallAndFloor& ball, BallState& now) const;
  Bounces operator()(const Scene& s) const;
  Bounces end(const Scene& s, Bounces bounces, double t, double next_flight) const;
};

/// Friction takes the slip of a ball away, or as much of it as μ can.
void Way::hit(const BallAndFloor& ball, BallState& now) const {
  const double r = ball.radius, w = -now.v.z(), e = bounces_back ? ball.e : 1;
  const Vec3 spin(-r * now.omega.y(), r * now.omega.x(), 0);
  const Vec3 slip = Vec3(now.v.x(), now.v.y(), 0) + spin_in_slip * spin;
  const double needed = slip.norm() / answer, most = ball.mu * (1 + e) * w;
  const double part = needed > most && limits_friction ? most / needed : 1;
  const Vec3 change = -part / answer * slip;
  now.v += change;
  now.v.z() = e * w;
  now.omega += torque / (inertia * r) * Vec3(change.y(), -change.x(), 0);
}

Bounces Way::end(const Scene& s, Bounces bounces, double t, double next_flight) const {
  const double all = next_flight > 0 && !one_flight ? 1 / (1 - s.ball.e) : 1;
  const double time = t + rest * (skips_next ? all - 1 : all) * next_flight;
  bounces.at_rest = time <= s.t1 || rests_later;
  bounces.rest_time = bounces.at_rest ? time : 0;
  return bounces;
}

Bounces Way::operator()(const Scene& s) const {
  constexpr std::size_t most = 3000;  // of a wrong way, which may not end
  const double g = s.ball.gravity, v = from_rest ? 0 : s.start.v.z();
  const double floor = s.ball.height + centre * s.ball.radius;
  const double landing = std::sqrt(std::fmax(0, v * v + 2 * g * (s.start.x.z() - floor)));
  BallState now = s.start;
  if (clock_at_zero) now.t = 0;
  Bounces bounces{{}, false, 0};
  if (landing == 0 || (s.above() <= near && std::abs(v) <= near)) return end(s, bounces, now.t, 0);
  double duration = (v + root * landing) / g, speed = landing;
  while (now.t + duration <= s.t1 && bounces.after.size() < most) {
    now.t += duration;
    now.x += duration * now.v;
    now.x.z() = adds_up_z ? now.x.z() - g / 2 * duration * duration : floor;
    now.v.z() = -speed;
    if (lists_before) bounces.after.push_back(now);
    hit(s.ball, now);
    if (!lists_before) bounces.after.push_back(now);
    speed = now.v.z();
    duration = flight * speed / g;
    if (speed <= slowest * (in_metres ? 1 : landing)) return end(s, bounces, now.t, duration);
  }
  return bounces;
}

Bounces right(const Scene& s) { return Way{}(s); }

auto as(const Way& way) {
  return [way](const BallAndFloor& ball, const BallState& start, double t1) {
    return way({ball, start, t1});
  };
}

// ── How exact ──

/// The largest number that can occur in an answer, as long as a scene's metres, seconds and
/// kilograms are not far from 1. A place that is off makes a time off by as much over the speed.
double size(const Scene& s) {
  const BallState& b = s.start;
  const double speed = b.v.norm() + s.landing() + s.ball.radius * b.omega.norm();
  const double last = std::isfinite(s.t1) ? s.t1 : s.rest_time();
  const double time = std::abs(b.t) + std::abs(last) + s.landing() / s.ball.gravity;
  const double place = b.x.norm() + std::abs(s.ball.height) + s.ball.radius + speed * time;
  const double fall = s.landing() > 0 ? place / s.landing() : 0;
  return speed * (1 + 1 / s.ball.radius) + time + place + fall + b.omega.norm();
}

/// Each contact takes some 32 roundings of the numbers before it, on either side; the flights that
/// are left are divided by 1 − e.
double rounding(const Scene& s, const Bounces& expected) {
  const double contacts = static_cast<double>(expected.after.size()) + 2;
  const double left = s.ball.e < 1 ? 1 / (1 - s.ball.e) : 1;
  return 64 * eps * contacts * left * size(s);
}

/// "As it is right": both, to be written in one line.
CloseTo as_expected(const Scene& s) {
  const Bounces expected = right(s);
  return close_to(expected, rounding(s, expected));
}

// ── Scenes ──

/// A number that is a multiple of 1/64, so that sums of two are not rounded.
double any_even(double low, double high) { return std::round(64 * any_number(low, high)) / 64; }

/// Whether x is clear of every whole number.
bool is_between_numbers(double x) { return std::abs(x - std::round(x)) > 0.02; }

/// A coefficient of restitution with which no contact leaves just a billionth of the first speed.
double any_e(double low, double high) {
  Scene scene{};
  do scene.ball.e = any_number(low, high);
  while (!is_between_numbers(scene.bounces_to_rest()));
  return scene.ball.e;
}

/// A ball above the floor; t1 is twice as far away as the rest_time.
Scene any_scene(double lowest_e = 0.2, double highest_e = 0.6) {
  Scene s{};
  s.ball = {any_number(0.1, 3), any_even(0.1, 1),           any_even(-3, 3),
            any_number(1, 20),  any_e(lowest_e, highest_e), any_number(0.05, 0.5)};
  s.start.t = any_number(-3, 3);
  s.start.x = any_vector(3);
  s.start.x.z() = s.ball.height + s.ball.radius + any_even(0.5, 5);
  s.start.v = any_vector(3);
  s.start.omega = any_vector(3) / s.ball.radius;
  s.t1 = s.start.t + 2 * (s.rest_time() - s.start.t);
  return s;
}

/// One that falls straight down, from rest.
Scene any_drop(double lowest_e = 0.2, double highest_e = 0.6) {
  Scene s = any_scene(lowest_e, highest_e);
  s.start.v.setZero();
  s.start.omega.setZero();
  s.t1 = s.start.t + 2 * (s.rest_time() - s.start.t);
  return s;
}

/// ½ m v² + ½ · 0.4 m r² ω² + m g z, by the mass.
double energy(const BallAndFloor& ball, const BallState& s) {
  const double spin = 0.4 * ball.radius * ball.radius * s.omega.squaredNorm();
  return (s.v.squaredNorm() + spin) / 2 + ball.gravity * (s.x.z() - ball.height - ball.radius);
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("any ball that is thrown with any spin, until it is at rest") {
    // All is asked before the first answer is looked at: two wrong ways may agree on one scene.
    std::vector<Scene> scenes;
    std::vector<Answer<Bounces>> answers;
    for (int n = 0; n < 12; ++n) {
      scenes.push_back(any_scene());
      answers.push_back(ask(scenes.back()));
    }
    for (std::size_t n = 0; n < scenes.size(); ++n) REQUIRE(answers[n] == as_expected(scenes[n]));
  }

  TEST_CASE("it rises to e², e⁴, e⁶ … of its height, and all its bounces end in a finite time") {
    for (int n = 0; n < 5; ++n) {
      const Scene drop = any_drop(0.3, 0.8);
      const auto bounces = ask(drop);
      REQUIRE(bounces == as_expected(drop));
      const double h = drop.above(), e = drop.ball.e, g = drop.ball.gravity;
      const double bound = 4 * rounding(drop, bounces);
      double missed = 0, part = 1;
      for (const BallState& after : bounces->after) {
        part *= e * e;
        missed = worse(missed, std::abs(after.v.z() * after.v.z() / (2 * g) - part * h));
      }
      REQUIRE(bounces == obeys("after k contacts it rises to e²ᵏ of its height", missed,
                               bound * (1 + drop.landing() / g)));
      const double whole = std::sqrt(2 * h / g) * (1 + e) / (1 - e);
      REQUIRE(bounces == obeys("it is at rest (1 + e)/(1 − e) times the first fall after the start",
                               std::abs(bounces->rest_time - drop.start.t - whole), bound));
    }
  }

  TEST_CASE("right contacts: none creates energy, and at each the centre is one radius up") {
    for (int n = 0; n < 8; ++n) {
      const Scene s = any_scene(0.2, 0.95);
      const auto bounces = ask(s);
      REQUIRE(bounces == as_expected(s));
      double gained = 0, off = 0, before = energy(s.ball, s.start);
      const double first = before;
      for (const BallState& after : bounces->after) {
        const double now = energy(s.ball, after);
        gained = worse(gained, now - before);
        off = worse(off, std::abs(after.x.z() - s.ball.height - s.ball.radius));
        before = now;
      }
      const double bound = rounding(s, bounces);
      REQUIRE(bounces == obeys("no contact creates energy", gained,
                               4 * bound * (s.start.v.norm() + std::sqrt(first) + s.ball.gravity)));
      REQUIRE(bounces == obeys("the centre is one radius above the floor at each contact", off,
                               2 * eps * (std::abs(s.ball.height) + s.ball.radius)));
    }
  }

  TEST_CASE(
      "a ball without spin rolls off with 5/7 of its speed, and spins to match, given friction") {
    for (int n = 0; n < 5; ++n) {
      Scene s = any_scene();
      s.ball.mu = 50;
      s.start.omega.setZero();
      const auto bounces = ask(s);
      REQUIRE(bounces == as_expected(s));
      double missed = 0;
      for (const BallState& after : bounces->after)
        missed = worse(missed, (after.v - 5. / 7 * s.start.v).head<2>().norm());
      REQUIRE(bounces == obeys("it goes on with 5/7 of its speed along the floor", missed,
                               4 * rounding(s, bounces)));
    }
  }

  TEST_CASE("backspin throws it back, and a spin about the vertical changes nothing") {
    for (int n = 0; n < 5; ++n) {
      Scene s = any_drop(0.3, 0.9);
      s.start.v.x() = any_number(0.5, 1);
      s.start.omega.y() = -any_number(5, 9) / s.ball.radius;
      s.ball.mu = any_number(1, 2);
      const auto bounces = ask(s);
      REQUIRE(bounces == as_expected(s));
      Scene spun = s;
      spun.start.omega.z() = any_number(1, 5);
      REQUIRE(ask(spun) == as_expected(spun));
    }
  }

  TEST_CASE("straight down without spin, or without friction: nothing but v_z changes") {
    for (int n = 0; n < 5; ++n) {
      Scene s = any_drop();
      if (n % 2) {
        s.ball.mu = 0;
        s.start.v.x() = any_number(-3, 3);
        s.start.omega = any_vector(5);
      }
      const auto bounces = ask(s);
      REQUIRE(bounces == as_expected(s));
      double changed = 0;
      for (const BallState& after : bounces->after) {
        changed = worse(changed, (after.v - s.start.v).head<2>().norm());
        changed = worse(changed, (after.omega - s.start.omega).norm());
      }
      REQUIRE(bounces == obeys("the spin and the velocity along the floor stay", changed,
                               rounding(s, bounces)));
    }
  }

  TEST_CASE("with e = 1 it bounces for ever, and the film runs backwards as well") {
    for (int n = 0; n < 5; ++n) {
      Scene s = any_scene();
      s.ball.e = 1;
      const double period = 2 * s.landing() / s.ball.gravity;
      s.t1 = s.first_contact() + any_number(6.1, 12.9) * period;
      while (!is_between_numbers((s.t1 - s.first_contact()) / period)) s.t1 += 0.03 * period;
      REQUIRE(ask(s) == as_expected(s));

      s.ball.mu = 0;
      const auto bounces = ask(s);
      REQUIRE(bounces == as_expected(s));
      // From the last contact backwards, each contact is at the place where it was.
      Scene back = s;
      back.start = bounces->after.back();
      back.start.v = -back.start.v;
      back.start.omega = -back.start.omega;
      const std::size_t count = bounces->after.size();
      back.t1 = back.start.t + (static_cast<double>(count) - 0.5) * period;
      const auto again = ask(back);
      REQUIRE(again == as_expected(back));
      REQUIRE(again == obeys("as many contacts as before",
                             std::abs(static_cast<double>(again->after.size() - count)), 0));
      double off = 0;
      for (std::size_t i = 0; i < count; ++i)
        off = worse(off, (again->after[i].x - bounces->after[count - 1 - i].x).norm());
      REQUIRE(again == obeys("it comes back to the places of its contacts, the last one first", off,
                             4 * (rounding(s, bounces) + rounding(back, again))));
    }
  }

  TEST_CASE("e = 0 and a tiny e: one contact, and it is at rest") {
    for (const double e : {0., 1e-15, 1e-12, 1e-10}) {
      Scene s = any_scene();
      s.ball.e = e;
      REQUIRE(ask(s) == as_expected(s));
    }
  }

  TEST_CASE("on the floor at the start: at rest, landing at once, or thrown up") {
    for (const double height : {0., 1.5, -2.25}) {
      Scene s = any_scene();
      s.ball.height = height;
      s.start.x.z() = height + s.ball.radius;
      for (const double v : {-1.5, 2.5, 0.}) {
        s.start.v.z() = v;
        s.t1 = s.start.t + 2 * (s.rest_time() - s.start.t) + 1;
        REQUIRE(ask(s) == as_expected(s));
      }
      s.ball.e = 1;
      REQUIRE(ask(s) == as_expected(s));
      s.start.v.z() = -1.5;  // this contact is at t1, not after it
      s.t1 = s.start.t;
      REQUIRE(ask(s) == as_expected(s));
    }
  }

  TEST_CASE("a hair above the floor, at rest: it falls, and bounces as often as from anywhere") {
    for (const double above : {1e-4, 1e-7, 1e-10}) {
      Scene s = any_scene();
      s.start.x.z() = s.ball.height + s.ball.radius + above;
      s.start.v.z() = 0;
      s.t1 = s.start.t + 2 * (s.rest_time() - s.start.t);
      REQUIRE(ask(s) == as_expected(s));
    }
  }

  TEST_CASE("t1 at the start, before the first contact, between two, and just after all of them") {
    for (int n = 0; n < 4; ++n) {
      Scene s = any_scene();
      const double first = s.first_contact(), rest = s.rest_time();
      s.t1 = s.start.t;
      REQUIRE(ask(s) == as_expected(s));
      s.t1 = s.start.t + 0.9 * (first - s.start.t);
      REQUIRE(ask(s) == as_expected(s));
      // In the flight after the first contact, in the one after the second, and just after all.
      const double flight = 2 * s.ball.e * s.landing() / s.ball.gravity;
      s.t1 = first + 0.5 * flight;
      REQUIRE(ask(s) == as_expected(s));
      s.t1 = first + (1 + 0.5 * s.ball.e) * flight;
      REQUIRE(ask(s) == as_expected(s));
      s.t1 = rest + 0.01;
      REQUIRE(ask(s) == as_expected(s));
    }
  }

  TEST_CASE("t1 after the last contact that counts, but before the ball is at rest") {
    for (int n = 0; n < 3; ++n) {
      // It is slow enough after its first contact; a part e of the first flight is left then.
      Scene s = any_scene();
      s.ball.e = 1e-9 * any_number(0.5, 0.9);
      const double left = s.rest_time() - s.first_contact();
      s.t1 = s.first_contact() + 0.5 * left;
      REQUIRE(left > 8 * rounding(s, right(s)));
      REQUIRE(ask(s) == as_expected(s));
    }
  }

  TEST_CASE("a floor at any height: 0.1 + 0.2 is rounded, and the ball lands for all that") {
    for (const double height : {0.1, 1e3 / 3, -7.7, 0.7}) {
      Scene s = any_drop(0.4, 0.6);
      s.ball.height = height;
      s.ball.radius = 0.2;
      s.start.x.z() = height + any_number(1, 3);
      s.t1 = s.start.t + 2 * (s.rest_time() - s.start.t);
      REQUIRE(ask(s) == as_expected(s));
    }
  }

  TEST_CASE("many bounces, specks of dust, and planets") {
    Scene s = any_scene(0.988, 0.99);
    REQUIRE(ask(s) == as_expected(s));
    for (const double mass : {1e-18, 1e24}) {
      s = any_scene();
      const Bounces expected = right(s);
      s.ball.mass = mass;
      REQUIRE(ask(s) == close_to(expected, rounding(s, expected)));
    }
    // All lengths a million times, a millionth, or a millionth of that.
    for (const double scale : {1e-12, 1e-6, 1e6}) {
      s = any_scene();
      s.start.x *= scale;
      s.start.v *= scale;
      s.ball.radius *= scale;
      s.ball.gravity *= scale;
      s.ball.height *= scale;
      s.start.x.z() = s.ball.height + s.ball.radius + scale;
      s.t1 = s.start.t + 2 * (s.rest_time() - s.start.t);
      REQUIRE(ask(s) == as_expected(s));
    }
  }
}

const Misconceptions<decltype(when_bodies_meet::bounce)> misconceptions{
    TUMBLE_UNIT,
    {{"centre on the floor",
      "Your ball sinks into the floor up to its centre. It touches when the centre is one radius "
      "above the floor.",
      "From contact to contact", as({.centre = 0})},
     {"bounces as it came",
      "Your ball leaves the floor as fast as it landed. It keeps only the part e of v_z.",
      "An impact without friction", as({.bounces_back = false})},
     {"slip without spin",
      "You took the velocity of the centre for that of the point that touches. The spin moves that "
      "point as well.",
      "From contact to contact", as({.spin_in_slip = 0})},
     {"slip of the top",
      "Your slip has the spin with the wrong sign: that is the velocity of the ball's top. The arm "
      "goes from the centre down to the floor.",
      "From contact to contact", as({.spin_in_slip = -1})},
     {"spin stays",
      "Friction changes your ball's velocity, but not its spin. The impulse has an arm of one "
      "radius.",
      "From contact to contact", as({.torque = 0})},
     {"spun the wrong way",
      "Friction spins your ball the wrong way round: a ball that slides starts to roll forwards.",
      "From contact to contact", as({.torque = -1})},
     {"hollow ball",
      "You took the moment of inertia of a hollow ball. This one is solid: 2/5 m r².",
      "From contact to contact", as({.inertia = 2. / 3, .answer = 2.5})},
     {"disc", "You took the moment of inertia of a disc. This is a solid ball: 2/5 m r².",
      "From contact to contact", as({.inertia = 0.5, .answer = 3})},
     {"spin of a hollow ball",
      "Friction spins your ball as if it were hollow. This one is solid: 2/5 m r².",
      "From contact to contact", as({.inertia = 2. / 3})},
     {"stopped like a particle",
      "Your friction stops the slip as if the ball could not turn. Its spin takes part of the slip "
      "away, so it needs less.",
      "The slip may turn round", as({.answer = 1})},
     {"friction without a limit", "Your friction takes all of the slip away, however small μ is.",
      "Friction during the impact", as({.limits_friction = false})},
     {"only the way up",
      "Your flights take only the time of the way up. The ball falls as long as it rises.",
      "From contact to contact", as({.flight = 1})},
     {"falls from rest",
      "Your ball falls as if its v_z were 0 at the start. Both roots of the quadratic depend on "
      "v_z.",
      "From contact to contact", as({.from_rest = true})},
     {"the other root",
      "You took the root at which the ball would have left the floor, in the past.",
      "From contact to contact", as({.root = -1})},
     {"clock set to zero", "Your times count from the start. The ball's clock shows start.t there.",
      "From contact to contact", as({.clock_at_zero = true})},
     {"before the contact",
      "You list the states right before the contacts. We ask for those right after.",
      "From contact to contact", as({.lists_before = true})},
     {"z added up",
      "You add up z from flight to flight, so that rounding lets the ball sink or rise. You know "
      "where its centre is at a contact: set it there.",
      "From contact to contact", as({.adds_up_z = true})},
     {"nearly on the floor",
      "You say that a ball is at rest that is not yet on the floor, as it is low and slow. It "
      "falls even so, and bounces as often as from any other height.",
      "Infinitely many bounces", as({.near = 1e-9})},
     {"a billionth of 1 m/s",
      "You count until the ball is slower than 1e-9 m/s. What counts is the part of the speed at "
      "which it landed first: a ball of another size must bounce as often.",
      "Infinitely many bounces", as({.in_metres = true})},
     {"at rest at the last contact",
      "You say that the ball is at rest at the last contact that you list. There are flights left, "
      "infinitely many, and their times add up.",
      "Infinitely many bounces", as({.rest = 0})},
     {"one more flight",
      "After the last contact you add one flight. There are infinitely many left, each e times as "
      "long as the one before.",
      "Infinitely many bounces", as({.one_flight = true})},
     {"one flight too few",
      "You leave out the flight that follows the last contact. It has yet to come: of the flights "
      "that are left it is the first.",
      "Infinitely many bounces", as({.skips_next = true})},
     {"at rest after t1", "You say that the ball is at rest, though that is later than t1.",
      "Infinitely many bounces", as({.rests_later = true})}}};
