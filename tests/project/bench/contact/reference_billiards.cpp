#include "project/bench/contact/reference_billiards.hpp"

#include <cmath>

#include "tumble/simd/double_double.hpp"

namespace tumble::bench {
namespace {

using T = simd::DoubleDouble;

struct Vector {
  T x, y, z;
};

T dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector operator+(const Vector& a, const Vector& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Vector operator*(const Vector& a, const T& s) { return {a.x * s, a.y * s, a.z * s}; }
Vector exactly(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

/// One step of Newton's method from that of the leading double.
T square_root(const T& x) {
  const T root = std::sqrt(x.hi);
  return root + (x - root * root) / (root * T(2));
}

class Table {
 public:
  Table(const Scene& scene, double nudge) : scene_(scene), radius_(scene.bodies[0].radius()) {
    for (const Body& body : scene.bodies)
      x_.push_back(exactly(body.start.x)), v_.push_back(exactly(body.start.v));
    v_[0] = v_[0] * (T(1) + T(nudge));
  }

  std::vector<Collision> collisions(double duration) {
    std::vector<Collision> all;
    for (T left = duration; find_next(left); left -= time_) {
      for (std::size_t i = 0; i < x_.size(); ++i) x_[i] = x_[i] + v_[i] * time_;
      collide();
      all.push_back(next_);
    }
    return all;
  }

 private:
  bool find_next(const T& within) {
    time_ = within;
    next_ = {-1, 0};
    for (int i = 0; i < static_cast<int>(x_.size()); ++i) {
      for (int j = i + 1; j < static_cast<int>(x_.size()); ++j)
        consider(time_of_pair(i, j), {i, j});
      for (int w = 0; w < static_cast<int>(scene_.walls.size()); ++w)
        consider(time_of_wall(i, w), {i, -1 - w});
    }
    return next_.ball >= 0;
  }

  void consider(const T& time, const Collision& collision) {
    if (time < time_) time_ = time, next_ = collision;
  }

  /// |Δx + Δv t| = 2r, the earlier root; only of balls that come together.
  T time_of_pair(int i, int j) const {
    const Vector dx = x(j) - x(i), dv = v(j) - v(i);
    const T closing = dot(dx, dv), apart = dot(dx, dx) - T(4) * radius_ * radius_;
    const T square = closing * closing - dot(dv, dv) * apart;
    if (!(closing < T(0)) || square < T(0)) return never;
    return apart / (square_root(square) - closing);
  }
  T time_of_wall(int i, int w) const {
    const Wall& wall = scene_.walls[static_cast<std::size_t>(w)];
    const Vector n = exactly(wall.normal);
    const T speed = dot(n, v(i));
    if (!(speed < T(0))) return never;
    return (dot(n, x(i) - exactly(wall.point)) - radius_) / -speed;
  }

  /// Along the line of centres two equal balls swap velocities; a wall turns it round.
  void collide() {
    Vector& v_i = v_[static_cast<std::size_t>(next_.ball)];
    if (next_.other < 0) {
      const Vector n = exactly(scene_.walls[static_cast<std::size_t>(-1 - next_.other)].normal);
      v_i = v_i - n * (T(2) * dot(n, v_i));
      return;
    }
    Vector& v_j = v_[static_cast<std::size_t>(next_.other)];
    const Vector dx = x(next_.other) - x(next_.ball);
    const Vector swap = dx * (dot(dx, v_j - v_i) / dot(dx, dx));
    v_i = v_i + swap;
    v_j = v_j - swap;
  }

  const Vector& x(int i) const { return x_[static_cast<std::size_t>(i)]; }
  const Vector& v(int i) const { return v_[static_cast<std::size_t>(i)]; }

  static constexpr double never = std::numeric_limits<double>::infinity();
  const Scene& scene_;
  T radius_, time_ = 0;
  Collision next_{};
  std::vector<Vector> x_, v_;
};

}  // namespace

std::vector<Collision> billiards(const Scene& scene, double duration, double nudge) {
  return Table(scene, nudge).collisions(duration);
}

}  // namespace tumble::bench
