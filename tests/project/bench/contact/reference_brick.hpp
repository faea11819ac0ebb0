#pragma once
/// @file
/// A box that flies among walls without friction, in double-doubles: the truth, written on its own.

#include "project/bench/contact/contest.hpp"
#include "reference/double_double_motion.hpp"

namespace tumble::bench {

class ReferenceBrick {
 public:
  /// @param nudge of its velocity, relative: to see how far its digits reach
  explicit ReferenceBrick(const Scene& scene, double nudge = 0);

  /// Flies to the next impact, and through it.
  /// @throws std::invalid_argument if there is none within 100 s
  void next_impact();
  /// Flies on without a look at the walls.
  void fly(double time);

  double t() const { return static_cast<double>(t_); }
  Motion motion() const;

 private:
  using T = simd::DoubleDouble;
  using Vector = Eigen::Matrix<T, 3, 1>;

  /// A corner over a wall.
  struct Place {
    std::size_t wall;
    Vec3 corner;  ///< body coordinates
  };
  /// The lowest of all corners over all walls, roughly: to rounding of doubles.
  struct Lowest {
    Place place;
    double gap;
  };

  Lowest lowest() const;
  Vector into_world(const Vector& body) const;
  Vector into_body(const Vector& world) const;
  T gap(const Place& place) const;
  T speed(const Place& place) const;
  T turning(const Place& place, const Vector& omega) const;
  void fly_exactly(double time);
  void push(const Place& place);

  Body body_;
  std::vector<Wall> walls_;
  Vector gravity_, x_, v_;
  double e_;
  reference::DoubleDoubleTurning turning_;
  T t_ = 0;
};

}  // namespace tumble::bench
