#pragma once
/// @file
/// A steady turn, whose exact orientation is known: R(t) = exp(t [ω]×).

#include "common.hpp"
#include "tumble/ode.hpp"

namespace rotation_matrices_chapter {

inline const Vec3 omega = 2 * Vec3(2, -1, 2).normalized();  // [rad/s]
inline constexpr double h = 1.0 / 60;                       // a frame of a game [s]

inline Mat3 euler_turned(int steps) {
  Mat3 R = Mat3::Identity();
  for (int i = 0; i < steps; ++i) R += h * rotation::rotation_dot(R, omega);
  return R;
}

/// One step of a method, from R to R.
using Step = Mat3 (*)(const Mat3&);

using Flat = Eigen::Matrix<double, 9, 1>;

/// The same rate, as a solver of chapter 1 wants it.
inline Flat rate(double, const Flat& y) {
  return rotation::rotation_dot(Mat3(y.reshaped(3, 3)), omega).reshaped();
}

inline Mat3 euler(const Mat3& R) { return R + h * rotation::rotation_dot(R, omega); }
inline Mat3 midpoint(const Mat3& R) {
  return runge_kutta::midpoint_step(rate, 0, Flat(R.reshaped()), h).reshaped(3, 3);
}
inline Mat3 rk4(const Mat3& R) {
  return runge_kutta::rk4_step(rate, 0, Flat(R.reshaped()), h).reshaped(3, 3);
}

inline Mat3 stepped(Step step, int steps) {
  Mat3 R = Mat3::Identity();
  for (int i = 0; i < steps; ++i) R = step(R);
  return R;
}

inline Mat3 exact_orientation(int steps) { return exp_rotation(Vec3(omega * (h * steps))); }

/// One way to make a rotation of a matrix that has drifted.
struct Repair {
  std::string name;
  Step apply;
};

inline const std::vector<Repair> repairs{{"Gram–Schmidt", rotation::gram_schmidt},
                                         {"one Newton step", rotation::newton_rotation_step},
                                         {"nearest rotation (SVD)", nearest_rotation}};

}  // namespace rotation_matrices_chapter
