#pragma once
/// @file
/// A scene and its states as the numbers that a figure exchanges with a reader's functions.

#include <span>
#include <vector>

#include "tumble/body/rigid_body.hpp"
#include "tumble/body/steady_forces.hpp"

namespace tumble::support {

/// @param f a constant force, and where it acts
/// @return 30 numbers, as tests/judge/page/student/figure_numbers.hpp lists them
inline std::vector<double> scene_for_reader(const RigidBody<>& body, const RigidBodyState<>& start,
                                            double duration,
                                            const SteadyForces::AtPoint& f = {Vec3::Zero(),
                                                                              Vec3::Zero()}) {
  std::vector<double> numbers{body.mass()};
  const auto add = [&](const auto& matrix) {
    numbers.insert(numbers.end(), matrix.data(), matrix.data() + matrix.size());
  };
  add(body.I_body());  // symmetric: its columns are its rows
  add(f.force);
  add(f.p_body);
  add(start.x);
  numbers.insert(numbers.end(), {start.q.w(), start.q.x(), start.q.y(), start.q.z()});
  add(start.P);
  add(start.L);
  numbers.push_back(duration);
  return numbers;
}

/// States of 13 numbers each; their q need not have length 1.
inline std::vector<RigidBodyState<>> states_from_reader(std::span<const double> numbers) {
  constexpr std::size_t size = 13;
  std::vector<RigidBodyState<>> states;
  for (std::size_t i = 0; i + size <= numbers.size(); i += size) {
    const double* y = numbers.data() + i;
    states.push_back({{y[0], y[1], y[2]},
                      Quat(y[3], y[4], y[5], y[6]).normalized(),
                      {y[7], y[8], y[9]},
                      {y[10], y[11], y[12]}});
  }
  return states;
}

}  // namespace tumble::support
