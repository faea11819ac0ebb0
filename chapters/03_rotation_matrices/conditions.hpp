#pragma once
/// @file
/// The six conditions that the columns of a rotation meet, as words in a drawing, and what a repair
/// has done to the columns.

#include <array>
#include <cmath>
#include <string>

#include "paper_rotation.hpp"

namespace rotation_matrices_chapter {

/// A dot product of two columns.
struct Condition {
  const char* name;
  Eigen::Index i, j;
};
inline constexpr std::array<Condition, 6> conditions{{{"x · x", 0, 0},
                                                      {"y · y", 1, 1},
                                                      {"z · z", 2, 2},
                                                      {"x · y", 0, 1},
                                                      {"y · z", 1, 2},
                                                      {"z · x", 2, 0}}};

/// The six dot products; red are those that are not as in a rotation.
inline void draw_conditions(support::Sketch& sketch, const Mat3& M, double x, double y) {
  constexpr double column = 126, row = 24, seen_as_equal = 0.005;
  for (std::size_t k = 0; k < 6; ++k) {
    const auto& [name, i, j] = conditions[k];
    const double product = M.col(i).dot(M.col(j)), wanted = i == j ? 1 : 0;
    sketch.words({x + column * static_cast<double>(k % 3), -y - (k < 3 ? 0 : row)}, {0, 0},
                 name + (" = " + support::svg_number(product, 2)),
                 std::abs(product - wanted) < seen_as_equal ? "ink" : "c6", "middle");
  }
}

/// How far from a rotation, to three digits, however near it is.
inline std::string small_number(double value) {
  if (value < 1e-13) return "0, but for rounding";
  if (value >= 0.001) return support::svg_number(value, 3);
  int exponent = 0;
  while (value < 1) {
    value *= 10;
    --exponent;
  }
  return support::svg_number(value, 1) + "e" + support::svg_number(exponent, 0);
}

/// How far the repair has turned each column.
inline std::string turned_by(const Mat3& M, const Mat3& R) {
  std::string text = "turned: ";
  const std::array<const char*, 3> names{"x", ", y", ", z"};
  for (Eigen::Index j = 0; j < 3; ++j) {
    const Vec3 m = M.col(j), r = R.col(j);
    const double angle = std::atan2(m.cross(r).norm(), m.dot(r)) / degree;
    text += std::string(names[static_cast<std::size_t>(j)]) + " by " +
            support::svg_number(angle, 1) + "°";
  }
  return text;
}

}  // namespace rotation_matrices_chapter
