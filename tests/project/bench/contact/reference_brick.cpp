#include "project/bench/contact/reference_brick.hpp"

#include <cmath>

#include "tumble/core/require.hpp"

namespace tumble::bench {
namespace {

using T = simd::DoubleDouble;

template <class V>
Eigen::Matrix<T, 3, 1> exactly(const V& v) {
  return {T(v[0]), T(v[1]), T(v[2])};
}

double roughly(const T& x) { return static_cast<double>(x); }

Vec3 roughly(const Eigen::Matrix<T, 3, 1>& v) {
  return {roughly(v[0]), roughly(v[1]), roughly(v[2])};
}

T dot(const Vec3& a, const Eigen::Matrix<T, 3, 1>& b) {
  return T(a[0]) * b[0] + T(a[1]) * b[1] + T(a[2]) * b[2];
}

Eigen::Matrix<T, 3, 1> cross(const Eigen::Matrix<T, 3, 1>& a, const Eigen::Matrix<T, 3, 1>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vec3 momentum(const Body& body) {
  const Quat& q = body.start.q;
  return q * body.moments.cwiseProduct(q.conjugate() * body.start.omega);
}

}  // namespace

ReferenceBrick::ReferenceBrick(const Scene& scene, double nudge)
    : body_(scene.bodies[0]),
      walls_(scene.walls),
      gravity_(exactly(scene.gravity)),
      x_(exactly(body_.start.x)),
      v_(exactly(body_.start.v)),
      e_(scene.e),
      turning_({body_.moments, body_.start.q, momentum(body_)}) {
  for (int i = 0; i < 3; ++i) v_[i] *= T(1) + T(nudge);
}

// ── Where its corners are ──

/// q v q* / |q|², with q of any length: v + 2 u × (u × v + w v) / |q|².
ReferenceBrick::Vector ReferenceBrick::into_world(const Vector& body) const {
  const auto& s = turning_.now();
  const Vector u(s[7], s[8], s[9]), inner = cross(u, body);
  const T w = s[6], twice = T(2) / (w * w + u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
  const Vector outer = cross(u, inner);
  return {body[0] + (outer[0] + w * inner[0]) * twice, body[1] + (outer[1] + w * inner[1]) * twice,
          body[2] + (outer[2] + w * inner[2]) * twice};
}

ReferenceBrick::Vector ReferenceBrick::into_body(const Vector& world) const {
  Vector body;
  for (int i = 0; i < 3; ++i) {
    const Vector axis = into_world(exactly(Vec3(Vec3::Unit(i))));
    body[i] = axis[0] * world[0] + axis[1] * world[1] + axis[2] * world[2];
  }
  return body;
}

T ReferenceBrick::gap(const Place& place) const {
  const Wall& wall = walls_[place.wall];
  const Vector p = into_world(exactly(place.corner));
  return dot(wall.normal, x_) + dot(wall.normal, p) - dot(wall.point, exactly(wall.normal));
}

/// The part of the corner's speed out of the wall that comes from an ω in body coordinates.
T ReferenceBrick::turning(const Place& place, const Vector& omega) const {
  return dot(walls_[place.wall].normal, into_world(cross(omega, exactly(place.corner))));
}

T ReferenceBrick::speed(const Place& place) const {
  const auto& s = turning_.now();
  return dot(walls_[place.wall].normal, v_) + turning(place, {s[0], s[1], s[2]});
}

ReferenceBrick::Lowest ReferenceBrick::lowest() const {
  const Motion now = motion();
  Lowest lowest{{0, Vec3::Zero()}, std::numeric_limits<double>::infinity()};
  for (std::size_t w = 0; w < walls_.size(); ++w)
    for (int i = 0; i < 8; ++i) {
      const Vec3 corner = body_.corner(i);
      const double gap = walls_[w].normal.dot(now.x + now.q * corner - walls_[w].point);
      if (gap < lowest.gap) lowest = {{w, corner}, gap};
    }
  return lowest;
}

Motion ReferenceBrick::motion() const {
  const auto& s = turning_.now();
  const Quat q = Quat(roughly(s[6]), roughly(s[7]), roughly(s[8]), roughly(s[9])).normalized();
  return {roughly(x_), roughly(v_), q, q * Vec3(roughly(s[0]), roughly(s[1]), roughly(s[2]))};
}

// ── Flights ──

void ReferenceBrick::fly_exactly(double time) {
  for (int i = 0; i < 3; ++i) {
    x_[i] += v_[i] * time + gravity_[i] * time * time * 0.5;
    v_[i] += gravity_[i] * time;
  }
  turning_.shift(time);
  t_ += T(time);
}

void ReferenceBrick::fly(double time) {
  constexpr double longest = 0.02;  // [s]: well within the radius of the series
  for (double left = time; left > 0; left -= longest) fly_exactly(std::fmin(left, longest));
}

/// Steps of 2 ms until a corner is below a wall; from there by Newton's method.
void ReferenceBrick::next_impact() {
  constexpr double step = 2e-3, below = -1e-13, longest = 100;
  const double end = t() + longest;
  Lowest low = lowest();
  while (!(low.gap < below)) {
    require(t() < end, "reference: no impact within ", longest, " s");
    fly_exactly(step);
    low = lowest();
  }
  // Another corner may have been earlier: the lowest one just before.
  for (double part = step / 2; part > 1e-9; part /= 2) {
    fly_exactly(lowest().gap < below ? -part : part);
    if (const Lowest now = lowest(); now.gap < below) low = now;
  }
  for (int i = 0; i < 6; ++i) fly_exactly(-roughly(gap(low.place) / speed(low.place)));
  push(low.place);
}

/// The impulse along the normal that turns the corner's speed round: j = −(1 + e) u_n / nᵀ K n.
void ReferenceBrick::push(const Place& place) {
  const Wall& wall = walls_[place.wall];
  const Vector n = exactly(wall.normal);
  const Vector arm = cross(exactly(place.corner), into_body(n));
  Vector answer;  // of ω in body coordinates
  for (int i = 0; i < 3; ++i) answer[i] = arm[i] / T(body_.moments[i]);
  const T length = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
  const T K = length / T(body_.mass) + turning(place, answer);
  const T j = -(T(1) + T(e_)) * speed(place) / K;
  for (int i = 0; i < 3; ++i) v_[i] += n[i] * j / T(body_.mass), answer[i] *= j;
  turning_.kick(answer);
}

}  // namespace tumble::bench
