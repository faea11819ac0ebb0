/// @file
/// A ball whose path depends on its spin, and that nobody wants the orientation of.

#include "common.hpp"
#include "parts.hpp"
#include "tumble/mass/solids/ball.hpp"

namespace scene_chapter {

namespace {

/// The golf ball of chapter 1.
constexpr double ball_mass = 0.0459, ball_radius = 0.02135;                  // [kg], [m]
constexpr double air_area = 1.2 / 2 * pi * ball_radius * ball_radius;        // ½ ρ A [kg/m]
constexpr double spin_drag = 1e-6;                                           // [kg m²/s]
constexpr double ball_moment = 0.4 * ball_mass * ball_radius * ball_radius;  // [kg m²]
constexpr double flight = 2;                                                 // [s]

/// Weight, drag, and a lift that is perpendicular to the spin and to the velocity.
Vec3 force_of_air(const Vec3& v, const Vec3& omega) {
  return ball_mass * weight.g - air_area * 0.25 * v.norm() * v +
         air_area * ball_radius * omega.cross(v);
}

/// As a force of the library.
struct Air {
  Wrench<> operator()(double, const RigidBody<>&, const Derived<>& now) const {
    return {force_of_air(now.v, now.omega), -spin_drag * now.omega};
  }
};

/// x and P; the spin is not there.
using Particle = Eigen::Matrix<double, 6, 1>;
Particle rate_of_particle(double, const Particle& y) {
  const Vec3 v = y.tail<3>() / ball_mass;
  Particle rate;
  rate << v, force_of_air(v, Vec3::Zero());
  return rate;
}

/// x, P and L.
using SpinningBall = Eigen::Matrix<double, 9, 1>;
SpinningBall rate_of_spinning_ball(double, const SpinningBall& y) {
  const Vec3 v = y.segment<3>(3) / ball_mass, omega = y.tail<3>() / ball_moment;
  SpinningBall rate;
  rate << v, force_of_air(v, omega), -spin_drag * omega;
  return rate;
}

/// Hit at 70 m/s, 12° upwards, with a back-spin of 45 turns per second.
const Vec3 hit = 70 * Vec3(std::cos(12 * degree), 0, std::sin(12 * degree));
const Vec3 back_spin = 45 * 2 * pi * Vec3(0, -1, 0);

template <class State, class Rhs>
void add_flight(Table& table, const std::string& model, const Rhs& rate, const State& start) {
  const auto end = integrate_adaptive<Dop853>(rate, start, 0.0, flight, {1e-8, 1e-8});
  table.add({model, std::to_string(start.size()), support::svg_number(end.y[0], 2) + " m",
             support::svg_number(end.y[2], 2) + " m", std::to_string(end.evaluations)});
}

}  // namespace

Table spin_table() {
  Table table({"as a", "numbers", "flown", "height", "evaluations"});
  Particle particle;
  particle << Vec3::Zero(), ball_mass * hit;
  add_flight(table, "particle", rate_of_particle, particle);
  SpinningBall spinning_ball;
  spinning_ball << Vec3::Zero(), ball_mass * hit, ball_moment * back_spin;
  add_flight(table, "spinning ball", rate_of_spinning_ball, spinning_ball);
  const RigidBody<> body(ball_mass, ball_moment * Mat3::Identity());
  add_flight(table, "full body", RigidBodyRhs(body, Air{}),
             pack(state_of_motion<double>(body, Vec3::Zero(), Quat::Identity(), hit, back_spin)));
  return table;
}

}  // namespace scene_chapter
