#pragma once
/// @file
/// Gram–Schmidt that begins with any of the three columns.

#include "tumble/rotation/gram_schmidt.hpp"

namespace rotation_matrices_chapter {

/// A rotation near M that keeps the direction of one column, the favourite, and takes the others in
/// the order x, y, z, x, …
/// @param first 0 … 2
/// @throws std::invalid_argument as gram_schmidt() does
inline tumble::Mat3 gram_schmidt_from(const tumble::Mat3& M, int first) {
  const int second = (first + 1) % 3, third = (first + 2) % 3;
  tumble::Mat3 cycled, R;
  cycled << M.col(first), M.col(second), M.col(third);  // still right-handed
  const tumble::Mat3 repaired = tumble::rotation::gram_schmidt(cycled);
  R.col(first) = repaired.col(0);
  R.col(second) = repaired.col(1);
  R.col(third) = repaired.col(2);
  return R;
}

}  // namespace rotation_matrices_chapter
