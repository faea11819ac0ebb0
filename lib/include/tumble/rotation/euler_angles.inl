#pragma once

#include "tumble/rotation/euler_angles.hpp"

#include <cmath>
#include <utility>

#include "tumble/core/compiled.hpp"
#include "tumble/core/require.hpp"

namespace tumble::detail {

TUMBLE_BODY std::array<int, 3> axes_of(EulerSequence sequence) {
  constexpr std::array<std::array<int, 3>, 12> axes{{{0, 1, 2},
                                                     {0, 2, 1},
                                                     {1, 0, 2},
                                                     {1, 2, 0},
                                                     {2, 0, 1},
                                                     {2, 1, 0},
                                                     {0, 1, 0},
                                                     {0, 2, 0},
                                                     {1, 0, 1},
                                                     {1, 2, 1},
                                                     {2, 0, 2},
                                                     {2, 1, 2}}};
  const auto index = static_cast<std::size_t>(sequence);
  require(index < axes.size(), "there is no Euler sequence number ", index);
  return axes[index];
}

}  // namespace tumble::detail

namespace tumble {

TUMBLE_BODY Mat3 euler_angles_to_matrix(const Vec3& angles, EulerSequence sequence) {
  require(angles.allFinite(), "Euler angles must be finite, got ", angles.transpose());
  const auto [i, j, k] = detail::axes_of(sequence);
  return axis_rotation(i, angles[0]) * axis_rotation(j, angles[1]) * axis_rotation(k, angles[2]);
}

TUMBLE_BODY Vec3 matrix_to_euler_angles(const Mat3& R, EulerSequence sequence) {
  const auto [i, j, last] = detail::axes_of(sequence);
  const bool proper = last == i;
  const int k = 3 - i - j;
  const double s = (j - i + 3) % 3 == 1 ? 1 : -1;  // e_i × e_j = s e_k

  // The image of the last axis does not depend on γ, and its azimuth about axis i is α.
  const double alpha =
      proper ? std::atan2(R(j, i), -s * R(k, i)) : std::atan2(-s * R(j, k), R(k, k));
  // With the first turn taken out, β and γ are read off what is left, stable even at gimbal lock.
  const Mat3 M = axis_rotation(i, -alpha) * R;
  if (proper) return {alpha, std::atan2(-s * M(k, i), M(i, i)), std::atan2(-s * M(j, k), M(j, j))};
  return {alpha, std::atan2(s * M(i, k), M(k, k)), std::atan2(s * M(j, i), M(j, j))};
}

TUMBLE_BODY Mat3 fixed_angles_to_matrix(const Vec3& angles, EulerSequence sequence) {
  require(angles.allFinite(), "fixed-axis angles must be finite, got ", angles.transpose());
  const auto [i, j, k] = detail::axes_of(sequence);
  return axis_rotation(k, angles[2]) * axis_rotation(j, angles[1]) * axis_rotation(i, angles[0]);
}

}  // namespace tumble
