/// @file
/// Contacts that break simulators, and what the library makes of them. Each truth is a formula.

#include <algorithm>

#include "common.hpp"
#include "parts.hpp"
#include "support/rounding.hpp"
#include "tumble/collide/first_meeting.hpp"
#include "tumble/mass/solids/ball.hpp"
#include "tumble/mass/solids/box.hpp"

namespace contact_chapter {

namespace {

using collide::Convex, collide::HalfSpace, collide::Pose;
using contact::ContactBody, contact::ContactRun, contact::ContactScene;

std::string below(double error) { return support::rounding_number(error, 1e-14); }

ContactBody ball(double radius, const Vec3& x, const Vec3& v) {
  const RigidBody<> body(mass_properties(Ball{radius}, 1000));
  return {"ball", body, Convex::ball(radius),
          state_of_motion<double>(body, x, Quat::Identity(), v, Vec3::Zero())};
}

ContactBody box(const Vec3& size, const Vec3& x, const Vec3& v, const Vec3& omega) {
  const RigidBody<> body(mass_properties(Box{size}, 1000));
  return {"box", body, Convex::box(size),
          state_of_motion<double>(body, x, Quat::Identity(), v, omega)};
}

// ── How far apart ──

using Row = std::vector<std::string>;

/// A box stands on another one, a gap above it. Both are moved away, and the upper one is turned.
struct Boxes {
  std::string name;
  Vec3 lower, upper;
  double gap;
  Vec3 away = Vec3::Zero();
  double tilt = 0;  ///< about x [rad]

