#pragma once
/// @file
/// The ways from one orientation to another that the chapter compares.

#include <functional>
#include <string>
#include <vector>

#include "common.hpp"

namespace quaternions_chapter {

inline const Mat3 start = Mat3::Identity();
inline constexpr double whole_turn = 150 * degree;
inline const Mat3 goal = exp_rotation(Vec3(whole_turn * Vec3(0.3, -1, 0.25).normalized()));

/// A way from `start` at t = 0 to `goal` at t = 1. Not every step of it need be a rotation.
struct Way {
  std::string name;
  std::function<Mat3(double)> at;
};

inline Mat3 mix_nine(double t) { return (1 - t) * start + t * goal; }

/// Each angle the short way round.
inline Mat3 mix_angles(double t) {
  const Vec3 a = matrix_to_euler_angles(start, EulerSequence::zyx);
  Vec3 way = matrix_to_euler_angles(goal, EulerSequence::zyx) - a;
  for (double& angle : way) angle = std::remainder(angle, 2 * pi);
  return euler_angles_to_matrix(a + t * way, EulerSequence::zyx);
}

inline const std::vector<Way> ways{
    {"nine numbers mixed", mix_nine},
    {"… and repaired", [](double t) { return nearest_rotation(mix_nine(t)); }},
    {"three angles mixed", mix_angles},
    {"four numbers mixed, normalised",
     [](double t) { return to_matrix(mix_four(from_matrix(start), from_matrix(goal), t)); }},
    {"slerp", [](double t) { return to_matrix(slerp(from_matrix(start), from_matrix(goal), t)); }}};

/// Angular speed along a way [rad per unit of t].
inline double speed(const Way& way, double t) {
  constexpr double d = 1e-4;
  return angle_apart(nearest_rotation(way.at(t - d)), nearest_rotation(way.at(t + d))) / (2 * d);
}

}  // namespace quaternions_chapter
