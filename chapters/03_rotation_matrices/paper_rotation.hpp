#pragma once
/// @file
/// The one rotation that goes through the whole chapter, and its matrix as a drawing.

#include <array>
#include <numbers>
#include <string>

#include "support/space_sketch.hpp"

namespace rotation_matrices_chapter {

using namespace tumble;

inline constexpr double degree = std::numbers::pi / 180;

/// A rotation that fits on paper.
inline Mat3 paper_rotation() {
  Mat3 R;
  R << 0.6, -0.64, 0.48, 0.8, 0.48, -0.36, 0, 0.6, 0.8;
  return R;
}

/// How the three columns are drawn.
inline const std::array<support::Pen, 3> column_pens{
    support::Pen{"c0", 2.6}, {"c1", 2.6}, {"c2", 2.6}};

/// Where a matrix is in a drawing, and how large [px].
struct MatrixPlace {
  double left, middle;  ///< of its left bracket
  double column, row;   ///< of a number
};

inline void draw_brackets(support::Sketch& sketch, const MatrixPlace& at) {
  const double right = at.left + 3 * at.column + 8, half = 1.5 * at.row + 4;
  for (const double side : {at.left, right}) {
    const double inwards = side == at.left ? 8 : -8;
    sketch.curve({{side + inwards, -at.middle + half},
                  {side, -at.middle + half},
                  {side, -at.middle - half},
                  {side + inwards, -at.middle - half}},
                 {"ink", 1.6});
  }
}

/// A matrix of three columns, each in its colour.
inline void draw_matrix(support::Sketch& sketch, const Mat3& R, const std::string& name,
                        const MatrixPlace& at) {
  sketch.look({0, 0, 1});
  draw_brackets(sketch, at);
  const std::array<std::string, 3> names{"x", "y", "z"};
  for (Eigen::Index j = 0; j < 3; ++j) {
    const auto index = static_cast<std::size_t>(j);
    const double x = at.left + 4 + at.column * (static_cast<double>(j) + 0.5);
    const std::string& colour = column_pens[index].colour;
    sketch.words({x, -at.middle + 2 * at.row}, {0, 0}, names[index], colour, "middle");
    for (Eigen::Index i = 0; i < 3; ++i)
      sketch.words({x, -at.middle + at.row * static_cast<double>(1 - i)}, {0, 6},
                   support::svg_number(R(i, j), 2), colour, "middle");
  }
  sketch.words({at.left, -at.middle}, {-14, 6}, name + " =", "ink", "end");
}

}  // namespace rotation_matrices_chapter
