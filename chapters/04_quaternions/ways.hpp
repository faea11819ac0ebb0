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

inline const std::vector<Way> ways{
    {"nine numbers mixed", [](double t) { return mix_nine(start, goal, t); }},
    {"… and repaired", [](double t) { return nearest_rotation(mix_nine(start, goal, t)); }},
    {"three angles mixed", [](double t) { return mix_angles(start, goal, t); }},
    {"four numbers mixed, normalised",
     [](double t) { return to_matrix(mix_four(from_matrix(start), from_matrix(goal), t)); }},
    {"slerp", [](double t) { return to_matrix(slerp(from_matrix(start), from_matrix(goal), t)); }}};

/// Angular speed along a way [rad per unit of t].
inline double speed(const Way& way, double t) {
  constexpr double d = 1e-4;
  return angle_apart(nearest_rotation(way.at(t - d)), nearest_rotation(way.at(t + d))) / (2 * d);
}

}  // namespace quaternions_chapter