  Row row() const {
    const Mat3 R(Eigen::AngleAxisd(tilt, Vec3::UnitX()));
    // Half the height of the turned box.
    const double reach = (std::cos(tilt) * upper.z() + std::sin(tilt) * upper.y()) / 2;
    const Vec3 centre(0, 0, lower.z() / 2 + gap + reach);
    const collide::Distance found = distance(Convex::box(lower), {away, Mat3::Identity()},
                                             Convex::box(upper), {away + centre, R});
    return {name, number(gap) + " m apart", std::to_string(found.rounds),
            below(found.gap - gap) + " m"};
  }
};

// ── When ──

/// A body flies without gravity, or falls.
contact::Flight flight_of(const ContactBody& body, double pull = 0) {
  return {body.body, body.start, {0, 0, -pull}, 0};
}

constexpr double near_enough = 1e-10;  // [m]

Row bullet_row() {
  constexpr double radius = 1e-3, thick = 1e-3, from = 1000, speed = 1e4;
  const ContactBody bullet = ball(radius, {-from, 0, 0}, {speed, 0, 0}),
                    plate = box({thick, 1, 1}, Vec3::Zero(), Vec3::Zero(), Vec3::Zero());
  const contact::Flight a = flight_of(bullet), b = flight_of(plate);
  const collide::Meeting found =
      first_meeting(collide::Moving<contact::Flight>{bullet.shape, a},
                    collide::Moving<contact::Flight>{plate.shape, b}, 0, 1, near_enough);
  return {"10 km/s at a plate of 1 mm", found.found ? "hits" : "passes",
          std::to_string(found.queries),
          below(found.t - (from - radius - thick / 2) / speed) + " s"};
}

/// When a body first meets a wall.
collide::Meeting meeting(const ContactBody& body, const HalfSpace& wall, double until,
                         double pull) {
  const contact::Flight flight = flight_of(body, pull);
  return first_meeting(collide::Moving<contact::Flight>{body.shape, flight}, wall, 0, until,
                       near_enough);
}

/// A rod turns about its middle beside a wall, ten times.
/// @param beyond how far its end would reach into the wall [m]
Row grazing_row(const std::string& name, double beyond) {
  constexpr double length = 2, thin = 1e-3, spin = 5;
  const double reach = std::hypot(length, thin) / 2, turns = 10 * 2 * std::acos(-1) / spin;
  const ContactBody rod = box({length, thin, thin}, Vec3::Zero(), Vec3::Zero(), {0, 0, spin});
  const collide::Meeting found = meeting(rod, {{0, beyond - reach, 0}, Vec3::UnitY()}, turns, 0);
  // The corner that leads is ahead of the rod's middle line.
  const double truth = (std::asin(1 - beyond / reach) - std::atan2(thin, length)) / spin;
  return {name, found.found ? "hits" : "passes", std::to_string(found.queries),
          found.found ? error_number(std::abs(found.t - truth)) + " s" : "–"};
}

Row far_row() {
  constexpr double height = 1e8, spin = 2e4;
  const ContactBody cube = box(Vec3::Ones(), {0, 0, height}, Vec3::Zero(), {0, 0, spin});
  const collide::Meeting found = meeting(cube, {}, 1e6, gravity);
  const double truth = std::sqrt(2 * (height - 0.5) / gravity);
  return {"from 10⁸ m, at 20,000 rad/s", "lands", std::to_string(found.queries),
          below(found.t / truth - 1) + " of t"};
}

Row thrown_up_row() {
  const ContactBody cube = box(Vec3::Ones(), {0, 0, 0.5}, {0, 0, gravity}, Vec3::Zero());
  const collide::Meeting found = meeting(cube, {}, 10, gravity);
  return {"touches the floor, is thrown up", "lands", std::to_string(found.queries),
          below(found.t - 2) + " s"};
}

// ── What then ──

Row row_of(const std::string& name, const ContactRun& run, const std::string& off) {
  const std::size_t count = run.impacts.size();
  return {name, std::to_string(count) + (count == 1 ? " impact" : " impacts"),
          std::to_string(run.queries), off};
}

double speed_of(const ContactScene& scene, const ContactRun& run, int i) {
  return run.state(scene, i, run.t).P.x() / scene.body(i).body.mass();
}

/// A grain flies at a ball that is at rest, without loss.
Row grain_row() {
  constexpr double grain = 1e-4, speed = 3;
  const ContactScene scene{
      {ball(grain, {-2, 0, 0}, {speed, 0, 0}), ball(1, Vec3::Zero(), Vec3::Zero())},
      {},
      Vec3::Zero(),
      1,
      0};
  const ContactRun run = simulate_contacts(scene, {.until = 1});
  const double ratio = std::pow(grain, 3), truth = 2 * speed * ratio / (1 + ratio);
  return row_of("masses 1 : 10¹²", run, below(speed_of(scene, run, 1) / truth - 1) + " of v");
}

Row cradle_row() {
  constexpr int balls = 100;
  ContactScene scene{{}, {}, Vec3::Zero(), 1, 0};
  for (int i = 0; i < balls; ++i)
    scene.bodies.push_back(ball(0.5, {i == 0 ? -1. : i, 0, 0}, {i == 0 ? 1. : 0, 0, 0}));
  const ContactRun run = simulate_contacts(scene, {.until = 3});
  double worst = 0;
  for (int i = 0; i < balls; ++i)
    worst = std::max(worst, std::abs(speed_of(scene, run, i) - (i + 1 == balls)));
  return row_of("Newton's cradle, 100 balls", run, below(worst) + " m/s");
}

/// A ball falls by a metre.
ContactRun bounced(double e, double until) {
  constexpr double radius = 0.1;
  const ContactScene scene{
      {ball(radius, {0, 0, radius + 1}, Vec3::Zero())}, {HalfSpace{}}, {0, 0, -gravity}, e, 0};
  return simulate_contacts(scene, {.until = until});
}

Row bounces_row() {
  constexpr double count = 1e4;
  const double first = std::sqrt(2 / gravity), truth = (2 * count - 1) * first;
  const ContactRun run = bounced(1, 2 * count * first);
  return row_of("a ball with e = 1", run, below(run.impacts.back().t - truth) + " s");
}

Row rest_row() {
  constexpr double e = 0.999;
  const double truth = std::sqrt(2 / gravity) * (1 + e) / (1 - e);
  const ContactRun run = bounced(e, 1e4);
  return row_of("with e = 0.999, until it rests", run, below(run.rest_since[0] - truth) + " s");
}

}  // namespace

Table hard_cases_table() {
  Table table({"case", "what is found", "looks", "off by"});
  const Vec3 one = Vec3::Ones();
  for (const Boxes& boxes : {Boxes{"faces and edges parallel", one, one, 1e-9},
                             Boxes{"turned by 10⁻⁹ rad", one, one, 1e-9, Vec3::Zero(), 1e-9},
                             Boxes{"10⁸ m away from the origin", one, one, 0.125, 1e8 * one},
                             Boxes{"a needle on a mountain", 1e4 * one, {1e-6, 1e-6, 1}, 1e-6}})
    table.add(boxes.row());
  for (const Row& row : {bullet_row(), grazing_row("a rod's end goes 10⁻⁸ m into a wall", 1e-8),
                         grazing_row("or passes by, 10⁻⁸ m away", -1e-8), far_row(),
                         thrown_up_row(), grain_row(), cradle_row(), bounces_row(), rest_row()})
    table.add(row);
  return table;
}

}  // namespace contact_chapter
