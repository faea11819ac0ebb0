#include <cmath>

#include "contract.hpp"

namespace when_bodies_meet {

namespace {

/// A flight of `duration` that ends on the floor with the speed `speed` downwards.
void land(const BallAndFloor& scene, double duration, double speed, BallState& ball) {
  ball.t += duration;
  ball.x += duration * ball.v;
  ball.x.z() = scene.height + scene.radius;
  ball.v.z() = -speed;
}

void hit(const BallAndFloor& scene, BallState& ball) {
  const Eigen::Matrix3d arm = rotation_matrices::skew({0, 0, -scene.radius});
  const double inertia = 0.4 * scene.mass * scene.radius * scene.radius;
  const Eigen::Vector3d u = ball.v - arm * ball.omega;  // ω × r = −r × ω
  const Eigen::Vector3d slip(u.x(), u.y(), 0), along = slip.normalized();
  // 1/m + r²/I = 7/2 m along the surface, 1/m along the normal
  const Eigen::Matrix2d K = Eigen::Vector2d(3.5, 1).asDiagonal() * (1 / scene.mass);
  const Eigen::Vector2d j =
      collide_with_friction(K, {slip.norm(), u.z()}, scene.e, scene.mu).impulse;
  const Eigen::Vector3d impulse = j[0] * along + j[1] * Eigen::Vector3d::UnitZ();
  ball.v += impulse / scene.mass;
  ball.omega += arm * impulse / inertia;
}

}  // namespace

Bounces bounce(const BallAndFloor& scene, const BallState& start, double t1) {
  BallState ball = start;
  const double above = ball.x.z() - (scene.height + scene.radius);
  if (above == 0 && ball.v.z() == 0) return {{}, true, ball.t};
  // above + v t − ½ g t² = 0
  const double landing = std::sqrt(ball.v.z() * ball.v.z() + 2 * scene.gravity * above);
  double flight = (ball.v.z() + landing) / scene.gravity, speed = landing;
  Bounces bounces{{}, false, 0};
  while (ball.t + flight <= t1) {
    land(scene, flight, speed, ball);
    hit(scene, ball);
    bounces.after.push_back(ball);
    speed = ball.v.z();
    flight = 2 * speed / scene.gravity;
    if (speed > 1e-9 * landing) continue;
    // flight (1 + e + e² + …)
    const double rest_time = ball.t + flight / (1 - scene.e);
    if (rest_time <= t1) return {bounces.after, true, rest_time};
    break;
  }
  return bounces;
}

}  // namespace when_bodies_meet
